#############################################################################
#
# Circular fiducial markers for ViSP, the Visual Servoing Platform.
#
# This software is free software; you can redistribute it and/or modify
# it under the terms of the GNU General Public License as published by
# the Free Software Foundation; either version 2 of the License, or
# (at your option) any later version.
# See the file LICENSE at the root directory of this source
# distribution for additional information about the GNU GPL.
#
# This file is provided AS IS with NO WARRANTY OF ANY KIND, INCLUDING THE
# WARRANTY OF DESIGN, MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE.
#
# Description:
# Takes the run paths out of what is about to be packed, and adds what Debian wants beside it.
#
#############################################################################

# Read by CPack: CPACK_TEMPORARY_DIRECTORY is the folder that becomes the package, CPACK_CIRCLE_MARKER_DOCUMENTS are the
# package's papers. In /usr the libraries are found without a path in each program, and Debian forbids such paths.
file(GLOB_RECURSE files ${CPACK_TEMPORARY_DIRECTORY}/*)
foreach(file ${files})
  if(NOT IS_SYMLINK ${file})
    file(READ ${file} magic LIMIT 4 HEX)
    if(magic STREQUAL "7f454c46") # an ELF file
      file(RPATH_REMOVE FILE ${file})
    endif()
  endif()
endforeach()
file(COPY ${CPACK_CIRCLE_MARKER_DOCUMENTS} FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
     DESTINATION ${CPACK_TEMPORARY_DIRECTORY}/usr/share/doc/${CPACK_PACKAGE_NAME})

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
# Takes the run paths out of what is about to be packed, and adds what Debian wants beside it: papers, manual pages.
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

# The first sentence of a program's help is what apropos shows of it.
if(CPACK_CIRCLE_MARKER_HELP2MAN)
  set(ENV{LD_LIBRARY_PATH} ${CPACK_CIRCLE_MARKER_LIBRARIES})
  set(manual ${CPACK_TEMPORARY_DIRECTORY}/usr/share/man/man1)
  file(MAKE_DIRECTORY ${manual})
  file(GLOB programs ${CPACK_TEMPORARY_DIRECTORY}/usr/bin/*)
  foreach(program ${programs})
    get_filename_component(name ${program} NAME)
    execute_process(COMMAND ${program} --help OUTPUT_VARIABLE sentence RESULT_VARIABLE result)
    string(REGEX REPLACE "\n.*" "" sentence "${sentence}")
    string(REGEX REPLACE "\\.( .*)?$" "" sentence "${sentence}")
    if(result EQUAL 0)
      execute_process(
        COMMAND ${CPACK_CIRCLE_MARKER_HELP2MAN} --no-info --section 1 --version-string ${CPACK_PACKAGE_VERSION}
                --name ${sentence} --source "circular markers for ViSP" --manual "User Commands"
                --output ${manual}/${name}.1 ${program}
        RESULT_VARIABLE result)
    endif()
    if(result EQUAL 0)
      execute_process(COMMAND ${CPACK_CIRCLE_MARKER_GZIP} -9n ${manual}/${name}.1 RESULT_VARIABLE result)
    endif()
    if(NOT result EQUAL 0)
      message(FATAL_ERROR "${name}: no manual page could be made of its --help")
    endif()
  endforeach()
  file(GLOB pages ${manual}/*)
  file(CHMOD ${pages} PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endif()

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
# Writes a pkg-config file for each of our modules, for installation beside ViSP's visp.pc.
#
#############################################################################

get_property(modules GLOBAL PROPERTY CIRCLE_MARKER_MODULES)
set(pkgconfig_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
# Relative to the file itself: an installation can be moved.
file(RELATIVE_PATH CIRCLE_MARKER_PC_PREFIX ${CMAKE_INSTALL_PREFIX}/${pkgconfig_folder} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" CIRCLE_MARKER_PC_PREFIX ${CIRCLE_MARKER_PC_PREFIX})
foreach(CIRCLE_MARKER_PC_MODULE ${modules})
  get_target_property(CIRCLE_MARKER_PC_DESCRIPTION ${CIRCLE_MARKER_PC_MODULE} CIRCLE_MARKER_DESCRIPTION)
  set(file ${CMAKE_BINARY_DIR}/cmake/pkgconfig/${CIRCLE_MARKER_PC_MODULE}.pc)
  configure_file(cmake/visp_module.pc.in ${file} @ONLY)
  install(FILES ${file} DESTINATION ${pkgconfig_folder})
endforeach()

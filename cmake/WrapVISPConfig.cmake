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
# Writes the VISPConfig.cmake that adds our modules to ViSP's, for our programs and for installation.
#
#############################################################################

get_property(CIRCLE_MARKER_MODULES GLOBAL PROPERTY CIRCLE_MARKER_MODULES)

# Build tree: the targets are already there.
set(CIRCLE_MARKER_TARGETS_FILE "")
set(CIRCLE_MARKER_CONFIG_INCLUDE_DIRS "")
configure_file(cmake/VISPConfig.cmake.in ${CMAKE_BINARY_DIR}/cmake/visp-circle-marker/VISPConfig.cmake @ONLY)
configure_file(cmake/VISPConfig-version.cmake.in
               ${CMAKE_BINARY_DIR}/cmake/visp-circle-marker/VISPConfig-version.cmake @ONLY)

# Installed. A folder of its own name: in ViSP's own prefix cmake/visp is ViSP's.
set(CIRCLE_MARKER_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/visp-circle-marker)
set(CIRCLE_MARKER_TARGETS_FILE CircleMarkerModules.cmake)
file(RELATIVE_PATH CIRCLE_MARKER_CONFIG_INCLUDE_DIRS ${CMAKE_INSTALL_PREFIX}/${CIRCLE_MARKER_INSTALL_CMAKEDIR}
     ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(cmake/VISPConfig.cmake.in ${CMAKE_BINARY_DIR}/cmake/install/VISPConfig.cmake @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/cmake/install/VISPConfig.cmake
              ${CMAKE_BINARY_DIR}/cmake/visp-circle-marker/VISPConfig-version.cmake
        DESTINATION ${CIRCLE_MARKER_INSTALL_CMAKEDIR})
install(EXPORT CircleMarkerModules DESTINATION ${CIRCLE_MARKER_INSTALL_CMAKEDIR})

set(VISP_DIR ${CMAKE_BINARY_DIR}/cmake/visp-circle-marker)

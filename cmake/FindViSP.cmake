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
# Finds an installed ViSP with the modules that ours and the programs need.
#
#############################################################################

# Gives VISP_DIR and CIRCLE_MARKER_VISP_DIR, the folder of ViSP's own VISPConfig.cmake.
find_package(VISP 3.5.0 REQUIRED visp_core visp_blob visp_detection visp_gui visp_io visp_me visp_robot visp_sensor
             visp_vision visp_visual_features visp_vs)
# An earlier installation of this project answers in ViSP's name (VISPConfig.cmake.in): it says where ViSP itself is.
if(DEFINED VISP_CIRCLE_MARKER_VISP_DIR)
  set(CIRCLE_MARKER_VISP_DIR ${VISP_CIRCLE_MARKER_VISP_DIR})
else()
  set(CIRCLE_MARKER_VISP_DIR ${VISP_DIR})
endif()
message(STATUS "ViSP ${VISP_VERSION_STRING} in ${CIRCLE_MARKER_VISP_DIR}")
# Each module names the ViSP modules it needs; the list of all that were looked for would go on into every program.
unset(VISP_LIBS)
unset(VISP_LIBRARIES)

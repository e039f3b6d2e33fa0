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
# Installs the build, then configures, builds and runs a third party's project against the installation.
#
#############################################################################

# cmake -D BUILD_DIR=... -D WORK_DIR=... -D CXX_COMPILER=... -D LIBRARY_FOLDER=... -D PKG_CONFIG=... -P run.cmake
# LIBRARY_FOLDER: in the prefix, for instance lib; PKG_CONFIG: the program, empty to leave that way out.
include(${CMAKE_CURRENT_LIST_DIR}/use.cmake)

# From nothing: a header or a library that the installation forgets must not be left from an earlier run.
file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
# udev reads this folder of /usr and /usr/local, and none that is named after the architecture.
if(CMAKE_HOST_SYSTEM_NAME STREQUAL "Linux" AND
   NOT EXISTS ${WORK_DIR}/prefix/lib/udev/rules.d/60-circle-marker-cameras.rules)
  message(FATAL_ERROR "the udev rules are not installed")
endif()
# Moved: nothing installed may point back to where it was installed first.
file(RENAME ${WORK_DIR}/prefix ${WORK_DIR}/moved)
use_with_cmake(${WORK_DIR}/build ${CXX_COMPILER} CMAKE_PREFIX_PATH=${WORK_DIR}/moved)
if(PKG_CONFIG)
  use_with_pkg_config(${WORK_DIR}/with-pkg-config ${CXX_COMPILER} ${PKG_CONFIG} ${WORK_DIR}/moved/${LIBRARY_FOLDER})
endif()

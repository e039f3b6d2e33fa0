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
# Packs the build for Debian, then looks at the package and builds a third party's project against what it holds.
#
#############################################################################

# cmake -D BUILD_DIR=... -D WORK_DIR=... -D CXX_COMPILER=... -D CPACK=... -D DPKG_DEB=... -D LINTIAN=... -P ...
# LINTIAN: the program; empty to leave it out. Nothing is installed into the system.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "failed with ${result}: ${command}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
run(${CPACK} -G DEB --config ${BUILD_DIR}/CPackConfig.cmake -B ${WORK_DIR})
file(GLOB packages ${WORK_DIR}/*.deb)
list(LENGTH packages count)
if(NOT count EQUAL 1)
  message(FATAL_ERROR "cpack made ${count} packages instead of one: ${packages}")
endif()

if(LINTIAN)
  # Warnings are not errors: one package has library and headers, and the programs have no manual pages but --help.
  run(${LINTIAN} --fail-on error --allow-root ${packages})
endif()

run(${DPKG_DEB} --info ${packages})
run(${DPKG_DEB} --extract ${packages} ${WORK_DIR}/root)
file(GLOB stray RELATIVE ${WORK_DIR}/root ${WORK_DIR}/root/*)
if(NOT stray STREQUAL "usr")
  message(FATAL_ERROR "the package has files outside of /usr: ${stray}")
endif()
file(GLOB_RECURSE config ${WORK_DIR}/root/usr/VISPConfig.cmake)
if(NOT config)
  message(FATAL_ERROR "the package has no VISPConfig.cmake")
endif()
get_filename_component(folder ${config} DIRECTORY)
# ViSP's own VISPConfig.cmake is in /usr as well, so the folder is named.
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/install-consumer -B ${WORK_DIR}/build -D VISP_DIR=${folder}
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${CXX_COMPILER})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/install-consumer)

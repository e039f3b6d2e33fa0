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
# A third party's project built and run against what was installed, by CMake and by pkg-config.
#
#############################################################################

cmake_minimum_required(VERSION 3.19)
set(consumer ${CMAKE_CURRENT_LIST_DIR})

# run(<command> <argument>...): what fails ends the test.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "failed with ${result}: ${command}")
  endif()
endfunction()

# use_with_cmake(<folder of its own> <compiler> <definition>): <definition> tells find_package where the modules are.
function(use_with_cmake folder compiler definition)
  run(${CMAKE_COMMAND} -S ${consumer} -B ${folder} -D ${definition} -D CMAKE_BUILD_TYPE=Release
      -D CMAKE_CXX_COMPILER=${compiler})
  run(${CMAKE_COMMAND} --build ${folder})
  run(${folder}/install-consumer)
endfunction()

# use_with_pkg_config(<program to make> <compiler> <pkg-config> <folder of the libraries>): the linker looks elsewhere.
function(use_with_pkg_config program compiler pkg_config libraries)
  set(ENV{PKG_CONFIG_PATH} ${libraries}/pkgconfig)
  execute_process(COMMAND ${pkg_config} --cflags --libs visp_circle_marker OUTPUT_VARIABLE flags
                  RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "pkg-config does not know the installed visp_circle_marker")
  endif()
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${compiler} ${consumer}/install-consumer.cpp -o ${program} ${flags} -Wl,-rpath,${libraries})
  run(${program})
endfunction()

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
# A test that uses the names of a module opens ViSP's namespace before, which ViSP has from 3.7.0 on.
#
#############################################################################

cmake_minimum_required(VERSION 3.19)

# cmake -D MODULES=<the project's modules folder> -P visp-namespace.cmake
# With an older ViSP, as in every run of the tests, it compiles without.

# opens_namespace <variable> <file>: whether it does so, itself or by a header of the tests beside it.
function(opens_namespace variable file)
  set(opens FALSE)
  file(STRINGS ${file} uses REGEX "^using namespace VISP_NAMESPACE_NAME;")
  if(uses)
    set(opens TRUE)
  else()
    get_filename_component(beside ${file} DIRECTORY)
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
    foreach(line ${lines})
      string(REGEX REPLACE "^[^\"]*\"([^\"]+)\".*" "\\1" header ${line})
      if(NOT opens AND EXISTS ${beside}/${header})
        opens_namespace(opens ${beside}/${header})
      endif()
    endforeach()
  endif()
  set(${variable} ${opens} PARENT_SCOPE)
endfunction()

set(mistakes "")
set(count 0)
file(GLOB tests ${MODULES}/*/test/*.cpp)
foreach(test ${tests})
  file(STRINGS ${test} uses REGEX "^using namespace (circle_marker|marker_simulator);")
  if(uses)
    math(EXPR count "${count} + 1")
    opens_namespace(opens ${test})
    if(NOT opens)
      string(APPEND mistakes "  ${test}\n")
    endif()
  endif()
endforeach()
if(mistakes)
  message(FATAL_ERROR "before 'using namespace circle_marker;' there must be, as in other tests,\n"
                      "#ifdef ENABLE_VISP_NAMESPACE\nusing namespace VISP_NAMESPACE_NAME;\n#endif\n${mistakes}")
endif()
if(count EQUAL 0)
  message(FATAL_ERROR "no test of a module was found in ${MODULES}")
endif()
message(STATUS "${count} tests open ViSP's namespace")

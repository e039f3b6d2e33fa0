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
# The rooms of the detector are passed in one direction: none includes a header of a later one.
#
#############################################################################

cmake_minimum_required(VERSION 3.19)

# cmake -D MODULES=<the project's modules folder> -P room-order.cmake
# A file may include what is in its own room and in those before it. What belongs to no room (support) includes none of
# them; files beside the rooms use all. The simulator and the detector share no code, so that neither hides the other's
# mistakes.
set(rooms segment edges ellipse pose decode refine)
# What keeps markers from image to image works on outlines alone.
set(folder_track_may support segment edges ellipse)
set(folder_support_may "")
set(earlier support)
foreach(room ${rooms})
  set(folder_${room}_may ${earlier})
  list(APPEND earlier ${room})
endforeach()

set(mistakes "")
set(source ${MODULES}/circle_marker/src)
file(GLOB folders LIST_DIRECTORIES true RELATIVE ${source} ${source}/*)
foreach(folder ${folders})
  if(NOT IS_DIRECTORY ${source}/${folder})
    continue()
  endif()
  if(NOT DEFINED folder_${folder}_may)
    string(APPEND mistakes "  ${folder} is no room that this test knows\n")
    continue()
  endif()
  file(GLOB_RECURSE files ${source}/${folder}/*.h ${source}/${folder}/*.cpp)
  foreach(file ${files})
    get_filename_component(beside ${file} DIRECTORY)
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
    foreach(line ${lines})
      string(REGEX REPLACE "^[^\"]*\"([^\"]+)\".*" "\\1" header ${line})
      if(EXISTS ${beside}/${header})
        get_filename_component(header ${beside}/${header} ABSOLUTE)
        file(RELATIVE_PATH header ${source} ${header})
      endif()
      string(REGEX REPLACE "/.*" "" other ${header})
      if(NOT other STREQUAL folder AND NOT other IN_LIST folder_${folder}_may)
        file(RELATIVE_PATH name ${source} ${file})
        string(APPEND mistakes "  ${name} includes ${header}\n")
      endif()
    endforeach()
  endforeach()
endforeach()

# may_not_include <module> <other module>
function(may_not_include module other)
  file(GLOB_RECURSE files ${MODULES}/${module}/include/*.h ${MODULES}/${module}/src/*.h ${MODULES}/${module}/src/*.cpp)
  if(NOT files)
    string(APPEND mistakes "  ${module} has no files\n")
  endif()
  foreach(file ${files})
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*<visp3/${other}/")
    if(lines)
      string(APPEND mistakes "  ${file}: ${lines}\n")
    endif()
  endforeach()
  set(mistakes "${mistakes}" PARENT_SCOPE)
endfunction()
may_not_include(circle_marker circle_marker_simulator)
may_not_include(circle_marker_simulator circle_marker)

if(mistakes)
  message(FATAL_ERROR "includes against the direction:\n${mistakes}")
endif()

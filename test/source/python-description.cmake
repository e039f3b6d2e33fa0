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
# What the Python description names must be in the headers.
#
#############################################################################

cmake_minimum_required(VERSION 3.19)

# cmake -D MODULE=<modules/circle_marker> -D "INCLUDE_DIRS=<folder>;..." -P python-description.cmake
# ViSP's generator looks for the methods by their signatures, and passes over in silence what it does not find.
set(headers_folder ${MODULE}/include/visp3/circle_marker)
file(READ ${MODULE}/python/circle_marker.json description)
set(mistakes "")

# in_json(<variable> <key>...): a value, or nothing where there is none.
macro(in_json variable)
  string(JSON ${variable} ERROR_VARIABLE no_value GET "${description}" ${ARGN})
  if(no_value)
    set(${variable} "")
  endif()
endmacro()
# last_in_json(<variable> <key>...): the last index of a list or object; -1 where it is empty or not there.
macro(last_in_json variable)
  string(JSON ${variable} ERROR_VARIABLE no_value LENGTH "${description}" ${ARGN})
  if(no_value)
    set(${variable} 0)
  endif()
  math(EXPR ${variable} "${${variable}} - 1")
endmacro()

# As the generator finds them: a class by its definition; a method by its type, name and parameters' types.
function(body_of class variable)
  file(GLOB headers ${headers_folder}/*.h)
  set(body "")
  foreach(header ${headers})
    file(READ ${header} text)
    # What ends with a bracket or semicolon would be taken for a list; names have neither.
    string(REGEX REPLACE ";" "<end>" text "${text}")
    string(REGEX REPLACE "(/\\*([^*]|\\*+[^*/])*\\*+/|//[^\n]*)" "" text "${text}")
    string(REGEX MATCH "(class VISP_EXPORT|struct|struct VISP_EXPORT) ${class}[ \n:].*" text "${text}")
    string(REGEX REPLACE "\n}<end>.*" "" text "${text}")
    string(APPEND body "${text}")
  endforeach()
  string(REGEX REPLACE "[ \n\t]" "" body "${body}")
  set(${variable} "${body}" PARENT_SCOPE)
endfunction()

file(READ ${MODULE}/python/circle_marker.hpp bindings)
last_in_json(last classes)
if(last LESS 0)
  string(APPEND mistakes "  no class is described\n")
endif()
set(count 0)
foreach(index RANGE ${last})
  string(JSON class MEMBER "${description}" classes ${index})
  body_of(${class} body)
  if(NOT body)
    string(APPEND mistakes "  there is no ${class}\n")
    continue()
  endif()
  in_json(function classes ${class} additional_bindings)
  if(function AND NOT bindings MATCHES "${function}\\(")
    string(APPEND mistakes "  circle_marker.hpp has no ${function}()\n")
  endif()
  last_in_json(last_method classes ${class} methods)
  if(last_method LESS 0)
    continue()
  endif()
  foreach(method RANGE ${last_method})
    in_json(signature classes ${class} methods ${method} signature)
    # In the header each parameter may have a name and a default value.
    string(REGEX REPLACE " ([a-zA-Z_0-9]+)\\(" "\\1<open>" pattern "${signature}")
    string(REGEX REPLACE "[ \n\t]" "" pattern "${pattern}")
    string(REGEX REPLACE "([*+?.])" "\\\\\\1" pattern "${pattern}")
    string(REPLACE "," "<name>," pattern "${pattern}")
    string(REPLACE ")" "<name>[)]" pattern "${pattern}")
    string(REPLACE "<open>" "[(]" pattern "${pattern}")
    string(REPLACE "<name>" "[a-zA-Z_0-9]*(=[^,]*)?" pattern "${pattern}")
    if(NOT body MATCHES "${pattern}")
      string(APPEND mistakes "  ${class} has no ${signature}\n")
    endif()
    in_json(custom classes ${class} methods ${method} custom_implem)
    string(REGEX REPLACE ".* ([a-zA-Z_0-9]+)\\(.*" "\\1" name "${signature}")
    if(custom AND NOT bindings MATCHES "\"${name}\"")
      string(APPEND mistakes "  circle_marker.hpp binds no ${name}()\n")
    endif()
    math(EXPR count "${count} + 1")
  endforeach()
endforeach()

foreach(list required_headers user_defined_headers)
  last_in_json(last ${list})
  foreach(index RANGE 0 ${last})
    in_json(header ${list} ${index})
    set(found OFF)
    foreach(folder ${INCLUDE_DIRS} ${MODULE}/include ${MODULE}/python)
      if(EXISTS ${folder}/${header})
        set(found ON)
      endif()
    endforeach()
    if(NOT found)
      string(APPEND mistakes "  there is no header ${header}\n")
    endif()
  endforeach()
endforeach()

if(mistakes)
  message(FATAL_ERROR "circle_marker.json names what is not there:\n${mistakes}")
endif()
message(STATUS "${count} methods of circle_marker.json are in the headers")

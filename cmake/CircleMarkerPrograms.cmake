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
# What programs need, and programs from one file or from a folder of files.
#
#############################################################################

# circle_marker_find_visp_or_return(<what> <module>...): finds ViSP with the modules, or says that <what> is left out and
# returns from the file that calls it (a macro, so that its return() is the caller's). In ViSP's own build a module may be
# switched off, or left out for want of what it needs.
macro(circle_marker_find_visp_or_return what)
  foreach(module ${ARGN})
    if(DEFINED VISP_MODULES_BUILD AND NOT module IN_LIST VISP_MODULES_BUILD)
      message(STATUS "${what} are left out: they need ${module}")
      return()
    endif()
  endforeach()
  find_package(VISP REQUIRED ${ARGN})
endmacro()

# circle_marker_find_command_line_or_return(<what>): finds what reads command lines and JSON in the same manner.
macro(circle_marker_find_command_line_or_return what)
  find_package(Threads REQUIRED)
  find_package(CLI11 QUIET)
  find_package(nlohmann_json QUIET)
  if(NOT TARGET CLI11::CLI11 OR NOT TARGET nlohmann_json::nlohmann_json)
    message(WARNING "${what} are left out: they need CLI11 and nlohmann-json")
    return()
  endif()
endmacro()

# circle_marker_add_program(<name> <library>...): the program <name> from <name>.cpp or from <name>/*.cpp, linked with
# ViSP and the libraries. Programs beside each other share the headers of common/, as "common/...", and all have those of
# the tutorials as "circle_marker/common/...".
# A program whose sources are not there is left out. CIRCLE_MARKER_PROGRAMS (global property) collects the names.
function(circle_marker_add_program name)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR})
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/${name}.cpp ${folder}/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  # A command line is read once: made fast, CLI11 takes the compiler twice the time.
  set_source_files_properties(${folder}/${name}/command_line.cpp PROPERTIES
    COMPILE_OPTIONS "$<$<AND:$<CXX_COMPILER_ID:GNU,Clang>,$<CONFIG:Release>>:-O1>")
  add_executable(${name} ${sources})
  target_include_directories(${name} PRIVATE ${folder} ${folder}/${name} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../tutorial)
  target_include_directories(${name} SYSTEM PRIVATE ${VISP_INCLUDE_DIRS})
  target_link_libraries(${name} ${VISP_LIBRARIES} ${ARGN})
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_compile_options(${name} PRIVATE -Wall -Wextra)
  set_property(GLOBAL APPEND PROPERTY CIRCLE_MARKER_PROGRAMS ${name})
endfunction()

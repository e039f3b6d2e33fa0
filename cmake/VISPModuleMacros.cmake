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
# The module macros of ViSP that our modules use, for a build outside of ViSP's tree.
#
#############################################################################

# Inside ViSP's tree its own cmake/VISPModule.cmake defines them, so that modules/*/CMakeLists.txt are the same files in
# both builds. Only what our modules need is here, with ViSP's meaning. Expects: VISP_INCLUDE_DIRS, and
#   VISP_INCLUDE_DIR      folder of generated headers in the build tree,
#   CIRCLE_MARKER_MODULES (global property) collects the names of our modules.

# vp_module_disable(<name>): leaves the module in the current folder out.
macro(vp_module_disable _name)
  return()
endmacro()

# vp_add_module(<name> <dependency>... [OPTIONAL <dependency>...]): starts the module visp_<name>.
macro(vp_add_module _name)
  set(name ${_name})
  set(the_module visp_${name})
  set(VISP_MODULE_${the_module}_LOCATION ${CMAKE_CURRENT_LIST_DIR})
  set(VISP_MODULE_${the_module}_DEPS "")
  set(__optional FALSE)
  foreach(__dependency ${ARGN})
    if(__dependency STREQUAL "OPTIONAL")
      set(__optional TRUE)
    elseif(TARGET ${__dependency})
      list(APPEND VISP_MODULE_${the_module}_DEPS ${__dependency})
    elseif(NOT __optional)
      message(FATAL_ERROR "The module ${the_module} needs ${__dependency}, which ViSP in ${VISP_DIR} does not have")
    endif()
  endforeach()
endmacro()

# vp_glob_module_sources(): src/** is private, include/visp3/<name>/*.h is public.
macro(vp_glob_module_sources)
  file(GLOB_RECURSE VISP_MODULE_${the_module}_SOURCES CONFIGURE_DEPENDS
       ${CMAKE_CURRENT_LIST_DIR}/src/*.cpp ${CMAKE_CURRENT_LIST_DIR}/src/*.h ${CMAKE_CURRENT_LIST_DIR}/src/*.hpp)
  file(GLOB VISP_MODULE_${the_module}_HEADERS CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/include/visp3/${name}/*.h)
endmacro()

# vp_module_include_directories(<extra folder>...)
macro(vp_module_include_directories)
  set(VISP_MODULE_${the_module}_INC_DEPS ${ARGN})
endmacro()

# vp_add_config_file(<template>.h.in): configures it into visp3/<name>/<template>.h.
macro(vp_add_config_file)
  foreach(__template ${ARGN})
    get_filename_component(__header ${__template} NAME)
    string(REGEX REPLACE "\\.(in|cmake)$" "" __header ${__header})
    configure_file(${CMAKE_CURRENT_LIST_DIR}/${__template} ${VISP_INCLUDE_DIR}/visp3/${name}/${__header})
    install(FILES ${VISP_INCLUDE_DIR}/visp3/${name}/${__header}
            DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/visp3/${name})
    list(APPEND VISP_MODULE_${the_module}_HEADERS ${VISP_INCLUDE_DIR}/visp3/${name}/${__header})
  endforeach()
endmacro()

# vp_create_module(<extra library>...): the target visp_<name>, its umbrella header visp3/visp_<name>.h, installation.
macro(vp_create_module)
  set(__includes "")
  foreach(__header ${VISP_MODULE_${the_module}_HEADERS})
    string(REGEX REPLACE "^.*/(visp3/.*)$" "\\1" __header ${__header})
    string(APPEND __includes "#include <${__header}>\n")
  endforeach()
  file(CONFIGURE OUTPUT ${VISP_INCLUDE_DIR}/visp3/${the_module}.h
       CONTENT "#ifndef __${the_module}_h_\n#define __${the_module}_h_\n\n${__includes}\n#endif\n")

  add_library(${the_module} SHARED ${VISP_MODULE_${the_module}_SOURCES} ${VISP_MODULE_${the_module}_HEADERS})
  target_link_libraries(${the_module} PUBLIC ${VISP_MODULE_${the_module}_DEPS} ${ARGN})
  target_include_directories(${the_module}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_LIST_DIR}/include> $<BUILD_INTERFACE:${VISP_INCLUDE_DIR}>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_LIST_DIR}/src)
  target_include_directories(${the_module} SYSTEM PUBLIC "$<BUILD_INTERFACE:${VISP_INCLUDE_DIRS}>"
                             PRIVATE ${VISP_MODULE_${the_module}_INC_DEPS})
  # As ViSP does: what is not marked VISP_EXPORT is hidden.
  target_compile_definitions(${the_module} PRIVATE visp_EXPORTS)
  set_target_properties(${the_module} PROPERTIES
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN OFF LINKER_LANGUAGE CXX
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib CIRCLE_MARKER_DESCRIPTION "${the_description}")

  set_property(GLOBAL APPEND PROPERTY CIRCLE_MARKER_MODULES ${the_module})
  install(TARGETS ${the_module} EXPORT CircleMarkerModules LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/include/visp3 DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.h")
  install(FILES ${VISP_INCLUDE_DIR}/visp3/${the_module}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/visp3)
endmacro()

# vp_add_tests(DEPENDS_ON <target>... [SOURCES_EXCLUDE <file in test/>...]): every test/**/*.cpp that is not excluded is a
# program and a test.
macro(vp_add_tests)
  cmake_parse_arguments(__test "" "" "DEPENDS_ON;SOURCES_EXCLUDE" ${ARGN})
  if(BUILD_TESTS)
    file(GLOB_RECURSE __tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/test/*.cpp)
    foreach(__source ${__test_SOURCES_EXCLUDE})
      list(REMOVE_ITEM __tests ${CMAKE_CURRENT_LIST_DIR}/test/${__source})
    endforeach()
    foreach(__source ${__tests})
      get_filename_component(__target ${__source} NAME_WE)
      add_executable(${__target} ${__source})
      target_link_libraries(${__target} ${the_module} ${__test_DEPENDS_ON})
      # ViSP runs every test so: without clicks (-c), without display (-d).
      add_test(NAME ${__target} COMMAND ${__target} -c -d)
    endforeach()
  endif()
endmacro()

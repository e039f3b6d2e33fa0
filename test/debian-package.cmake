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
# Packs the build for Debian, installs the package, builds a third party's project against it, and removes it again.
#
#############################################################################

# cmake -D BUILD_DIR=... -D WORK_DIR=... -D CXX_COMPILER=... -D CPACK=... -D DPKG=... -D LINTIAN=... -D PKG_CONFIG=...
#       -P ...
# LINTIAN, PKG_CONFIG: the programs; empty to leave them out. The package is installed below WORK_DIR, with a list of
# packages of its own: nothing of the system changes, and no rights are asked for.
cmake_minimum_required(VERSION 3.19)
include(${CMAKE_CURRENT_LIST_DIR}/install-consumer/use.cmake)

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
run(${CPACK} -G DEB --config ${BUILD_DIR}/CPackConfig.cmake -B ${WORK_DIR})
file(GLOB packages ${WORK_DIR}/*.deb)
list(LENGTH packages count)
if(NOT count EQUAL 1)
  message(FATAL_ERROR "cpack made ${count} packages instead of one: ${packages}")
endif()

if(LINTIAN)
  # Warnings are not errors (doc/decisions/one-debian-package.md).
  run(${LINTIAN} --fail-on error --allow-root ${packages})
endif()

# dpkg asks that ldconfig can be found, which an ordinary user's path leaves out; the package's scripts call it, and the
# system's must not be told of what is not there tomorrow.
set(root ${WORK_DIR}/root)
file(MAKE_DIRECTORY ${root}/var/lib/dpkg/info ${root}/var/lib/dpkg/updates ${root}/var/lib/dpkg/triggers)
file(WRITE ${root}/var/lib/dpkg/status "")
file(WRITE ${root}/var/lib/dpkg/available "")
file(WRITE ${WORK_DIR}/commands/ldconfig "#!/bin/sh\n")
file(CHMOD ${WORK_DIR}/commands/ldconfig PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
set(ENV{PATH} "${WORK_DIR}/commands:$ENV{PATH}:/usr/sbin:/sbin")
# The packages that it depends on are in the system's list.
set(dpkg ${DPKG} --root=${root} --force-not-root --force-depends --force-script-chrootless --log=${WORK_DIR}/dpkg.log)
run(${dpkg} --install ${packages})
run(${dpkg} --verify visp-circle-marker)
file(GLOB stray RELATIVE ${root} ${root}/*)
if(NOT stray STREQUAL "usr;var")
  message(FATAL_ERROR "the package has files outside of /usr: ${stray}")
endif()
file(GLOB programs RELATIVE ${root}/usr/bin ${root}/usr/bin/*)
file(GLOB pages RELATIVE ${root}/usr/share/man/man1 ${root}/usr/share/man/man1/*)
foreach(program ${programs})
  if(pages AND NOT "${program}.1.gz" IN_LIST pages)
    message(FATAL_ERROR "${program} has no manual page")
  endif()
endforeach()

file(GLOB_RECURSE config ${root}/usr/VISPConfig.cmake)
if(NOT config)
  message(FATAL_ERROR "the package has no VISPConfig.cmake")
endif()
get_filename_component(folder ${config} DIRECTORY)
# ViSP's own VISPConfig.cmake is in /usr as well, so the folder is named.
use_with_cmake(${WORK_DIR}/build ${CXX_COMPILER} VISP_DIR=${folder})
if(PKG_CONFIG)
  get_filename_component(libraries ${folder}/../.. ABSOLUTE) # <libraries>/cmake/visp-circle-marker
  use_with_pkg_config(${WORK_DIR}/with-pkg-config ${CXX_COMPILER} ${PKG_CONFIG} ${libraries})
endif()

run(${dpkg} --remove visp-circle-marker)
# Settings, if the package had any, would go with this only.
run(${dpkg} --purge visp-circle-marker)
file(GLOB left LIST_DIRECTORIES true RELATIVE ${root} ${root}/*)
if(NOT left STREQUAL "var")
  file(GLOB_RECURSE left RELATIVE ${root} ${root}/usr/*)
  message(FATAL_ERROR "the package, removed, leaves: ${left}")
endif()

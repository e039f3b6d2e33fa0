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
# The Debian package: cpack -G DEB in the build folder.
#
#############################################################################

# One package with the libraries, headers, CMake and pkg-config files and programs. Its dependencies are those of the
# libraries and programs (dpkg-shlibdeps), and ViSP's headers.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME visp-circle-marker)
set(CPACK_PACKAGE_VENDOR "The circular markers' maintainers")
set(CPACK_PACKAGE_CONTACT "Circular markers for ViSP <maintainers@visp-circle-marker.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "circular fiducial markers for the Visual Servoing Platform")
set(CPACK_PACKAGE_DESCRIPTION
    "Detects printed circular markers in the images of one camera, reads their
codes and computes their poses with a covariance. The package has the
ViSP modules visp_circle_marker and visp_circle_marker_simulator with
their headers, and programs that print markers, detect them, servo on
them and compare them with AprilTag.")
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_DEPENDS libvisp-dev)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The libraries of the package itself are not installed while their dependencies are looked for.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# What Debian wants beside the files: licence, changes, and the dynamic linker told of new libraries.
set(debian_folder ${CMAKE_BINARY_DIR}/cmake/debian)
find_program(GZIP_PROGRAM gzip)
mark_as_advanced(GZIP_PROGRAM)
if(GZIP_PROGRAM)
  string(TIMESTAMP CIRCLE_MARKER_DEBIAN_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
  configure_file(cmake/debian-changelog.in ${debian_folder}/changelog.Debian @ONLY)
  configure_file(cmake/debian-copyright.in ${debian_folder}/copyright @ONLY)
  # Without name and time in it, so that the same sources give the same file.
  execute_process(COMMAND ${GZIP_PROGRAM} -9nc ${debian_folder}/changelog.Debian
                  OUTPUT_FILE ${debian_folder}/changelog.Debian.gz)
  file(WRITE ${debian_folder}/triggers "activate-noawait ldconfig\n")
  file(CHMOD ${debian_folder}/triggers PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${debian_folder}/triggers)
  set(CPACK_CIRCLE_MARKER_DOCUMENTS ${debian_folder}/copyright ${debian_folder}/changelog.Debian.gz)
endif()
# The programs' manual pages are made of what they say to --help; left out where help2man is not there.
find_program(HELP2MAN_PROGRAM help2man)
mark_as_advanced(HELP2MAN_PROGRAM)
if(GZIP_PROGRAM AND HELP2MAN_PROGRAM)
  set(CPACK_CIRCLE_MARKER_HELP2MAN ${HELP2MAN_PROGRAM})
  set(CPACK_CIRCLE_MARKER_GZIP ${GZIP_PROGRAM})
  set(CPACK_CIRCLE_MARKER_LIBRARIES ${CMAKE_BINARY_DIR}/lib)
endif()
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/FinishDebianPackage.cmake)

include(CPack)

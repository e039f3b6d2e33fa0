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
# Target doc: the documentation as Doxygen makes it, into doc/html of the build folder.
#
#############################################################################

find_package(Doxygen QUIET)
find_program(BIBTEX_PROGRAM bibtex)
find_program(KPSEWHICH_PROGRAM kpsewhich)
mark_as_advanced(BIBTEX_PROGRAM KPSEWHICH_PROGRAM)
# Without the configuration that texlive-base has, Debian's bibtex finds no file, not even beside it.
set(bibtex_works ${BIBTEX_PROGRAM})
if(BIBTEX_PROGRAM AND KPSEWHICH_PROGRAM)
  execute_process(COMMAND ${KPSEWHICH_PROGRAM} -var-value BIBINPUTS OUTPUT_VARIABLE bibtex_works ERROR_QUIET
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
if(NOT DOXYGEN_FOUND OR bibtex_works MATCHES "^$|NOTFOUND$")
  message(STATUS "The target doc is left out: it needs Doxygen and a bibtex that works "
                 "(bash cmake/install-packages.sh doc)")
  return()
endif()

# Formulas are drawn by MathJax: that of the system, or the one on the network.
find_path(CIRCLE_MARKER_MATHJAX_FOLDER MathJax.js PATHS /usr/share/javascript/mathjax)
mark_as_advanced(CIRCLE_MARKER_MATHJAX_FOLDER)
set(CIRCLE_MARKER_MATHJAX "https://cdn.jsdelivr.net/npm/mathjax@2")
if(CIRCLE_MARKER_MATHJAX_FOLDER)
  set(CIRCLE_MARKER_MATHJAX "file://${CIRCLE_MARKER_MATHJAX_FOLDER}")
endif()
set(CIRCLE_MARKER_DOC_DIR ${CMAKE_BINARY_DIR}/doc)
configure_file(doc/mainpage.dox.in ${CIRCLE_MARKER_DOC_DIR}/mainpage.dox COPYONLY)
configure_file(doc/config-doxygen.in ${CIRCLE_MARKER_DOC_DIR}/config-doxygen @ONLY)
# "@INCLUDE" in it is Doxygen's.
configure_file(doc/config-doxygen-public.in ${CIRCLE_MARKER_DOC_DIR}/config-doxygen-public @ONLY)
add_custom_target(doc COMMAND ${DOXYGEN_EXECUTABLE} ${CIRCLE_MARKER_DOC_DIR}/config-doxygen-public
                  COMMAND ${DOXYGEN_EXECUTABLE} ${CIRCLE_MARKER_DOC_DIR}/config-doxygen
                  WORKING_DIRECTORY ${CIRCLE_MARKER_DOC_DIR} VERBATIM
                  COMMENT "Documentation: ${CIRCLE_MARKER_DOC_DIR}/html/index.html")

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
# The library circle_marker_tutorial_common: what several programs of tutorial/ and example/ share.
#
#############################################################################

# Tutorials and examples are separate projects, of which a build may have one or both, in any order.
if(TARGET circle_marker_tutorial_common)
  return()
endif()

# common/ of the tutorials but for its headers.
set(tutorial_folder ${CMAKE_CURRENT_LIST_DIR}/../tutorial/circle_marker)
file(GLOB shared_sources CONFIGURE_DEPENDS ${tutorial_folder}/common/*/*.cpp)
add_library(circle_marker_tutorial_common STATIC ${shared_sources})
target_include_directories(circle_marker_tutorial_common SYSTEM PRIVATE ${VISP_INCLUDE_DIRS})
target_link_libraries(circle_marker_tutorial_common ${VISP_LIBRARIES} CLI11::CLI11 nlohmann_json::nlohmann_json
                      Threads::Threads)
target_compile_features(circle_marker_tutorial_common PUBLIC cxx_std_17)
target_compile_options(circle_marker_tutorial_common PRIVATE -Wall -Wextra)

# Cameras that need more than ViSP: without these libraries the programs say what is missing.
# vp1394TwoGrabber hides what libdc1394 knows of the bus and of damaged images.
find_library(CIRCLE_MARKER_DC1394_LIBRARY dc1394)
mark_as_advanced(CIRCLE_MARKER_DC1394_LIBRARY)
if(CIRCLE_MARKER_DC1394_LIBRARY)
  target_link_libraries(circle_marker_tutorial_common ${CIRCLE_MARKER_DC1394_LIBRARY})
  target_compile_definitions(circle_marker_tutorial_common PRIVATE CIRCLE_MARKER_HAVE_LIBDC1394)
endif()
# ViSP's own grabber for OpenCV is for versions before 2.4.8, and its readers know fewer kinds of images and videos.
find_package(OpenCV QUIET COMPONENTS core OPTIONAL_COMPONENTS imgcodecs videoio)
if(TARGET opencv_videoio)
  target_link_libraries(circle_marker_tutorial_common opencv_core opencv_videoio)
  target_compile_definitions(circle_marker_tutorial_common PRIVATE CIRCLE_MARKER_HAVE_OPENCV_VIDEOIO)
endif()
if(TARGET opencv_imgcodecs)
  target_link_libraries(circle_marker_tutorial_common opencv_core opencv_imgcodecs)
  target_compile_definitions(circle_marker_tutorial_common PRIVATE CIRCLE_MARKER_HAVE_OPENCV_IMGCODECS)
endif()

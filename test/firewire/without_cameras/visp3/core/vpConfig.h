/*
 * Circular fiducial markers for ViSP, the Visual Servoing Platform.
 *
 * This software is free software; you can redistribute it and/or modify
 * it under the terms of the GNU General Public License as published by
 * the Free Software Foundation; either version 2 of the License, or
 * (at your option) any later version.
 * See the file LICENSE at the root directory of this source
 * distribution for additional information about the GNU GPL.
 *
 * This file is provided AS IS with NO WARRANTY OF ANY KIND, INCLUDING THE
 * WARRANTY OF DESIGN, MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE.
 *
 * Description:
 * ViSP's configuration as it is where no camera, no display and no AprilTag was found.
 */

// Another file of the same name: no guard of its own, the hidden one has one.
#include_next <visp3/core/vpConfig.h>

#undef VISP_HAVE_DC1394
#undef VISP_HAVE_V4L2
#undef VISP_HAVE_X11
#undef VISP_HAVE_OPENCV
#undef VISP_HAVE_DISPLAY
#undef VISP_HAVE_APRILTAG

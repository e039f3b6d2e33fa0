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
 * Uses the installed module as a third party would: every public header, the library, its settings.
 */

#include <cstdlib>
#include <iostream>
#include <vector>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/visp_circle_marker.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

int main()
{
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  const vpImage<unsigned char> white(480, 640, 255);
  const vpCameraParameters cam(600., 600., 319.5, 239.5);
  std::vector<vpHomogeneousMatrix> cMo;
  const double size = 0.180; // outer diameter of the ring, metres
  if (detector.detect(white, size, cam, cMo) || !cMo.empty()) {
    std::cerr << "install-consumer: a marker was found in a white image" << std::endl;
    return EXIT_FAILURE;
  }
  const std::vector<vpCircleMarkerFamily> families = vpCircleMarkerFamily::all();
  if (families.empty() || families.front().getNbIds() != 178) {
    std::cerr << "install-consumer: the first family is not golay23 with 178 markers" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "The installed detector works." << std::endl;
  return EXIT_SUCCESS;
}

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
 * The shortest program: the markers of an image and where they are. One file, with ViSP alone.
 */

/*!
  \example tutorial-circle-marker-image.cpp
*/

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpXmlParserCamera.h>
#include <visp3/gui/vpDisplayX.h>
#include <visp3/io/vpImageIo.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

int main(int argc, const char **argv)
{
  std::string input;
  std::string intrinsic;
  std::string cameraName;
  double size = 0.; // outer diameter of the black ring, metres
  bool isDisplayed = false;
  for (int i = 1; i < argc; i++) {
    std::string option = argv[i];
    if (option.rfind("--", 0) == 0) { // with underscores, too, as ViSP's own tutorials have it
      std::replace(option.begin(), option.end(), '_', '-');
    }
    if (option == "--input" && i + 1 < argc) {
      input = argv[++i];
    }
    else if (option == "--intrinsic" && i + 1 < argc) {
      intrinsic = argv[++i];
    }
    else if (option == "--camera-name" && i + 1 < argc) {
      cameraName = argv[++i];
    }
    else if (option == "--size" && i + 1 < argc) {
      size = std::atof(argv[++i]);
    }
    else if (option == "--display") {
      isDisplayed = true;
    }
    else if (option == "--help") {
      std::cout << "Finds circular markers in an image and prints where they are.\n"
                   "Usage: tutorial-circle-marker-image [OPTIONS]\n\n"
                   "Options:\n"
                   "  --input FILE        An image\n"
                   "  --intrinsic FILE    Cameras, XML of ViSP\n"
                   "  --camera-name NAME  Camera in that file, of which the model with distortion is taken\n"
                   "  --size FLOAT        Outer diameter of the black ring, metres\n"
                   "  --display           Shows the markers in a window, until it is clicked in\n"
                   "  --help              Says this\n";
      return EXIT_SUCCESS;
    }
    else {
      std::cerr << "tutorial-circle-marker-image: what is meant by " << option << "? see --help\n";
      return 2;
    }
  }
  if (input.empty() || intrinsic.empty() || cameraName.empty() || !(size > 0.)) {
    std::cerr
        << "tutorial-circle-marker-image: --input, --intrinsic, --camera-name and --size are needed; see --help\n";
    return 2;
  }
  try {
    vpImage<unsigned char> I;
    vpImageIo::read(I, input);

    vpCameraParameters cam;
    vpXmlParserCamera parser;
    if (parser.parse(cam, intrinsic, cameraName, vpCameraParameters::perspectiveProjWithDistortion) !=
        vpXmlParserCamera::SEQUENCE_OK) {
      std::cerr << "tutorial-circle-marker-image: there is no camera " << cameraName << " with distortion in "
                << intrinsic << "; check the names, or take tutorial-circle-marker-detector, which knows all models\n";
      return EXIT_FAILURE;
    }

    //! [Detect]
    vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
    std::vector<vpHomogeneousMatrix> cMo;
    detector.detect(I, size, cam, cMo);
    for (size_t i = 0; i < cMo.size(); i++) {
      const vpMatrix covariance = detector.getDetections()[i].covarianceAtMarker; // of (t, theta u), m and rad
      std::cout << detector.getMessage(i) << " at " << cMo[i].getTranslationVector().t() << " m, z to within "
                << 1000. * std::sqrt(covariance[2][2]) << " mm\n";
    }
    //! [Detect]

    if (isDisplayed) {
#ifdef VISP_HAVE_X11
      //! [Display]
      vpDisplayX display(I, 0, 0, "Circular markers");
      vpDisplay::display(I);
      detector.displayTags(I);
      detector.displayFrames(I, cMo, cam, size);
      vpDisplay::flush(I);
      vpDisplay::getClick(I);
      //! [Display]
#else
      std::cerr << "tutorial-circle-marker-image: ViSP has no windows here, it was built without X11\n";
#endif
    }
    return cMo.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
  }
  catch (const std::exception &e) { // vpException is one
    std::cerr << "tutorial-circle-marker-image: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}

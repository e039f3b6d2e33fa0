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
 * Camera files: writes those of ViSP, reads those of OpenCV and ROS.
 */

#ifndef VP_CALIBRATE_CAMERA_FILES_H
#define VP_CALIBRATE_CAMERA_FILES_H

#include <string>
#include <vector>

#include <Eigen/Core>

#include "lens.h"

namespace calibrate {
/*!
  Finds out before the work that a file has other cameras, which would be lost: it is written as a whole.
  \exception UsageError : If so.
*/
void checkCameraFile(const std::string &file, const std::string &name);

/*!
  Writes cameras into one file as vpXmlParserCamera does, whole or not at all; an older file is replaced.
  \param file : Its path.
  \param name : Of the camera.
  \param cameras : One for each model.
  \param width : Of the images, pixels.
  \param height : The same.
  \exception std::runtime_error : If it cannot be written.
*/
void writeCameras(const std::string &file, const std::string &name, const std::vector<vpCameraParameters> &cameras,
                  unsigned int width, unsigned int height);

/*! A camera of OpenCV's. */
struct ForeignCamera
{
  double fx = 0., fy = 0., cx = 0., cy = 0.;
  std::vector<double> distortion;
  bool isFisheye = false; //!< The coefficients are those of cv::fisheye, ROS's "equidistant".
  unsigned int width = 0;
  unsigned int height = 0;
};

/*!
  Reads a YAML file of OpenCV's calibration (camera_matrix, distortion_coefficients, image_width, image_height) or of
  ROS (the same with distortion_model).
  \exception std::runtime_error : If it cannot be used: what is missing.
*/
ForeignCamera readForeignCamera(const std::string &file);

/*! A camera of ViSP's in place of another one. */
struct Conversion
{
  Lens lens;
  double rms = 0.;      //!< Distance of the two cameras' images of the same ray over the image, pixels.
  double greatest = 0.; //!< The greatest such distance, pixels.
};

/*!
  The camera of a model whose images of the same rays differ least from another camera's, over the whole image.
  \exception std::runtime_error : If the camera has no rays there.
*/
Conversion convert(const ForeignCamera &camera, LensModel model);
} // namespace calibrate

#endif

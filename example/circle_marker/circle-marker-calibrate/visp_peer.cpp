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
 * ViSP's own calibration on the same pictures.
 */

#include "visp_peer.h"

#include <cmath>
#include <iostream>
#include <map>
#include <vector>

#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPoint.h>
#include <visp3/vision/vpCalibration.h>

#include "circle_marker/common/camera_file.h"

namespace calibrate {
namespace {
vpCalibration calibrationOf(const Target &target, const View &view)
{
  vpCalibration calibration;
  for (const Observation &o : view.observations) {
    const Eigen::Vector2d &place = target.points[o.point].place;
    vpImagePoint pixel(o.pixel.y(), o.pixel.x());
    calibration.addPoint(place.x(), place.y(), 0., pixel);
  }
  return calibration;
}

double squaredErrors(const Target &target, const View &view, const vpHomogeneousMatrix &cMo,
                     const vpCameraParameters &cam)
{
  double sum = 0.;
  for (const Observation &o : view.observations) {
    vpPoint point(target.points[o.point].place.x(), target.points[o.point].place.y(), 0.);
    point.track(cMo);
    double u = 0., v = 0.;
    vpMeterPixelConversion::convertPoint(cam, point.get_x(), point.get_y(), u, v);
    sum += (o.pixel - Eigen::Vector2d(u, v)).squaredNorm();
  }
  return sum;
}

/*! The views that can be calibrated alone, and the best camera of them, as calibrate-camera begins. */
std::vector<vpCalibration> alone(const Target &target, const std::vector<View> &views, std::vector<View> &used,
                                 vpCameraParameters &cam)
{
  cam.initPersProjWithoutDistortion(600., 600., views.front().width / 2., views.front().height / 2.);
  std::multimap<double, vpCameraParameters> known{{1000., cam}}; // the example's own beginning
  std::vector<vpCalibration> calibrations;
  for (const View &view : views) {
    vpCalibration calibration = calibrationOf(target, view);
    for (const auto &[residual, start] : known) {
      (void)residual;
      vpCameraParameters own = start;
      vpHomogeneousMatrix cMo;
      if (calibration.computeCalibration(vpCalibration::CALIB_VIRTUAL_VS, cMo, own, false) == EXIT_SUCCESS) {
        calibrations.push_back(calibration);
        used.push_back(view);
        known.emplace(calibration.getResidual(), own);
        break;
      }
    }
  }
  cam = known.begin()->second;
  return calibrations;
}
} // namespace

VispCalibration calibrateByVisp(const Target &target, const std::vector<View> &views, bool hasDistortion)
{
  const tutorial::SilentStream silentErrors(std::cerr), silentOutput(std::cout);
  VispCalibration result;
  try {
    vpCalibration::setLambda(0.5);
    std::vector<View> used;
    std::vector<vpCalibration> calibrations = alone(target, views, used, result.camera);
    double ownError = 0.;
    int status = calibrations.empty() ? EXIT_FAILURE
                                      : vpCalibration::computeCalibrationMulti(vpCalibration::CALIB_VIRTUAL_VS,
                                                                               calibrations, result.camera, ownError);
    if (status == EXIT_SUCCESS && hasDistortion) {
      status = vpCalibration::computeCalibrationMulti(vpCalibration::CALIB_VIRTUAL_VS_DIST, calibrations, result.camera,
                                                      ownError);
    }
    if (status != EXIT_SUCCESS || used.size() != views.size()) {
      result.problem = "vpCalibration did not converge on all views";
      return result;
    }
    double sum = 0., count = 0.;
    for (std::size_t v = 0; v < used.size(); ++v) {
      sum +=
          squaredErrors(target, used[v], hasDistortion ? calibrations[v].cMo_dist : calibrations[v].cMo, result.camera);
      count += static_cast<double>(used[v].observations.size());
    }
    result.rms = std::sqrt(sum / count);
  }
  catch (const vpException &e) {
    result.problem = std::string("vpCalibration failed: ") + e.what();
  }
  return result;
}
} // namespace calibrate

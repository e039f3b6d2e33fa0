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
 * Results of a calibration: table, JSON.
 */

#include "report.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "checks.h"
#include "common/numbers.h"

namespace calibrate {
namespace {
double sigmaOf(const Adjustment &a, int number)
{
  return std::sqrt(std::max(0., a.covariance(number, number)));
}

/*! "1600.02 +- 0.11", digits to a tenth of the standard deviation. */
std::string withSigma(double value, double sigma)
{
  const int places = sigma > 0. && std::isfinite(sigma)
                         ? std::max(0, std::min(9, 1 - static_cast<int>(std::floor(std::log10(sigma)))))
                         : 3;
  std::ostringstream text;
  text << std::fixed << std::setprecision(places) << value << " +- " << sigma;
  return text.str();
}

void addPeer(std::ostream &out, const std::string &name, const std::optional<VispCalibration> &peer)
{
  if (!peer) {
    return;
  }
  out << "  " << name << ": ";
  if (!peer->problem.empty()) {
    out << peer->problem << "\n";
    return;
  }
  const vpCameraParameters &cam = peer->camera;
  out << "rms " << common::digits(peer->rms) << " pixels; px " << cam.get_px() << ", py " << cam.get_py() << ", u0 "
      << cam.get_u0() << ", v0 " << cam.get_v0();
  if (cam.get_projModel() == vpCameraParameters::perspectiveProjWithDistortion) {
    out << ", kud " << cam.get_kud() << ", kdu " << cam.get_kdu();
  }
  out << "\n";
}

void addModel(std::ostream &out, const Report &report, const ModelReport &model)
{
  const Adjustment &a = model.calibration.adjustment;
  out << "\nmodel " << nameOf(model.model) << ": reprojection rms " << common::digits(a.rms()) << " pixels, "
      << a.points << " points in " << a.poses.size() << " views\n";
  const std::vector<std::string> names = a.lens.names();
  std::vector<double> errors;
  if (report.truth) {
    errors = errorsInSigmas(a, *report.truth);
  }
  for (std::size_t i = 0; i < names.size() && a.covariance.size() > 0; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    out << "  " << names[i] << "  " << withSigma(a.lens.numbers[k], sigmaOf(a, static_cast<int>(k)));
    if (!errors.empty()) {
      out << "   truth " << report.truth->numbers[k] << ", error " << common::digits(errors[i]) << " sigma";
    }
    out << "\n";
  }
  if (!errors.empty()) {
    out << "  all together: " << common::digits(errors.back()) << " sigma\n";
  }
  if (model.byEllipses) {
    const Adjustment &e = model.byEllipses->adjustment;
    out << "  with the ellipses' centres instead (up to " << common::digits(model.calibration.greatestOffset)
        << " pixels from the circles' centres): rms " << common::digits(e.rms()) << " pixels, px "
        << common::digits(e.lens.numbers[0] - a.lens.numbers[0]) << ", u0 "
        << common::digits(e.lens.numbers[2] - a.lens.numbers[2]) << ", v0 "
        << common::digits(e.lens.numbers[3] - a.lens.numbers[3]) << " pixels away";
    const std::vector<double> theirs = report.truth ? errorsInSigmas(e, *report.truth) : std::vector<double>();
    if (!theirs.empty()) {
      out << "; all together " << common::digits(theirs.back()) << " sigma from the truth";
    }
    out << "\n";
  }
  addPeer(out, "ViSP's vpCalibration on the same points", model.visp);
  addPeer(out, "ViSP's vpCalibration on the points of its own example", model.vispOwn);
  for (const std::string &remark : model.remarks) {
    out << "  note: " << remark << "\n";
  }
  for (const std::string &problem : model.problems) {
    out << "  refused: " << problem << "\n";
  }
}

nlohmann::json jsonOf(const Lens &lens)
{
  nlohmann::json json;
  const std::vector<std::string> names = lens.names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    json[names[i]] = lens.numbers[static_cast<Eigen::Index>(i)];
  }
  return json;
}

nlohmann::json jsonOf(const Report &report, const Calibration &calibration)
{
  const Adjustment &a = calibration.adjustment;
  nlohmann::json json{{"rms_pixels", a.rms()},
                      {"sigma_pixels", a.sigma()},
                      {"points", a.points},
                      {"left_out", calibration.leftOut},
                      {"condition", a.condition},
                      {"camera", jsonOf(a.lens)},
                      {"greatest_center_offset_pixels", calibration.greatestOffset}};
  const std::vector<std::string> names = a.lens.names();
  for (std::size_t i = 0; i < names.size() && a.covariance.size() > 0; ++i) {
    json["sigma"][names[i]] = sigmaOf(a, static_cast<int>(i));
  }
  constexpr Eigen::Index ofCamera = 4; // px, py, u0, v0, as vpDetectorCircleMarker::setCameraCovariance() takes them
  for (Eigen::Index i = 0; i < ofCamera && a.covariance.size() > 0; ++i) {
    const Eigen::Vector4d row = a.covariance.row(i).head<ofCamera>();
    json["cameraCovariance"].push_back({row[0], row[1], row[2], row[3]});
  }
  const ViewSpread spread = spreadOf(calibration.views, a);
  json["greatest_turn_degrees"] = spread.greatestTurn * 180. / M_PI;
  json["reach"] = spread.reach;
  if (report.truth && a.covariance.size() > 0) {
    json["errors_in_sigmas"] = errorsInSigmas(a, *report.truth);
  }
  const auto residuals = residualsOf(report.target, calibration.views, a);
  for (std::size_t v = 0; v < residuals.size(); ++v) {
    double sum = 0.;
    for (const Eigen::Vector2d &r : residuals[v]) {
      sum += r.squaredNorm();
    }
    json["views"].push_back({{"name", calibration.views[v].name},
                             {"points", residuals[v].size()},
                             {"rms_pixels", std::sqrt(sum / static_cast<double>(residuals[v].size()))}});
  }
  return json;
}

nlohmann::json jsonOf(const VispCalibration &visp)
{
  if (!visp.problem.empty()) {
    return {{"problem", visp.problem}};
  }
  const vpCameraParameters &cam = visp.camera;
  return {{"rms_pixels", visp.rms}, {"px", cam.get_px()},   {"py", cam.get_py()},  {"u0", cam.get_u0()},
          {"v0", cam.get_v0()},     {"kud", cam.get_kud()}, {"kdu", cam.get_kdu()}};
}
} // namespace

std::vector<double> errorsInSigmas(const Adjustment &adjustment, const Lens &truth)
{
  if (truth.model != adjustment.lens.model || adjustment.covariance.size() == 0) {
    return {};
  }
  const Eigen::VectorXd error = adjustment.lens.numbers - truth.numbers;
  std::vector<double> errors;
  for (int i = 0; i < error.size(); ++i) {
    errors.push_back(error[i] / sigmaOf(adjustment, i));
  }
  const double squared = error.dot(adjustment.covariance.inverse() * error);
  errors.push_back(std::sqrt(squared / static_cast<double>(error.size())));
  return errors;
}

std::string tableOf(const Report &report)
{
  std::ostringstream out;
  const std::size_t seen = report.models.empty() ? 0 : report.models.front().calibration.views.size();
  out << report.target.name() << " of " << report.target.points.size() << " points, found in " << seen << " of "
      << report.pictures << " pictures of " << report.width << " x " << report.height << " pixels\n";
  for (const ModelReport &model : report.models) {
    addModel(out, report, model);
  }
  return out.str();
}

std::string jsonOf(const Report &report)
{
  nlohmann::json json{{"target", report.target.name()},
                      {"pictures", report.pictures},
                      {"width", report.width},
                      {"height", report.height}};
  if (report.truth) {
    json["truth"] = jsonOf(*report.truth);
  }
  for (const ModelReport &model : report.models) {
    nlohmann::json entry = jsonOf(report, model.calibration);
    entry["model"] = nameOf(model.model);
    entry["problems"] = model.problems;
    entry["remarks"] = model.remarks;
    if (model.byEllipses) {
      entry["by_ellipse_centers"] = jsonOf(report, *model.byEllipses);
    }
    if (model.visp) {
      entry["visp_same_points"] = jsonOf(*model.visp);
    }
    if (model.vispOwn) {
      entry["visp_own_points"] = jsonOf(*model.vispOwn);
    }
    json["models"].push_back(entry);
  }
  return json.dump(2) + "\n";
}
} // namespace calibrate

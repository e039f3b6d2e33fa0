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
 * A fitter whose fits end as a test says.
 */

#ifndef VP_TEST_SCRIPTED_FITTER_H
#define VP_TEST_SCRIPTED_FITTER_H

#include <functional>
#include <optional>
#include <vector>

#include "refine/fitter.h"

namespace room_test {
/*!
  A fitter that looks at no pixels: what it finds from a start is what the test says, so that what is made of fits can
  be tested at every limit.
*/
class ScriptedFitter : public circle_marker::Fitter
{
public:
  //! A fit that was asked for.
  struct Asked
  {
    circle_marker::FitStart start;
    circle_marker::FitSettings settings;
    circle_marker::MarkerPattern pattern;
  };

  //! How a fit was judged against others.
  struct Judged
  {
    circle_marker::Photometry surround;
    double noise;
  };

  using Script = std::function<std::optional<circle_marker::FittedPose>(const Asked &)>;

  explicit ScriptedFitter(Script script) : m_script(std::move(script)) {}

  void selectPixels(const vpImage<unsigned char> &, const circle_marker::CameraModel &,
                    const circle_marker::ImageFrame &, const circle_marker::MarkerPlane *, std::size_t,
                    const circle_marker::MarkerPattern &, const circle_marker::PixelChoice &,
                    std::vector<circle_marker::FitPixel> &pixels) override
  {
    pixels.clear();
  }

  std::optional<circle_marker::FittedPose> fitPose(const std::vector<circle_marker::FitPixel> &,
                                                   const circle_marker::FitStart &start,
                                                   const circle_marker::MarkerPattern &pattern,
                                                   const circle_marker::FitSettings &settings) override
  {
    asked.push_back({start, settings, pattern});
    return m_script(asked.back());
  }

  //! What the script gave it, and moreSquares.
  double robustSquares(const std::vector<circle_marker::FitPixel> &, const circle_marker::FittedPose &fit,
                       const circle_marker::MarkerPattern &, const circle_marker::Photometry &surround, double noise,
                       bool) override
  {
    judged.push_back({surround, noise});
    return fit.squares + (moreSquares ? moreSquares(fit) : 0.);
  }

  void explainPixels(const std::vector<circle_marker::FitPixel> &, const circle_marker::FittedPose &,
                     const circle_marker::MarkerPattern &,
                     std::vector<circle_marker::ExplainedPixel> &explained) override
  {
    explained = explains;
  }

  std::function<double(const circle_marker::FittedPose &)> moreSquares; //!< Where a fit is judged against others.

  std::vector<circle_marker::ExplainedPixel> explains; //!< What pixels show, if it is asked how a fit explains them.

  std::vector<Asked> asked;
  std::vector<Judged> judged;

private:
  Script m_script;
};

//! A fit that has ended where it started and explains the image, in noise of 2 grey levels.
inline circle_marker::FittedPose fitAt(const circle_marker::FitStart &start)
{
  circle_marker::FittedPose fit;
  fit.plane = start.plane;
  if (start.photometry) {
    fit.photometry = *start.photometry;
  }
  fit.squares = 1000.;
  fit.noise = 2.;
  fit.inliers = 0.95;
  fit.correlation = 0.98;
  fit.isSettled = true;
  fit.covariance = 1e-8 * Eigen::Matrix<double, 6, 6>::Identity();
  return fit;
}
} // namespace room_test

#endif

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
 * Fits poses to pixels with the widest instructions that the processor has.
 */

/*!
  \file fitter.h
  \brief The work on pixels that is compiled for several processors (lanes.h), behind one interface.
*/

#ifndef VP_CIRCLE_MARKER_FITTER_H
#define VP_CIRCLE_MARKER_FITTER_H

#include <memory>
#include <optional>
#include <vector>

#include "refine/fit_pixel.h"
#include "refine/fitted_pose.h"
#include "refine/shadow_split.h"
#include "support/camera_model.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Chooses pixels, fits poses to them and compares fits; with working memory that is used again. */
class Fitter
{
public:
  Fitter() = default;
  Fitter(const Fitter &) = delete;
  Fitter &operator=(const Fitter &) = delete;
  virtual ~Fitter() = default;

  /*! See circle_marker::selectPixels(). */
  virtual void selectPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                            const MarkerPlane *planes, std::size_t count, const MarkerPattern &pattern,
                            const PixelChoice &choice, std::vector<FitPixel> &pixels) = 0;

  /*! See circle_marker::fitPose(). */
  virtual std::optional<FittedPose> fitPose(const std::vector<FitPixel> &pixels, const FitStart &start,
                                            const MarkerPattern &pattern, const FitSettings &settings) = 0;

  /*! See circle_marker::robustSquares(). */
  virtual double robustSquares(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                               const Photometry &surround, double noise, bool exactBends) = 0;

  /*! See circle_marker::explainPixels(). */
  virtual void explainPixels(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                             std::vector<ExplainedPixel> &explained) = 0;
};

/*! Instructions that code on lanes is compiled for. */
enum class Instructions
{
  PLAIN, //!< What every processor of the kind has.
  WIDE,  //!< AVX2 and FMA.
  WIDEST //!< AVX-512, as processors since 2019 have it.
};

/*! A fitter with the given instructions; nothing if the processor, or this build, does not have them. */
std::unique_ptr<Fitter> makeFitter(Instructions instructions);

/*! A fitter with the widest instructions there are. */
std::unique_ptr<Fitter> makeFitter();

/*! What poses are fitted with, used again from one marker to the next. A copy has a memory of its own. */
struct FittingMemory
{
  FittingMemory() = default;
  FittingMemory(const FittingMemory &) {}
  FittingMemory &operator=(const FittingMemory &) { return *this; }

  std::vector<FitPixel> pixels;                  //!< The pixels that are explained.
  std::vector<ExplainedPixel> explained;         //!< The pixels as a fit explains them.
  std::unique_ptr<Fitter> fitter = makeFitter(); //!< What fits poses to them.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif

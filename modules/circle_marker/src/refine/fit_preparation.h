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
 * The pixels of a fit, prepared for the pose, the blur and the light that it has come to.
 */

/*!
  \file fit_preparation.h
  \brief The pixels of a fit, prepared for the pose, the blur and the light that it has come to.
*/

#ifndef VP_CIRCLE_MARKER_FIT_PREPARATION_H
#define VP_CIRCLE_MARKER_FIT_PREPARATION_H

#include <vector>

#include "refine/likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*!
  The pixels as they are prepared for a fit: sorted by what they see, strong bends corrected, the surround judged. All
  that depends on the pose, the blur and the light, but little, so that it is done again only now and then.
*/
class FitPreparation
{
public:
  FitPreparation(const std::vector<FitPixel> &pixels, const FitSettings &settings, Likelihood &fit,
                 const FitMemory &memory);

  /*! Only sorts, for what comes before light and noise are known (noise 0: not at all). */
  void sort(const MarkerPlane &plane, const Photometry &photometry, double noise);

  /*! Sorts, corrects and judges. */
  void prepare(const MarkerPlane &plane, const Photometry &photometry, double noise);

  /*! Whether pixels may see other edges by now, or other light. */
  bool isStale(const MarkerPlane &plane, const Photometry &photometry, double noise) const;

  /*! Whether a fit that is done wants a better preparation for its last steps. */
  bool isRough(const MarkerPlane &plane, const Photometry &photometry) const;

private:
  double motion(const MarkerPlane &from, const MarkerPlane &to) const; // pixels
  bool isWider(const Photometry &photometry) const;
  bool hasOtherEdges(const MarkerPlane &plane, const Photometry &photometry) const; // than those that were corrected

  const std::vector<FitPixel> &m_pixels; //!< What is explained.
  const double m_sortAgain;              //!< Motion of the outline from which on pixels may see other edges, pixels.
  Likelihood &m_fit;                     //!< Has the pixels as they are sorted.
  const FitMemory &m_memory;             //!< Its memory.
  bool m_hasPixels;                      //!< Whether those in the memory are these.
  MarkerPlane m_sorted;                  //!< Where they were sorted.
  double m_sortedBlur = 0.;              //!< With which blur, pixels; 0 before.
  bool m_isCorrected = false;            //!< Whether edges are corrected as the pixels are sorted.
  MarkerPlane m_corrected;               //!< Where.
  double m_correctedBlur = 0.;           //!< For which blur, pixels.
  Shadow m_correctedShadow;              //!< And which shadow, if there is one.
  bool m_isBent = false;                 //!< Whether any is.
  Photometry m_judged;                   //!< The light in which the surround was judged.
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif

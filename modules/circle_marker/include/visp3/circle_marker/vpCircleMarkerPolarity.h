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
 * Whether markers are black on white or white on black.
 */

/*!
  \file vpCircleMarkerPolarity.h
  \brief Whether markers are black on white or white on black.
*/

#ifndef VP_CIRCLE_MARKER_POLARITY_H
#define VP_CIRCLE_MARKER_POLARITY_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_circle_marker
  \brief Which markers are looked for: see vpDetectorCircleMarker::setPolarity().
*/
enum class vpCircleMarkerPolarity
{
  BLACK_ON_WHITE, //!< As they are printed by default.
  WHITE_ON_BLACK, //!< Inverse: what is black is white and the other way round, the quiet zone is black.
  BOTH            //!< Either, which takes twice the time.
};

END_VISP_NAMESPACE

#endif

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
 * Names of the reasons why a candidate was not taken for a marker.
 */

#include <visp3/circle_marker/vpCircleMarkerReject.h>

BEGIN_VISP_NAMESPACE

std::string vpCircleMarkerRejectName(vpCircleMarkerReject reason)
{
  using Reject = vpCircleMarkerReject;
  // No default: compilers tell of a reason that was forgotten.
  switch (reason) {
  case Reject::NONE:
    return "none";
  case Reject::TOO_SHORT:
    return "too short";
  case Reject::LITTLE_BEND:
    return "little bend";
  case Reject::BRIGHT_INSIDE:
    return "bright inside";
  case Reject::NOT_AN_ELLIPSE:
    return "not an ellipse";
  case Reject::BAD_FIT:
    return "bad fit";
  case Reject::LITTLE_SUPPORT:
    return "little support";
  case Reject::NOT_DARK_INSIDE:
    return "not dark inside";
  case Reject::OTHER_CENTER:
    return "other centre";
  case Reject::KNOWN_OUTLINE:
    return "known outline";
  case Reject::NO_POSE:
    return "no pose";
  case Reject::INSIDE_OF_A_MARKER:
    return "inside of a marker";
  case Reject::TOO_SMALL:
    return "too small";
  case Reject::OUT_OF_IMAGE:
    return "out of image";
  case Reject::NO_RING:
    return "no ring";
  case Reject::OTHER_SHAPE:
    return "other shape";
  case Reject::NOT_ALL_AROUND:
    return "not all around";
  case Reject::NO_SECTORS:
    return "no sectors";
  case Reject::NO_CODEWORD:
    return "no codeword";
  case Reject::MIRRORED:
    return "mirrored";
  case Reject::LOW_MARGIN:
    return "low margin";
  case Reject::UNLIKE_THE_MODEL:
    return "unlike the model";
  case Reject::TOO_MANY:
    return "too many";
  case Reject::TIMEOUT:
    return "timeout";
  }
  return "unknown";
}

END_VISP_NAMESPACE

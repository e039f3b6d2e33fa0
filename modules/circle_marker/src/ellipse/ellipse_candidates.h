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
 * Ellipses that may be the outer edge of a marker.
 */

#ifndef VP_CIRCLE_MARKER_ELLIPSE_CANDIDATES_H
#define VP_CIRCLE_MARKER_ELLIPSE_CANDIDATES_H

#include "ellipse/ellipse_search.h"
#include "support/workers.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Finds the ellipses among the edge chains of an image. A closed chain is fitted as it is; the others are cut where they
  bend the wrong way or sharply, and the ellipse fitted to an arc, or else to two arcs with something between them, is
  completed by searching its whole outline for edges. Where an ellipse is so narrow that it bends sharply itself, at its
  tips, it is put together from these, or from the dark dots that its ring has there.
  The chains are shared among the workers; the result does not depend on their number.
  \param I : The image.
  \param gradient : Its gradient.
  \param chains : Its edge chains.
  \param sought : What the markers have inside.
  \param other : Chains that lie on outlines known at another scale are left out.
  \param workers : Threads.
  \param deadline : When to stop; what is found by then is kept.
  \param memory : Working memory; memory.known has the ellipses, no two of the same outline.
*/
void findEllipses(const vpImage<unsigned char> &I, const Gradient &gradient, const EdgeChains &chains,
                  const SoughtCenters &sought, const OtherScale &other, Workers &workers, const Deadline &deadline,
                  EllipseMemory &memory);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif

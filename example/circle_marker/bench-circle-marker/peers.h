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
 * What others take for a frame: ViSP's AprilTag, OpenCV's threshold and edges.
 */

#ifndef VP_BENCH_PEERS_H
#define VP_BENCH_PEERS_H

#include <functional>
#include <string>
#include <vector>

#include "scenes.h"

namespace bench {
/*! Something that looks at a frame; its working memory is kept from frame to frame. */
struct Peer
{
  std::string name;
  std::function<void(const Scene &)> look;
};

/*! This project's detector for golay23. */
Peer circleMarker(unsigned int threads = 1, bool refine = true);

/*!
  The same, following its markers from frame to frame; one that is looked at again and again stays where it is, so that
  only regions are searched.
*/
Peer trackingCircleMarker(bool refine);

/*! The others that this machine has: AprilTag at decimations 1 and 2 (one thread), adaptive threshold, Canny. */
std::vector<Peer> peers();
} // namespace bench

#endif

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
 * Benchmarks of the whole detection: kinds of frames, sizes, numbers of markers, hard images, threads.
 */

#ifndef VP_BENCH_REGISTER_H
#define VP_BENCH_REGISTER_H

namespace bench {
/*! Registers the benchmarks of whole frames, with the peers' beside them. */
void registerWholeFrames();

/*! Registers the benchmarks of the rooms of the detector, each on its own. */
void registerRooms();
} // namespace bench

#endif

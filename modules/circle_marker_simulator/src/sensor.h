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
 * From the light on the sensor to grey levels: illumination, gamma, noise, 8 bits.
 */

#ifndef VP_SIMULATOR_SENSOR_H
#define VP_SIMULATOR_SENSOR_H

#include <cstdint>

#include <visp3/core/vpImage.h>

#include <visp3/circle_marker_simulator/vpScenePhotometry.h>

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! Multiplies each pixel with the light that falls there, but for shadows (see vpScenePhotometry).
void illuminate(const vpScenePhotometry &photometry, vpImage<float> &I);

//! Adds to each pixel what is reflected there.
void reflect(const vpSceneReflection &reflection, vpImage<float> &I);

//! Applies the sensor's gamma; does nothing for 1.
void applyGamma(double gamma, vpImage<float> &I);

//! Adds noise of the standard deviation `sigma`, in grey levels, rounds and clamps to 8 bits.
void quantise(const vpImage<float> &exact, double sigma, std::uint64_t seed, vpImage<unsigned char> &I);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif

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
 * What is behind the markers of a simulated scene.
 */

/*!
  \file vpSceneBackground.h
  \brief What is behind the markers of a simulated scene.
*/

#ifndef VP_SCENE_BACKGROUND_H
#define VP_SCENE_BACKGROUND_H

#include <cstdint>
#include <optional>

#include <visp3/core/vpImage.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE

/*!
  \class vpSceneBackground
  \ingroup group_circle_marker_simulator
  \brief Background of a scene: one grey level, a photograph, or clutter drawn at random from a seed.

  A photograph is stretched to the size of the image and taken as it is, with its own blur. Clutter is a gradient
  strewn with polygons, discs, rings, bars, thin lines and strokes as of writing, seen through the camera's blur.
*/
class VISP_EXPORT vpSceneBackground
{
public:
  static vpSceneBackground plain(double grey);
  static vpSceneBackground photo(const vpImage<unsigned char> &picture);
  static vpSceneBackground clutter(std::uint64_t seed, unsigned int shapes = 120);

  /*! Grey level of a plain background, under the reference light. */
  double getGrey() const { return m_grey; }
  /*! The photograph; of size 0 for another background. */
  const vpImage<unsigned char> &getPhoto() const { return m_photo; }
  /*! Seed of the clutter; empty for another background. */
  const std::optional<std::uint64_t> &getClutterSeed() const { return m_clutterSeed; }
  /*! Number of shapes of the clutter. */
  unsigned int getClutterShapes() const { return m_clutterShapes; }

private:
  vpSceneBackground() = default;

  double m_grey = 110.;                       //!< Grey level of a plain background.
  vpImage<unsigned char> m_photo;             //!< Photograph.
  std::optional<std::uint64_t> m_clutterSeed; //!< Seed of the clutter.
  unsigned int m_clutterShapes = 0;           //!< Number of shapes of the clutter.
};

END_VISP_NAMESPACE

#endif

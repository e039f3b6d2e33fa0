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

#include <visp3/core/vpException.h>

#include <visp3/circle_marker_simulator/vpSceneBackground.h>

BEGIN_VISP_NAMESPACE

/*! The same grey level everywhere. */
vpSceneBackground vpSceneBackground::plain(double grey)
{
  vpSceneBackground background;
  background.m_grey = grey;
  return background;
}

/*!
  A photograph, stretched to the size of the image.
  \param picture : its grey levels.
  \exception vpException::badValue : the picture is empty.
*/
vpSceneBackground vpSceneBackground::photo(const vpImage<unsigned char> &picture)
{
  if (picture.getSize() == 0) {
    throw vpException(vpException::badValue, "an empty picture cannot be a background");
  }
  vpSceneBackground background;
  background.m_photo = picture;
  return background;
}

/*! Clutter. \param seed : the same seed gives the same clutter. \param shapes : number of shapes. */
vpSceneBackground vpSceneBackground::clutter(std::uint64_t seed, unsigned int shapes)
{
  vpSceneBackground background;
  background.m_clutterSeed = seed;
  background.m_clutterShapes = shapes;
  return background;
}

END_VISP_NAMESPACE

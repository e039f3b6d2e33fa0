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
 * Light, lens blur and sensor of the simulated camera.
 */

/*!
  \file vpScenePhotometry.h
  \brief Light, lens blur and sensor of the simulated camera.
*/

#ifndef VP_SCENE_PHOTOMETRY_H
#define VP_SCENE_PHOTOMETRY_H

#include <optional>

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpImagePoint.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE

/*!
  \struct vpSceneShadow
  \ingroup group_circle_marker_simulator
  \brief A shadow with a straight edge: the light is multiplied by \e factor on one side of it.

  It falls on sheets and occluders before the lens blurs their image: where it crosses an edge of the print, the
  product of both is blurred. Of the background, and with a penumbra of more than 30 pixels of all, it multiplies
  pixels. With d = (u - u_e) cos(direction) + (v - v_e) sin(direction), in pixels, the light is multiplied by 1 - (1 -
  factor) Phi(d / penumbra), Phi being the normal distribution function.
*/
struct vpSceneShadow
{
  vpImagePoint edge;     //!< A point of the edge, in pixels.
  double direction = 0.; //!< Direction from the lit to the dark side, in radians from +u toward +v.
  double factor = 0.5;   //!< Light that is left in the shadow, 1: all of it.
  double penumbra = 2.;  //!< Softness of the edge, standard deviation in pixels.
};

/*!
  \struct vpSceneReflection
  \ingroup group_circle_marker_simulator
  \brief A lamp's soft reflection on a glossy surface: it adds to the light of paper and ink alike.

  At the distance r from its centre, in pixels, grey exp(-r^2 / (2 radius^2)) is added, at the pixel's centre: it is to
  be far wider than the lens' blur.
*/
struct vpSceneReflection
{
  vpImagePoint center; //!< Where it is brightest, in pixels.
  double radius = 30.; //!< Standard deviation of its Gaussian shape, in pixels.
  double grey = 60.;   //!< Grey level that it adds there under the reference light.
};

/*!
  \struct vpScenePhotometry
  \ingroup group_circle_marker_simulator
  \brief What turns a scene's geometry into grey levels, in the order in which a camera does it.

  1. Reflectance: paper, ink, background and occluders, as the grey level each would give under the reference light, and
     the shadow that falls on them.
  2. Motion during the exposure, blur of the lens (Gaussian and defocus disc), integration over the square pixels.
  3. Light, at the pixel's centre: L(u, v) = 1 + gradientU (u - u_c) / width + gradientV (v - v_c) / height,
     where (u_c, v_c) is \e lightCenter or else the image's centre; and what a glossy surface reflects.
  4. Gamma: grey = 255 (grey / 255)^gamma, after clamping to 0 ... 255; 1 is a linear sensor.
  5. Noise, independent in each pixel, then rounding and clamping to 8 bits.
  6. The loss of JPEG compression.

  The defaults are the reference camera of this project's figures.
*/
struct vpScenePhotometry
{
  double paper = 220.;                         //!< Grey level of white paper.
  double ink = 30.;                            //!< Grey level of black ink; the contrast is paper - ink.
  double blurSigma = 0.7;                      //!< Standard deviation of the Gaussian blur, in pixels.
  double defocusRadius = 0.;                   //!< Radius of the defocus disc, in pixels.
  double gradientU = 0.;                       //!< Relative change of the light over the image's width.
  double gradientV = 0.;                       //!< Relative change of the light over the image's height.
  std::optional<vpImagePoint> lightCenter;     //!< Where the gradient leaves the light unchanged; empty: image centre.
  std::optional<vpSceneShadow> shadow;         //!< Shadow with a straight edge.
  std::optional<vpSceneReflection> reflection; //!< A lamp's soft reflection, on all that is in the image.
  double gamma = 1.;                           //!< Exponent of the sensor's response.
  double noiseSigma = 2.;                      //!< Standard deviation of the noise, in grey levels.
  std::optional<int> jpegQuality;              //!< Quality of JPEG compression, 1 to 100; empty: no compression.
};

/*!
  \struct vpSceneMotion
  \ingroup group_circle_marker_simulator
  \brief Motion of the camera during the exposure.

  The camera moves at a constant velocity, and the markers' poses are those at the middle of the exposure:
  at the instant s from -1/2 to 1/2 of the exposure cMo(s) = exp(-s twist) cMo. Background and occluders, which are
  given in the image, stand still in it.
*/
struct vpSceneMotion
{
  vpColVector twist = vpColVector(6, 0.); //!< Velocity (camera frame) times exposure: metres, then radians.
  unsigned int steps = 0;                 //!< Instants averaged (midpoint rule); 0: one for each quarter pixel.
};

END_VISP_NAMESPACE

#endif

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
 * Simulated camera that looks at printed markers.
 */

/*!
  \file vpMarkerSceneSimulator.h
  \brief Simulated camera that looks at printed markers.
*/

#ifndef VP_MARKER_SCENE_SIMULATOR_H
#define VP_MARKER_SCENE_SIMULATOR_H

#include <cstdint>
#include <memory>
#include <vector>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>
#include <visp3/circle_marker_simulator/vpMarkerTruth.h>
#include <visp3/circle_marker_simulator/vpSceneBackground.h>
#include <visp3/circle_marker_simulator/vpSceneOccluder.h>
#include <visp3/circle_marker_simulator/vpScenePhotometry.h>
#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

BEGIN_VISP_NAMESPACE

namespace marker_simulator {
class PixelResponse;
}

/*!
  \class vpMarkerSceneSimulator
  \ingroup group_circle_marker_simulator
  \brief Simulated camera: images of printed markers, exact to a small part of a grey level, with their ground truth.

  Integer pixel coordinates are pixel centres: pixel (u, v) integrates the light over
  [u - 1/2, u + 1/2] x [v - 1/2, v + 1/2]. The markers' outlines are projected point by point through the camera's
  model, and blur and pixel are integrated along these outlines (divergence theorem), not sampled. With lens distortion
  the image is the one that vpPixelMeterConversion undoes exactly: that is the direction an estimator uses, and ViSP's
  two directions are not exact inverses of one another.

  Later markers cover earlier ones, occluders cover all markers. A marker seen from behind is a blank sheet. The same
  scene and seed give the same bytes on every run.

  \code
  vpMarkerSceneSimulator simulator(cam, 1280, 960);
  simulator.addMarker(vpSimulatedMarker::circle("golay23", 5, 0.18).setPose(cMo));
  vpImage<unsigned char> I;
  std::vector<vpMarkerTruth> truth = simulator.render(I, 42);
  \endcode
*/
class VISP_EXPORT vpMarkerSceneSimulator
{
public:
  vpMarkerSceneSimulator(const vpCameraParameters &cam, unsigned int width, unsigned int height);

  void setPhotometry(const vpScenePhotometry &photometry);
  void setBackground(const vpSceneBackground &background);
  void setMotion(const vpSceneMotion &motion);

  unsigned int addMarker(const vpSimulatedMarker &marker);
  void setMarkerPose(unsigned int index, const vpHomogeneousMatrix &cMo);
  void clearMarkers();
  void addOccluder(const vpSceneOccluder &occluder);
  void clearOccluders();

  std::vector<vpMarkerTruth> render(vpImage<unsigned char> &I, std::uint64_t seed) const;
  void renderNoiseFree(vpImage<float> &I) const;
  std::vector<vpMarkerTruth> getTruth() const;

  vpImagePoint project(double X, double Y, double Z) const;

  /*! Camera parameters. */
  const vpCameraParameters &getCameraParameters() const { return m_cam; }
  /*! Light, blur and sensor. */
  const vpScenePhotometry &getPhotometry() const { return m_photometry; }
  /*! Markers, in the order in which they were added. */
  const std::vector<vpSimulatedMarker> &getMarkers() const { return m_markers; }
  /*! Width of the images, in pixels. */
  unsigned int getWidth() const { return m_width; }
  /*! Height of the images, in pixels. */
  unsigned int getHeight() const { return m_height; }

private:
  void drawBackground();

  vpCameraParameters m_cam;                                          //!< Camera parameters.
  unsigned int m_width;                                              //!< Width of the images, in pixels.
  unsigned int m_height;                                             //!< Height of the images, in pixels.
  vpScenePhotometry m_photometry;                                    //!< Light, blur and sensor.
  vpSceneBackground m_background;                                    //!< Background, as asked for.
  vpSceneMotion m_motion;                                            //!< Motion during the exposure.
  std::vector<vpSimulatedMarker> m_markers;                          //!< Markers, from the back to the front.
  std::vector<vpSceneOccluder> m_occluders;                          //!< Occluders, from the back to the front.
  std::shared_ptr<const marker_simulator::PixelResponse> m_response; //!< Blur and pixel; never changed once built.
  vpImage<float> m_backgroundImage; //!< Background as grey levels under the reference light.
};

END_VISP_NAMESPACE

#endif

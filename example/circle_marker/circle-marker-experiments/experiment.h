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
 * An experiment: series of frames, each seen by several methods.
 */

#ifndef VP_EXPERIMENTS_EXPERIMENT_H
#define VP_EXPERIMENTS_EXPERIMENT_H

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker_simulator/vpScenePhotometry.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include "common/visp_names.h"
#include "design.h"
#include "method.h"
#include "settings.h"
#include "thesis_figures.h"

namespace experiments {
/*! A part of the marker that something opaque covers: all beyond a line across the disc of the ring. */
struct Cover
{
  double share;     //!< Of the disc's area.
  double direction; //!< Of the covered side, radians from the marker's x axis toward its y axis.
  double grey;      //!< Grey level of what covers it.
};

/*! All that makes one image but the kind of marker. */
struct Scene
{
  std::optional<vpHomogeneousMatrix> cMo;   //!< Pose of the marker, z into it, metres; nothing: no marker.
  vpCameraParameters cam;                   //!< Camera.
  vpScenePhotometry photometry;             //!< Light, blur, noise.
  vpSceneMotion motion;                     //!< During the exposure.
  std::optional<Cover> cover;               //!< What covers the marker.
  std::optional<Design> design;             //!< Of the marker, unless it is the default.
  std::optional<std::uint64_t> clutterSeed; //!< Clutter behind the marker; a plain grey ground without.
};

/*! Frames of one kind. */
struct Series
{
  std::string name;            //!< In files; no comma, no blank.
  std::string title;           //!< For people.
  std::string group;           //!< Series of a group are the points of one curve.
  double level = 0.;           //!< What the points are drawn against.
  unsigned int frames = 0;     //!< How many.
  std::vector<Method> methods; //!< Each sees every frame, but for bound and limit, which take long.
  unsigned int kinds = 1;      //!< Frames go in turn through so many kinds of poses.
  //! The scene of a frame. All that is random must come from the seed, which is that of the frame.
  std::function<Scene(unsigned int frame, std::uint64_t seed)> scene;
  //! Series with the same stream have the same seeds, hence the same poses: their differences are paired.
  std::uint64_t stream = 0;
  const ThesisFigures *thesis = nullptr; //!< What the thesis has of such frames, if it has it.
};

struct Experiment
{
  std::string name;           //!< Of its files.
  std::string title;          //!< For people.
  std::vector<Series> series; //!< In the order of the report.
};

/*! The methods that see a frame: bound and limit are computed for a fifth of them, of each kind. */
std::vector<Method> methodsOf(const Series &series, std::size_t frame);

/*! The experiment that has a recording of a camera in place of simulated frames. */
constexpr const char *recordedExperiment = "1";

/*! Names of the simulated experiments, as --experiment takes them. */
const std::vector<std::string> &experimentNames();

/*! \exception std::invalid_argument : If there is no experiment of that name. */
Experiment experimentNamed(const std::string &name, const Settings &settings);

/*! The thesis's experiment 2: markers that face the camera, along five lines and along one. */
Experiment experimentOfLines(const Settings &settings);

/*! The thesis's experiment 3: random poses in cells of depth and angle. */
Experiment experimentOfCells(const Settings &settings);

/*! What the thesis left open (6.2.3): one disturbance after another, each from none to more than is borne. */
Experiment experimentOfResilience(const Settings &settings);

/*! The requirements of the thesis's section 2.2.1, each as far as a simulated camera can measure it. */
Experiment experimentOfRequirements(const Settings &settings);

/*! What the thesis left open (6.2.4): one measure of the marker after another, on a sheet of the same size. */
Experiment experimentOfDesign(const Settings &settings);

/*! The settings' photometry: the reference camera's with their noise and blur. */
vpScenePhotometry photometryOf(const Settings &settings);
} // namespace experiments

#endif

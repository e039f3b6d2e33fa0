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
 * The parts of the measurement: which scenes are made, and by which methods they are looked at.
 */

#ifndef VP_ACCURACY_PARTS_H
#define VP_ACCURACY_PARTS_H

#include <array>
#include <vector>

#include "common/parallel.h"
#include "record.h"
#include "scene.h"

namespace accuracy {
/*! Limits of the octaves of diameter, pixels; the last one is cut at the largest that fits into a window. */
constexpr std::array<double, 6> octaves = {17., 34., 68., 136., 272., 400.};
constexpr const char *families[] = {"golay23", "bch31", "ring"};

/*! A range of distance and tilt at which the two poses are told apart, or are one. */
struct DistanceCell
{
  const char *name;           //!< Without a comma: a column of accuracy.csv.
  double distance;            //!< Depth of the marker's centre, metres.
  double leastTilt, mostTilt; //!< Degrees.
};

/*! A golay23 of 200 mm under the reference camera, noise 2, blur 0.7, contrast 190: DESIGN's conditions. */
constexpr DistanceCell distanceCells[] = {{"10 m facing", 10., 0., 0.},
                                          {"10 m tilt 10-75", 10., 10., 75.},
                                          {"15 m tilt 30-60", 15., 30., 60.},
                                          {"20 m tilt 30-60", 20., 30., 60.}};
constexpr double distanceCellSize = 0.2; //!< Metres.

/*! Something the estimator does not know of. */
struct Factor
{
  const char *name;                          //!< Without a comma: a column of accuracy.csv.
  void (*apply)(Scene &scene, Draws &draws); //!< Changes the scene; may be nothing.
  std::optional<Camera> camera;              //!< Another camera, whose parameters are known.
  bool isModelled = false;                   //!< Whether the bound is of the changed scene.
};

const std::vector<Factor> &factors();

/*! A range of poses, as in the columns of the thesis's table 5.6. */
struct ThesisCell
{
  double maxTilt;               //!< Degrees.
  double maxDepth;              //!< Metres.
  double meanError, meanNormal; //!< What is aimed at: mean |C - eC|, mm, and mean angle of the normal, degrees.
  double leastFound;            //!< And share of the coded markers found and rightly read.
};

constexpr ThesisCell thesisCells[] = {{30., 10.4, 0.6, 0.07, 0.999},
                                      {60., 10.4, 0.7, 0.07, 0.999},
                                      {60., 18.4, 3., 0.3, 0.995},
                                      {90., 10.4, 1., 0.1, 0.92},
                                      {90., 18.4, 4., 0.4, 0.9}};
constexpr const char *thesisFamilies[] = {"golay23", "ring"};

std::string nameOf(const ThesisCell &cell);

/*!
  Makes all records of the parts asked for. Each image has a seed of its own, made of the settings' seed, its part, its
  group and its number: the records depend neither on the number of threads nor, but for their number, on the frames.
*/
std::vector<Record> makeRecords(const Settings &settings, const Progress &progress);
} // namespace accuracy

#endif

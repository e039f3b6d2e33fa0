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
 * Settings of the circular marker detector.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <visp3/core/vpException.h>

#include "support/visp_matrix.h"

BEGIN_VISP_NAMESPACE

/*!
  \param family : The only family to look for.
*/
void vpDetectorCircleMarker::setFamily(const vpCircleMarkerFamily &family)
{
  m_impl->settings.families = {family};
  m_impl->forgetTracks();
}

/*!
  \param families : Families to look for, at least one. An outline that could be of several is given to the first,
  unless another with another number of sectors explains it clearly better. Every marker of bch31r is also one of bch31
  (its code is a part of that code), so name bch31r before bch31.
  \exception vpException::badValue : If there is none.
*/
void vpDetectorCircleMarker::setFamilies(const std::vector<vpCircleMarkerFamily> &families)
{
  if (families.empty()) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: at least one family must be looked for");
  }
  m_impl->settings.families = families;
  m_impl->forgetTracks();
}

/*!
  \return Families that are looked for.
*/
const std::vector<vpCircleMarkerFamily> &vpDetectorCircleMarker::getFamilies() const
{
  return m_impl->settings.families;
}

/*!
  \param database : What is known of the markers. Those in it have its sizes, whatever detect() and setMarkerSizes()
  say, and their messages carry name and payload: "golay23 id: 5 name: door payload: wait". Which families are looked
  for is setFamilies()'s.

  \warning The poses wMo in the database have z into the marker. For poses cMo that go together with them, as in
  wMo * cMo.inverse(), call setZAlignedWithCameraAxis(true): by default z of cMo points toward the camera.
*/
void vpDetectorCircleMarker::setDatabase(const vpCircleMarkerDatabase &database)
{
  m_impl->database = database;
}

/*!
  \return What is known of the markers.
*/
const vpCircleMarkerDatabase &vpDetectorCircleMarker::getDatabase() const
{
  return m_impl->database;
}

/*!
  \param sizes : Sizes of single markers, metres, by id; the others have the size given to detect(). The id counts
  alone: where two families are looked for, both markers of an id have its size. That of -1 is for all markers without
  a code, and not, as in getTagsPoints3D(), for all that are not named. Where this does not do, the database tells sizes
  by family and id (setDatabase()).
  \exception vpException::badValue : If a size is not positive, or an id is not one from -1 to 999999999.
*/
void vpDetectorCircleMarker::setMarkerSizes(const std::map<int, double> &sizes)
{
  for (const auto &[id, size] : sizes) {
    if (id < -1 || id > circle_marker::largestId) {
      throw vpException(vpException::badValue,
                        "vpDetectorCircleMarker: a size for the id %d, which no marker has; give ids from 0, or -1 for "
                        "markers without a code",
                        id);
    }
    circle_marker::checkMarkerSize(size);
  }
  m_impl->settings.sizes = sizes;
}

/*!
  \return Sizes of single markers, metres, by id: see setMarkerSizes().
*/
std::map<int, double> vpDetectorCircleMarker::getMarkerSizes() const
{
  return m_impl->settings.sizes;
}

/*!
  \param distance : Most sectors of a code that are corrected (2 by default): that were read, and against the code. The
  more are wrong the less the image looks like the marker, which is demanded, too: of golay23 hardly one with three is
  found at any distance. Sectors that are not seen are not corrected; one in plain sight that is of the other colour is,
  even of a marker that something covers elsewhere. Of such a one of bch31r, whose code can correct five sectors where
  the others' correct three, five thirds of the distance may be, rounded up, and of any no more than its code can
  correct; getHammingDistance() tells how many. Corrections raise the least margin: see setMinimumMargin(). Markers with
  sectors too small to be read one by one are read as a whole, unless the distance is 0.
*/
void vpDetectorCircleMarker::setMaximumHammingDistance(unsigned int distance)
{
  m_impl->settings.decode.maximumHamming = distance;
}

/*!
  \return Most sectors of a code that are corrected: see setMaximumHammingDistance().
*/
unsigned int vpDetectorCircleMarker::getMaximumHammingDistance() const
{
  return m_impl->settings.decode.maximumHamming;
}

/*!
  Sets the least margin of codes. At the default, and below, small markers may be proven as a whole, by the likelihood
  of all codewords, whatever the margin of their first reading; above it they may not.

  Corrected sectors ask for more: n of the c that the code can correct (three of golay23 and bch31, five of bch31r) for
  0.3 n / c besides, and each takes at least 1 / (number of sectors) of the margin. So a golay23 with two corrections,
  whose margin is 0.91 at most, is found up to a least margin of 0.71, and one with three, 0.87 at most, up to 0.57: by
  default it is not.

  \param margin : Least decision margin, from 0 to 1 (see getMargin()); 0.6 by default.
  \exception vpException::badValue : If it is outside of [0, 1].
*/
void vpDetectorCircleMarker::setMinimumMargin(double margin)
{
  if (!(margin >= 0. && margin <= 1.)) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: the margin %g is not in [0, 1]", margin);
  }
  m_impl->settings.decode.minimumMargin = margin;
}

/*!
  \return Least decision margin of a code, from 0 to 1: see setMinimumMargin().
*/
double vpDetectorCircleMarker::getMinimumMargin() const
{
  return m_impl->settings.decode.minimumMargin;
}

/*!
  \param threads : Number of threads, from 1 to 1024; 1 by default. They are started by the next detect(), which throws
  vpException::fatalError if the system does not give so many.
  \exception vpException::badValue : If it is another.
*/
void vpDetectorCircleMarker::setNbThreads(unsigned int threads)
{
  if (threads == 0 || threads > circle_marker::mostThreads) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: %u threads are not from 1 to %u", threads,
                      circle_marker::mostThreads);
  }
  m_impl->settings.threads = threads;
}

/*!
  \return Number of threads: see setNbThreads().
*/
unsigned int vpDetectorCircleMarker::getNbThreads() const
{
  return m_impl->settings.threads;
}

/*!
  \param refine : Whether poses are refined on the grey levels around the marker's edges (the default), or left as the
  closed form of vpPoseCircle gives them, which takes less time. Their errors are then up to a hundred times as large,
  and the mirrored pose comes first more often; the covariance and the log-odds say so, but for discs that are strongly
  moved, whose smear is taken for their outline. And small codes are read sector by sector without a proof: of 2000
  golay23 of 12 to 45 pixels in any light 4 are read as others, of as many in light 2.5 times too strong 30
  (bench-circle-marker --hardships 2000 --small --unrefined --seed 301); where poses are refined none. Plain rings that
  something covers are found where poses are refined only.
*/
void vpDetectorCircleMarker::setRefinePose(bool refine)
{
  m_impl->settings.refinePose = refine;
}

/*!
  \return Whether poses are refined on the grey levels: see setRefinePose().
*/
bool vpDetectorCircleMarker::getRefinePose() const
{
  return m_impl->settings.refinePose;
}

/*!
  Without it the covariance of a pose is that of an exactly known camera. A principal point that is off by one pixel
  turns all poses about the camera by 1/f radians, f the focal length in pixels, which may be far more than the noise
  does.

  All poses from one camera have this part of their error in common: it does not become less in their mean.

  \param covariance : 4 x 4 covariance of (px, py, u0, v0), pixels^2, as a calibration gives it; it is propagated to the
  covariance of every pose. Empty: the camera is known exactly (the default).
  \exception vpException::dimensionError : If it is neither empty nor 4 x 4.
  \exception vpException::badValue : If it is not symmetric, or a variance is negative.
*/
void vpDetectorCircleMarker::setCameraCovariance(const vpMatrix &covariance)
{
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  if (covariance.size() > 0) {
    if (covariance.getRows() != 4 || covariance.getCols() != 4) {
      throw vpException(vpException::dimensionError,
                        "vpDetectorCircleMarker: the camera's covariance is %u x %u; it must be 4 x 4, or empty",
                        covariance.getRows(), covariance.getCols());
    }
    for (unsigned int i = 0; i < 4; ++i) {
      for (unsigned int j = 0; j < 4; ++j) {
        matrix(i, j) = covariance[i][j];
      }
    }
    circle_marker::checkCameraCovariance(matrix);
  }
  m_impl->settings.cameraCovariance = matrix;
}

/*!
  \return 4 x 4 covariance of the camera's (px, py, u0, v0), pixels^2: see setCameraCovariance().
*/
vpMatrix vpDetectorCircleMarker::getCameraCovariance() const
{
  return circle_marker::vispMatrix(m_impl->settings.cameraCovariance);
}

/*!
  \param aligned : Whether the marker's z axis points into the marker (and y down), or toward the camera (and y up),
  which is the default as in vpDetectorAprilTag.
*/
void vpDetectorCircleMarker::setZAlignedWithCameraAxis(bool aligned)
{
  m_impl->settings.zAlignedWithCameraAxis = aligned;
}

/*!
  \return Whether the marker's z axis points into the marker: see setZAlignedWithCameraAxis().
*/
bool vpDetectorCircleMarker::isZAlignedWithCameraAxis() const
{
  return m_impl->settings.zAlignedWithCameraAxis;
}

/*!
  Reads settings from a JSON file; those it does not name stay as they are. Keys: families (list of names, of {"name":
  "ring", "ratio": inner by outer radius} for other rings, or of {"name", "layout"} for other prints, with the four
  radii of vpCircleMarkerLayout), sizes (id to metres; -1 for markers without a code), maximumHammingDistance,
  minimumMargin, refinePose, zAlignedWithCameraAxis, polarity
  ("black on white", "white on black", "both"), threads, tracking, fullSearchPeriod, cameraCovariance (four lists of
  four numbers).

  \param filename : Its path.
  \exception vpException::ioError : If it cannot be read.
  \exception vpException::badValue : If it is not JSON, or a key or value is not known.
  \exception vpException::functionNotImplementedError : If the module was built without nlohmann-json.
*/
void vpDetectorCircleMarker::loadConfigFile(const std::string &filename)
{
  m_impl->settings = circle_marker::readSettings(filename, m_impl->settings);
  m_impl->forgetTracks();
}

/*!
  Writes the settings as loadConfigFile() reads them, whole or not at all.
  \param filename : Path of the file.
  \exception vpException::ioError : If it cannot be written.
  \exception vpException::functionNotImplementedError : If the module was built without nlohmann-json.
*/
void vpDetectorCircleMarker::saveConfigFile(const std::string &filename) const
{
  circle_marker::writeSettings(filename, m_impl->settings);
}

/*!
  \param display : Whether detect() draws the outline of what it finds in the image's display.
  \param color : Colour; vpColor::none for the default.
  \param thickness : Of the lines, pixels.
*/
void vpDetectorCircleMarker::setDisplayTag(bool display, const vpColor &color, unsigned int thickness)
{
  m_impl->displayTag = display;
  m_impl->displayColor = color;
  m_impl->displayThickness = thickness;
}

END_VISP_NAMESPACE

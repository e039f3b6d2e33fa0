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
 * Detection, identification and pose of circular markers.
 */

/*!
  \file vpDetectorCircleMarker.h
  \brief Detection, identification and pose of circular markers.
*/

#ifndef VP_DETECTOR_CIRCLE_MARKER_H
#define VP_DETECTOR_CIRCLE_MARKER_H

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerDatabase.h>
#include <visp3/circle_marker/vpCircleMarkerDebug.h>
#include <visp3/circle_marker/vpCircleMarkerDetection.h>
#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/circle_marker/vpCircleMarkerPolarity.h>
#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpColor.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpPoint.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/core/vpRect.h>
#include <visp3/detection/vpDetectorBase.h>

BEGIN_VISP_NAMESPACE

/*!
  \class vpDetectorCircleMarker
  \ingroup group_circle_marker
  \brief Finds circular markers in an image, reads their codes and gives their poses with a covariance.

  The interface is that of vpDetectorAprilTag. The size of a marker is the outer diameter of its black ring, metres.

  \code
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  std::vector<vpHomogeneousMatrix> cMo;
  detector.detect(I, 0.180, cam, cMo);
  for (size_t i = 0; i < cMo.size(); i++) {
    std::cout << detector.getMessage(i) << "\n" << cMo[i] << std::endl; // "golay23 id: 5"; see setDatabase()
  }
  \endcode

  By default the marker frame is that of vpDetectorAprilTag: x right and y up as the print is seen upright, z toward
  the camera. After setZAlignedWithCameraAxis(true) y is down and z points into the marker.

  A circle seen by a camera has two poses with the same image of its outer edge. Both are refined and compared;
  the likelier comes first, and vpCircleMarkerDetection::logOdds says by how much.

  Paper need not be flat: where a coded print shows that its sheet is bent, the bend is fitted with the pose, which is
  that of the plane in which the ring's outer circle lies in the mean.

  Without camera parameters, in detect(const vpImage<unsigned char> &), the codes are read with a nominal camera
  (focal length equal to the image's larger side); call getPose() afterwards.

  getCog(), inherited, is the mean of the polygon's points; the image of the circle's centre is getCenter().
*/
class VISP_EXPORT vpDetectorCircleMarker : public vpDetectorBase
{
public:
  explicit vpDetectorCircleMarker(const vpCircleMarkerFamily &family = vpCircleMarkerFamily::GOLAY23);
  explicit vpDetectorCircleMarker(vpCircleMarkerFamily::vpType family);
  vpDetectorCircleMarker(const vpDetectorCircleMarker &other);
  vpDetectorCircleMarker &operator=(const vpDetectorCircleMarker &other);
  ~vpDetectorCircleMarker() VP_OVERRIDE;

  /** @name Detection */
  //@{
  bool detect(const vpImage<unsigned char> &I) VP_OVERRIDE;
  bool detect(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam,
              std::vector<vpHomogeneousMatrix> &cMo_vec, std::vector<vpHomogeneousMatrix> *cMo_vec2 = nullptr,
              std::vector<double> *projErrors = nullptr, std::vector<double> *projErrors2 = nullptr);
  //@}

  /** @name Results, one per detected marker */
  //@{
  const std::vector<vpCircleMarkerDetection> &getDetections() const;
  bool getPose(size_t index, double size, const vpCameraParameters &cam, vpHomogeneousMatrix &cMo,
               vpHomogeneousMatrix *cMo2 = nullptr, double *projError = nullptr, double *projError2 = nullptr,
               vpMatrix *covariance = nullptr, vpMatrix *covariance2 = nullptr);
  vpImagePoint getCenter(size_t index) const;
  vpMatrix getCovariance(size_t index) const;
  double getLogOdds(size_t index) const;
  double getMargin(size_t index) const;
  unsigned int getHammingDistance(size_t index) const;
  unsigned int getNbOutlines() const;
  bool hasTimedOut() const;
  std::vector<int> getTagsId() const;
  std::vector<std::vector<vpImagePoint>> getTagsCorners() const;
  std::vector<std::vector<vpPoint>> getTagsPoints3D(const std::vector<int> &tagsId,
                                                    const std::map<int, double> &tagsSize) const;
  std::vector<int> getTagsHammingDistance() const;
  std::vector<float> getTagsDecisionMargin() const;
  //@}

  /** @name Settings */
  //@{
  void setFamily(const vpCircleMarkerFamily &family);
  void setFamilies(const std::vector<vpCircleMarkerFamily> &families);
  const std::vector<vpCircleMarkerFamily> &getFamilies() const;
  void setDatabase(const vpCircleMarkerDatabase &database);
  const vpCircleMarkerDatabase &getDatabase() const;
  void setMarkerSizes(const std::map<int, double> &sizes);
  std::map<int, double> getMarkerSizes() const;
  void setMaximumHammingDistance(unsigned int distance);
  unsigned int getMaximumHammingDistance() const;
  void setMinimumMargin(double margin);
  double getMinimumMargin() const;
  void setNbThreads(unsigned int threads);
  unsigned int getNbThreads() const;
  void setPolarity(vpCircleMarkerPolarity polarity);
  vpCircleMarkerPolarity getPolarity() const;
  void setTracking(bool tracking, unsigned int fullSearchPeriod = 10);
  bool getTracking() const;
  unsigned int getFullSearchPeriod() const;
  void setRefinePose(bool refine);
  bool getRefinePose() const;
  void setCameraCovariance(const vpMatrix &covariance);
  vpMatrix getCameraCovariance() const;
  void setZAlignedWithCameraAxis(bool aligned);
  bool isZAlignedWithCameraAxis() const;
  void loadConfigFile(const std::string &filename);
  void saveConfigFile(const std::string &filename) const;
  //@}

  /** @name Why (not): what the rooms of the detector saw */
  //@{
  void setDebug(bool debug);
  const vpCircleMarkerDebug &getDebug() const;
  std::vector<vpCircleMarkerCandidate> getRejectedCandidates() const;
  const std::vector<vpRect> &getSearchedRegions() const;
  //@}

  /** @name Display */
  //@{
  void setDisplayTag(bool display, const vpColor &color = vpColor::none, unsigned int thickness = 2);
  void displayFrames(const vpImage<unsigned char> &I, const std::vector<vpHomogeneousMatrix> &cMo_vec,
                     const vpCameraParameters &cam, double size, const vpColor &color = vpColor::none,
                     unsigned int thickness = 1) const;
  void displayFrames(const vpImage<vpRGBa> &I, const std::vector<vpHomogeneousMatrix> &cMo_vec,
                     const vpCameraParameters &cam, double size, const vpColor &color = vpColor::none,
                     unsigned int thickness = 1) const;
  void displayTags(const vpImage<unsigned char> &I, const vpColor &color = vpColor::none,
                   unsigned int thickness = 2) const;
  void displayTags(const vpImage<vpRGBa> &I, const vpColor &color = vpColor::none, unsigned int thickness = 2) const;
  void displayTags(const vpImage<unsigned char> &I, const std::vector<std::vector<vpImagePoint>> &tagsCorners,
                   const vpColor &color = vpColor::none, unsigned int thickness = 1) const;
  void displayTags(const vpImage<vpRGBa> &I, const std::vector<std::vector<vpImagePoint>> &tagsCorners,
                   const vpColor &color = vpColor::none, unsigned int thickness = 1) const;
  //@}

private:
  class Impl;

  bool detectWith(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam, bool isCameraGuessed,
                  std::vector<vpHomogeneousMatrix> &cMo_vec, std::vector<vpHomogeneousMatrix> *cMo_vec2,
                  std::vector<double> *projErrors, std::vector<double> *projErrors2);
  void fillOutputs(std::vector<vpHomogeneousMatrix> &cMo_vec, std::vector<vpHomogeneousMatrix> *cMo_vec2,
                   std::vector<double> *projErrors, std::vector<double> *projErrors2);

  std::unique_ptr<Impl> m_impl; //!< Settings, working memory and results.
};

END_VISP_NAMESPACE

#endif

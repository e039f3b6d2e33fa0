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
 * What a circular marker detector keeps: settings, working memory, results.
 */

#ifndef VP_DETECTOR_CIRCLE_MARKER_IMPL_H
#define VP_DETECTOR_CIRCLE_MARKER_IMPL_H

#include <optional>
#include <vector>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpRect.h>

#include "decode/marker_places.h"
#include "decode/recognise.h"
#include "ellipse/outlines.h"
#include "refine/mask_search.h"
#include "refine/measure.h"
#include "detect_covered.h"
#include "detector_settings.h"
#include "support/few.h"
#include "support/workers.h"
#include "track/marker_tracks.h"

BEGIN_VISP_NAMESPACE

/*! What a detector keeps: settings, results of the last image, working memory. */
class vpDetectorCircleMarker::Impl
{
public:
  //! Points of the polygon that vpDetectorBase keeps of each object: every 10 degrees.
  static constexpr unsigned int polygonPoints = 36;

  /*! What is kept of a detected marker, to measure it again with another camera or size. */
  struct Found
  {
    vpCircleMarkerDetection detection;       //!< What the user sees.
    circle_marker::Recognition marker;       //!< Family and code.
    circle_marker::EllipseCandidate outline; //!< Its outer edge, as found.
    std::vector<vpImagePoint> polygon;       //!< Points along the outline.
    circle_marker::ImageNoise noise;         //!< Of the image it was found in.
    bool mayBeBlurred = false;               //!< Whether it was read through a blur, or might have been.
    bool isOtherRing = false;                //!< Whether it is none, but a plain ring of another ratio of radii.
  };

  void detect(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam, bool isCameraGuessed,
              const circle_marker::Deadline &deadline);

  std::optional<vpCircleMarkerDetection> measureAgain(std::size_t index, double size, const vpCameraParameters &cam);

  const Found &at(std::size_t index) const;

  void forgetTracks();

  void forgetResults() noexcept;

  circle_marker::DetectorSettings settings;        //!< All that a user can set.
  vpCircleMarkerDatabase database;                 //!< What is known of the markers.
  bool displayTag = false;                         //!< Whether detect() draws.
  vpColor displayColor = vpColor::none;            //!< In which colour.
  unsigned int displayThickness = 2;               //!< Pixels.
  std::vector<Found> found;                        //!< Markers of the last image.
  std::vector<vpCircleMarkerDetection> detections; //!< The same, as the user sees them.
  vpImage<unsigned char> image;                    //!< The last image around its markers, for getPose().
  unsigned int outlineCount = 0;                   //!< Outlines of the last image that were looked at.
  bool hasTimedOut = false;                        //!< Whether its time was over before its search ended.
  std::vector<vpRect> searched;                    //!< Where the last image was searched.
  bool keepsDebug = false;                         //!< Whether what the rooms see is kept.
  vpCircleMarkerDebug debug;                       //!< What they saw in the last image.

private:
  /*! How far an outline has come. */
  struct Examination
  {
    std::size_t attempt = 0;                                   //!< Index of the way to read it that is next.
    bool isRead = false;                                       //!< Whether that was done.
    bool isOver = false;                                       //!< Whether it is found, or is none.
    bool mayBeBlurred = false;                                 //!< Whether it may be read through a blur.
    std::optional<std::size_t> otherRingOf;                    //!< The family of plain rings whose ratio it has not.
    std::optional<std::size_t> mirroredOf;                     //!< The family of which it is a marker in a mirror.
    std::optional<circle_marker::Recognition> marker;          //!< What it was read as.
    std::size_t place = 0;                                     //!< Of what was measured of it, in m_measured.
    bool isFound = false;                                      //!< Whether that is a marker.
    vpCircleMarkerReject refusal = vpCircleMarkerReject::NONE; //!< Why what it was read as is none, once that is known.
    std::vector<vpCircleMarkerCandidate> candidates;           //!< What it was tried as, if that is to be shown.
  };
  /*! Outlines of a kind that may be none: a few are measured at a time, until there were too many that are none. */
  struct Trials
  {
    std::size_t mostInVain = 0; //!< That are none, before the others are passed over; more, the more are proven.
    std::size_t inVain = 0;     //!< Measured so far that were none.
    std::size_t proven = 0;     //!< And that were a marker.
    std::size_t begin = 0;      //!< Those that are left, among the chosen ones.
    std::size_t end = 0;
    std::size_t taken = 0; //!< The first of these, so many, are being measured.
  };
  /*! What the room refine tells of a marker besides its measurement. */
  struct Fit
  {
    circle_marker::Few<circle_marker::MarkerPlane> poses; //!< Where it may be.
    std::optional<circle_marker::Measurement>
        measurement;          //!< Before what is in doubt was added; nothing if there is none.
    std::size_t pixels = 0;   //!< Number of pixels that it was fitted to.
    double left = HUGE_VAL;   //!< What that leaves, in units of the image's noise.
    double halo = 1.;         //!< Of its outer edge (haloOf()), if it is measured.
    bool isOtherRing = false; //!< Whether it is a plain ring of another ratio of radii.
  };
  /*! Working memory of one thread. */
  struct Workspace
  {
    std::vector<Eigen::Vector2d> meters;    //!< Points of an outline.
    circle_marker::MeasureMemory measuring; //!< Of the refinement.
    vpImage<unsigned char> restored;        //!< What the image was before the camera sharpened it, around a marker.
  };

  using Outlines = circle_marker::ReusedList<circle_marker::EllipseCandidate>;

  /*! One image on its way through the rooms. */
  struct Visit
  {
    const vpImage<unsigned char> &I;
    double size; //!< Of the markers, metres.
    const circle_marker::CameraModel &camera;
    const circle_marker::Deadline &deadline;
    const circle_marker::ImageNoise &noise; //!< Of the image: known after the first room.
    bool isSizeGiven = false;               //!< Whether all markers have that size, whatever the database says.
    const circle_marker::SearchedMask *mask = nullptr; //!< That was undone; nullptr: none was.
    bool isCameraGuessed = false; //!< Whether edges of circles may lie a little beside where it would show them.
    bool readsWholeOnly = false;  //!< Whether nothing is read as covered, blurred or in doubt.
  };

  void detectBlack(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam, bool isCameraGuessed,
                   const circle_marker::Deadline &deadline);
  void addInverse(Impl &inverse);
  void dropPiecesOf(const Found &inverse);
  circle_marker::SoughtCenters soughtCenters() const;
  bool searchRegions(const Visit &visit);
  void searchWhole(const Visit &visit);
  bool followAll(const Visit &visit, const std::vector<circle_marker::PixelBox> &boxes);
  bool followOutlines(const Visit &visit, const std::vector<circle_marker::PixelBox> &boxes);
  bool examineRegions(const Visit &visit);
  void searchRegion(const Visit &visit, const circle_marker::PixelBox &box);
  void examineAll(const Visit &visit, const Outlines &outlines);
  void allowBlurred(const Visit &visit, const Outlines &outlines);
  void readTogether(const Visit &visit, const Outlines &outlines);
  void read(const Visit &visit, const circle_marker::EllipseCandidate &outline, Workspace &workspace,
            Examination &examination) const;
  void readWhole(const Visit &visit, circle_marker::OutlineInImage &seen, const vpCircleMarkerFamily &family,
                 Examination &examination) const;
  std::optional<circle_marker::Recognition> readInDoubt(const Visit &visit, circle_marker::OutlineInImage &seen,
                                                        const vpCircleMarkerFamily &family,
                                                        circle_marker::ReadingKind kind) const;
  void keepAsMarker(const circle_marker::EllipseCandidate &outline, const vpCircleMarkerFamily &family,
                    Examination &examination) const;
  bool isCoveredRing(const Examination &examination) const;
  bool readCovered(const Visit &visit, const circle_marker::EllipseCandidate &outline, Workspace &workspace,
                   Examination &examination) const;
  double sizeOf(const circle_marker::Recognition &marker, const Visit &visit) const;
  std::optional<circle_marker::Measurement> withoutCover(const Visit &visit,
                                                         const circle_marker::EllipseCandidate &outline,
                                                         const circle_marker::Measurement &measurement,
                                                         circle_marker::Recognition &marker,
                                                         Workspace &workspace) const;
  bool measureMarker(const Visit &visit, const circle_marker::EllipseCandidate &outline,
                     const circle_marker::Recognition &marker, Workspace &workspace, Found &measured) const;
  std::optional<circle_marker::Measurement> explain(const Visit &visit, const circle_marker::EllipseCandidate &outline,
                                                    circle_marker::Recognition &marker, Workspace &workspace) const;
  void addDoubts(const Visit &visit, const circle_marker::EllipseCandidate &outline,
                 const circle_marker::Recognition &marker, Workspace &workspace,
                 circle_marker::Measurement &measurement, Fit &fit) const;
  bool measureSharpened(const Visit &visit, const circle_marker::EllipseCandidate &outline,
                        const circle_marker::Recognition &marker, Workspace &workspace, Found &measured,
                        Fit &fit) const;
  bool measureIn(const Visit &visit, const circle_marker::EllipseCandidate &outline, circle_marker::Recognition marker,
                 Workspace &workspace, Found &measured, Fit &fit) const;
  bool searchMask(const Visit &visit, const circle_marker::EllipseCandidate &outline,
                  const circle_marker::Recognition &marker, Workspace &workspace, Fit &fit, Found &measured) const;
  bool measureBehind(const Visit &visit, const circle_marker::SearchedMask &found,
                     const circle_marker::EllipseCandidate &outline, const circle_marker::Recognition &marker,
                     Workspace &workspace, Fit &fit, Found &measured) const;
  void choose(const Visit &visit, const Outlines &outlines);
  void reserve(const circle_marker::EllipseCandidate &outline, const Examination &examination);
  void measureChosen(const Visit &visit, const Outlines &outlines);
  void measureTogether(const Visit &visit, const Outlines &outlines);
  void takeNext(Trials &trials);
  void countTaken(Trials &trials);
  void passOver(Trials &trials);
  void refuse(Examination &examination) const;
  bool settleChosen();
  void keepSeen(const Outlines &outlines);
  void followSeen(const Visit &visit);
  void keepCandidates(const Visit &visit, const Outlines &outlines);
  static circle_marker::PixelBox surroundingsOf(const circle_marker::EllipseCandidate &outline,
                                                const vpCircleMarkerFamily &family, const vpImage<unsigned char> &I);
  void keepSurroundings(const vpImage<unsigned char> &I);

  circle_marker::OutlineMemory m_outlines;            //!< Memory of the rooms up to the outlines.
  circle_marker::OutlineMemory m_regions;             //!< The same for regions of images.
  vpImage<unsigned char> m_region;                    //!< A region of the image.
  Outlines m_regionOutlines;                          //!< Outlines of all regions.
  circle_marker::OutlineFitter m_follower;            //!< Finds them where they are expected.
  circle_marker::MarkerTracks m_tracks;               //!< Markers of the last images.
  unsigned int m_sinceWhole = 0;                      //!< Images since a whole one was searched.
  std::vector<circle_marker::SeenMarker> m_seen;      //!< Markers of the last image.
  std::vector<circle_marker::SeenMarker> m_inRegions; //!< Those of a search of its regions that did not find all.
  bool m_hadRegions = false;                          //!< Whether the regions of the last image were searched in vain.
  circle_marker::Workers m_workers;                   //!< Threads.
  std::vector<Workspace> m_workspaces;                //!< One for each thread.
  std::vector<Examination> m_examinations;            //!< One for each outline.
  circle_marker::ReusedList<Found> m_measured;        //!< What was measured of outlines.
  std::vector<circle_marker::Attempt> m_attempts;     //!< The ways to read an outline.
  std::vector<std::size_t> m_chosen;                  //!< Outlines to be read or measured together.
  circle_marker::MarkerPlaces m_chosenPlaces;         //!< Where they are.
  std::vector<std::size_t> m_together;                //!< Those of them that are measured at once.
  Trials m_doubts;                                    //!< Of the outlines whose code is in doubt.
  Trials m_covered;                                   //!< Of the rings of codes that something covers.
  Trials m_coveredRings;                              //!< And of the plain rings.
  std::vector<Impl> m_inverse;       //!< What looks at the negative, if markers white on black are sought.
  vpImage<unsigned char> m_negative; //!< The negative.
  bool m_isInverseFirst = true;      //!< Whether that was looked at first: in every other image with both polarities.
};

END_VISP_NAMESPACE

#endif

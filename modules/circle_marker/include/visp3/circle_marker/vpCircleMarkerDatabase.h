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
 * Names, sizes, payloads and places of circular markers.
 */

/*!
  \file vpCircleMarkerDatabase.h
  \brief What is known of the markers of a place: name, size, payload, pose.
*/

#ifndef VP_CIRCLE_MARKER_DATABASE_H
#define VP_CIRCLE_MARKER_DATABASE_H

#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpHomogeneousMatrix.h>

BEGIN_VISP_NAMESPACE

/*!
  \struct vpCircleMarkerEntry
  \ingroup group_circle_marker
  \brief What is known of one marker before it is seen.
*/
struct vpCircleMarkerEntry
{
  vpCircleMarkerFamily family; //!< Its family.
  int id = -1;                 //!< Its identity in the family; -1 for a family without code.
  double size = 0.;            //!< Outer diameter of its ring, metres.
  std::string name;            //!< What people call it; may be empty.
  std::string payload;         //!< Text that it carries, or the text of a JSON value; may be empty.
  bool isPayloadJson = false;  //!< Whether the payload is structured data, as the text of a JSON value.
  //! Its pose in the world, metres, if it is known; z into the marker, as vpDetectorCircleMarker's poses have it after
  //! setZAlignedWithCameraAxis(true), and not by default.
  std::optional<vpHomogeneousMatrix> wMo;
};

/*!
  \class vpCircleMarkerDatabase
  \ingroup group_circle_marker
  \brief The markers of a place: each with its size, and if known with its name, a payload and its pose in the world.

  A payload is what the marker tells a robot: a text, or structured data. It is not printed on the marker, which carries
  its number alone, but looked up.

  The file is JSON:
  \code{.json}
  {
    "markers": [
      {"family": "golay23", "id": 5, "size": 0.18, "name": "door", "payload": "wait",
       "pose": [1.0, 0.0, 2.5, 0.0, 1.5708, 0.0]},
      {"family": "golay23", "id": 6, "size": 0.18, "payload": {"task": "go", "to": [2.0, 1.0]}}
    ]
  }
  \endcode
  \e family, \e id (but for families without code) and \e size (outer diameter of the ring, metres) must be there. A
  family is its name; a ring of its own ratio is {"name": "ring", "ratio": 0.65}, one with other radii {"name":
  "golay23", "layout": {"ringInner": 0.75, "codeOuter": ..., "codeInner": ..., "quietZone": ...}}, with all four of
  them. The pose is ViSP's vpPoseVector, wMo: translation in metres, then \f$ \theta {\bf u} \f$ in radians, with z into
  the marker, x to the right and y down as the print is seen upright (vpDetectorCircleMarker's frame after
  setZAlignedWithCameraAxis(true)).

  \code
  vpCircleMarkerDatabase database;
  database.load("markers.json");
  detector.setDatabase(database);
  detector.setZAlignedWithCameraAxis(true); // as the poses of the database have it
  detector.detect(I, 0.18, cam, cMo);
  detector.getMessage(0); // "golay23 id: 5 name: door payload: wait"
  \endcode
*/
class VISP_EXPORT vpCircleMarkerDatabase
{
public:
  void load(const std::string &filename);
  void save(const std::string &filename) const;

  void add(const vpCircleMarkerEntry &entry);
  /*! Forgets all markers. */
  void clear() { m_entries.clear(); }

  const vpCircleMarkerEntry *find(const vpCircleMarkerFamily &family, int id) const;
  /*! What there is, in the order of the file. */
  const std::vector<vpCircleMarkerEntry> &getEntries() const { return m_entries; }

private:
  std::vector<vpCircleMarkerEntry> m_entries; //!< In the order in which they were added; each marker once.
};

END_VISP_NAMESPACE

#endif

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
 * Pixels of a code track at a measured pose, and what they say of its sectors and of a codeword.
 */

#ifndef VP_CIRCLE_MARKER_TRACK_PIXELS_H
#define VP_CIRCLE_MARKER_TRACK_PIXELS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "decode/code_track.h"
#include "decode/cyclic_code.h"
#include "decode/measured_ring.h"
#include "pose/marker_plane.h"
#include "support/camera_model.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Parts of a sector for which it is told apart whether something covers them; and the parts to either side that are
  taken to be covered by the same.
*/
constexpr unsigned int partsPerSector = 8;
constexpr unsigned int mostParts = partsPerSector * mostSectors;
constexpr unsigned int coverReach = 3;
/*! Pixels of a cover that make it one. */
constexpr int fewestOfCover = 2;
/*! Standard deviation of what the model leaves of a pixel's level, share of the contrast: common to those of a sector.
 */
constexpr double usualModelError = 0.008;

/*! What the pixels say of a codeword; of the sectors that are left nothing is said. */
struct CodewordVerdict
{
  unsigned int confirmed = 0;    //!< Sectors whose pixels are what the codeword makes them.
  unsigned int contradicted = 0; //!< Sectors whose pixels are what the other kind of sector would make them.
  double all = 0.;               //!< Pixels that show one sector alone.
  double explained = 0.;         //!< Those of them that are what the codeword makes them.
};

/*! Working memory of TrackPixels, used again from one marker to the next. */
struct TrackMemory
{
  /*! A pixel, as the marker has it. */
  struct Pixel
  {
    double turn = 0.;      //!< Direction from the centre, turns.
    double level = 0.;     //!< 0 ink, 1 paper.
    double ring = 0.;      //!< Share of the ring in it.
    double track = 0.;     //!< Share of the code track in it.
    double spread = 0.;    //!< Standard deviation of the blur around the marker, turns.
    double growth = 0.;    //!< By which black is larger there, turns.
    std::size_t cell = 0;  //!< Its place in the grid.
    bool isCutOff = false; //!< Whether it is that bright, or brighter.

    /*! Number of its part of the code track, of so many. */
    std::size_t partOf(unsigned int parts) const { return static_cast<std::size_t>(turn * parts) % parts; }

    /*! Whether it may show the print, whatever the sectors are. slack: what its level may be off. */
    bool mayBePrint(double slack) const { return level > 1. - ring - track - slack && level < 1. - ring + slack; }
  };
  /*! A pixel on the grid of sectors. */
  struct Placed
  {
    unsigned int sector = 0;
    double own = 0.;               //!< Share of its sector in it.
    double before = 0.;            //!< Share of the sector before.
    double after = 0.;             //!< Share of the sector after.
    double residual = 0.;          //!< Its level, less what it would be on a white track.
    bool isCutOff = false;         //!< Whether that is so much, or more.
    std::array<bool, 2> isTrusted; //!< Whether nothing like paper, like ink, is beside.
  };

  /*! A pixel on the grid of sectors, and the colours of three sectors that explain it. */
  struct Explained
  {
    unsigned int sector = 0;
    float residual = 0.f;        //!< Its level, less what it would be on a white track.
    std::array<float, 3> shares; //!< In the design, of the sector after its own, its own and the one before in it.
    //! What ink takes of white at the border to the one after, to the one before: if its own is black, if the other is.
    std::array<std::array<float, 2>, 2> growth;
    std::uint8_t byColours = 0; //!< One bit for each of the 8 ways to colour these three.
    bool isOnTrack = false;     //!< Whether it tells of its sector.
    bool isCutOff = false;      //!< Whether its level is that, or more.

    /*! Its level, less what it would be with these three sectors coloured so: bit 1 is its own. */
    float residualOf(unsigned int colours) const
    {
      float sum = residual;
      for (unsigned int bit = 0; bit < 3; ++bit) {
        sum += (colours >> bit) & 1U ? shares[bit] : 0.f;
      }
      for (unsigned int border = 0; border < 2; ++border) {
        const bool isBorder = ((colours >> border) ^ (colours >> (border + 1))) & 1U;
        sum += isBorder ? growth[border][(colours >> 1) & 1U ? 0 : 1] : 0.f;
      }
      return isCutOff ? std::max(sum, 0.f) : sum;
    }
  };

  std::vector<Pixel> pixels;        //!< Of the track and what is beside it.
  std::vector<Placed> placed;       //!< Those that show one sector alone.
  std::vector<Explained> explained; //!< All of the first.
  std::vector<int> grid;            //!< Numbers of the pixels by rows, -1 for those beside; a margin of one all around.
  std::size_t columns = 0;          //!< Of the grid.
};

/*!
  At the pose of a measured ring each pixel of the code track has the grey level that its sectors give it through the
  blur, to a hundredth of the contrast and the noise; or something covers it.
*/
class TrackPixels
{
public:
  /*!
    \param I : The image.
    \param camera : Its camera.
    \param ring : The ring.
    \param family : The family.
    \param memory : Working memory, in use as long as this object is.
  */
  TrackPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const MeasuredRing &ring,
              const vpCircleMarkerFamily &family, TrackMemory &memory);

  /*! Whether what covers the marker is, where the print is known, as dark as ink or as bright as paper. */
  bool hasCoverLikePrint() const { return m_hasLikePrint; }

  /*! The pixels of the track and beside it. */
  TrackMemory &getMemory() const { return m_memory; }

  /*! Standard deviation of a pixel's noise, share of the contrast. */
  double getNoise() const { return m_noise; }

  /*! What a pixel's level may be off. */
  double getSlack() const { return m_slack; }

  /*! Number of sectors. */
  unsigned int getSectors() const { return m_sectors; }

  /*! Adds to a reading what the pixels tell of the sectors, and improves its phase. */
  void improve(SectorReading &reading);

  /*! Sets the angle at which the first sector starts, rad. */
  void turnTo(double phase);

  /*! Judges a codeword: it gives all sectors, so that what each pixel should be is known. */
  CodewordVerdict judge(CyclicCode::Word word) const;

private:
  using Pixel = TrackMemory::Pixel;
  using Placed = TrackMemory::Placed;
  /*! What a sector is. */
  enum class Kind
  {
    UNKNOWN,
    WHITE,
    BLACK
  };
  using Kinds = std::array<Kind, mostSectors>;
  /*! Pixels of a sector. */
  struct Tally
  {
    double all = 0.;                            //!< Pixels that show the sector alone.
    std::array<double, 2> explained = {0., 0.}; //!< Those as they are if it is white, and if it is black.
    std::array<double, 2> trusted = {0., 0.};   //!< Those of them with nothing like them beside.
    std::array<double, 2> squares = {0., 0.};   //!< Sums of the squares of what is left of their levels.
  };
  using Tallies = std::array<Tally, mostSectors>;

  void collect(const vpImage<unsigned char> &I, const CameraModel &camera, const MeasuredRing &ring);
  void findCover();
  Tallies count(const Kinds &kinds) const;
  bool isSo(const Tally &tally, std::size_t kind, bool trusts) const;
  double fitOf(const Kinds &kinds) const;
  void improvePhase(const Kinds &kinds, double firstStep);
  Kinds kindsAlone() const;
  Kinds kindsOf(CyclicCode::Word word) const;

  const vpCircleMarkerLayout &m_layout;
  const unsigned int m_sectors;
  const double m_noise; //!< Standard deviation, share of the contrast.
  const double m_slack; //!< What a pixel's level may be off.
  bool m_hasLikePrint = false;
  TrackMemory &m_memory;
  std::vector<Pixel> &m_pixels;
  std::vector<Placed> &m_placed;            //!< Those that show one sector alone.
  double m_phase = 0.;                      //!< Of the grid of sectors, rad.
  std::array<bool, mostParts> m_inkCover;   //!< By parts of sectors: whether something there is like ink.
  std::array<bool, mostParts> m_paperCover; //!< Or like paper.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif

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
 * Pixels in blocks of lanes, sorted by what they see.
 */

/*!
  \file pixel_blocks.h
  \brief Pixels sorted by what they see of the print and packed in blocks of lanes.

  Most pixels near the ring see nothing of the code, and the other way round: each kind has a cheaper model of its own.
*/

#ifndef VP_CIRCLE_MARKER_PIXEL_BLOCKS_H
#define VP_CIRCLE_MARKER_PIXEL_BLOCKS_H

#include <array>
#include <optional>
#include <vector>

#include "refine/fit_pixel.h"
#include "refine/plane_lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! What a pixel may see of the print. */
enum class PixelSight
{
  RING,          //!< Edges of the ring at most.
  TRACK,         //!< Edges of the code track at most.
  RING_AND_TRACK //!< Both.
};
constexpr std::size_t pixelSights = 3;

/*! Borders between sectors that a pixel may see: the nearest one and as many to either side. */
constexpr int mostBorders = 5;

/*! Sectors around the marker's centre by which neighbouring pixels are told from others. */
constexpr std::size_t directions = 32;

/*! Variance of a lane that holds no pixel, grey levels^2. */
constexpr float noPixel = 1e30f;

/*! What a block's pixels may see of the code. */
struct SectorLanes
{
  Lanes acrossX, acrossY;    //!< Unit vector on the marker across the nearest border between sectors.
  Lanes base;                //!< 1 if the sector before the first border is black, 0 if it is white.
  Lanes change[mostBorders]; //!< Of each border: 1 from white to black, -1 from black to white, 0 if there is no edge.
};

/*! What a block's pixels may see beyond the paper. */
struct SurroundLanes
{
  //! For each shape of the paper, whether the surround is known (1, else 0), the share of it that a pixel sees if the
  //! paper ends there, and its grey level.
  Lanes isKnown[paperShapes];
  Lanes share[paperShapes];
  Lanes beyond[paperShapes];
  Lanes spread; //!< Most that the surround may change, grey levels.
};

/*! Pixels, as many as there are lanes, that may see the same parts of the print. */
struct PixelBlock
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  PlaceLanes place;            //!< Where the pixels are.
  Lanes offsetU, offsetV;      //!< In the coordinates of the ImageFrame.
  Lanes grey;                  //!< Grey level.
  Lanes variance;              //!< Of what the surround may change beside its share, grey levels^2; or noPixel.
  Lanes correction;            //!< What the parabolas of ImageModel lack of the share of black (correctBends()).
  std::size_t sectors = none;  //!< Place in PixelBlocks::sectors.
  std::size_t surround = none; //!< Place in PixelBlocks::surrounds.
};

/*! All pixels of a marker, in blocks. */
struct PixelBlocks
{
  /*! What a block sees beyond the paper; nullptr if nothing. */
  const SurroundLanes *surroundOf(const PixelBlock &block) const
  {
    return block.surround == PixelBlock::none ? nullptr : &surrounds[block.surround];
  }

  /*! What the pixels are sorted for. */
  struct Sorting
  {
    MarkerPlane plane;
    double seen = 0.; //!< How far each is thought to see, pixels, where the blur is round.
  };
  std::optional<Sorting> sorting; //!< Nothing: they are not sorted.

  ImageReference reference;                                 //!< Origin and unit of the places.
  int borders = mostBorders;                                //!< Borders that a pixel may see: 1, 3 or 5.
  std::array<std::vector<PixelBlock>, pixelSights> bySight; //!< Blocks of each kind.
  std::array<std::size_t, pixelSights> count = {{0, 0, 0}}; //!< Pixels of each kind.
  //! Direction from the marker's centre, below \e directions, of each block's first pixel: pixels come in its order.
  std::array<std::vector<unsigned char>, pixelSights> direction;

  std::vector<SectorLanes> sectors;     //!< Of the blocks that may see the code.
  std::vector<SurroundLanes> surrounds; //!< Of the blocks that may see the surround.

  // Working memory of packPixels().
  std::vector<unsigned char> bins;        //!< Kind and direction of each pixel.
  std::vector<unsigned int> sortedPixels; //!< Their numbers, by bin.
};

/*!
  How far pixels see the print, pixels, in coordinates in which the blur is round.
  \param blur : The blur, roughly.
  \param poseError : How far the pose may be off, pixels.
*/
double sightThrough(const BlurParameters &blur, double poseError);

/*!
  Whether pixels that are sorted into blocks are right for another pose, too, once the surround is judged by it
  (judgeSurround()).
  \param blocks : The pixels.
  \param plane : The other pose.
  \param pattern : The print.
  \param blur : The other blur.
  \param poseError : How far the pose may be off, pixels.
  \param mostSeen : Borders between sectors that a pixel may see at most: 1, 3 or 5.
*/
bool serve(const PixelBlocks &blocks, const MarkerPlane &plane, const MarkerPattern &pattern,
           const BlurParameters &blur, double poseError, int mostSeen);

/*!
  Sorts pixels into blocks.
  \param pixels : The pixels.
  \param plane : The pose, known to about a pixel.
  \param pattern : The print.
  \param photometry : Light and blur, roughly.
  \param noise : Standard deviation of a pixel's noise, grey levels; 0 if it is not known yet.
  \param poseError : How far the pose may be off and the sorting still be right, pixels.
  \param mostSeen : Borders between sectors that a pixel may see at most: 1, 3 or 5.
  \param blocks : The result; its memory is used again.
*/
void packPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const MarkerPattern &pattern,
                const Photometry &photometry, double noise, double poseError, int mostSeen, PixelBlocks &blocks);

/*! Judges again what the surround may do to sorted pixels; the parameters are those of packPixels(). */
void judgeSurround(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const MarkerPattern &pattern,
                   const Photometry &photometry, double noise, PixelBlocks &blocks);
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif

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
 * What all pixels of a covered code track say of all codewords.
 */

#ifndef VP_CIRCLE_MARKER_WORD_EVIDENCE_H
#define VP_CIRCLE_MARKER_WORD_EVIDENCE_H

#include <array>
#include <cstdint>
#include <vector>

#include "decode/cyclic_code.h"
#include "decode/seen_parts.h"
#include "decode/track_pixels.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The codeword for which the pixels of a covered track speak most. */
struct LikeliestWord
{
  CyclicCode::Word word = 0;
  double odds = 0.;           //!< Against all other codewords together, and what speaks against it, ln.
  double confirmed = 0.;      //!< Sectors that the pixels tell to be what the word makes them; doubtful ones in part.
  double confirmedBlack = 0.; //!< Those of them that are black.
  double contradicted = 0.;   //!< Sectors that the pixels tell to be the other kind.
};

/*! What is ink or paper on a track, in plain sight, though a word has the other there. */
struct OtherColours
{
  double ink = 0.;          //!< Where the word has white, share of all pixels of the track.
  double paper = 0.;        //!< Where it has black.
  unsigned int sectors = 0; //!< Sectors that are of the other colour above all.
};

/*! Sectors whose colour is told, bit by bit; the first sector is the highest bit of so many as there are sectors. */
struct PrintedSectors
{
  CyclicCode::Word black = 0;
  CyclicCode::Word white = 0;
};

/*!
  What the pixels of a covered code track say of words.

  A pixel shows a word if its grey level is what the word makes it, and those of the pixels beside it are, too: what
  covers the marker has such levels along its edge here and there, but not beside each other. The pixels of a sector
  that show a word are a part of the print, or of a cover that happens to have this grey level: the odds between the two
  are what the sector, or what is seen of it, says for the word. What a sector should look like depends on it and the
  two sectors to either side, so that the evidence is in tables of 32 entries a sector, and all codewords are compared.
*/
class WordEvidence
{
public:
  /*!
    \param pixels : The pixels; they have to stay, and their memory is used.
  */
  explicit WordEvidence(const TrackPixels &pixels);

  /*! Counts the pixels with the first sector beginning at an angle, rad. */
  void turnTo(double phase);

  /*!
    Turns the first sector's beginning, from where it is, to where a word explains the pixels best, those at the borders
    between black and white above all.
    \return The angle, rad.
  */
  double improvePhase(CyclicCode::Word word);

  /*! Takes what a word leaves unexplained and is as dark as ink or as bright as paper for covers, too. */
  void findCoverBeside(CyclicCode::Word word);

  /*!
    Whether another print lies on the track: what a word does not explain is as dark as ink here and as bright as paper
    there, or is like one of these though all of the ring is seen. A cover has one grey level, seldom one of these, or
    both. And it is scattered around the marker, in places where the ring is seen: bars hide both.
    \param word : The word.
    \param seen : What is seen of the marker, without what the word does not explain: leaveOutUnexplained().
  */
  bool isOtherPrint(CyclicCode::Word word, const SeenParts &seen) const;

  /*!
    What is ink or paper from rim to rim of the track though a word has the other, where ring, gap and centre beside it
    are what they should be: hardly anything that covers a track ends at its rims, but another code does. And sector by
    sector, by the pixels that show one alone, or by the likeliest of all prints (printedSectors()).
  */
  OtherColours otherColours(CyclicCode::Word word) const;

  /*!
    Leaves out of what is seen of ring, track and centre the directions in which a word does not explain the pixels, and
    those beside them. A bright cover over a black sector looks like a white one until the codeword is known.
  */
  void leaveOutUnexplained(CyclicCode::Word word, SeenParts &seen) const;

  /*! Pixels that show one sector above all, of each sector in the mean. */
  double pixelsPerSector() const;

  /*!
    What is printed if nothing covers the track: of all words, codewords or not, that for which most speaks. A
    codeword's print is its own, where it is seen; where it is covered the word is what the cover is most like.
    \return The sectors that the pixels tell to be black, and those that they tell to be white; the others are neither.
  */
  PrintedSectors printedSectors() const;

  /*! The codeword for which most speaks; it may be a constant one, which is no marker's. */
  LikeliestWord likeliest(const CyclicCode &code) const;

private:
  using Pixel = TrackMemory::Pixel;
  using Explained = TrackMemory::Explained;
  //! Colours of five sectors, 1 for black: bit 2 is the sector's own, bits 4 and 3 those of the two before it, bits 1
  //! and 0 those of the two after it. Shifted by 1 - k they end with those of the sector k after it and its neighbours.
  static constexpr unsigned int patterns = 32;
  using Table = std::array<std::array<float, patterns>, mostSectors>;

  /*! Numbers of pixels of a sector that show a pattern. */
  struct Tally
  {
    float counted = 0.f; //!< All.
    float trusted = 0.f; //!< Each by how little it may be a cover.
    float inner = 0.f;   //!< Those that show it to within the noise.
    float edges = 0.f;   //!< Those on an edge, which no cover of one grey level has.
    float cutOff = 0.f;  //!< Those as bright as the sensor can tell.
  };

  /*! What the pixels of a sector say for a pattern. */
  struct Told
  {
    float odds = 0.f;  //!< ln, that what shows it is the print, not a cover.
    float share = 0.f; //!< Share of the sector that is told.
  };

  Explained placedAt(const Pixel &pixel, double phase) const;
  double misfitAt(double phase, CyclicCode::Word word) const;
  void findRangeOfCutOff();
  void findCover();
  void spreadTrust();
  std::uint32_t patternsShownAt(std::size_t i) const;
  void count(std::size_t i, std::array<Tally, patterns> &ofSector) const;
  Told toldBy(const Tally &tally) const;
  void weigh();

  const TrackPixels &m_pixels;
  const unsigned int m_sectors;
  const float m_slack;
  const float m_inner;       //!< What noise leaves of most pixels of a flat part, share of the contrast.
  const float m_innerAtEdge; //!< The same at an edge.
  std::vector<Explained> &m_explained;
  std::array<std::array<int, mostParts>, 2> m_cover;   //!< Pixels like paper (0), ink (1), by parts of sectors.
  std::array<std::array<float, mostParts>, 2> m_trust; //!< In paper, in ink, by parts of sectors.
  Table m_evidence;                                    //!< Log-odds for what is seen of a sector.
  double m_cutOffRange = 1e-3;                         //!< Levels that the sensor does not tell from paper.
  Table m_told;                                        //!< Share of a sector that is told.
  double m_phase = 0.;                                 //!< Where the first sector begins, rad.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif

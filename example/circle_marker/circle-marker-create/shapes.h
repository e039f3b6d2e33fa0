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
 * What a printed sheet is made of: black shapes on white paper.
 */

#ifndef VP_CREATE_SHAPES_H
#define VP_CREATE_SHAPES_H

#include <string>
#include <variant>
#include <vector>

/*!
  Pictures are lists of black shapes on white paper, in millimetres, x right and y down from the upper left corner.
  Angles are in radians from +x toward +y, clockwise as a viewer sees the print. The layout makes them, the encoders
  (PDF, PNG, SVG) draw them.
*/
namespace create {
/*! A part of a ring between two radii; inner radius 0: of a disc; sweep 2 pi: the whole ring. */
struct AnnularSector
{
  double x, y;         //!< Centre.
  double outer, inner; //!< Radii.
  double start, sweep; //!< First angle and the angle spanned.
};

/*! An upright square out of which annular sectors are cut, none overlapping another. */
struct PiercedSquare
{
  double left, top, side;
  std::vector<AnnularSector> holes;
};

/*! A straight line with square ends at its two points. */
struct Line
{
  double x1, y1, x2, y2; //!< The two ends.
  double thickness;
};

/*! A line of text. */
struct Text
{
  double x, y;      //!< Middle of the text on its base line.
  double height;    //!< Size of the font (the em).
  std::string text; //!< ASCII.
};

using Shape = std::variant<AnnularSector, PiercedSquare, Line, Text>;

struct Picture
{
  double width, height;      //!< Of the paper.
  std::string title;         //!< For the reader of the file, not drawn.
  std::vector<Shape> shapes; //!< None overlaps another.
};
} // namespace create

#endif

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
 * Measuring a rendered page in millimetres.
 */

#ifndef VP_TEST_RENDERED_PAGE_H
#define VP_TEST_RENDERED_PAGE_H

#include <cstdint>
#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace test {
/*! A page as pixels, measured in millimetres from its upper left corner, x right and y down. */
class RenderedPage
{
public:
  RenderedPage(const cv::Mat &grey, double pixelsPerMillimetre);

  /*! Grey level between the pixels' centres, bilinear; white beyond the page. */
  double at(double x, double y) const;

  /*! Darkest pixel whose whole area lies in a square and out of the circle at its centre. */
  int darkestAround(double x, double y, double side, double diameter) const;

  /*! A circle between black and white, fitted to its crossings of the middle grey. */
  struct Circle
  {
    double x, y;      //!< Centre.
    double diameter;  //!< Mean.
    double roundness; //!< Largest deviation of the radius from that of the fitted circle.
  };

  /*!
    Looks along rays from the point (x, y) for the crossing of the middle grey between two radii.
    \e from and \e to: Radii between which there is one crossing; the search goes from the first to the second.
  */
  Circle circleAround(double x, double y, double from, double to) const;

  /*!
    The word of a code track, sector 0 first, read with the plain geometry of its definition: sector k of n spans
    2 pi k/n to 2 pi (k+1)/n from +x toward +y, between 0.40 and 0.68 of the outer radius.
    \e clean: Whether every sector is uniform: all white or all black.
  */
  std::uint32_t wordAround(double x, double y, double diameter, unsigned int nbSectors, bool &clean) const;

  /*! Length of the dark run along the row y between two abscissas, from its crossings of the middle grey. */
  double darkLength(double y, double fromX, double toX) const;

  double getWidth() const { return m_grey.cols / m_density; }
  double getHeight() const { return m_grey.rows / m_density; }
  int getColumns() const { return m_grey.cols; }
  int getRows() const { return m_grey.rows; }

private:
  cv::Mat m_grey;   //!< 8 bits.
  double m_density; //!< Pixels a millimetre.
};

/*! Whether a program of which the build knows the path was not found then. */
bool isMissing(const char *program);

/*! A picture of a page. */
RenderedPage loadPage(const std::filesystem::path &file, double pixelsPerMillimetre);

/*! A page of a PDF as poppler draws it, which is also in page.pgm in the folder then. */
RenderedPage renderPdf(const std::filesystem::path &folder, const std::string &file, int page, int dotsPerInch);

/*! An SVG picture of a width of \e width millimetres as librsvg draws it, with \e density pixels a millimetre. */
RenderedPage renderSvg(const std::filesystem::path &folder, const std::string &file, double width, double density);
} // namespace test

#endif

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
 * Pictures drawn with cairo: PDF and PNG.
 */

#include <cmath>
#include <memory>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo.h>

#include "encode.h"

namespace create {
namespace {
using Surface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t *)>;
using Context = std::unique_ptr<cairo_t, void (*)(cairo_t *)>;

constexpr double pointsPerMillimetre = 72 / 25.4; // The unit of PDF is the point of 1/72 inch.

// Largest distance of cairo's curves from the true circle, pixels or points: far below what prints (1 point is 0.35
// mm).
constexpr double tolerance = 0.002;

void check(cairo_status_t status)
{
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("cairo could not draw the picture: ") + cairo_status_to_string(status));
  }
}

cairo_status_t appendTo(void *content, const unsigned char *data, unsigned int length)
{
  static_cast<std::string *>(content)->append(reinterpret_cast<const char *>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/*! Draws shapes in a context whose unit is the millimetre. */
struct Pen
{
  cairo_t *context;

  void operator()(const AnnularSector &sector) const
  {
    cairo_new_path(context);
    trace(sector);
    cairo_fill(context);
  }

  void operator()(const PiercedSquare &square) const
  {
    cairo_new_path(context);
    cairo_rectangle(context, square.left, square.top, square.side, square.side);
    for (const AnnularSector &hole : square.holes) {
      trace(hole);
    }
    cairo_save(context);
    cairo_set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill(context);
    cairo_restore(context);
  }

  /*! Adds the border of a sector to the path. */
  void trace(const AnnularSector &sector) const
  {
    const double end = sector.start + sector.sweep;
    const bool whole = sector.sweep > 2 * std::acos(-1.) - 1e-9;
    cairo_new_sub_path(context);
    cairo_arc(context, sector.x, sector.y, sector.outer, sector.start, end);
    if (whole) {
      cairo_close_path(context);
      cairo_new_sub_path(context);
    }
    if (sector.inner > 0) {
      cairo_arc_negative(context, sector.x, sector.y, sector.inner, end, sector.start); // Backward: a hole.
    }
    else if (!whole) {
      cairo_line_to(context, sector.x, sector.y);
    }
    cairo_close_path(context);
  }

  void operator()(const Line &line) const
  {
    cairo_set_line_width(context, line.thickness);
    cairo_move_to(context, line.x1, line.y1);
    cairo_line_to(context, line.x2, line.y2);
    cairo_stroke(context);
  }

  void operator()(const Text &text) const
  {
    cairo_text_extents_t extents;
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, text.height);
    cairo_text_extents(context, text.text.c_str(), &extents);
    cairo_move_to(context, text.x - extents.x_advance / 2, text.y);
    cairo_show_text(context, text.text.c_str());
  }
};

void draw(const Picture &picture, cairo_t *context, double unitsPerMillimetre)
{
  cairo_save(context);
  cairo_scale(context, unitsPerMillimetre, unitsPerMillimetre);
  cairo_set_tolerance(context, tolerance);
  cairo_set_antialias(context, CAIRO_ANTIALIAS_BEST);
  cairo_set_source_rgb(context, 0, 0, 0);
  for (const Shape &shape : picture.shapes) {
    std::visit(Pen{context}, shape);
  }
  cairo_restore(context);
  check(cairo_status(context));
}
} // namespace

std::string encodePdf(const std::vector<Picture> &pictures)
{
  std::string content;
  const Surface surface(cairo_pdf_surface_create_for_stream(appendTo, &content, 1, 1), cairo_surface_destroy);
  if (!pictures.empty()) {
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, pictures.front().title.c_str());
  }
  {
    const Context context(cairo_create(surface.get()), cairo_destroy);
    for (const Picture &picture : pictures) {
      cairo_pdf_surface_set_size(surface.get(), picture.width * pointsPerMillimetre,
                                 picture.height * pointsPerMillimetre);
      draw(picture, context.get(), pointsPerMillimetre);
      cairo_show_page(context.get());
    }
  }
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return content;
}

std::string encodePng(const Picture &picture, const Raster &raster)
{
  // Ink on a surface of coverage alone, inverted to grey afterwards: one byte a pixel, and cairo writes it as grey.
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, raster.width, raster.height),
                        cairo_surface_destroy);
  check(cairo_surface_status(surface.get()));
  {
    const Context context(cairo_create(surface.get()), cairo_destroy);
    draw(picture, context.get(), raster.pixelsPerMillimetre);
  }
  cairo_surface_flush(surface.get());
  unsigned char *pixels = cairo_image_surface_get_data(surface.get());
  const std::size_t nbBytes =
      static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get())) * static_cast<std::size_t>(raster.height);
  for (std::size_t i = 0; i < nbBytes; ++i) {
    pixels[i] = static_cast<unsigned char>(255 - pixels[i]);
  }
  cairo_surface_mark_dirty(surface.get());

  std::string png;
  check(cairo_surface_write_to_png_stream(surface.get(), appendTo, &png));
  return withDensity(png, raster.pixelsPerMillimetre * 1000);
}
} // namespace create

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
 * A report of headings, paragraphs, tables and figures, as HTML and as Markdown.
 */

#ifndef VP_COMMON_DOCUMENT_H
#define VP_COMMON_DOCUMENT_H

#include <string>
#include <variant>
#include <vector>

namespace common {
/*! Text is plain: it is escaped where it is written. */
class Document
{
public:
  explicit Document(const std::string &title) : m_title(title) {}

  void addHeading(const std::string &text);
  void addParagraph(const std::string &text);
  /*! Lines as they are: a command. */
  void addListing(const std::string &text);
  /*! \e rows: Each with as many cells as there are titles; the first cell names the row. */
  void addTable(const std::string &caption, const std::vector<std::string> &titles,
                const std::vector<std::vector<std::string>> &rows);
  /*! \e file: Name of an SVG file in the document's folder. */
  void addFigure(const std::string &file, const std::string &caption);

  /*! A whole page in one file, but for the figures. */
  std::string html() const;
  std::string markdown() const;

private:
  struct Heading
  {
    std::string text;
  };
  struct Paragraph
  {
    std::string text;
  };
  struct Listing
  {
    std::string text;
  };
  struct Table
  {
    std::string caption;
    std::vector<std::string> titles;
    std::vector<std::vector<std::string>> rows;
  };
  struct Figure
  {
    std::string file, caption;
  };

  static std::string html(const Heading &heading);
  static std::string html(const Paragraph &paragraph);
  static std::string html(const Listing &listing);
  static std::string html(const Table &table);
  static std::string html(const Figure &figure);
  static std::string markdown(const Heading &heading);
  static std::string markdown(const Paragraph &paragraph);
  static std::string markdown(const Listing &listing);
  static std::string markdown(const Table &table);
  static std::string markdown(const Figure &figure);

  std::string m_title;                                                           //!< Of the page.
  std::vector<std::variant<Heading, Paragraph, Listing, Table, Figure>> m_parts; //!< In their order.
};
} // namespace common

#endif

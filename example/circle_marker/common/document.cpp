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

#include <sstream>

#include "document.h"

namespace common {
namespace {
std::string escapedForHtml(const std::string &text)
{
  std::string result;
  for (const char letter : text) {
    switch (letter) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += letter;
    }
  }
  return result;
}

/*! A bar would end a table's cell, a less-than sign begin a tag. */
std::string escapedForMarkdown(const std::string &text)
{
  std::string result;
  for (const char letter : text) {
    if (letter == '|' || letter == '<' || letter == '*' || letter == '_') {
      result += '\\';
    }
    result += letter;
  }
  return result;
}

// Numbers stand below one another on the right; a page as wide as its figures.
constexpr const char *style = R"(
body { font-family: sans-serif; max-width: 1240px; margin: 2em auto; padding: 0 1em; color: #222; line-height: 1.4; }
table { border-collapse: collapse; margin: 1em 0; font-size: 0.92em; }
caption { text-align: left; font-weight: bold; padding: 0.3em 0; }
th, td { border: 1px solid #ccc; padding: 0.25em 0.7em; text-align: right; }
th { background: #f2f2f2; }
th:first-child, td:first-child { text-align: left; }
figure { margin: 1.5em 0; }
figure img { width: 100%; }
figcaption { font-size: 0.92em; }
pre { background: #f2f2f2; padding: 0.6em; }
)";
} // namespace

void Document::addHeading(const std::string &text)
{
  m_parts.push_back(Heading{text});
}

void Document::addParagraph(const std::string &text)
{
  m_parts.push_back(Paragraph{text});
}

void Document::addListing(const std::string &text)
{
  m_parts.push_back(Listing{text});
}

void Document::addTable(const std::string &caption, const std::vector<std::string> &titles,
                        const std::vector<std::vector<std::string>> &rows)
{
  m_parts.push_back(Table{caption, titles, rows});
}

void Document::addFigure(const std::string &file, const std::string &caption)
{
  m_parts.push_back(Figure{file, caption});
}

std::string Document::html() const
{
  const std::string title = escapedForHtml(m_title);
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + title +
                     "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n";
  for (const auto &part : m_parts) {
    page += std::visit([](const auto &p) { return html(p); }, part);
  }
  return page + "</body>\n</html>\n";
}

std::string Document::html(const Heading &heading)
{
  return "<h2>" + escapedForHtml(heading.text) + "</h2>\n";
}

std::string Document::html(const Paragraph &paragraph)
{
  return "<p>" + escapedForHtml(paragraph.text) + "</p>\n";
}

std::string Document::html(const Listing &listing)
{
  return "<pre>" + escapedForHtml(listing.text) + "</pre>\n";
}

std::string Document::html(const Table &table)
{
  std::string text = "<table>\n<caption>" + escapedForHtml(table.caption) + "</caption>\n<tr>";
  for (const std::string &title : table.titles) {
    text += "<th>" + escapedForHtml(title) + "</th>";
  }
  text += "</tr>\n";
  for (const auto &row : table.rows) {
    text += "<tr>";
    for (const std::string &cell : row) {
      text += "<td>" + escapedForHtml(cell) + "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string Document::html(const Figure &figure)
{
  const std::string caption = escapedForHtml(figure.caption);
  return "<figure><img src=\"" + escapedForHtml(figure.file) + "\" alt=\"" + caption + "\"><figcaption>" + caption +
         "</figcaption></figure>\n";
}

std::string Document::markdown() const
{
  std::string text = "# " + escapedForMarkdown(m_title) + "\n";
  for (const auto &part : m_parts) {
    text += "\n" + std::visit([](const auto &p) { return markdown(p); }, part);
  }
  return text;
}

std::string Document::markdown(const Heading &heading)
{
  return "## " + escapedForMarkdown(heading.text) + "\n";
}

std::string Document::markdown(const Paragraph &paragraph)
{
  return escapedForMarkdown(paragraph.text) + "\n";
}

std::string Document::markdown(const Listing &listing)
{
  return "```\n" + listing.text + "\n```\n";
}

std::string Document::markdown(const Table &table)
{
  std::string text = "**" + escapedForMarkdown(table.caption) + "**\n\n|";
  std::string rule = "|";
  for (const std::string &title : table.titles) {
    text += " " + escapedForMarkdown(title) + " |";
    rule += rule.size() == 1 ? "---|" : "---:|";
  }
  text += "\n" + rule + "\n";
  for (const auto &row : table.rows) {
    text += "|";
    for (const std::string &cell : row) {
      text += " " + escapedForMarkdown(cell) + " |";
    }
    text += "\n";
  }
  return text;
}

std::string Document::markdown(const Figure &figure)
{
  const std::string caption = escapedForMarkdown(figure.caption);
  return "![" + caption + "](" + figure.file + ")\n\n" + caption + "\n";
}
} // namespace common

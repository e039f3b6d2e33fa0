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
 * JSON values that know the line of the file they stand on.
 */

#include "support/json_lines.h"

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
/*! Goes through a text and notes the line of the last character that is no white space. */
class CountingIterator
{
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char *;
  using reference = const char &;

  CountingIterator(pointer place, unsigned int *line) : m_place(place), m_line(line) {}

  reference operator*() const { return *m_place; }
  CountingIterator &operator++()
  {
    if (*m_place == '\n') {
      ++m_current;
    }
    else if (std::isspace(static_cast<unsigned char>(*m_place)) == 0) {
      *m_line = m_current;
    }
    ++m_place;
    return *this;
  }
  CountingIterator operator++(int)
  {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator &other) const { return m_place == other.m_place; }
  bool operator!=(const CountingIterator &other) const { return m_place != other.m_place; }

private:
  pointer m_place;            //!< In the text.
  unsigned int m_current = 1; //!< Line of that place.
  unsigned int *m_line;       //!< Where the line is noted.
};

/*!
  Builds the tree from the parser's events. The parser has read one character beyond a number: the next line's where
  a number ends a line, but that is white space; and beyond nothing else.
*/
class Builder : public nlohmann::json_sax<nlohmann::json>
{
public:
  Builder(const unsigned int &line, std::size_t deepest) : m_line(line), m_deepest(deepest) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t &) override { return add(value); }
  bool string(string_t &value) override { return add(value); }
  bool binary(binary_t &) override { return false; }
  bool start_object(std::size_t) override { return open(JsonNode::Kind::Object); }
  bool start_array(std::size_t) override { return open(JsonNode::Kind::Array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t &name) override
  {
    if (m_open.back()->find(name) != nullptr) {
      refuseAtLine(m_line, "\"" + name + "\" is there twice in the same object; remove one");
    }
    m_name = name;
    return true;
  }

  bool parse_error(std::size_t, const std::string &, const nlohmann::detail::exception &error) override
  {
    // Of "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error ..." the end: the line is
    // ours.
    const std::string text = error.what();
    const std::size_t start = text.find("syntax error");
    refuseAtLine(m_line, start == std::string::npos ? text : text.substr(start));
  }

  JsonNode root;

private:
  JsonNode &place(JsonNode::Kind kind)
  {
    JsonNode node;
    node.kind = kind;
    node.line = m_line;
    if (m_open.empty()) {
      root = std::move(node);
      return root;
    }
    m_open.back()->children.emplace_back(m_name, std::move(node));
    m_name.clear();
    return m_open.back()->children.back().second;
  }
  template <typename Value> bool add(const Value &value)
  {
    place(JsonNode::Kind::Scalar).scalar = value;
    return true;
  }
  bool open(JsonNode::Kind kind)
  {
    if (m_open.size() >= m_deepest) {
      refuseAtLine(m_line,
                   "lists and objects are nested more than " + std::to_string(m_deepest) + " deep; flatten them");
    }
    // Only the last child of an open node grows: the pointers to those above stay good.
    m_open.push_back(&place(kind));
    return true;
  }
  bool close()
  {
    m_open.pop_back();
    return true;
  }

  const unsigned int &m_line;     //!< Line of the last character that was read.
  std::size_t m_deepest;          //!< How many lists and objects may lie in each other.
  std::vector<JsonNode *> m_open; //!< Objects and arrays that are not complete, from the outside.
  std::string m_name;             //!< Of the member that comes next.
};
} // namespace

const JsonNode *JsonNode::find(const std::string &name) const
{
  const auto child = std::find_if(children.begin(), children.end(), [&](const auto &c) { return c.first == name; });
  return kind == Kind::Object && child != children.end() ? &child->second : nullptr;
}

nlohmann::json valueOf(const JsonNode &node)
{
  switch (node.kind) {
  case JsonNode::Kind::Object: {
    nlohmann::json object = nlohmann::json::object();
    for (const auto &[name, child] : node.children) {
      object[name] = valueOf(child);
    }
    return object;
  }
  case JsonNode::Kind::Array: {
    nlohmann::json array = nlohmann::json::array();
    for (const auto &[name, child] : node.children) {
      (void)name;
      array.push_back(valueOf(child));
    }
    return array;
  }
  default:
    return node.scalar;
  }
}

JsonNode parseWithLines(const std::string &text, std::size_t deepest)
{
  unsigned int line = 1;
  Builder builder(line, deepest);
  nlohmann::json::sax_parse(CountingIterator(text.data(), &line), CountingIterator(text.data() + text.size(), &line),
                            &builder);
  return std::move(builder.root);
}

void refuseAtLine(unsigned int line, const std::string &problem)
{
  throw vpException(vpException::badValue, "line %u: %s", line, problem.c_str());
}
} // namespace circle_marker
END_VISP_NAMESPACE
#endif

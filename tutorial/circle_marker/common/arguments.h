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
 * What a command line comes to.
 */

#ifndef VP_TUTORIAL_ARGUMENTS_H
#define VP_TUTORIAL_ARGUMENTS_H

#include <optional>
#include <stdexcept>
#include <string>

namespace tutorial {
/*! Wrong arguments: the program ends with 2. */
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*! What a command line asks for: an order, or a text to be shown instead, such as the help. */
template <class Order> struct RequestFor
{
  std::optional<Order> order;
  std::string text;
};
} // namespace tutorial

#endif

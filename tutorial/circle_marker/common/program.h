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
 * What every program's main does: errors to the standard error, and the exit status.
 */

#ifndef VP_TUTORIAL_PROGRAM_H
#define VP_TUTORIAL_PROGRAM_H

#include <exception>
#include <iostream>
#include <string>

#include "arguments.h"

namespace tutorial {
/*!
  A program as its user sees it: by its name.
*/
class Program
{
public:
  explicit Program(const std::string &name) : m_name(name) {}

  /*! Says on the standard error what is wrong. */
  void complain(const std::string &message) const { std::cerr << m_name << ": " << message << std::endl; }

  /*!
    Does what the command line asks for.

    \param parseCommandLine : Makes of the arguments a RequestFor<an order>.
    \param argc, argv : As main() has them.
    \param carryOut : Carries out an order; returns the exit status, 0 for done and 1 if an input could not be used.
    \return The exit status: that of \e carryOut, 0 if a text was asked for, 2 after a UsageError and 1 after any other
    exception.
  */
  template <class Parse, class CarryOut>
  int run(const Parse &parseCommandLine, int argc, const char *const argv[], const CarryOut &carryOut) const
  {
    try {
      const auto request = parseCommandLine(argc, argv);
      int status = 0;
      if (request.order) {
        status = carryOut(*request.order);
      }
      else {
        std::cout << request.text;
      }
      if (!std::cout.flush()) {
        complain("the standard output could not be written; is its disk full?");
        return 1;
      }
      return status;
    }
    catch (const UsageError &e) {
      complain(e.what());
      return 2;
    }
    catch (const std::exception &e) {
      complain(e.what());
      return 1;
    }
  }

private:
  std::string m_name; //!< As it is called.
};
} // namespace tutorial

#endif

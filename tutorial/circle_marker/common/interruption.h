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
 * Ctrl-C: a program that is told to end does so in its own time, and keeps what it has.
 */

#ifndef VP_TUTORIAL_INTERRUPTION_H
#define VP_TUTORIAL_INTERRUPTION_H

#include <csignal>

namespace tutorial {
/*! Set by the handler of signals, which can reach nothing else. */
inline volatile std::sig_atomic_t interruptionSeen = 0;

/*! From here on Ctrl-C and SIGTERM do not end the program. */
inline void watchInterruption()
{
  const auto handler = [](int) { interruptionSeen = 1; };
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
}

/*! \return Whether the user has asked the program to end. */
inline bool isInterrupted()
{
  return interruptionSeen != 0;
}
} // namespace tutorial

#endif

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
 * Loops over whole numbers that use what the processor has.
 */

/*!
  \file support/wider_registers.h
  \brief Functions that are compiled for wider registers as well.
*/

#ifndef VP_CIRCLE_MARKER_WIDER_REGISTERS_H
#define VP_CIRCLE_MARKER_WIDER_REGISTERS_H

/*!
  \def VP_CIRCLE_MARKER_WIDER_REGISTERS
  Before a function: it is compiled for AVX2, too, and that is called where the processor has it. Only for functions of
  whole numbers, whose results are the same; those of fractions might be rounded once less.
*/
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && defined(__OPTIMIZE__) &&  \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VP_CIRCLE_MARKER_WIDER_REGISTERS __attribute__((target_clones("avx2", "default")))
#else
#define VP_CIRCLE_MARKER_WIDER_REGISTERS
#endif

#endif

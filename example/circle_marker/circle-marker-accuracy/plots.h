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
 * The plots of the report page.
 */

#ifndef VP_ACCURACY_PLOTS_H
#define VP_ACCURACY_PLOTS_H

#include <vector>

#include "common/figure.h"
#include "summary.h"

namespace accuracy {
/*! Those for which there are records. */
std::vector<common::Figure> figuresOf(const Records &records);
} // namespace accuracy

#endif

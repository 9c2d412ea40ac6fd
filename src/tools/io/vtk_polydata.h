// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "cloud.h"

namespace filmsticking::io {

/// Points, colours (none, or one a point) and triangles for VTK, in double precision.
vtkSmartPointer<vtkPolyData> to_polydata(const std::vector<Point>& positions,
                                         const std::vector<Colour>& colours,
                                         const std::vector<Triangle>& triangles);

}  // namespace filmsticking::io

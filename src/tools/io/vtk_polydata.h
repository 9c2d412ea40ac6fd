// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "model.h"

namespace filmsticking::io {

/// The same points, colours and triangles for VTK, in double precision.
vtkSmartPointer<vtkPolyData> to_polydata(const Model& model);

}  // namespace filmsticking::io

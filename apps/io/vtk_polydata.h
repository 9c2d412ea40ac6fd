// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "model.h"

namespace filmsticking::io {

/// The same points, colours and triangles for VTK, in double precision.
vtkSmartPointer<vtkPolyData> to_polydata(const Model& model);

/// Points and polygons (as fans of triangles) of a VTK data set. Throws IoError.
Model from_polydata(vtkPolyData* data);

/// Reads a legacy VTK file of polygonal data by VTK. Throws IoError.
Model read_vtk(const std::string& path);

/// A binary legacy VTK file (version 4.2, which all readers know) with double coordinates.
std::string encode_vtk(const Model& model);

}  // namespace filmsticking::io

// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_surface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>
#include <stdexcept>

namespace filmsticking::bench {
namespace {

constexpr double kMostCells = 5e7;

// No corner of the grid is nearer to the surface, in cells: else two vertices could fall on one place.
constexpr double kLeastOffset = 0.01;

}  // namespace

Mesh make_level_surface(const Field& field, const Vec3& low, const Vec3& high, double cell) {
  const Vec3 cells = ((high - low) / cell).array().ceil();
  if (!(cells.prod() <= kMostCells)) throw std::invalid_argument("the shape is too fine to be made");
  vtkNew<vtkImageData> image;
  image->SetDimensions(int(cells.x()) + 1, int(cells.y()) + 1, int(cells.z()) + 1);
  image->SetOrigin(low.data());
  image->SetSpacing(cell, cell, cell);
  image->AllocateScalars(VTK_DOUBLE, 1);
  auto* values = static_cast<double*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
    Vec3 p;
    image->GetPoint(i, p.data());
    const double value = field(p);
    values[i] = std::copysign(std::max(std::abs(value), kLeastOffset * cell), value);
  }

  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData* surface = contour->GetOutput();
  Mesh mesh;
  mesh.positions.resize(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    surface->GetPoint(static_cast<vtkIdType>(i), mesh.positions[i].data());
  const auto corners = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (corners->GoToFirstCell(); !corners->IsDoneWithTraversal(); corners->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* c = nullptr;
    corners->GetCurrentCell(count, c);
    mesh.triangles.push_back({int(c[0]), int(c[2]), int(c[1])});  // VTK has the larger values inside
  }
  return mesh;
}

}  // namespace filmsticking::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_polydata.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

namespace filmsticking::io {

vtkSmartPointer<vtkPolyData> to_polydata(const Model& model) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(model.positions.size()));
  for (std::size_t i = 0; i < model.positions.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), model.positions[i].data());
  vtkNew<vtkCellArray> triangles;
  for (const Triangle& triangle : model.triangles) {
    const vtkIdType corners[3] = {triangle[0], triangle[1], triangle[2]};
    triangles->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  if (!model.colours.empty()) {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("RGB");
    colours->SetNumberOfComponents(3);
    for (const Colour& colour : model.colours) colours->InsertNextTypedTuple(colour.data());
    data->GetPointData()->SetScalars(colours);
  }
  return data;
}

}  // namespace filmsticking::io

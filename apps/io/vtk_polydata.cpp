// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_polydata.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkUnsignedCharArray.h>

#include "io_error.h"

namespace filmsticking::io {
namespace {

/// VTK reports in several lines of its own; here one sentence is enough.
class QuietVtk {
 public:
  QuietVtk() { vtkObject::GlobalWarningDisplayOff(); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(display_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int display_ = vtkObject::GetGlobalWarningDisplay();
};

}  // namespace

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

Model from_polydata(vtkPolyData* data) {
  Model model;
  const vtkIdType count = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i) {
    Point p{};
    data->GetPoint(i, p.data());
    model.positions.push_back(p);
  }
  const auto* colours = vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetScalars());
  if (colours && colours->GetNumberOfComponents() >= 3 && colours->GetNumberOfTuples() == count)
    for (vtkIdType i = 0; i < count; ++i)
      model.colours.push_back({colours->GetTypedComponent(i, 0), colours->GetTypedComponent(i, 1),
                               colours->GetTypedComponent(i, 2)});

  const auto polygons = vtkSmartPointer<vtkCellArrayIterator>::Take(data->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell()) {
    vtkIdList* polygon = polygons->GetCurrentCell();
    const auto corner = [&](vtkIdType k) {
      const vtkIdType id = polygon->GetId(k);
      if (id < 0 || id >= count) throw IoError("a face in it names a vertex that does not exist");
      return static_cast<std::int32_t>(id);
    };
    for (vtkIdType k = 2; k < polygon->GetNumberOfIds(); ++k)
      model.triangles.push_back({corner(0), corner(k - 1), corner(k)});
  }
  return model;
}

Model read_vtk(const std::string& path) {
  const QuietVtk quiet;
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  if (!reader->IsFilePolyData()) throw IoError("it is not a legacy VTK file of polygons");
  reader->Update();
  if (reader->GetErrorCode() != 0) throw IoError("it is not a whole VTK file");
  return from_polydata(reader->GetOutput());
}

std::string encode_vtk(const Model& model) {
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(to_polydata(model));
  writer->SetFileTypeToBinary();
  writer->SetFileVersion(vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);
  writer->WriteToOutputStringOn();
  if (!writer->Write()) throw IoError("VTK could not encode the mesh");
  return writer->GetOutputStdString();
}

}  // namespace filmsticking::io

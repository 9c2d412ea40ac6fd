// SPDX-License-Identifier: GPL-3.0-or-later
// Legacy VTK files: as VTK writes them, and as nobody should.
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <string>

#include "io/codecs.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "io/vtk_polydata.h"
#include "support/model.h"

namespace filmsticking::test {
namespace {

using io::Colour;
using io::IoError;

/// Of coordinates that text of VTK's keeps.
Model square() {
  Model model;
  model.positions = {{0.5, 0, -2}, {1.25, 0, 0}, {1, 1.5, 0}, {0, 1, 0.125}, {3, 3, 3}};
  model.colours = {Colour{0, 1, 2}, Colour{253, 254, 255}, Colour{127, 128, 129}, Colour{10, 200, 30},
                   Colour{7, 77, 177}};
  model.triangles = {{0, 1, 2}, {0, 2, 3}};
  return model;
}

std::string written(vtkPolyData* data, bool binary, int version) {
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileType(binary ? VTK_BINARY : VTK_ASCII);
  writer->SetFileVersion(version);
  writer->WriteToOutputStringOn();
  EXPECT_TRUE(writer->Write());
  return writer->GetOutputStdString();
}

vtkSmartPointer<vtkPolyData> polydata(const Model& model) {
  return io::to_polydata(model.positions, model.colours, model.triangles);
}

constexpr int kVersions[] = {vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2,
                             vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_5_1};

void expect_same(const Model& model, const Model& expected) {
  EXPECT_EQ(model.positions, expected.positions);
  EXPECT_EQ(model.colours, expected.colours);
  EXPECT_EQ(model.triangles, expected.triangles);
}

/// A square, a strip of three triangles, and all that VTK hangs on to a data set.
vtkSmartPointer<vtkPolyData> laden() {
  const vtkSmartPointer<vtkPolyData> data = polydata(square());
  vtkNew<vtkCellArray> polygons, strips, lines, vertices;
  const vtkIdType corners[] = {0, 1, 2, 3}, strip[] = {0, 1, 2, 3, 4};
  polygons->InsertNextCell(4, corners);
  strips->InsertNextCell(5, strip);
  lines->InsertNextCell(3, strip);
  vertices->InsertNextCell(1, strip);
  vertices->InsertNextCell(2, strip);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  data->SetLines(lines);
  data->SetVerts(vertices);
  const auto array = [](auto values, const char* name, int components, vtkIdType tuples) {
    values->SetName(name);
    values->SetNumberOfComponents(components);
    values->SetNumberOfTuples(tuples);
    for (int k = 0; k < components; ++k) values->FillComponent(k, k + 0.5);
    return values;
  };
  using Doubles = vtkNew<vtkDoubleArray>;
  Doubles normals, places, tensors, more, of_cells, field;
  vtkNew<vtkFloatArray> vectors;
  vtkNew<vtkIntArray> numbers;
  data->GetPointData()->SetNormals(array(normals.Get(), "normals", 3, 5));
  data->GetPointData()->SetTCoords(array(places.Get(), "places", 2, 5));
  data->GetPointData()->SetTensors(array(tensors.Get(), "tensors", 9, 5));
  data->GetPointData()->SetVectors(array(vectors.Get(), "vectors", 3, 5));
  data->GetPointData()->AddArray(array(more.Get(), "an odd name, of more", 4, 5));
  more->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "m");  // goes into a METADATA part
  data->GetCellData()->SetScalars(array(of_cells.Get(), "of cells", 1, data->GetNumberOfCells()));
  data->GetCellData()->AddArray(array(numbers.Get(), "numbers", 1, data->GetNumberOfCells()));
  data->GetFieldData()->AddArray(array(field.Get(), "field", 2, 7));
  return data;
}

TEST(Vtk, IsWrittenInBinaryOfAVersionThatAllReadersKnow) {
  const std::string bytes = io::encode_mesh("vtk", square());
  EXPECT_EQ(
      bytes.rfind("# vtk DataFile Version 4.2\nvtk output\nBINARY\nDATASET POLYDATA\nPOINTS 5 double\n", 0),
      0u);
  Model grey = square(), cloud = square();
  grey.colours.clear();
  cloud.triangles.clear();
  for (const Model& model : {square(), grey, cloud})
    expect_same(io::decode_mesh("vtk", io::encode_mesh("vtk", model)), model);
}

TEST(Vtk, IsReadAsVtkWritesIt) {
  Model laden_model = square();
  laden_model.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {2, 1, 3}, {2, 3, 4}};
  for (const bool binary : {false, true})
    for (const int version : kVersions) {
      SCOPED_TRACE((binary ? "binary " : "text ") + std::to_string(version));
      expect_same(io::decode_mesh("vtk", written(polydata(square()), binary, version)), square());
      expect_same(io::decode_mesh("vtk", written(laden(), binary, version)), laden_model);
    }
}

TEST(Vtk, AFileThatEndsTooSoonIsRefusedOrLosesWholeParts) {
  for (const bool binary : {false, true})
    for (const int version : kVersions) {
      const std::string bytes = written(laden(), binary, version);
      const Model whole = io::decode_mesh("vtk", bytes);
      std::size_t read = 0;
      for (std::size_t size = 0; size < bytes.size(); ++size) try {
          const Model part = io::decode_mesh("vtk", std::string_view(bytes).substr(0, size));
          ++read;
          EXPECT_TRUE(part.positions.empty() || part.positions.size() == whole.positions.size()) << size;
          if (!part.colours.empty()) {
            ASSERT_EQ(part.colours.size(), whole.colours.size()) << size;
            // The last number of a text may be cut off.
            for (std::size_t i = 0; i + !binary < part.colours.size(); ++i)
              EXPECT_EQ(part.colours[i], whole.colours[i]) << size;
          }
          EXPECT_TRUE(part.triangles.empty() || part.triangles.size() == 2 || part.triangles.size() == 5)
              << size;
        } catch (const IoError&) {
        }
      EXPECT_LT(read, bytes.size() / 4);  // at the ends of parts, and in the metadata at the end
    }
}

TEST(Vtk, AByteThatIsAnotherIsRefusedOrMakesNoCornerThatIsNoPoint) {
  for (const bool binary : {false, true})
    for (const int version : kVersions) {
      const std::string bytes = written(laden(), binary, version);
      for (std::size_t i = 0; i < bytes.size(); ++i)
        for (const char other : {'\0', '\xff', '9', '-', '\n'}) {
          std::string broken = bytes;
          broken[i] = other;
          try {
            const Model model = io::decode_mesh("vtk", broken);
            for (const Triangle& triangle : model.triangles)
              for (const std::int32_t corner : triangle)
                ASSERT_TRUE(corner >= 0 && static_cast<std::size_t>(corner) < model.positions.size()) << i;
            ASSERT_TRUE(model.colours.empty() || model.colours.size() == model.positions.size()) << i;
          } catch (const IoError&) {
          }
        }
    }
}

TEST(Vtk, WhatIsWrongIsSaid) {
  const std::string header = "# vtk DataFile Version 4.2\nof a test\nASCII\nDATASET POLYDATA\n",
                    new_header = "# vtk DataFile Version 5.1\nof a test\nASCII\nDATASET POLYDATA\n",
                    points = "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  const std::pair<std::string, const char*> files[] = {
      {"noise", "it is not a legacy VTK file"},
      {"# vtk DataFile Version x\n", "it is not a legacy VTK file"},
      {"# vtk DataFile Version 3.0\n\nXML\n", "it is neither a text nor a binary VTK file"},
      {"# vtk DataFile Version 3.0\n\nASCII\nDATASET RECTILINEAR_GRID\n",
       "its VTK data are rectilinear_grid, which have no points; save them as POLYDATA or UNSTRUCTURED_GRID"},
      {header + "POINTS -3 float\n", "a number of things in it is none"},
      {header + "POINTS 3 string\n", "an array in it has an unknown type 'string'"},
      {header + "POINTS 3 float\n0 0 0 1 0", "it is not a whole VTK file"},
      {header + "POINTS 6000000000000000000 float\n0 0 0", "it is not a whole VTK file"},
      {header + "POINTS 3 float\n0 0 0 1 0 zero 0 1 0\n", "an array in it has a word that is not a number"},
      {header + points + points, "its VTK data has points twice"},
      {header + points + "POLYGONS 1 4\n3 0 1 3\n", "a face in it names a vertex that does not exist"},
      {header + points + "POLYGONS 1 4\n3 0 1 -1\n", "a face in it names a vertex that does not exist"},
      {header + points + "POLYGONS 1 4\n4 0 1 2\n", "the cells in it do not have the size that it says"},
      {header + points + "POLYGONS 2 4\n3 0 1 2\n", "the cells in it do not have the size that it says"},
      {header + points + "POLYGONS 1 5\n3 0 1 2 0\n", "the cells in it do not have the size that it says"},
      {new_header + points + "POLYGONS 2 3\n3 0 1 2\n", "the cells in it do not have the size that it says"},
      {new_header + points + "POLYGONS 2 3\nOFFSETS int\n0 4\nCONNECTIVITY int\n0 1 2\n",
       "the cells in it do not have the size that it says"},
      {new_header + points + "POLYGONS 3 3\nOFFSETS int\n0 9 3\nCONNECTIVITY int\n0 1 2\n",
       "the cells in it do not have the size that it says"},
      {new_header + points + "POLYGONS 2 3\nOFFSETS int\n0 3\nCORNERS int\n0 1 2\n",
       "the cells in it do not have the size that it says"},
      {header + points + "SCALARS a float\n", "its VTK data has an unknown part 'scalars'"},
      {header + points + "POINT_DATA 3\nCOLOURS a float\n",
       "its VTK data has an unknown attribute 'colours'"},
      {header + points + "POINT_DATA 3\nSCALARS a float 5\n", "scalars in it are not one to four a point"},
      {header + points + "POINT_DATA 3\nSCALARS a float\nzero 0 0\n", "scalars in it have no lookup table"},
      {header + points + "POINT_DATA 1\nCOLOR_SCALARS a 3\n0 0 0\n", "it does not have a colour a point"},
      {header + points + "POINT_DATA 3\nCOLOR_SCALARS a 3\n0 0 0 0 0 0 0 0 2\n",
       "a colour in it is not from 0 to 255"},
      {header + points + "FIELD data 2\na 1 1 float\n0\n", "it is not a whole VTK file"},
  };
  for (const auto& [bytes, message] : files) try {
      io::decode_mesh("vtk", bytes);
      ADD_FAILURE() << "was read: " << bytes;
    } catch (const IoError& error) {
      EXPECT_STREQ(error.what(), message) << bytes;
    }
}

TEST(Vtk, OldFilesAreReadToo) {
  const Model model = io::decode_mesh(
      "vtk",
      "# vtk DataFile Version 2.0\r\nby hand\r\nascii\r\ndataset polydata\r\nPoints 4 Float 0 0 0 1 0 0 0 1 "
      "0 0 0 1\r\n"
      "polygons 2 8\r\n3 0 1 2 3 0\r\n2 3\r\npoint_data 4\r\nscalars c unsigned_char 4\r\nlookup_table "
      "default\r\n"
      "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\r\nlookup_table default 1\r\n0 0 0 1\r\nglobal_ids i int\r\n1 "
      "2 3 4\r\n");
  EXPECT_EQ(model.positions, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(model.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(model.colours, (std::vector<Colour>{{1, 2, 3}, {5, 6, 7}, {9, 10, 11}, {13, 14, 15}}));
}

}  // namespace
}  // namespace filmsticking::test

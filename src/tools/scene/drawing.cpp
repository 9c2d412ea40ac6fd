// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkLightKit.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/vtk_polydata.h"

namespace filmsticking::scene {
namespace {

using Rgb = std::array<double, 3>;

constexpr Rgb kFront = {0.88, 0.86, 0.82}, kBack = {0.86, 0.08, 0.08}, kGreyBack = {0.48, 0.52, 0.58};
constexpr Rgb kHole = {0.90, 0.00, 0.00}, kSurplus = {0.60, 0.00, 0.80}, kEdge = {0.35, 0.38, 0.42},
              kPoint = {0.05, 0.25, 0.55}, kText = {0.1, 0.1, 0.1};
/// YlGnBu of ColorBrewer (Brewer 2003): light to dark also on a grey print, and neither red nor violet, which
/// are the edges'.
constexpr Rgb kScale[] = {{1.000, 1.000, 0.800},
                          {0.631, 0.855, 0.706},
                          {0.255, 0.714, 0.769},
                          {0.173, 0.498, 0.722},
                          {0.145, 0.204, 0.580}};

void set_colour(vtkProperty* property, const Rgb& colour) {
  property->SetColor(colour[0], colour[1], colour[2]);
}

std::vector<Point> centred(std::vector<Point> positions, const Point& middle) {
  for (Point& p : positions)
    for (int k = 0; k < 3; ++k) p[k] -= middle[k];
  return positions;
}

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

vtkSmartPointer<vtkDoubleArray> to_array(const Values& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (const double value : values) array->InsertNextValue(value);
  return array;
}

/// The mapper shows the values if there are some, else the data's own colours if the style says so.
void show_values(vtkPolyDataMapper* mapper, const Values& values, const Style& style) {
  if (!values.empty()) {
    mapper->SetLookupTable(make_colour_table(style.scale));
    mapper->UseLookupTableScalarRangeOn();
  }
  mapper->SetScalarVisibility(!values.empty() || style.colours);
}

vtkSmartPointer<vtkActor> make_surface(vtkPolyData* surface, const Values& values, const Style& style) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  if (values.empty()) {
    mapper->SetScalarModeToUsePointData();
  } else {
    mapper->SetScalarModeToUseCellData();
  }
  show_values(mapper, values, style);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* front = actor->GetProperty();
  front->SetInterpolationToFlat();
  set_colour(front, kFront);
  front->SetAmbient(0.12);
  front->SetDiffuse(0.88);
  front->SetEdgeVisibility(style.edges);
  front->SetEdgeColor(kEdge[0], kEdge[1], kEdge[2]);
  vtkNew<vtkProperty> back;
  back->DeepCopy(front);
  set_colour(back, style.grey_backs ? kGreyBack : kBack);
  actor->SetBackfaceProperty(back);
  return actor;
}

vtkSmartPointer<vtkActor> make_lines(vtkPolyData* surface, bool boundary, const Rgb& colour) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetBoundaryEdges(boundary);
  edges->SetNonManifoldEdges(!boundary);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  set_colour(actor->GetProperty(), colour);
  actor->GetProperty()->SetLineWidth(3);
  actor->GetProperty()->LightingOff();
  return actor;
}

}  // namespace

vtkSmartPointer<vtkScalarsToColors> make_colour_table(double length) {
  constexpr int kColours = 256, kStops = static_cast<int>(std::size(kScale));
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kColours);
  for (int i = 0; i < kColours; ++i) {
    const double place = double(i) / (kColours - 1) * (kStops - 1);
    const int stop = std::min(static_cast<int>(place), kStops - 2);
    Rgb colour{};
    for (int k = 0; k < 3; ++k)
      colour[k] = kScale[stop][k] + (place - stop) * (kScale[stop + 1][k] - kScale[stop][k]);
    table->SetTableValue(i, colour[0], colour[1], colour[2]);
  }
  table->SetTableRange(0, length);
  table->SetNanColor(0.5, 0.5, 0.5, 1);
  return table;
}

std::vector<vtkSmartPointer<vtkProp>> draw_mesh(const pcl::PolygonMesh& mesh, const Values& values,
                                                const Point& middle, const Style& style) {
  std::vector<Point> positions = centred(io::positions_of(mesh.cloud), middle);
  const std::vector<Triangle> triangles = io::triangles_of(mesh.polygons);
  std::vector<Triangle> finite;
  Values finite_values;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    if (!std::all_of(t.begin(), t.end(), [&](std::int32_t i) { return is_finite(positions[i]); })) continue;
    finite.push_back(t);
    if (!values.empty()) finite_values.push_back(values[f]);
  }
  for (Point& p : positions)
    if (!is_finite(p)) p = {0, 0, 0};  // of no face; VTK would draw nothing at all for it
  const vtkSmartPointer<vtkPolyData> surface = io::to_polydata(positions, io::colours_of(mesh.cloud), finite);
  if (!values.empty()) surface->GetCellData()->SetScalars(to_array(finite_values));
  std::vector<vtkSmartPointer<vtkProp>> props{make_surface(surface, values, style)};
  if (style.holes) {
    props.push_back(make_lines(surface, true, kHole));
    props.push_back(make_lines(surface, false, kSurplus));
  }
  return props;
}

vtkSmartPointer<vtkProp> draw_points(const pcl::PCLPointCloud2& cloud, const Values& values,
                                     const Point& middle, const Style& style) {
  const std::vector<Point> positions = io::positions_of(cloud);
  const std::vector<io::Colour> colours = io::colours_of(cloud);
  std::vector<Point> finite;
  std::vector<io::Colour> finite_colours;
  Values finite_values;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!is_finite(positions[i])) continue;
    finite.push_back(positions[i]);
    if (!colours.empty()) finite_colours.push_back(colours[i]);
    if (!values.empty()) finite_values.push_back(values[i]);
  }
  const vtkSmartPointer<vtkPolyData> points =
      io::to_polydata(centred(std::move(finite), middle), finite_colours, {});
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) vertices->InsertNextCell(1, &i);
  points->SetVerts(vertices);
  if (!values.empty()) points->GetPointData()->SetScalars(to_array(finite_values));

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetScalarModeToUsePointData();
  show_values(mapper, values, style);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  set_colour(actor->GetProperty(), kPoint);
  actor->GetProperty()->SetPointSize(static_cast<float>(style.point_size));
  actor->GetProperty()->RenderPointsAsSpheresOn();
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkProp> draw_label(const std::string& text, int size) {
  auto label = vtkSmartPointer<vtkTextActor>::New();
  label->SetInput(text.c_str());
  label->GetTextProperty()->SetFontSize(size);
  label->GetTextProperty()->SetColor(kText[0], kText[1], kText[2]);
  label->GetTextProperty()->SetJustificationToCentered();
  label->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  label->GetPositionCoordinate()->SetValue(0.5, 0.015);
  return label;
}

vtkSmartPointer<vtkProp> draw_help(const std::string& text) {
  auto help = vtkSmartPointer<vtkTextActor>::New();
  help->SetInput(text.c_str());
  vtkTextProperty* property = help->GetTextProperty();
  property->SetFontFamilyToCourier();
  property->SetFontSize(14);
  property->SetColor(kText[0], kText[1], kText[2]);
  property->SetBackgroundColor(1, 1, 1);
  property->SetBackgroundOpacity(0.8);
  property->SetVerticalJustificationToTop();
  help->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  help->GetPositionCoordinate()->SetValue(0.01, 0.99);
  return help;
}

double scale_bar_share(double width) {
  constexpr double kNeeded = 105, kMost = 0.4;  // pixels for a bar and numbers like 0.00125; share
  return std::min(kNeeded / width, kMost);
}

vtkSmartPointer<vtkProp> draw_scale_bar(const std::string& title, double length, double width) {
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(make_colour_table(length));
  bar->SetTitle(title.c_str());
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat("%.3g");
  bar->UnconstrainedFontSizeOn();
  bar->SetVerticalTitleSeparation(12);
  for (vtkTextProperty* text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()}) {
    text->SetColor(kText[0], kText[1], kText[2]);
    text->SetFontFamilyToArial();
    text->SetFontSize(14);
    text->BoldOff();
    text->ItalicOff();
    text->ShadowOff();
  }
  const double share = scale_bar_share(width);
  bar->SetBarRatio(0.25);
  bar->SetPosition(1 - share, 0.25);
  bar->SetWidth(0.95 * share);
  bar->SetHeight(0.5);
  return bar;
}

void light(vtkRenderer* renderer) {
  renderer->SetBackground(1, 1, 1);
  renderer->RemoveAllLights();  // a window has had one made for it already
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightAngle(40, -25);
  lights->SetKeyLightIntensity(0.82);
  lights->SetKeyToFillRatio(2);
  lights->SetKeyToHeadRatio(2);
  lights->AddLightsToRenderer(renderer);
}

}  // namespace filmsticking::scene

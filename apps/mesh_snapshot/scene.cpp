// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFeatureEdges.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/vtk_polydata.h"

namespace filmsticking::app {
namespace {

struct Rgb {
  double red, green, blue;
};

constexpr Rgb kFront = {0.88, 0.86, 0.82}, kBack = {0.86, 0.08, 0.08}, kGreyBack = {0.48, 0.52, 0.58};
constexpr Rgb kHole = {0.90, 0.00, 0.00}, kSurplus = {0.60, 0.00, 0.80}, kEdge = {0.35, 0.38, 0.42},
              kPoint = {0.05, 0.25, 0.55};
constexpr double kMargin = 1.06, kLabelMargin = 1.16;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// The directions of the camera's picture: to the right, up, and out of it towards the camera.
struct Frame {
  Point right, up, out;
};

Frame make_frame(const View& view) {
  const double a = view.azimuth * M_PI / 180, e = view.elevation * M_PI / 180;
  Frame frame{{std::cos(a), 0, -std::sin(a)},
              {-std::sin(a) * std::sin(e), std::cos(e), -std::cos(a) * std::sin(e)},
              {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)}};
  if (view.z_up)
    for (Point* p : {&frame.right, &frame.up, &frame.out}) *p = {(*p)[0], -(*p)[2], (*p)[1]};
  return frame;
}

/// The extent of all that is drawn along the frame's directions.
struct Extent {
  Point low, high;
};

/// Of the panels from `first` to before `last`, and of the points.
Extent measure(const std::vector<Panel>& panels, std::size_t first, std::size_t last,
               const std::vector<Point>& points, const Frame& frame) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Extent extent{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  const auto take = [&](const std::vector<Point>& positions) {
    for (const Point& p : positions) {
      if (!is_finite(p)) continue;
      const Point q{dot(p, frame.right), dot(p, frame.up), dot(p, frame.out)};
      for (int k = 0; k < 3; ++k) {
        extent.low[k] = std::min(extent.low[k], q[k]);
        extent.high[k] = std::max(extent.high[k], q[k]);
      }
    }
  };
  for (std::size_t i = first; i < last; ++i) take(panels[i].mesh.positions);
  take(points);
  if (!(extent.low[0] <= extent.high[0])) return {{0, 0, 0}, {1, 1, 1}};
  return extent;
}

/// Into the camera's frame, around its middle: large coordinates keep their digits in single precision.
void to_frame(std::vector<Point>& positions, const Frame& frame, const Extent& extent) {
  for (Point& p : positions) {
    Point q{dot(p, frame.right), dot(p, frame.up), dot(p, frame.out)};
    for (int k = 0; k < 3; ++k) q[k] -= extent.low[k] / 2 + extent.high[k] / 2;
    p = q;
  }
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
  actor->GetProperty()->SetColor(colour.red, colour.green, colour.blue);
  actor->GetProperty()->SetLineWidth(3);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> make_surface(vtkPolyData* surface, const View& view) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* front = actor->GetProperty();
  front->SetInterpolationToFlat();
  front->SetColor(kFront.red, kFront.green, kFront.blue);
  front->SetAmbient(0.12);
  front->SetDiffuse(0.88);
  front->SetEdgeVisibility(view.edges);
  front->SetEdgeColor(kEdge.red, kEdge.green, kEdge.blue);
  vtkNew<vtkProperty> back;
  back->DeepCopy(front);
  const Rgb& colour = view.grey_backs ? kGreyBack : kBack;
  back->SetColor(colour.red, colour.green, colour.blue);
  actor->SetBackfaceProperty(back);
  return actor;
}

vtkSmartPointer<vtkActor> make_points(const std::vector<Point>& points) {
  vtkNew<vtkPoints> positions;
  vtkNew<vtkCellArray> vertices;
  for (const Point& p : points) {
    const vtkIdType id = positions->InsertNextPoint(p.data());
    vertices->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(positions);
  cloud->SetVerts(vertices);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(cloud);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(kPoint.red, kPoint.green, kPoint.blue);
  actor->GetProperty()->SetPointSize(3);
  actor->GetProperty()->RenderPointsAsSpheresOn();
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkTextActor> make_label(const std::string& text) {
  auto label = vtkSmartPointer<vtkTextActor>::New();
  label->SetInput(text.c_str());
  label->GetTextProperty()->SetFontSize(18);
  label->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
  label->GetTextProperty()->SetJustificationToCentered();
  label->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  label->GetPositionCoordinate()->SetValue(0.5, 0.015);
  return label;
}

/// Looks along the frame at the extent's middle, which to_frame() makes the origin.
vtkSmartPointer<vtkCamera> make_camera(const Extent& extent, double aspect, double margin) {
  const double half_width = (extent.high[0] - extent.low[0]) / 2,
               half_height = (extent.high[1] - extent.low[1]) / 2;
  const double depth =
      std::max((extent.high[2] - extent.low[2]) / 2, std::max(half_width, half_height)) * kMargin;
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(std::max({half_height, half_width / aspect, 1e-30}) * margin);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, 0, 2 * depth);
  camera->SetViewUp(0, 1, 0);
  camera->SetClippingRange(0.5 * depth, 3.5 * depth);
  return camera;
}

/// The panels whose extent the panel's view is fitted to: from the first to before the second.
std::pair<std::size_t, std::size_t> fitted_with(std::size_t panel, std::size_t panels, const View& view) {
  const auto columns = static_cast<std::size_t>(view.columns), row = panel / columns * columns;
  if (view.fit == Fit::Each) return {panel, panel + 1};
  if (view.fit == Fit::Row) return {row, std::min(row + columns, panels)};
  return {0, panels};
}

std::string to_png(vtkRenderWindow* window) {
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                     static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

}  // namespace

std::string render_png(const std::vector<Panel>& panels, const std::vector<Point>& points, const View& view) {
  const Frame frame = make_frame(view);
  const int rows = (static_cast<int>(panels.size()) + view.columns - 1) / view.columns;
  const double aspect =
      (static_cast<double>(view.width) / view.columns) / (static_cast<double>(view.height) / rows);
  const bool labels =
      std::any_of(panels.begin(), panels.end(), [](const Panel& p) { return !p.label.empty(); });

  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();  // lines and points on the surface stay in sight
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(view.width, view.height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int column = static_cast<int>(i) % view.columns, row = static_cast<int>(i) / view.columns;
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(static_cast<double>(column) / view.columns, 1 - static_cast<double>(row + 1) / rows,
                          static_cast<double>(column + 1) / view.columns,
                          1 - static_cast<double>(row) / rows);
    renderer->SetBackground(1, 1, 1);
    const auto [first, last] = fitted_with(i, panels.size(), view);
    const Extent extent = measure(panels, first, last, points, frame);
    renderer->SetActiveCamera(make_camera(extent, aspect, labels ? kLabelMargin : kMargin));
    vtkNew<vtkLightKit> lights;
    lights->SetKeyLightAngle(40, -25);
    lights->SetKeyLightIntensity(0.82);
    lights->SetKeyToFillRatio(2);
    lights->SetKeyToHeadRatio(2);
    lights->AddLightsToRenderer(renderer);

    io::Model mesh = panels[i].mesh;
    to_frame(mesh.positions, frame, extent);
    const vtkSmartPointer<vtkPolyData> surface = io::to_polydata(mesh);
    renderer->AddActor(make_surface(surface, view));
    renderer->AddActor(make_lines(surface, true, kHole));
    renderer->AddActor(make_lines(surface, false, kSurplus));
    std::vector<Point> cloud;
    std::copy_if(points.begin(), points.end(), std::back_inserter(cloud), is_finite);
    to_frame(cloud, frame, extent);
    if (!cloud.empty()) renderer->AddActor(make_points(cloud));
    if (!panels[i].label.empty()) renderer->AddActor(make_label(panels[i].label));
    window->AddRenderer(renderer);
  }
  window->Render();
  return to_png(window);
}

}  // namespace filmsticking::app

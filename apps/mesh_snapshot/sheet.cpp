// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet.h"

#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

#include "scene/image.h"

namespace filmsticking::app {
namespace {

constexpr double kLabelMargin = 1.16;

double panel_width(const View& view) { return static_cast<double>(view.width) / view.columns; }

/// The range of panels, first and past the last, whose extent fits the view of a panel.
std::pair<std::size_t, std::size_t> fitted_with(std::size_t panel, std::size_t panels, const View& view) {
  const auto columns = static_cast<std::size_t>(view.columns), row = panel / columns * columns;
  if (view.fit == Fit::Each) return {panel, panel + 1};
  if (view.fit == Fit::Row) return {row, std::min(row + columns, panels)};
  return {0, panels};
}

scene::Target aim_at(const std::vector<Panel>& panels, std::pair<std::size_t, std::size_t> fitted,
                     const pcl::PCLPointCloud2& cloud, const std::vector<scene::Frame>& frames) {
  std::vector<std::vector<Point>> points = {io::positions_of(cloud)};
  for (std::size_t i = fitted.first; i < fitted.second; ++i)
    for (const Film& film : panels[i].films) points.push_back(io::positions_of(film.mesh.cloud));
  return scene::aim(points, frames);
}

/// A panel's part of the window.
class PanelDrawing {
 public:
  PanelDrawing(const Panel& panel, const pcl::PCLPointCloud2& cloud, const scene::Target& target,
               const View& view)
      : panel_(panel), cloud_(cloud), target_(target), view_(view) {
    scene::light(renderer_);
    if (!panel.label.empty()) renderer_->AddActor(scene::draw_label(panel.label));
    const Film& film = panel.films[0];
    if (!film.face_values.empty() || !film.point_values.empty())
      renderer_->AddActor(scene::draw_scale_bar("distance", view.style.scale, panel_width(view)));
  }

  /// Of the panel's films the one for picture `k` of `pictures`.
  void show(std::size_t k, std::size_t pictures) {
    const Film& film = panel_.films[k * panel_.films.size() / pictures];
    if (&film == shown_) return;
    shown_ = &film;
    for (const auto& prop : props_) renderer_->RemoveViewProp(prop);
    props_ = scene::draw_mesh(film.mesh, film.face_values, target_.middle, view_.style);
    if (io::size_of(cloud_) > 0)
      props_.push_back(scene::draw_points(cloud_, film.point_values, target_.middle, view_.style));
    for (const auto& prop : props_) renderer_->AddViewProp(prop);
  }

  void look_along(const scene::Frame& frame, double aspect, const scene::Margins& margins) {
    renderer_->SetActiveCamera(scene::make_camera(target_, frame, aspect, margins));
  }

  vtkRenderer* renderer() { return renderer_; }

 private:
  const Panel& panel_;
  const pcl::PCLPointCloud2& cloud_;
  scene::Target target_;
  const View& view_;
  vtkNew<vtkRenderer> renderer_;
  const Film* shown_ = nullptr;
  std::vector<vtkSmartPointer<vtkProp>> props_;
};

}  // namespace

void draw_sheet(const std::vector<Panel>& panels, const pcl::PCLPointCloud2& cloud, const View& view,
                int turns, const std::function<void(vtkSmartPointer<vtkImageData>)>& take) {
  std::vector<scene::Frame> frames;
  for (int turn = 0; turn < turns; ++turn) {
    scene::Angles angles = view.angles;
    angles.azimuth += 360.0 * turn / turns;
    frames.push_back(scene::make_frame(angles));
  }
  std::size_t films = 1;
  scene::Margins margins;
  for (const Panel& panel : panels) {
    films = std::max(films, panel.films.size());
    if (!panel.label.empty()) margins.factor = kLabelMargin;
    const Film& film = panel.films[0];
    if (!film.face_values.empty() || !film.point_values.empty())
      margins.right = scene::scale_bar_share(panel_width(view));
  }

  const int rows = (static_cast<int>(panels.size()) + view.columns - 1) / view.columns;
  const double width = 1.0 / view.columns, height = 1.0 / rows;
  const double aspect = view.width * width / (view.height * height);
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();  // lines and points on the surface stay in sight
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(view.width, view.height);
  std::vector<PanelDrawing> drawings;
  drawings.reserve(panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int column = static_cast<int>(i) % view.columns, row = static_cast<int>(i) / view.columns;
    drawings.emplace_back(panels[i], cloud,
                          aim_at(panels, fitted_with(i, panels.size(), view), cloud, frames), view);
    drawings[i].renderer()->SetViewport(column * width, 1 - (row + 1) * height, (column + 1) * width,
                                        1 - row * height);
    window->AddRenderer(drawings[i].renderer());
  }

  const std::size_t pictures = turns > 1 ? static_cast<std::size_t>(turns) : films;
  for (std::size_t k = 0; k < pictures; ++k) {
    for (PanelDrawing& drawing : drawings) {
      drawing.show(k, pictures);
      drawing.look_along(frames[turns > 1 ? k : 0], aspect, margins);
    }
    window->Render();
    take(scene::grab(window));
  }
}

}  // namespace filmsticking::app

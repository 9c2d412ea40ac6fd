// SPDX-License-Identifier: GPL-3.0-or-later
#include "window.h"

#include <pcl/visualization/interactor_style.h>
#include <pcl/visualization/pcl_visualizer.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRendererCollection.h>

#include <cstdio>
#include <filesystem>
#include <functional>

#include "io/files.h"
#include "io/io_error.h"
#include "io/with_file.h"
#include "scene/drawing.h"
#include "scene/image.h"

namespace fs = std::filesystem;

namespace filmsticking::app {
namespace {

using pcl::visualization::PCLVisualizer;
using pcl::visualization::PCLVisualizerInteractorStyle;

constexpr unsigned kTick = 200;  // milliseconds from a film to the next

/// PCL's mouse with other keys: many of PCL's act on clouds that PCL drew.
class OwnKeys : public PCLVisualizerInteractorStyle {
 public:
  static OwnKeys* New();
  // clang-format off
  vtkTypeMacro(OwnKeys, PCLVisualizerInteractorStyle)
      // clang-format on

      std::function<void(const std::string&)> on_key;

 protected:
  void OnKeyDown() override {
    const char* key = Interactor->GetKeySym();
    if (key) on_key(key);
  }
  void OnKeyUp() override {}
  void OnChar() override {}
};

vtkStandardNewMacro(OwnKeys);

/// "a.png" or, where that is taken, "a_2.png", "a_3.png" ...
std::string free_name(const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; fs::exists(name); ++number)
    name = fs::path(wanted).replace_extension().string() + "_" + std::to_string(number) + ".png";
  return name;
}

class Window {
 public:
  Window(Contents& contents, const WindowOptions& options)
      : contents_(contents), options_(options), scope_(contents.scope()) {
    visualizer_.setSize(options.width, options.height);
    visualizer_.setShowFPS(false);
    renderer_ = visualizer_.getRendererCollection()->GetFirstRenderer();
    scene::light(renderer_);
    std::vector<std::vector<Point>> points = {io::positions_of(contents.cloud())};
    for (const scene::Step& step : contents.films()) points.push_back(io::positions_of(step.film.cloud));
    frame_ = scene::make_frame(options.angles);
    target_ = scene::aim(points, {frame_});
    reset_view();
    style_->on_key = [this](const std::string& key) { press_key(key); };
  }

  void run() {
    draw();
    vtkRenderWindowInteractor* interactor = visualizer_.getRenderWindow()->GetInteractor();
    interactor->Initialize();
    vtkNew<vtkCallbackCommand> ticks;
    ticks->SetClientData(this);
    ticks->SetCallback(
        [](vtkObject*, unsigned long, void* window, void*) { static_cast<Window*>(window)->tick(); });
    const unsigned long observer = interactor->AddObserver(vtkCommand::TimerEvent, ticks);
    const int timer = interactor->CreateRepeatingTimer(kTick);
    visualizer_.spin();
    interactor->DestroyTimer(timer);
    interactor->RemoveObserver(observer);
  }

 private:
  void press_key(const std::string& key) {
    switch (press(key, scope_, state_)) {
      case Action::None:
        return;
      case Action::ResetView:
        reset_view();
        [[fallthrough]];
      case Action::Draw:
        draw();
        return;
      case Action::Screenshot:
        take_screenshot();
        return;
      case Action::Quit:
        visualizer_.getRenderWindow()->GetInteractor()->TerminateApp();
        return;
    }
  }

  /// Presses the next key of the options, or shows the next film while they play.
  void tick() {
    const bool waits = next_key_ < options_.keys.size() && options_.keys[next_key_] == kWait;
    if (waits) ++next_key_;
    if (!waits && next_key_ < options_.keys.size()) {
      vtkRenderWindowInteractor* interactor = visualizer_.getRenderWindow()->GetInteractor();
      const std::string& key = options_.keys[next_key_++];
      interactor->SetKeyEventInformation(0, 0, key.size() == 1 ? key[0] : '\0', 0, key.c_str());
      for (const auto event : {vtkCommand::KeyPressEvent, vtkCommand::CharEvent, vtkCommand::KeyReleaseEvent})
        interactor->InvokeEvent(event);
    } else if (state_.playing) {
      play_on(scope_, state_);
      draw();
    }
  }

  void reset_view() {
    scene::Margins margins;
    margins.factor = 1.12;  // for the line below
    if (scope_.paints.size() > 1) margins.right = scene::scale_bar_share(options_.width);
    renderer_->SetActiveCamera(
        scene::make_camera(target_, frame_, double(options_.width) / options_.height, margins));
  }

  void draw() {
    for (const auto& prop : props_) renderer_->RemoveViewProp(prop);
    props_.clear();
    const bool measured = state_.paint == Paint::Faces || state_.paint == Paint::Points;
    scene::Style style;
    style.edges = state_.edges;
    style.holes = state_.holes;
    style.colours = state_.paint == Paint::Colours;
    style.point_size = state_.point_size;
    const scene::Values none;
    const auto values = [&](Paint paint) -> const scene::Values& {
      return state_.paint == paint ? contents_.values(paint, state_.film) : none;
    };
    if (measured) {
      style.scale = contents_.scale(state_.paint);
      props_.push_back(scene::draw_scale_bar("distance", style.scale, options_.width));
    }
    if (state_.surface && scope_.films > 0)
      for (const auto& prop :
           scene::draw_mesh(contents_.films()[state_.film].film, values(Paint::Faces), target_.middle, style))
        props_.push_back(prop);
    if (state_.points && scope_.points)
      props_.push_back(scene::draw_points(contents_.cloud(), values(Paint::Points), target_.middle, style));
    props_.push_back(scene::draw_label(message_.empty() ? status_line(contents_, state_) : message_, 14));
    message_.clear();
    if (state_.help) props_.push_back(scene::draw_help(key_help()));
    for (const auto& prop : props_) renderer_->AddViewProp(prop);
    visualizer_.getRenderWindow()->Render();
  }

  /// Errors are shown in the window, which stays open.
  void take_screenshot() {
    const std::string name = free_name(options_.screenshot);
    draw();  // the status line in place of the last message
    try {
      io::with_file(
          name, [&] { io::write_file(name, scene::encode_png(scene::grab(visualizer_.getRenderWindow()))); });
      message_ = "wrote " + name;
      std::printf("%s\n", message_.c_str());
    } catch (const io::IoError& error) {
      message_ = error.what();
      std::fprintf(stderr, "mesh_view: %s.\n", message_.c_str());
    }
    std::fflush(stdout);
    draw();
  }

  Contents& contents_;
  const WindowOptions& options_;
  const Scope scope_;
  ViewState state_;
  vtkNew<OwnKeys> style_;
  int argument_count_ = 1;
  char program_[10] = "mesh_view";
  char* arguments_[2] = {program_, nullptr};
  PCLVisualizer visualizer_{argument_count_, arguments_, "mesh_view", style_};
  vtkRenderer* renderer_ = nullptr;
  scene::Frame frame_;
  scene::Target target_;
  std::vector<vtkSmartPointer<vtkProp>> props_;
  std::string message_;  ///< in place of the status line, once
  std::size_t next_key_ = 0;
};

}  // namespace

void show_window(Contents& contents, const WindowOptions& options) {
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();  // lines and points on the surface stay in sight
  Window(contents, options).run();
}

}  // namespace filmsticking::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/pcl_config.h>

#include "capture_error.h"
#include "frame_source.h"

#ifdef HAVE_OPENNI2

#include <pcl/conversions.h>
#include <pcl/io/openni2_grabber.h>
#include <pcl/point_types.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>

namespace filmsticking::capture {
namespace {

using namespace std::chrono_literals;

/// Frames between the camera's thread and the program's: a few, so that memory is bounded.
class FrameQueue {
 public:
  void push(Frame frame) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (frames_.size() == kMost) frames_.pop_front();
    frames_.push_back(std::move(frame));
    last_ = std::chrono::steady_clock::now();
    filled_.notify_one();
  }

  /// Waits a tenth of a second at the most.
  std::optional<Frame> pop() {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!filled_.wait_for(lock, 100ms, [&] { return !frames_.empty(); })) return std::nullopt;
    Frame frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
  }

  bool silent_for(std::chrono::milliseconds time) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return frames_.empty() && std::chrono::steady_clock::now() - last_ > time;
  }

 private:
  static constexpr std::size_t kMost = 4;
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::deque<Frame> frames_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

class OpenniSource : public FrameSource {
 public:
  explicit OpenniSource(const std::string& name) {
    try {
      grabber_ = std::make_unique<pcl::io::OpenNI2Grabber>(name);
      // With colours where the camera has them.
      if (grabber_->providesCallback<void(const pcl::PointCloud<pcl::PointXYZRGBA>::ConstPtr&)>())
        listen<pcl::PointXYZRGBA>();
      else
        listen<pcl::PointXYZ>();
      grabber_->start();
    } catch (const std::exception&) {  // several lines about PCL's own code
      std::error_code error;
      if (std::filesystem::exists(name, error))
        throw CaptureError(name + ": it is no recording that OpenNI2 can play");
      throw CaptureError("OpenNI2 finds no depth camera" + (name.empty() ? name : " '" + name + "'"));
    }
  }

  ~OpenniSource() override {
    try {
      grabber_->stop();
    } catch (const std::exception&) {  // there is nothing left to do with it
    }
  }

  std::optional<Frame> next() override { return queue_.pop(); }

  /// A recording ends by silence; a camera that is silent so long is gone.
  bool at_end() const override { return queue_.silent_for(3s); }

 private:
  template <typename PointT>
  void listen() {
    using Cloud = pcl::PointCloud<PointT>;
    grabber_->registerCallback(
        std::function<void(const typename Cloud::ConstPtr&)>([this](const typename Cloud::ConstPtr& cloud) {
          Frame frame;
          frame.name = "frame " + std::to_string(++count_);
          if (cloud->header.stamp > 0) frame.time = static_cast<double>(cloud->header.stamp) * 1e-6;
          pcl::toPCLPointCloud2(*cloud, frame.cloud);
          queue_.push(std::move(frame));
        }));
  }

  FrameQueue queue_;
  std::size_t count_ = 0;
  std::unique_ptr<pcl::io::OpenNI2Grabber> grabber_;  // last: it goes first, and with it the callbacks
};

}  // namespace

bool has_openni() { return true; }

std::unique_ptr<FrameSource> openni_source(const std::string& device_or_file) {
  return std::make_unique<OpenniSource>(device_or_file);
}

}  // namespace filmsticking::capture

#else

namespace filmsticking::capture {

bool has_openni() { return false; }

std::unique_ptr<FrameSource> openni_source(const std::string&) {
  throw CaptureError("this program's PCL was built without OpenNI2, which depth cameras and .oni files need");
}

}  // namespace filmsticking::capture

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/pcl_config.h>

#include "frame_source.h"
#include "stream_error.h"

#ifdef HAVE_OPENNI2

#include <pcl/conversions.h>
#include <pcl/io/openni2_grabber.h>
#include <pcl/point_types.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>

namespace filmsticking::stream {
namespace {

using namespace std::chrono_literals;

/// The frames that the camera's thread hands to the program's thread: few, so that memory is bounded.
class FrameQueue {
 public:
  void push(Frame frame) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (frames_.size() == kMost) frames_.pop_front();
    frames_.push_back(std::move(frame));
    begun_ = true;
    last_ = std::chrono::steady_clock::now();
    filled_.notify_one();
  }

  /// Waits at most a tenth of a second.
  std::optional<Frame> pop() {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!filled_.wait_for(lock, 100ms, [&] { return !frames_.empty(); })) return std::nullopt;
    Frame frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
  }

  /// Whether no frame has come for so long that none will. A camera may take long to begin.
  bool silent() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return frames_.empty() && std::chrono::steady_clock::now() - last_ > (begun_ ? 3s : 10s);
  }

 private:
  static constexpr std::size_t kMost = 4;
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::deque<Frame> frames_;
  bool begun_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

class OpenniSource : public FrameSource {
 public:
  explicit OpenniSource(const std::string& name) : recording_(is_file(name)) {
    try {
      grabber_ = std::make_unique<pcl::io::OpenNI2Grabber>(name);
      // With colours if the camera has them.
      if (grabber_->providesCallback<void(const pcl::PointCloud<pcl::PointXYZRGBA>::ConstPtr&)>())
        listen<pcl::PointXYZRGBA>();
      else
        listen<pcl::PointXYZ>();
      grabber_->start();
    } catch (const std::exception&) {  // its text is about PCL's own code
      if (recording_) throw StreamError(name + ": it is no recording that OpenNI2 can play");
      throw StreamError("OpenNI2 finds no depth camera" + (name.empty() ? name : " '" + name + "'"));
    }
  }

  ~OpenniSource() override {
    try {
      grabber_->stop();
    } catch (const std::exception&) {  // the grabber is destroyed next
    }
  }

  std::optional<Frame> next() override { return queue_.pop(); }

  bool at_end() const override { return queue_.silent(); }

 private:
  static bool is_file(const std::string& name) {
    std::error_code error;
    return std::filesystem::is_regular_file(name, error);
  }

  template <typename PointT>
  void listen() {
    using Cloud = pcl::PointCloud<PointT>;
    grabber_->registerCallback(
        std::function<void(const typename Cloud::ConstPtr&)>([this](const typename Cloud::ConstPtr& cloud) {
          // OpenNI2 repeats a recording: it ends where the numbers or the times fall.
          if (recording_ && (cloud->header.seq < seq_ || cloud->header.stamp < stamp_)) ended_ = true;
          if (ended_) return;
          seq_ = cloud->header.seq;
          stamp_ = cloud->header.stamp;
          Frame frame;
          frame.name = "frame " + std::to_string(++count_);
          if (cloud->header.stamp > 0) frame.time = static_cast<double>(cloud->header.stamp) * 1e-6;
          pcl::toPCLPointCloud2(*cloud, frame.cloud);
          queue_.push(std::move(frame));
        }));
  }

  FrameQueue queue_;
  const bool recording_;
  std::size_t count_ = 0;  // the grabber's thread uses this and what follows
  std::uint32_t seq_ = 0;
  std::uint64_t stamp_ = 0;
  bool ended_ = false;
  std::unique_ptr<pcl::io::OpenNI2Grabber> grabber_;  // last: it is destroyed first, with the callbacks
};

}  // namespace

bool has_openni() { return true; }

std::unique_ptr<FrameSource> openni_source(const std::string& device_or_file) {
  return std::make_unique<OpenniSource>(device_or_file);
}

}  // namespace filmsticking::stream

#else

namespace filmsticking::stream {

bool has_openni() { return false; }

std::unique_ptr<FrameSource> openni_source(const std::string&) {
  throw StreamError("this program's PCL was built without OpenNI2, which depth cameras and .oni files need");
}

}  // namespace filmsticking::stream

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/io/pcd_grabber.h>

#include <filesystem>

#include "capture_error.h"
#include "frame_source.h"
#include "io/files.h"
#include "io/pcd.h"
#include "strict_pcd.h"

namespace filmsticking::capture {
namespace {

/// Asks the grabber for a file's frame as it is, with all its fields. A grabber for each file: one that has
/// many reads them all before the first. Its trigger() is not for use: in PCL 1.13 it ends the program, since
/// it does not join the thread that it starts.
class BlobGrabber : public pcl::PCDGrabberBase {
 public:
  explicit BlobGrabber(const std::string& file) : PCDGrabberBase(file, 0, false) {}

  std::optional<Frame> grab() const {
    Frame frame;
    Eigen::Vector4f origin = Eigen::Vector4f::Zero();
    Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
    if (numFrames() == 0) return std::nullopt;
    getCloudAt(0, frame.cloud, origin, orientation);  // PCL 1.13 tells success the wrong way round
    const std::size_t row = std::size_t{frame.cloud.width} * frame.cloud.point_step;
    if (row == 0 || frame.cloud.data.size() != row * frame.cloud.height) return std::nullopt;
    const Eigen::Quaterniond rotation = orientation.cast<double>();
    if (rotation.norm() > 0.5 && rotation.norm() < 2 && origin.allFinite())  // else there is none to speak of
      frame.sensor_pose = Pose(Eigen::Translation3d(origin.head<3>().cast<double>()) * rotation.normalized());
    return frame;
  }

 private:
  void publish(const pcl::PCLPointCloud2&, const Eigen::Vector4f&, const Eigen::Quaternionf&,
               const std::string&) const override {}
};

class PcdSequence : public FrameSource {
 public:
  explicit PcdSequence(std::vector<std::string> files) : files_(std::move(files)) {}

  std::optional<Frame> next() override {
    if (at_end()) return std::nullopt;
    const std::string file = files_[next_++];
    const std::string name = std::filesystem::path(file).filename().string();
    try {
      const std::string bytes = io::read_file(file);
      check_pcd(bytes);
      io::decode_pcd(bytes);  // compressed data that are broken
    } catch (const std::runtime_error& error) {
      throw CaptureError(name + ": " + error.what());
    }
    std::optional<Frame> frame = BlobGrabber(file).grab();
    if (!frame) throw CaptureError(name + ": it cannot be read");
    frame->name = name;
    frame->time = time_in_name(file);
    return frame;
  }

  bool at_end() const override { return next_ == files_.size(); }
  std::optional<std::size_t> size() const override { return files_.size(); }

 private:
  std::vector<std::string> files_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> pcd_sequence(std::vector<std::string> files) {
  return std::make_unique<PcdSequence>(std::move(files));
}

}  // namespace filmsticking::capture

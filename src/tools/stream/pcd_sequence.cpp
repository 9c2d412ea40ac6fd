// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/io/pcd_io.h>

#include <filesystem>
#include <stdexcept>

#include "frame_source.h"
#include "io/codecs.h"
#include "io/files.h"
#include "io/strict_pcd.h"
#include "stream_error.h"

namespace filmsticking::stream {
namespace {

/// Reads a file that passed the checks by PCL.
Frame read_frame(const std::string& file) {
  Frame frame;
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  int version = 0;
  if (pcl::PCDReader().read(file, frame.cloud, origin, orientation, version) < 0)
    throw StreamError("it cannot be read");
  const Eigen::Quaterniond rotation = orientation.cast<double>();
  if (rotation.norm() > 0.5 && rotation.norm() < 2 && origin.allFinite())  // else it is no pose
    frame.sensor_pose = Pose(Eigen::Translation3d(origin.head<3>().cast<double>()) * rotation.normalized());
  return frame;
}

class PcdSequence : public FrameSource {
 public:
  explicit PcdSequence(std::vector<std::string> files) : files_(std::move(files)) {}

  std::optional<Frame> next() override {
    if (at_end()) return std::nullopt;
    const std::string file = files_[next_++];
    const std::string name = std::filesystem::path(file).filename().string();
    try {
      const std::string bytes = io::read_file(file);
      io::check_pcd(bytes);
      io::decode_pcd(bytes);  // refuses compressed data that are broken
      Frame frame = read_frame(file);
      frame.name = name;
      frame.time = time_in_name(file);
      return frame;
    } catch (const std::runtime_error& error) {
      throw StreamError(name + ": " + error.what());
    }
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

}  // namespace filmsticking::stream

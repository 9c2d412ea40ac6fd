// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <deque>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "frame_source.h"
#include "io/codecs.h"
#include "io/files.h"
#include "io/formats.h"
#include "stream_error.h"

namespace filmsticking::stream {
namespace {

Frame frame_of(io::Cloud cloud) {
  Frame frame;
  frame.cloud = std::move(cloud.points);
  frame.notes = std::move(cloud.notes);
  const std::array<double, 4> turn = cloud.orientation.value_or(std::array<double, 4>{1, 0, 0, 0});
  const Eigen::Quaterniond rotation(turn[0], turn[1], turn[2], turn[3]);
  if (cloud.viewpoint && rotation.norm() > 0.5 && rotation.norm() < 2)  // else it is no pose
    frame.sensor_pose =
        Pose(Eigen::Translation3d(Eigen::Vector3d(cloud.viewpoint->data())) * rotation.normalized());
  return frame;
}

/// A station's matrix, if it is a rigid motion.
Pose pose_of(const std::array<double, 16>& matrix) {
  constexpr double kSlack = 1e-3;
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> all(matrix.data());
  const Eigen::Matrix3d turn = all.topLeftCorner<3, 3>();
  if (!all.allFinite() || !(turn * turn.transpose()).isIdentity(kSlack) || turn.determinant() < 0)
    throw StreamError("the matrix of a station is no rigid motion");
  return Pose(Eigen::Translation3d(all.topRightCorner<3, 1>()) * Eigen::Quaterniond(turn).normalized());
}

/// The frames of one file, most often a single one.
std::vector<Frame> read_frames(const std::string& file) {
  const std::string bytes = io::read_file(file), format = io::detect_format(bytes);
  std::vector<Frame> frames;
  if (format == "ptx") {
    for (io::Station& station : io::decode_stations(bytes)) {
      frames.emplace_back();
      frames.back().cloud = std::move(station.points);
      frames.back().sensor_pose = pose_of(station.pose);
    }
  } else {
    frames.push_back(frame_of(io::decode_any(bytes, io::extension_of(file))));
  }
  return frames;
}

class FileSequence : public FrameSource {
 public:
  explicit FileSequence(std::vector<std::string> files) : files_(std::move(files)) {}

  std::optional<Frame> next() override {
    if (at_end()) return std::nullopt;
    if (waiting_.empty()) read();
    if (waiting_.empty()) return std::nullopt;
    Frame frame = std::move(waiting_.front());
    waiting_.pop_front();
    return frame;
  }

  bool at_end() const override { return waiting_.empty() && next_ == files_.size(); }

  /// Unknown where a file may have several.
  std::optional<std::size_t> size() const override {
    for (const std::string& file : files_)
      if (io::extension_of(file) == ".ptx") return std::nullopt;
    return files_.size();
  }

 private:
  void read() {
    const std::string file = files_[next_++];
    const std::string name = std::filesystem::path(file).filename().string();
    try {
      std::vector<Frame> frames = read_frames(file);
      for (std::size_t k = 0; k < frames.size(); ++k) {
        frames[k].name = name + (frames.size() > 1 ? ", station " + std::to_string(k + 1) : "");
        frames[k].time = time_in_name(file);
        waiting_.push_back(std::move(frames[k]));
      }
    } catch (const std::runtime_error& error) {
      throw StreamError(name + ": " + error.what());
    }
  }

  std::vector<std::string> files_;
  std::size_t next_ = 0;
  std::deque<Frame> waiting_;  // of the last file
};

}  // namespace

std::unique_ptr<FrameSource> file_sequence(std::vector<std::string> files) {
  return std::make_unique<FileSequence>(std::move(files));
}

}  // namespace filmsticking::stream

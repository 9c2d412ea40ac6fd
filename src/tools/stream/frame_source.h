// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame.h"

namespace filmsticking::stream {

/// A recording or a camera that gives frames one after the other.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// The next frame; none at the end, or if a camera has sent none for a while (see at_end()). Throws
  /// StreamError for a broken frame; the next call continues after it.
  virtual std::optional<Frame> next() = 0;

  virtual bool at_end() const = 0;

  /// The number of frames in all; none if it is unknown.
  virtual std::optional<std::size_t> size() const { return std::nullopt; }
};

/// The files in the order given, one read at a time, of any format of io::read_cloud(). VIEWPOINT of a PCD
/// file is its frame's pose. Every station of a PTX file is a frame with its pose. A number at the end of a
/// file's name ("scan_12.5.pcd") is the frame's time.
std::unique_ptr<FrameSource> file_sequence(std::vector<std::string> files);

/// A recording of a depth camera (.oni), or a camera by its OpenNI2 name ("", "#1", a URI), read by
/// pcl::io::OpenNI2Grabber. A recording plays once, at its own speed. Frames that are not fetched in time are
/// dropped, the oldest first. Throws StreamError, also if PCL was built without OpenNI2.
std::unique_ptr<FrameSource> openni_source(const std::string& device_or_file);

/// Whether PCL was built with OpenNI2, which openni_source() needs.
bool has_openni();

/// The .pcd, .ply, .las, .ptx, .pts and .xyz files of a folder, sorted by name with numbers by value ("2"
/// before "10"). Throws StreamError if there are none.
std::vector<std::string> frame_files_in(const std::string& folder);

/// Whether the file's extension is one of those of frame_files_in().
bool is_frame_file(const std::string& path);

/// The number at the end of a file's name without its extension: 12.5 for "scan_12.5.pcd".
std::optional<double> time_in_name(const std::string& path);

}  // namespace filmsticking::stream

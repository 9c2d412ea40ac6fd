// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame.h"

namespace filmsticking::capture {

/// Where frames come from, one after the other. All of them play through a pcl::Grabber.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// The next frame; none at the end, or for a live one if none has come for a while (see at_end()). Throws
  /// CaptureError for a frame that is broken; the next call goes on behind it.
  virtual std::optional<Frame> next() = 0;

  virtual bool at_end() const = 0;

  /// How many frames there are in all; none if that is not known.
  virtual std::optional<std::size_t> size() const { return std::nullopt; }
};

/// The PCD files in the order given, read one at a time by pcl::PCDGrabberBase. A number at the end of a
/// file's name ("scan_12.5.pcd") is the frame's time.
std::unique_ptr<FrameSource> pcd_sequence(std::vector<std::string> files);

/// A recording of a depth camera (.oni), or a live one by its OpenNI2 name ("", "#1", a URI), by
/// pcl::io::OpenNI2Grabber. A recording plays once, at its own speed; frames that are not fetched in time are
/// dropped, the oldest first. Throws CaptureError, also where PCL was built without OpenNI2.
std::unique_ptr<FrameSource> openni_source(const std::string& device_or_file);

/// Whether openni_source() can work at all.
bool has_openni();

/// The .pcd files of a folder, in the order of their names, numbers in them by value ("2" before "10").
/// Throws CaptureError if there are none.
std::vector<std::string> pcd_files_in(const std::string& folder);

/// The number at the end of a file's name without its extension: 12.5 for "scan_12.5.pcd".
std::optional<double> time_in_name(const std::string& path);

}  // namespace filmsticking::capture

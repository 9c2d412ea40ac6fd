// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a file of points, in every format that the programs read: a clean refusal, or a model whose
// parts fit together and that reads back as it was written.
#include <pcl/console/print.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <string_view>

#include "io/codecs.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "stream/frame_points.h"
#include "stream/frame_source.h"
#include "stream/stream_error.h"
#include "stream/trajectory.h"
#include "support/model.h"
#include "target.h"

namespace filmsticking::test {
namespace {

std::string fault_of(const Model& model, std::size_t bytes) {
  if (model.positions.size() > bytes) return "more points than bytes";
  if (!model.colours.empty() && model.colours.size() != model.positions.size())
    return "colours of some points only";
  for (const Triangle& triangle : model.triangles)
    for (const std::int32_t corner : triangle)
      if (corner < 0 || static_cast<std::size_t>(corner) >= model.positions.size())
        return "a corner is no point";
  return "";
}

/// Bit by bit, but for the kind of NaN.
bool same(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (std::memcmp(&a[i][k], &b[i][k], sizeof(double)) != 0 &&
          !(std::isnan(a[i][k]) && std::isnan(b[i][k])))
        return false;
  return true;
}

/// What was read is written and read again.
std::string round_trip_fault(const pcl::PolygonMesh& mesh) {
  const Model model = mesh;
  for (const char* format : {"ply", "obj", "vtk"}) {
    const Model again = io::decode_mesh(format, io::encode_mesh(format, mesh));
    if (!same(again.positions, model.positions)) return "points change on their way through a file";
    if (again.triangles != model.triangles) return "triangles change on their way through a file";
    if (!model.colours.empty() && again.colours != model.colours)
      return "colours change on their way through a file";
  }
  for (const char* format : {"stl", "glb"}) try {
      io::encode_mesh(format, mesh);
    } catch (const io::IoError&) {  // glTF has no such number, or there are no triangles
    }
  return "";
}

void read_as(const std::string& format, std::string_view bytes) {
  pcl::PolygonMesh mesh;
  try {
    mesh = io::decode_mesh(format, bytes);
  } catch (const io::IoError&) {
    return;
  }
  require_no_fault(fault_of(mesh, bytes.size()));
  require_no_fault(round_trip_fault(mesh));
}

/// As the programs do: the content says the format, and the columns of a text are named.
void read_with_columns(std::string_view bytes) {
  for (const std::vector<std::string>& columns :
       {std::vector<std::string>{}, {"x", "_", "y", "z", "r", "g", "b"}})
    try {
      const io::Cloud cloud = io::decode_any(bytes, "", {0, {}, columns});
      require_no_fault(fault_of(cloud.points, bytes.size()));
      if (!cloud.viewpoints.empty() && cloud.viewpoints.size() != io::size_of(cloud.points)) std::abort();
      static_cast<void>(io::float_suffices(cloud.points));
      for (const std::string& note : cloud.notes)
        if (note.empty()) std::abort();
    } catch (const io::IoError&) {
    }
}

/// Frames of a capture.
void read_as_frame(std::string_view bytes) {
  const int file = memfd_create("frame", 0);
  if (file < 0 || write(file, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) std::abort();
  try {
    const auto frames = stream::file_sequence({"/proc/self/fd/" + std::to_string(file)});
    while (const auto frame = frames->next())
      require_no_fault(fault_of(stream::frame_points(*frame, {}), bytes.size()));
  } catch (const stream::StreamError&) {
  }
  close(file);
}

void read_as_trajectory(std::string_view bytes) {
  try {
    if (stream::parse_trajectory(bytes).size() == 0) std::abort();
  } catch (const stream::StreamError&) {
  }
}

/// The reader that FUZZ_READER names, or all of them.
void read_by_name(std::string_view reader, std::string_view bytes) {
  const auto wanted = [&](std::string_view name) { return reader.empty() || reader == name; };
  for (const char* format : {"pcd", "ply", "obj", "stl", "vtk", "xyz", "off", "las", "ptx", "grid"})
    if (wanted(format)) read_as(format, bytes);
  if (wanted("columns")) read_with_columns(bytes);
  if (wanted("frame")) read_as_frame(bytes);
  if (wanted("trajectory")) read_as_trajectory(bytes);
}

}  // namespace
}  // namespace filmsticking::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace filmsticking;
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // PCL says something of every broken file
  static const char* const reader = std::getenv("FUZZ_READER");
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  static_cast<void>(io::detect_format(bytes));
  test::read_by_name(reader ? reader : "", bytes);
  return 0;
}

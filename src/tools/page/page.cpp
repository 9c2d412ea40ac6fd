// SPDX-License-Identifier: GPL-3.0-or-later
#include "page.h"

#include <vtkBase64Utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "distances.h"
#include "io/files.h"
#include "io/io_error.h"
#include "page_files.h"
#include "report/sides.h"

namespace filmsticking::page {
namespace {

using Json = nlohmann::ordered_json;
using mesh_report::Frame;
using mesh_report::Side;
using mesh_report::Surface;
using mesh_report::Vec3;

constexpr std::size_t kMostHoles = 1000;  // in the list

/// Text that HTML shows as it is.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else {
      result += c;
    }
  }
  return result;
}

/// JSON within a script: nothing in it ends the script, and bytes that are not UTF-8 are replaced.
std::string embedded(const Json& json) {
  std::string result;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

/// Sends a script element with the bytes of numbers.
template <typename Number>
void send_numbers(const io::ByteSink& sink, const char* id, const std::vector<Number>& numbers) {
  constexpr std::size_t kPiece = 3 << 16;  // whole groups of base64
  sink("<script type=\"text/plain\" id=\"" + std::string(id) + "\">");
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  const std::size_t size = numbers.size() * sizeof(Number);
  std::vector<unsigned char> text(kPiece / 3 * 4 + 4);
  for (std::size_t begin = 0; begin < size; begin += kPiece) {
    const auto length =
        vtkBase64Utilities::Encode(bytes + begin, std::min(kPiece, size - begin), text.data());
    sink({reinterpret_cast<const char*>(text.data()), length});
  }
  sink("</script>\n");
}

/// Places in the unit box, where single precision keeps their digits.
std::vector<float> places(const std::vector<Vec3>& points, const Frame& frame, std::size_t stride = 1) {
  std::vector<float> numbers;
  numbers.reserve(3 * (points.size() / stride + 1));
  for (std::size_t i = 0; i < points.size(); i += stride)
    for (const double x : frame.to_unit(points[i])) numbers.push_back(static_cast<float>(x));
  return numbers;
}

/// Ends of the edges with `least` to `most` faces.
std::vector<std::int32_t> edges(const std::vector<Side>& sides, std::ptrdiff_t least, std::ptrdiff_t most) {
  std::vector<std::int32_t> ends;
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end =
        std::find_if(begin, sides.end(), [&](const Side& side) { return !side.same_edge(*begin); });
    if (end - begin >= least && end - begin <= most) ends.insert(ends.end(), {begin->low, begin->high});
    begin = end;
  }
  return ends;
}

Json list(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json facts_of(const std::vector<Hole>& holes, const Frame& frame) {
  Json facts = Json::array();
  for (std::size_t i = 0; i < std::min(holes.size(), kMostHoles); ++i) {
    const Hole& hole = holes[i];
    facts.push_back({{"centre", list(frame.to_unit(Vec3(hole.centre.data())))},
                     {"normal", hole.normal},
                     {"edges", hole.edges},
                     {"length", hole.length},
                     {"diameter", hole.diameter},
                     {"area", hole.area}});
  }
  return facts;
}

/// The faces' mean direction if most look that way, as in a scan from one side; else zero.
Vec3 front(const Surface& mesh) {
  constexpr double kOneSided = 0.4;  // of the area; half a ball has 0.5
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Vec3 face = mesh.area_vector2(f);
    sum += face, area += face.stableNorm();
  }
  return sum.stableNorm() > kOneSided * area ? sum.stableNormalized() : Vec3::Zero();
}

std::vector<std::int32_t> indices_of(const std::vector<char>& marked) {
  std::vector<std::int32_t> indices;
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i] != 0) indices.push_back(static_cast<std::int32_t>(i));
  return indices;
}

std::string table(const Contents& contents) {
  std::string html = "<table id=\"report\">";
  for (const auto& [name, value] : mesh_report::table_rows(contents.report))
    html += "<tr><th>" + escaped(name) + "</th><td>" + escaped(value) + "</td></tr>";
  return html + "</table>";
}

/// The numbers of the page, each in an element; first the facts that need them.
class Data {
 public:
  explicit Data(const Contents& contents)
      : contents_(contents), frame_(mesh_report::frame_of(everything(contents))) {}

  void send(const io::ByteSink& sink) const {
    const Surface& mesh = contents_.mesh;
    const std::vector<Side> sides = mesh_report::sides_by_edge(mesh);
    const std::vector<Hole>& holes = contents_.report.holes;
    Json facts = {{"side", frame_.side},
                  {"radius", frame_.side > 0 ? frame_.diagonal / 2 / frame_.side : 0.5},
                  {"middle", list(frame_.centre)},
                  {"front", list(front(mesh))},
                  {"hole_count", holes.size()},
                  {"holes", facts_of(holes, frame_)}};
    send_distances(sink, facts);
    sink("<script type=\"application/json\" id=\"facts\">" + embedded(facts) + "</script>\n");
    send_numbers(sink, "positions", places(mesh.positions, frame_));
    send_numbers(sink, "faces", mesh.triangles);
    send_numbers(sink, "boundary", edges(sides, 1, 1));
    send_numbers(sink, "surplus", edges(sides, 3, PTRDIFF_MAX));
    send_numbers(sink, "meeting", indices_of(contents_.report.meeting_faces));
  }

 private:
  static const std::vector<Vec3>& everything(const Contents& contents) {
    return contents.mesh.positions.empty() && contents.cloud ? contents.cloud->points
                                                             : contents.mesh.positions;
  }

  void send_distances(const io::ByteSink& sink, Json& facts) const {
    const Surface& mesh = contents_.mesh;
    const mesh_report::CloudDistances* cloud = contents_.cloud;
    if (cloud && !cloud->points.empty()) {
      const std::size_t stride = (cloud->points.size() - 1) / kMostPoints + 1;
      send_numbers(sink, "points", places(cloud->points, frame_, stride));
      facts["every"] = stride;
      if (!cloud->to_mesh.empty()) {
        const Painting points = paint("from points to mesh", cloud->to_mesh);
        std::vector<std::uint8_t> shown;
        for (std::size_t i = 0; i < points.colours.size(); i += stride) shown.push_back(points.colours[i]);
        send_numbers(sink, "point_distances", shown);
        facts["point_distances"] = points.facts();
        send_faces(sink, facts, "cloud_distances",
                   paint("from faces to points", faces_to_points(mesh, cloud->points)));
      }
    }
    if (contents_.truth && !contents_.truth->triangles.empty() && !mesh.triangles.empty())
      send_faces(sink, facts, "truth_distances",
                 paint("from faces to truth", faces_to_truth(mesh, *contents_.truth)));
  }

  static void send_faces(const io::ByteSink& sink, Json& facts, const char* id, const Painting& painting) {
    send_numbers(sink, id, painting.colours);
    facts[id] = painting.facts();
  }

  const Contents& contents_;
  Frame frame_;
};

}  // namespace

void write_page(const std::string& path, const Contents& contents) {
  const std::size_t faces = contents.mesh.triangles.size();
  if (faces > kMostFaces)
    throw io::IoError("a page shows at most " + std::to_string(kMostFaces) + " faces, and the mesh has " +
                      std::to_string(faces));
  io::write_file(path, [&](const io::ByteSink& sink) {
    std::string_view rest = kPageHtml;
    const auto send_up_to = [&](std::string_view mark) {
      const std::size_t place = rest.find(mark);
      sink(rest.substr(0, place));
      rest.remove_prefix(place + mark.size());
    };
    send_up_to("<!--TITLE-->");
    sink(escaped(contents.title));
    send_up_to("<!--TITLE-->");
    sink(escaped(contents.title));
    send_up_to("<!--TABLE-->");
    sink(table(contents));
    send_up_to("<!--DATA-->");
    Data(contents).send(sink);
    send_up_to("/*THREE*/");
    sink(kThree);
    send_up_to("/*SCRIPT*/");
    sink(kPageScript);
    sink(rest);
  });
}

}  // namespace filmsticking::page

// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>
#include <cmath>
#include <ostream>
#include <streambuf>
#include <vector>

#include "codecs.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

using Vertex = CGAL::Simple_cartesian<double>::Point_3;

/// Passes its output on to a ByteWriter.
class WriterBuffer : public std::streambuf {
 public:
  explicit WriterBuffer(ByteWriter& out) : out_(out) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize size) override {
    out_.append({bytes, static_cast<std::size_t>(size)});
    return size;
  }
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    if (!traits_type::eq_int_type(c, traits_type::eof())) out_.append({&byte, 1});
    return traits_type::not_eof(c);
  }

 private:
  ByteWriter& out_;
};

/// Whether the file is whole, which CGAL does not see of every short one. Binary files have a size that
/// follows from their number of triangles; some begin with "solid" like texts, some have more at their end.
bool is_whole(std::string_view bytes) {
  const std::size_t size =
      bytes.size() < 84 ? 84 : 84 + std::size_t{50} * load<std::uint32_t>(bytes.data() + 80);
  if (bytes.size() == size || bytes.substr(0, 5) != "solid") return bytes.size() >= size;
  const std::size_t end = bytes.rfind("endsolid"), vertex = bytes.rfind("vertex");
  return end != std::string_view::npos && (vertex == std::string_view::npos || vertex < end);
}

}  // namespace

pcl::PolygonMesh decode_stl(std::string_view bytes) {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  boost::iostreams::stream<boost::iostreams::array_source> file(bytes.data(), bytes.size());
  if (!is_whole(bytes) || !CGAL::IO::read_STL(file, vertices, triangles) || triangles.empty())
    throw IoError("it is not a whole STL file");
  std::vector<Point> positions;
  positions.reserve(vertices.size());
  for (const Vertex& v : vertices) positions.push_back({v.x(), v.y(), v.z()});
  for (const Point& p : positions)
    if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
      throw IoError("a corner in it is not finite");
  return make_mesh(make_cloud(positions), triangles);
}

void encode_stl(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles,
                ByteWriter& out) {
  std::vector<Vertex> corners;
  corners.reserve(size_of(vertices));
  for (const Point& p : positions_of(vertices)) corners.emplace_back(p[0], p[1], p[2]);
  WriterBuffer buffer(out);
  std::ostream file(&buffer);
  file.exceptions(std::ios::badbit);  // passes on what the sink throws
  CGAL::IO::set_mode(file, float_exact(vertices) ? CGAL::IO::BINARY : CGAL::IO::ASCII);
  CGAL::IO::write_STL(file, corners, triangles, CGAL::parameters::stream_precision(17));
}

}  // namespace filmsticking::io

// SPDX-License-Identifier: GPL-3.0-or-later
// Read by hand: with one byte changed in a small file VTK 9.1's reader crashed 218 times in 7,040, and 337
// times passed on corners that are no points.
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <optional>
#include <string>

#include "codecs.h"
#include "io_error.h"
#include "large_pages.h"
#include "text_scanner.h"
#include "vtk_polydata.h"

namespace filmsticking::io {
namespace {

[[noreturn]] void throw_vtk_short() { throw IoError("it is not a whole VTK file"); }

/// The words and numbers of a file, one after the other.
class VtkBody {
 public:
  explicit VtkBody(std::string_view bytes) : rest_(bytes) {}

  std::string_view line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  /// Empty at the end of the file.
  std::string_view word() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(TextScanner::kBlanks), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(TextScanner::kBlanks));
    rest_.remove_prefix(word.size());
    return word;
  }

  std::string keyword() { return lower(word()); }

  std::size_t count() {
    long long value = 0;
    if (!parse_integer(word(), value) || value < 0) throw IoError("a number of things in it is none");
    return static_cast<std::size_t>(value);
  }

  Scalar type() {
    static const std::map<std::string_view, Scalar> types = {{"char", Scalar::Int8},
                                                             {"signed_char", Scalar::Int8},
                                                             {"unsigned_char", Scalar::UInt8},
                                                             {"short", Scalar::Int16},
                                                             {"unsigned_short", Scalar::UInt16},
                                                             {"int", Scalar::Int32},
                                                             {"unsigned_int", Scalar::UInt32},
                                                             {"vtkidtype", Scalar::Int32},
                                                             {"long", Scalar::Int64},
                                                             {"unsigned_long", Scalar::UInt64},
                                                             {"vtktypeint64", Scalar::Int64},
                                                             {"vtktypeuint64", Scalar::UInt64},
                                                             {"float", Scalar::Float},
                                                             {"double", Scalar::Double}};
    const std::string name = keyword();
    const auto found = types.find(name);
    if (found == types.end()) throw IoError("an array in it has an unknown type '" + name + "'");
    return found->second;
  }

  /// Refuses an array that the rest of the file cannot hold.
  void require(std::size_t tuples, std::size_t size, Scalar type) const {
    const std::size_t smallest = binary_ ? size_of(type) : 1;
    if (size > 0 && tuples > rest_.size() / smallest / size) throw_vtk_short();
  }

  /// Calls use(value) for each number of an array of `tuples` times `size` of them. A length that the rest of
  /// the file cannot hold is refused before.
  template <class Use>
  void array(std::size_t tuples, std::size_t size, Scalar type, const Use& use) {
    if (binary_) line();
    require(tuples, size, type);
    if (binary_) return with_type(type, [&](auto zero) { binary_array<decltype(zero)>(tuples * size, use); });
    for (std::size_t i = 0; i < tuples * size; ++i) use(text_value(type));
  }

  std::vector<double> array(std::size_t count, Scalar type) {
    std::vector<double> values;
    array(count, 1, type, [&](double x) { values.push_back(x); });
    return values;
  }

  void skip(std::size_t tuples, std::size_t size, Scalar type) {
    if (!binary_) return array(tuples, size, type, [](double) {});
    line();
    require(tuples, size, type);
    rest_.remove_prefix(tuples * size * size_of(type));
  }

  void set_binary(bool binary) { binary_ = binary; }
  bool binary() const { return binary_; }

 private:
  /// Calls work with a number of the type.
  template <class Work>
  static void with_type(Scalar type, const Work& work) {
    switch (type) {
      case Scalar::Int8:
        return work(std::int8_t{});
      case Scalar::UInt8:
        return work(std::uint8_t{});
      case Scalar::Int16:
        return work(std::int16_t{});
      case Scalar::UInt16:
        return work(std::uint16_t{});
      case Scalar::Int32:
        return work(std::int32_t{});
      case Scalar::UInt32:
        return work(std::uint32_t{});
      case Scalar::Int64:
        return work(std::int64_t{});
      case Scalar::UInt64:
        return work(std::uint64_t{});
      case Scalar::Float:
        return work(float{});
      case Scalar::Double:
        return work(double{});
    }
  }

  /// Binary files are big-endian.
  template <typename T, class Use>
  void binary_array(std::size_t count, const Use& use) {
    const char* from = rest_.data();
    for (std::size_t i = 0; i < count; ++i, from += sizeof(T)) use(static_cast<double>(load_big<T>(from)));
    rest_.remove_prefix(count * sizeof(T));
  }

  double text_value(Scalar type) {
    const std::string_view text = word();
    if (text.empty()) throw_vtk_short();
    float single = 0;
    double value = 0;
    if (!(type == Scalar::Float ? TextScanner(text).number(single) : TextScanner(text).number(value)))
      throw IoError("an array in it has a word that is not a number");
    return type == Scalar::Float ? static_cast<double>(single) : value;
  }

  std::string_view rest_;
  bool binary_ = false;
};

class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : body_(bytes) {}

  /// Ends: every turn takes a word at least.
  Shape decode() {
    header();
    for (std::string keyword = body_.keyword(); !keyword.empty(); keyword = body_.keyword()) {
      if (keyword == "points") {
        points();
      } else if (keyword == "vertices" || keyword == "lines" || keyword == "cells") {
        cells([](const std::vector<std::int32_t>&) {});
      } else if (keyword == "cell_types") {
        const std::size_t count = body_.count();
        body_.skip(count, 1, Scalar::Int32);
      } else if (keyword == "dimensions") {
        for (int k = 0; k < 3; ++k) body_.count();
      } else if (keyword == "polygons") {
        cells([&](const std::vector<std::int32_t>& c) { append_polygon(c, shape_.triangles); });
      } else if (keyword == "triangle_strips") {
        cells([&](const std::vector<std::int32_t>& c) {
          for (std::size_t k = 2; k < c.size(); ++k)  // every other one is turned around
            shape_.triangles.push_back({c[k - 2 + k % 2], c[k - 1 - k % 2], c[k]});
        });
      } else if (keyword == "point_data" || keyword == "cell_data") {
        of_points_ = keyword == "point_data";
        tuples_ = body_.count();
      } else if (keyword == "field") {
        field();
      } else if (keyword == "metadata") {
        metadata();
      } else if (!tuples_) {
        throw IoError("its VTK data has an unknown part '" + keyword.substr(0, 20) + "'");
      } else {
        attribute(keyword);
      }
    }
    check_corners(shape_.triangles, size_of(shape_.points));
    add_colours();
    if (!left_out_.empty()) shape_.notes.push_back("left out its point data" + left_out_);
    if (coloured_cells_) shape_.notes.push_back("left out the colours of its cells");
    return std::move(shape_);
  }

 private:
  void leave_out(std::string_view name) {
    constexpr std::size_t kMost = 200;
    if (!of_points_ || left_out_.size() > kMost) return;
    left_out_ += " ";
    for (const char c : name.substr(0, 40)) left_out_ += c < ' ' || c > '~' ? '?' : c;
  }

  void header() {
    constexpr std::string_view kMagic = "# vtk datafile version ";
    const std::string magic = lower(body_.line());
    double version = 0;
    if (magic.compare(0, kMagic.size(), kMagic) != 0 ||
        !TextScanner(std::string_view(magic).substr(kMagic.size())).number(version))
      throw IoError("it is not a legacy VTK file");
    offsets_ = version >= 5;
    body_.line();  // a title
    const std::string format = body_.keyword();
    if (format != "ascii" && format != "binary") throw IoError("it is neither a text nor a binary VTK file");
    body_.set_binary(format == "binary");
    if (body_.keyword() != "dataset") throw IoError("its VTK header has no DATASET");
    const std::string kind = body_.keyword();
    if (kind != "polydata" && kind != "unstructured_grid" && kind != "structured_grid")
      throw IoError("its VTK data are " + kind.substr(0, 20) +
                    ", which have no points; save them as POLYDATA or UNSTRUCTURED_GRID");
  }

  static Scalar kept_type(Scalar type) { return type == Scalar::Float ? type : Scalar::Double; }

  /// There is room for colours, which come later.
  void points() {
    if (size_of(shape_.points) > 0) throw IoError("its VTK data has points twice");
    const std::size_t count = body_.count();
    const Scalar type = body_.type();
    body_.require(count, 3, type);
    const PointLayout layout({{"x", kept_type(type)}, {"y", kept_type(type)}, {"z", kept_type(type)}});
    shape_.points.data.reserve(count * (layout.step() + kColour));
    prefer_large_pages(shape_.points.data.data(), count * layout.step());
    pcl::PCLPointCloud2 cloud = layout.cloud(0);
    cloud.data = std::move(shape_.points.data);
    cloud.data.resize(count * layout.step());
    std::uint8_t* to = cloud.data.data();
    body_.array(count, 3, type, [&](double x) {
      const auto single = static_cast<float>(x);
      if (type == Scalar::Float) {
        std::memcpy(to, &single, sizeof single);
        to += sizeof single;
      } else {
        std::memcpy(to, &x, sizeof x);
        to += sizeof x;
      }
    });
    cloud.width = static_cast<std::uint32_t>(count);
    cloud.row_step = cloud.width * cloud.point_step;
    shape_.points = std::move(cloud);
  }

  /// Moves the points apart, from the last one on.
  void add_colours() {
    if (colours_.empty()) return;
    if (colours_.size() != size_of(shape_.points)) throw IoError("it does not have a colour a point");
    pcl::PCLPointCloud2& cloud = shape_.points;
    const std::size_t step = cloud.point_step, wide = step + kColour;
    cloud.fields.push_back(make_field("rgb", step, pcl::PCLPointField::FLOAT32));
    cloud.data.resize(size_of(cloud) * wide);
    for (std::size_t i = size_of(cloud); i-- > 0;) {
      std::uint8_t* const to = cloud.data.data() + i * wide;
      std::memmove(to, cloud.data.data() + i * step, step);
      const std::uint8_t packed[kColour] = {colours_[i][2], colours_[i][1], colours_[i][0], 255};
      std::memcpy(to + step, packed, kColour);
    }
    cloud.point_step = static_cast<std::uint32_t>(wide);
    cloud.row_step = cloud.width * cloud.point_step;
  }

  /// Calls use(corners) for each. From version 5 on, their corners in a row and where each begins, and the
  /// end; before, each with its number of corners ahead of them.
  template <class Use>
  void cells(const Use& use) {
    const std::size_t count = body_.count(), size = body_.count();
    std::vector<std::int32_t> corners;
    if (!offsets_) {
      const std::vector<double> all = body_.array(size, Scalar::Int32);
      std::size_t at = 0;
      for (std::size_t i = 0; i < count; ++i) {
        if (at == size || !(all[at] >= 0 && all[at] <= static_cast<double>(size - at - 1))) throw_bad_cells();
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(at) + 1;
        const auto end = begin + static_cast<std::ptrdiff_t>(all[at]);
        corners.clear();
        std::transform(begin, end, std::back_inserter(corners), corner_index);
        use(corners);
        at = static_cast<std::size_t>(end - all.begin());
      }
      if (at != size) throw_bad_cells();
      return;
    }
    if (count == 0) return;
    if (body_.keyword() != "offsets") throw_bad_cells();
    const Scalar offset_type = body_.type();
    const std::vector<double> offsets = body_.array(count, offset_type);
    if (body_.keyword() != "connectivity") throw_bad_cells();
    const Scalar corner_type = body_.type();
    const std::vector<double> all = body_.array(size, corner_type);
    if (offsets.front() != 0 || offsets.back() != static_cast<double>(size)) throw_bad_cells();
    for (std::size_t i = 0; i + 1 < count; ++i) {
      if (!(offsets[i] >= 0 && offsets[i] <= offsets[i + 1] && offsets[i + 1] <= static_cast<double>(size)))
        throw_bad_cells();
      corners.clear();
      std::transform(all.begin() + static_cast<std::ptrdiff_t>(offsets[i]),
                     all.begin() + static_cast<std::ptrdiff_t>(offsets[i + 1]), std::back_inserter(corners),
                     corner_index);
      use(corners);
    }
  }

  [[noreturn]] static void throw_bad_cells() {
    throw IoError("the cells in it do not have the size that it says");
  }

  /// Arrays of any size, which have names.
  void field() {
    body_.word();
    for (std::size_t left = body_.count(); left > 0; --left) {
      const std::string_view name = body_.word();
      if (name.empty()) throw_vtk_short();
      if (lower(name) == "metadata") {  // of the array before
        metadata();
        ++left;
        continue;
      }
      if (tuples_) leave_out(name);
      const std::size_t size = body_.count(), tuples = body_.count();
      body_.skip(tuples, size, body_.type());
    }
  }

  /// Lines up to an empty one.
  void metadata() {
    body_.line();
    while (!body_.line().empty()) {
    }
  }

  void attribute(const std::string& keyword) {
    static const std::map<std::string_view, std::size_t> sizes = {
        {"vectors", 3}, {"normals", 3},    {"tensors", 9},      {"tensors6", 6},
        {"scalars", 1}, {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    const std::string name(body_.word());
    if (keyword == "color_scalars") {
      const std::size_t size = body_.count();
      body_.binary() ? colours(size, Scalar::UInt8, 1) : colours(size, Scalar::Float, 255);
    } else if (keyword == "lookup_table") {
      const std::size_t size = body_.count();
      body_.skip(size, 4, body_.binary() ? Scalar::UInt8 : Scalar::Float);
    } else if (keyword == "texture_coordinates") {
      const std::size_t size = body_.count();
      body_.skip(*tuples_, size, body_.type());
    } else if (keyword == "scalars") {
      const Scalar type = body_.type();
      std::size_t size = 1;
      std::string word = body_.keyword();
      if (long long given = 0; parse_integer(word, given)) {
        if (given < 1 || given > 4) throw IoError("scalars in it are not one to four a point");
        size = static_cast<std::size_t>(given), word = body_.keyword();
      }
      if (word != "lookup_table") throw IoError("scalars in it have no lookup table");
      body_.word();
      if (type != Scalar::UInt8 || size < 3) leave_out(name);
      type == Scalar::UInt8 ? colours(size, type, 1) : body_.skip(*tuples_, size, type);
    } else if (const auto found = sizes.find(keyword); found != sizes.end()) {
      leave_out(name);
      body_.skip(*tuples_, found->second, body_.type());
    } else {
      throw IoError("its VTK data has an unknown attribute '" + keyword.substr(0, 20) + "'");
    }
  }

  /// Unsigned bytes, once they are multiplied by `scale`; colours if there are three for a point at least.
  void colours(std::size_t size, Scalar type, double scale) {
    coloured_cells_ |= !of_points_ && size >= 3;
    if (!of_points_ || size < 3 || !colours_.empty()) return body_.skip(*tuples_, size, type);
    Colour colour{};
    std::size_t k = 0;
    body_.array(*tuples_, size, type, [&](double x) {
      const double byte = std::floor(x * scale + 0.5);
      if (!(byte >= 0 && byte <= 255)) throw IoError("a colour in it is not from 0 to 255");
      if (k < 3) colour[k] = static_cast<std::uint8_t>(byte);
      k = (k + 1) % size;
      if (k == 0) colours_.push_back(colour);
    });
  }

  static constexpr std::size_t kColour = 4;

  VtkBody body_;
  Shape shape_{make_cloud({})};
  std::vector<Colour> colours_;
  bool offsets_ = false;               // are cells written as in version 5?
  std::optional<std::size_t> tuples_;  // of an attribute, once the attributes have begun
  bool of_points_ = false;             // or else of cells
  bool coloured_cells_ = false;
  std::string left_out_;  // names of point data
};

}  // namespace

Shape decode_vtk(std::string_view bytes) { return Decoder(bytes).decode(); }

void encode_vtk(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles,
                ByteWriter& out) {
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(to_polydata(positions_of(vertices), colours_of(vertices), triangles));
  writer->SetFileTypeToBinary();
  writer->SetFileVersion(vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2);
  writer->WriteToOutputStringOn();
  if (!writer->Write()) throw IoError("VTK cannot write it");
  const std::string_view bytes(writer->GetOutputString(),
                               static_cast<std::size_t>(writer->GetOutputStringLength()));
  out.append(bytes);
}

vtkSmartPointer<vtkPolyData> to_polydata(const std::vector<Point>& positions,
                                         const std::vector<Colour>& colours,
                                         const std::vector<Triangle>& triangles) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), positions[i].data());
  vtkNew<vtkCellArray> cells;
  for (const Triangle& triangle : triangles) {
    const vtkIdType corners[3] = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  if (!colours.empty()) {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName("RGB");
    array->SetNumberOfComponents(3);
    for (const Colour& colour : colours) array->InsertNextTypedTuple(colour.data());
    data->GetPointData()->SetScalars(array);
  }
  return data;
}

}  // namespace filmsticking::io

// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: the headers of LAS are few, and Debian's liblas knows no version beyond 1.2.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "codecs.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

constexpr std::size_t kHeader12 = 227;  // bytes of versions 1.0 to 1.2
constexpr std::size_t kHeader14 = 375;  // of 1.4
constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

/// Where a point format has what; the first 20 or 30 bytes are the same within both kinds.
struct PointFormat {
  std::size_t size, time, colours;
};
constexpr PointFormat kPointFormats[] = {{20, kAbsent, kAbsent}, {28, 20, kAbsent}, {26, kAbsent, 20},
                                         {34, 20, 28},           {57, 20, kAbsent}, {63, 20, 28},
                                         {30, 22, kAbsent},      {36, 22, 30},      {38, 22, 30},
                                         {59, 22, kAbsent},      {67, 22, 30}};
constexpr std::size_t kOldFormats = 6;

struct LasHeader {
  std::size_t format = 0, step = 0, begin = 0, points = 0;
  double scale[3] = {}, offset[3] = {};
};

[[noreturn]] void throw_short() { throw IoError("it ends before its LAS header says"); }

LasHeader parse_header(std::string_view bytes) {
  if (bytes.substr(0, 4) != "LASF") throw IoError("it is not a LAS file");
  if (bytes.size() < kHeader12) throw_short();
  const char* const at = bytes.data();
  const int minor = load<std::uint8_t>(at + 25);
  if (load<std::uint8_t>(at + 24) != 1 || minor > 4) throw IoError("its LAS version is none of 1.0 to 1.4");
  LasHeader header;
  const auto format = load<std::uint8_t>(at + 104);
  if (format & 0xc0)
    throw IoError(
        "its points are compressed (LAZ); decompress it with 'laszip -i IN.laz -o OUT.las' or "
        "'pdal translate IN.laz OUT.las'");
  header.format = format;
  if (header.format >= std::size(kPointFormats))
    throw IoError("its LAS point format " + std::to_string(format) + " is none of 0 to 10");
  header.begin = load<std::uint32_t>(at + 96);
  header.step = load<std::uint16_t>(at + 105);
  header.points = load<std::uint32_t>(at + 107);
  if (minor == 4 && bytes.size() >= kHeader14 && load<std::uint16_t>(at + 94) >= kHeader14) {
    const auto points = load<std::uint64_t>(at + 247);
    if (points > 0) header.points = points;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    header.scale[k] = load<double>(at + 131 + 8 * k);
    header.offset[k] = load<double>(at + 155 + 8 * k);
    if (!std::isfinite(header.scale[k]) || !std::isfinite(header.offset[k]) || header.scale[k] == 0)
      throw IoError("the scale or the offset in its LAS header is no number above zero");
  }
  if (header.step < kPointFormats[header.format].size)
    throw IoError("its LAS points have " + std::to_string(header.step) +
                  " bytes, fewer than their format has");
  if (header.begin > bytes.size() || header.points > (bytes.size() - header.begin) / header.step)
    throw_short();
  return header;
}

/// From stored integers to coordinates. Where scale and offset are decimals, as 0.001 and 500000 are, the
/// result is the double that is nearest to the decimal, as a text would give.
class Axis {
 public:
  Axis(double scale, double offset) : scale_(scale), offset_(offset) {
    const double parts = std::nearbyint(1 / scale);
    if (!(std::abs(parts) >= 1 && std::abs(parts) <= 1e12) || std::abs(parts * scale - 1) > 1e-12) return;
    const double ahead = std::nearbyint(offset * parts);
    if (std::abs(ahead) > 1e15 || std::abs(ahead - offset * parts) > 1e-9 * std::max(1.0, std::abs(ahead)))
      return;
    parts_ = parts, ahead_ = ahead;
  }

  double operator()(std::int32_t stored) const {
    return parts_ != 0 ? (stored + ahead_) / parts_ : stored * scale_ + offset_;
  }

 private:
  double scale_, offset_, parts_ = 0, ahead_ = 0;
};

struct Layout {
  std::size_t rgb = kAbsent, time = kAbsent;
  static constexpr std::size_t kIntensity = 24, kClass = 26, kEnd = 27;
  std::size_t step = kEnd;
};

pcl::PCLPointCloud2 make(const PointFormat& format, std::size_t points, Layout& layout) {
  using Type = pcl::PCLPointField;
  std::vector<pcl::PCLPointField> fields = {
      make_field("x", 0, Type::FLOAT64), make_field("y", 8, Type::FLOAT64),
      make_field("z", 16, Type::FLOAT64), make_field("intensity", Layout::kIntensity, Type::UINT16),
      make_field("classification", Layout::kClass, Type::UINT8)};
  if (format.time != kAbsent) {
    layout.time = layout.step;
    fields.push_back(make_field("gps_time", layout.time, Type::FLOAT64));
    layout.step += sizeof(double);
  }
  if (format.colours != kAbsent) {
    layout.rgb = layout.step;
    fields.push_back(make_field("rgb", layout.rgb, Type::FLOAT32));
    layout.step += 4;
  }
  return make_rows(std::move(fields), layout.step, points);
}

/// Colours have 16 bits; many writers put bytes there.
bool has_wide_colours(const LasHeader& header, const char* from) {
  for (std::size_t i = 0; i < header.points; ++i, from += header.step)
    for (std::size_t k = 0; k < 6; k += 2)
      if (load<std::uint16_t>(from + kPointFormats[header.format].colours + k) > 255) return true;
  return false;
}

}  // namespace

Cloud decode_las(std::string_view bytes) {
  const LasHeader header = parse_header(bytes);
  const PointFormat& format = kPointFormats[header.format];
  Layout layout;
  Cloud cloud;
  cloud.points = make(format, header.points, layout);
  const Axis axes[3] = {{header.scale[0], header.offset[0]},
                        {header.scale[1], header.offset[1]},
                        {header.scale[2], header.offset[2]}};
  const char* from = bytes.data() + header.begin;
  const bool wide = format.colours != kAbsent && has_wide_colours(header, from);
  std::uint8_t* to = cloud.points.data.data();
  for (std::size_t i = 0; i < header.points; ++i, from += header.step, to += layout.step) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = axes[k](load<std::int32_t>(from + 4 * k));
      std::memcpy(to + 8 * k, &x, sizeof x);
    }
    std::memcpy(to + Layout::kIntensity, from + 12, 2);
    const bool old = header.format < kOldFormats;  // these have flags above the classification
    to[Layout::kClass] = old ? load<std::uint8_t>(from + 15) & 31 : load<std::uint8_t>(from + 16);
    if (layout.time != kAbsent) std::memcpy(to + layout.time, from + format.time, sizeof(double));
    if (layout.rgb == kAbsent) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned value = load<std::uint16_t>(from + format.colours + 2 * k);
      to[layout.rgb + 2 - k] = static_cast<std::uint8_t>(wide ? (value + 128) / 257 : value);
    }
    to[layout.rgb + 3] = 255;
  }
  const bool infrared = header.format == 8 || header.format == 10;
  cloud.notes.push_back(
      std::string("left out the returns, flags, angles, user data and sources of its points") +
      (infrared ? ", near infrared" : "") + (header.step > format.size ? ", extra bytes" : ""));
  return cloud;
}

}  // namespace filmsticking::io

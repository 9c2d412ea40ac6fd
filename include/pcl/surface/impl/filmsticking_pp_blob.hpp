// SPDX-License-Identifier: GPL-3.0-or-later
// What pcl::FilmstickingPP does with a cloud whose fields are known at run time only.
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PCLPointField.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "filmsticking/types.h"

namespace pcl {
namespace detail {

/** \brief Why \a blob cannot be read as a cloud with x, y and z; empty if it can.
 *
 * pcl::fromPCLPointCloud2() trusts the sizes that a blob states; after this check it may.
 */
inline std::string blobFault(const pcl::PCLPointCloud2& blob) {
  if (blob.is_bigendian) return "the numbers of the blob are big-endian";
  int doubles = 0;
  for (const char* name : {"x", "y", "z"}) {
    const auto field = std::find_if(blob.fields.begin(), blob.fields.end(),
                                    [name](const pcl::PCLPointField& f) { return f.name == name; });
    if (field == blob.fields.end() || field->count > 1 ||
        (field->datatype != pcl::PCLPointField::FLOAT32 && field->datatype != pcl::PCLPointField::FLOAT64))
      return std::string("the blob has no field ") + name + " of type FLOAT32 or FLOAT64";
    doubles += field->datatype == pcl::PCLPointField::FLOAT64 ? 1 : 0;
  }
  if (doubles % 3 != 0) return "the fields x, y and z of the blob are not of one type";
  for (const pcl::PCLPointField& field : blob.fields) {
    const std::uint64_t bytes = static_cast<std::uint64_t>(std::max(0, pcl::getFieldSize(field.datatype))) *
                                std::max(1u, field.count);
    if (field.offset + bytes > blob.point_step)
      return "the field " + field.name + " of the blob is not within a point's " +
             std::to_string(blob.point_step) + " bytes";
  }
  const std::uint64_t row = static_cast<std::uint64_t>(blob.width) * blob.point_step;
  if (blob.height > 0 && blob.row_step < row) return "the rows of the blob are shorter than their points";
  if (static_cast<std::uint64_t>(blob.row_step) * blob.height != blob.data.size())
    return "the blob has " + std::to_string(blob.data.size()) + " bytes where its header states " +
           std::to_string(static_cast<std::uint64_t>(blob.row_step) * blob.height);
  return {};
}

/** \brief Where in a point's bytes the field \a name begins; \a blob has no blobFault(), and the field. */
inline std::size_t offsetOf(const pcl::PCLPointCloud2& blob, const char* name) {
  return std::find_if(blob.fields.begin(), blob.fields.end(),
                      [name](const pcl::PCLPointField& field) { return field.name == name; })
      ->offset;
}

/** \brief Whether x, y and z are of type FLOAT64; \a blob has no blobFault(). */
inline bool hasDoubles(const pcl::PCLPointCloud2& blob) {
  return std::any_of(blob.fields.begin(), blob.fields.end(), [](const pcl::PCLPointField& field) {
    return field.name == "x" && field.datatype == pcl::PCLPointField::FLOAT64;
  });
}

/** \brief Where in the bytes of \a blob its point \a index begins. */
inline std::size_t placeOf(const pcl::PCLPointCloud2& blob, pcl::index_t index) {
  const std::size_t row = index / blob.width, column = index % blob.width;
  return row * blob.row_step + column * blob.point_step;
}

/** \brief The number whose bytes begin at \a place, which may be any. */
template <typename Real>
Real realAt(const std::uint8_t* place) {
  Real value;
  std::memcpy(&value, place, sizeof value);
  return value;
}

/** \brief The number of a field FLOAT32 or FLOAT64 of the point whose bytes begin at \a point. */
inline double numberOf(const pcl::PCLPointField& field, const std::uint8_t* point) {
  return field.datatype == pcl::PCLPointField::FLOAT64 ? realAt<double>(point + field.offset)
                                                       : realAt<float>(point + field.offset);
}

/** \brief Where the sensor of each point was, as in pcl::PointWithViewpoint; null without such fields. */
inline std::shared_ptr<const std::vector<filmsticking::Point>> viewpointsOf(const pcl::PCLPointCloud2& blob,
                                                                            const pcl::Indices& indices) {
  std::array<const pcl::PCLPointField*, 3> fields{};
  for (const pcl::PCLPointField& field : blob.fields) {
    if (field.count > 1 ||
        (field.datatype != pcl::PCLPointField::FLOAT32 && field.datatype != pcl::PCLPointField::FLOAT64))
      continue;
    const char* const names[] = {"vp_x", "vp_y", "vp_z"};
    for (std::size_t k = 0; k < 3; ++k)
      if (field.name == names[k]) fields[k] = &field;
  }
  if (fields[0] == nullptr || fields[1] == nullptr || fields[2] == nullptr) return {};
  std::vector<filmsticking::Point> viewpoints;
  viewpoints.reserve(indices.size());
  for (const pcl::index_t index : indices) {
    const std::uint8_t* point = &blob.data[placeOf(blob, index)];
    viewpoints.push_back(
        {numberOf(*fields[0], point), numberOf(*fields[1], point), numberOf(*fields[2], point)});
  }
  return std::make_shared<const std::vector<filmsticking::Point>>(std::move(viewpoints));
}

/** \brief Whether a point type says where its sensor was, as pcl::PointWithViewpoint does. */
template <typename PointT, typename = void>
struct HasViewpoint : std::false_type {};
template <typename PointT>
struct HasViewpoint<PointT,
                    std::void_t<decltype(PointT::vp_x), decltype(PointT::vp_y), decltype(PointT::vp_z)>>
    : std::true_type {};

/** \brief Where the sensor of each point was; null if the point type does not say it. */
template <typename PointT>
std::shared_ptr<const std::vector<filmsticking::Point>> viewpointsOf(const pcl::PointCloud<PointT>& cloud,
                                                                     const pcl::Indices& indices) {
  if constexpr (HasViewpoint<PointT>::value) {
    std::vector<filmsticking::Point> viewpoints;
    viewpoints.reserve(indices.size());
    for (const pcl::index_t index : indices)
      viewpoints.push_back({cloud[index].vp_x, cloud[index].vp_y, cloud[index].vp_z});
    return std::make_shared<const std::vector<filmsticking::Point>>(std::move(viewpoints));
  } else {
    (void)cloud, (void)indices;
    return {};
  }
}

/** \brief Round x, y and z of type FLOAT64 to FLOAT32, in which PCL's point types have them.
 * \param[in,out] blob one row without padding, and no blobFault()
 */
inline void toSinglePrecision(pcl::PCLPointCloud2& blob) {
  for (pcl::PCLPointField& field : blob.fields) {
    if (field.datatype != pcl::PCLPointField::FLOAT64) continue;
    if (field.name != "x" && field.name != "y" && field.name != "z") continue;
    field.datatype = pcl::PCLPointField::FLOAT32;
    for (std::size_t at = field.offset; at < blob.data.size(); at += blob.point_step) {
      const auto rounded = static_cast<float>(realAt<double>(&blob.data[at]));
      std::memcpy(&blob.data[at], &rounded, sizeof rounded);
    }
  }
}

/** \brief Copy points with all their bytes.
 * \param[in] blob the points, without a blobFault()
 * \param[in] indices which points to copy, all in \a blob
 * \param[out] output the points in the order of \a indices, unorganized and dense
 */
inline void copyPoints(const pcl::PCLPointCloud2& blob, const pcl::Indices& indices,
                       pcl::PCLPointCloud2& output) {
  output.header = blob.header;
  output.fields = blob.fields;
  output.is_bigendian = blob.is_bigendian;
  output.is_dense = true;
  output.height = 1;
  output.width = static_cast<pcl::uindex_t>(indices.size());
  output.point_step = blob.point_step;
  output.row_step = output.width * output.point_step;
  output.data.resize(static_cast<std::size_t>(output.width) * output.point_step);
  std::uint8_t* to = output.data.data();
  for (const pcl::index_t index : indices)
    to = std::copy_n(&blob.data[placeOf(blob, index)], blob.point_step, to);
}

/** \brief Copy points as pcl::toPCLPointCloud2() does, without a cloud of them between. */
template <typename PointT>
void copyPoints(const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices,
                pcl::PCLPointCloud2& output) {
  pcl::toPCLPointCloud2(pcl::PointCloud<PointT>(), output);  // the fields
  output.header = cloud.header;
  output.is_dense = true;
  output.height = 1;
  output.width = static_cast<pcl::uindex_t>(indices.size());
  output.row_step = output.width * output.point_step;
  output.data.resize(indices.size() * sizeof(PointT));
  std::uint8_t* to = output.data.data();
  for (const pcl::index_t index : indices)
    to = std::copy_n(reinterpret_cast<const std::uint8_t*>(&cloud[index]), sizeof(PointT), to);
}

}  // namespace detail
}  // namespace pcl

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <new>
#include <numeric>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/surface/impl/filmsticking_pp_blob.hpp>
#include <type_traits>
#include <utility>
#include <vector>

#include "filmsticking/normals.h"
#include "filmsticking/reconstruct.h"

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::setInputCloud(const PointCloudConstPtr& cloud) {
  blob_.reset();
  SurfaceReconstruction<PointInT>::setInputCloud(cloud);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::setInputBlob(const pcl::PCLPointCloud2::ConstPtr& blob) {
  setInputCloud(nullptr);
  blob_ = blob;
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::useAllPoints() {
  indices_.reset();
  fake_indices_ = use_indices_ = false;
  indices_fault_.clear();
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::setIndices(const pcl::IndicesPtr& indices) {
  useAllPoints();
  if (indices) SurfaceReconstruction<PointInT>::setIndices(indices);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::setIndices(const pcl::IndicesConstPtr& indices) {
  useAllPoints();
  if (indices) SurfaceReconstruction<PointInT>::setIndices(indices);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::setIndices(const PointIndicesConstPtr& indices) {
  useAllPoints();
  if (indices) SurfaceReconstruction<PointInT>::setIndices(indices);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::setIndices(std::size_t row_start, std::size_t col_start,
                                               std::size_t nb_rows, std::size_t nb_cols) {
  useAllPoints();
  const std::size_t height = blob_ ? blob_->height : input_ ? input_->height : 0;
  const std::size_t width = blob_ ? blob_->width : input_ ? input_->width : 0;
  // Differences, because sums could overflow.
  if (nb_rows > height || row_start > height - nb_rows || nb_cols > width || col_start > width - nb_cols) {
    indices_fault_ = "the window of indices is not in the cloud of " + std::to_string(height) + " rows and " +
                     std::to_string(width) + " columns";
    return;
  }
  const pcl::IndicesPtr window(new pcl::Indices);
  window->reserve(nb_rows * nb_cols);
  for (std::size_t row = row_start; row < row_start + nb_rows; ++row)
    for (std::size_t column = col_start; column < col_start + nb_cols; ++column)
      window->push_back(static_cast<pcl::index_t>(row * width + column));
  SurfaceReconstruction<PointInT>::setIndices(window);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::reconstruct(pcl::PolygonMesh& output) {
  // Not in place: the caller's mesh may hold anything.
  pcl::PolygonMesh result;
  guarded([&] { performReconstruction(result); });
  if (status_ != Status::Ok) {
    result = pcl::PolygonMesh();
    result.header = result.cloud.header = inputHeader();
  }
  output = std::move(result);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::reconstruct(pcl::PointCloud<PointInT>& points,
                                                std::vector<pcl::Vertices>& polygons) {
  // Not in place: `points` may be the input cloud itself.
  pcl::PointCloud<PointInT> result_points;
  std::vector<pcl::Vertices> result_polygons;
  guarded([&] { performReconstruction(result_points, result_polygons); });
  if (status_ != Status::Ok) {
    result_points = pcl::PointCloud<PointInT>();
    result_polygons.clear();
    result_points.header = inputHeader();
  }
  points = std::move(result_points);
  polygons = std::move(result_polygons);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::reconstruct(pcl::PCLPointCloud2& vertices,
                                                std::vector<filmsticking::Triangle>& triangles) {
  // Built aside, then handed over: the caller's vertices may be the input blob itself.
  pcl::PCLPointCloud2 result_vertices;
  std::vector<filmsticking::Triangle> result_triangles;
  guarded([&] {
    if (computeTriangles(result_triangles)) copyVertices(result_vertices);
  });
  if (status_ != Status::Ok) {
    result_vertices = pcl::PCLPointCloud2();
    result_vertices.header = inputHeader();
    result_triangles.clear();
  }
  vertices = std::move(result_vertices);
  triangles = std::move(result_triangles);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::performReconstruction(pcl::PolygonMesh& output) {
  if (!computePolygons(output.polygons)) return;
  copyVertices(output.cloud);
  output.header = output.cloud.header;
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::copyVertices(pcl::PCLPointCloud2& vertices) const {
  if (blob_)
    detail::copyPoints(*blob_, vertex_indices_, vertices);
  else
    detail::copyPoints(*input_, vertex_indices_, vertices);
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::performReconstruction(pcl::PointCloud<PointInT>& points,
                                                          std::vector<pcl::Vertices>& polygons) {
  if (!computePolygons(polygons)) return;
  points.clear();
  if (blob_) {
    pcl::PCLPointCloud2 vertices;
    copyVertices(vertices);
    detail::toSinglePrecision(vertices);
    pcl::fromPCLPointCloud2(vertices, points);
  } else {
    points.header = input_->header;
    points.sensor_origin_ = input_->sensor_origin_;
    points.sensor_orientation_ = input_->sensor_orientation_;
    points.reserve(vertex_indices_.size());
    for (const pcl::index_t index : vertex_indices_) points.push_back((*input_)[index]);
  }
  points.is_dense = true;
}

template <typename PointInT>
bool pcl::FilmstickingPP<PointInT>::computePolygons(std::vector<pcl::Vertices>& polygons) {
  std::vector<filmsticking::Triangle> triangles;
  if (!computeTriangles(triangles)) return false;
  polygons.resize(triangles.size());
  for (std::size_t t = 0; t < polygons.size(); ++t)
    polygons[t].vertices.assign(triangles[t].begin(), triangles[t].end());
  return true;
}

template <typename PointInT>
bool pcl::FilmstickingPP<PointInT>::computeTriangles(std::vector<filmsticking::Triangle>& triangles) {
  filmsticking::Execution execution;
  execution.progress = progress_callback_;
  execution.on_step = step_callback_;
  execution.cancel = cancel_flag_ ? cancel_flag_ : &cancel_.raised;
  Options options = options_;
  if (!options.viewpoint) options.trust_viewpoint = false;
  options.viewpoint = viewPoint();
  if (!options.viewpoints)
    options.viewpoints =
        blob_ ? detail::viewpointsOf(*blob_, *indices_) : detail::viewpointsOf(*input_, *indices_);
  filmsticking::Result result = withAllPoints([&](const filmsticking::PointsView& points) {
    if constexpr (std::is_same_v<pcl::index_t, std::int32_t>) {
      return filmsticking::reconstruct(points.at(*indices_), options, execution);
    } else {
      const std::vector<std::int32_t> ids(indices_->begin(), indices_->end());
      return filmsticking::reconstruct(points.at(ids), options, execution);
    }
  });
  report_ = std::move(result.report);
  if (result.status != Status::Ok) {
    fail(result.status, result.message.empty() ? filmsticking::describe(result.status) : result.message);
    return false;
  }
  vertex_indices_.reserve(result.vertices.size());
  for (const std::int32_t position : result.vertices) vertex_indices_.push_back((*indices_)[position]);
  face_gaps_ = std::move(result.gaps);
  face_stability_ = std::move(result.stability);
  triangles = std::move(result.triangles);
  if (compute_normals_ && !computeNormals(triangles, execution)) return false;
  status_ = Status::Ok;
  return true;
}

template <typename PointInT>
template <typename Use>
auto pcl::FilmstickingPP<PointInT>::withAllPoints(const Use& use) const {
  if (blob_)
    return detail::hasDoubles(*blob_) ? withAllPointsOfBlob<double>(use) : withAllPointsOfBlob<float>(use);
  if constexpr (std::is_same_v<decltype(PointInT::x), float> &&
                std::is_same_v<decltype(PointInT::y), float> &&
                std::is_same_v<decltype(PointInT::z), float>) {
    const PointInT* first = input_->points.data();
    // True for PCL's own point types.
    if (!input_->empty() && &first->y == &first->x + 1 && &first->z == &first->x + 2)
      return use(filmsticking::PointsView(&first->x, sizeof(PointInT), input_->size()));
  }
  std::vector<filmsticking::Point> positions;
  positions.reserve(input_->size());
  for (const PointInT& point : *input_) positions.push_back({point.x, point.y, point.z});
  return use(filmsticking::PointsView(positions));
}

template <typename PointInT>
template <typename Real, typename Use>
auto pcl::FilmstickingPP<PointInT>::withAllPointsOfBlob(const Use& use) const {
  const pcl::PCLPointCloud2& blob = *blob_;
  const std::size_t size = static_cast<std::size_t>(blob.width) * blob.height;
  const std::size_t x = detail::offsetOf(blob, "x"), y = detail::offsetOf(blob, "y"),
                    z = detail::offsetOf(blob, "z");
  if (size > 0 && y == x + sizeof(Real) && z == y + sizeof(Real) &&
      (blob.height == 1 || blob.row_step == blob.width * blob.point_step))  // rows without padding
    return use(filmsticking::PointsView(reinterpret_cast<const Real*>(&blob.data[x]), blob.point_step, size));
  std::vector<filmsticking::Point> positions;
  positions.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint8_t* point = &blob.data[detail::placeOf(blob, static_cast<pcl::index_t>(i))];
    positions.push_back(
        {detail::realAt<Real>(point + x), detail::realAt<Real>(point + y), detail::realAt<Real>(point + z)});
  }
  return use(filmsticking::PointsView(positions));
}

template <typename PointInT>
bool pcl::FilmstickingPP<PointInT>::computeNormals(const std::vector<filmsticking::Triangle>& triangles,
                                                   const filmsticking::Execution& execution) {
  std::vector<filmsticking::Normal> normals;
  const Status status = withAllPoints([&](const filmsticking::PointsView& points) {
    const std::vector<std::int32_t> vertices(vertex_indices_.begin(), vertex_indices_.end());
    return filmsticking::point_normals(points, vertices, triangles, normals, options_.threads,
                                       execution.cancel);
  });
  if (status != Status::Ok) {
    fail(status, filmsticking::describe(status));
    return false;
  }
  normals_.reserve(normals.size());
  for (const filmsticking::Normal& n : normals) normals_.push_back(pcl::Normal(n[0], n[1], n[2]));
  normals_.header = inputHeader();
  normals_.width = blob_ ? blob_->width : input_->width;
  normals_.height = blob_ ? blob_->height : input_->height;
  normals_.is_dense = std::all_of(normals_.begin(), normals_.end(),
                                  [](const pcl::Normal& n) { return std::isfinite(n.normal_x); });
  return true;
}

template <typename PointInT>
std::optional<filmsticking::Point> pcl::FilmstickingPP<PointInT>::viewPoint() const {
  if (options_.viewpoint || !try_sensor_origin_) return options_.viewpoint;
  if (!input_) return filmsticking::Point{0, 0, 0};
  return filmsticking::Point{input_->sensor_origin_[0], input_->sensor_origin_[1], input_->sensor_origin_[2]};
}

template <typename PointInT>
pcl::PCLHeader pcl::FilmstickingPP<PointInT>::inputHeader() const {
  return blob_ ? blob_->header : input_ ? input_->header : pcl::PCLHeader();
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::setGuidingSurface(const pcl::PolygonMesh& surface) {
  pcl::PointCloud<pcl::PointXYZ> points;
  pcl::fromPCLPointCloud2(surface.cloud, points);
  auto mesh = std::make_shared<filmsticking::Mesh>();
  for (const pcl::PointXYZ& point : points) mesh->positions.push_back({point.x, point.y, point.z});
  for (const pcl::Vertices& polygon : surface.polygons)
    for (std::size_t k = 2; k < polygon.vertices.size(); ++k)
      mesh->triangles.push_back({polygon.vertices[0], polygon.vertices[k - 1], polygon.vertices[k]});
  setGuidingSurface(std::shared_ptr<const filmsticking::Mesh>(std::move(mesh)));
}

template <typename PointInT>
template <typename Compute>
void pcl::FilmstickingPP<PointInT>::guarded(Compute compute) noexcept {
  cancel_.raised = false;
  status_ = Status::InternalError;
  status_message_.clear();
  report_ = Report();
  vertex_indices_.clear();
  face_gaps_.clear();
  face_stability_.clear();
  normals_.clear();
  try {
    if (checkInput()) compute();
  } catch (const std::bad_alloc&) {
    fail(Status::OutOfMemory, filmsticking::describe(Status::OutOfMemory));
  } catch (const std::exception& error) {
    fail(Status::InternalError, error.what());
  } catch (...) {
    fail(Status::InternalError, filmsticking::describe(Status::InternalError));
  }
  if (status_ == Status::Ok) return;
  vertex_indices_.clear();
  face_gaps_.clear();
  face_stability_.clear();
  normals_.clear();
}

template <typename PointInT>
bool pcl::FilmstickingPP<PointInT>::checkInput() {
  const auto refuse = [this](const std::string& message) {
    fail(Status::InvalidInput, message);
    return false;
  };
  if (blob_) {  // the caller's: checked here, trusted elsewhere
    const std::string fault = detail::blobFault(*blob_);
    if (!fault.empty()) return refuse(fault);
  } else if (!input_) {
    return refuse("no input cloud is set");
  }
  if (!indices_fault_.empty()) return refuse(indices_fault_);
  const std::size_t size = blob_ ? static_cast<std::size_t>(blob_->width) * blob_->height : input_->size();
  if (size > static_cast<std::size_t>(std::numeric_limits<pcl::index_t>::max()))
    return refuse("the cloud has more points than an index can count");
  if (!indices_ || fake_indices_) {  // not in place as PCLBase does: a copy of this object shares the indices
    indices_.reset(new pcl::Indices(size));
    std::iota(indices_->begin(), indices_->end(), 0);
    fake_indices_ = true;
  }
  for (const pcl::index_t index : *indices_)
    if (index < 0 || static_cast<std::size_t>(index) >= size)
      return refuse("index " + std::to_string(index) + " is not in the cloud of " + std::to_string(size) +
                    " points");
  return true;
}

template <typename PointInT>
void pcl::FilmstickingPP<PointInT>::fail(Status status, const std::string& message) {
  status_ = status;
  status_message_ = message;
  PCL_ERROR("[pcl::%s::reconstruct] %s.\n", getClassName().c_str(), message.c_str());
}

#define PCL_INSTANTIATE_FilmstickingPP(T) template class PCL_EXPORTS pcl::FilmstickingPP<T>;

// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of pcl::FilmstickingPP: its input and its output.
#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "clouds.h"
#include "surface.h"

namespace filmsticking::test {
namespace {

TEST(FilmstickingPP, MakesAClosedManifoldOfASphere) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(500));
  const auto surface = run(filmsticking);
  ASSERT_EQ(filmsticking.getStatus(), Status::Ok) << filmsticking.getStatusMessage();
  EXPECT_TRUE(filmsticking.getStatusMessage().empty());
  expect_good_surface(to_mesh(surface));
  EXPECT_EQ(surface.points.size(), 500u);
  EXPECT_EQ(surface.polygons.size(), 996u);
  EXPECT_TRUE(filmsticking.getReport().closed);
  EXPECT_TRUE(filmsticking.getReport().manifold);
  EXPECT_EQ(filmsticking.getReport().points, 500);
}

TEST(FilmstickingPP, MakesAClosedManifoldOfBun0) {
  pcl::FilmstickingPP<PointNormal> filmsticking;
  filmsticking.setInputCloud(load_bunny());
  const auto surface = run(filmsticking);
  ASSERT_EQ(filmsticking.getStatus(), Status::Ok) << filmsticking.getStatusMessage();
  expect_good_surface(to_mesh(surface));
  EXPECT_GT(surface.points.size(), 350u);
}

TEST(FilmstickingPP, VerticesAreInputPointsWithAllFields) {
  const auto cloud = load_bunny();
  pcl::FilmstickingPP<PointNormal> filmsticking;
  filmsticking.setInputCloud(cloud);
  const auto surface = run(filmsticking);
  const pcl::Indices& indices = filmsticking.getVertexIndices();
  ASSERT_EQ(indices.size(), surface.points.size());
  ASSERT_FALSE(indices.empty());
  for (std::size_t k = 0; k < indices.size(); ++k)
    ASSERT_EQ(std::memcmp(&surface.points[k], &(*cloud)[indices[k]], sizeof(PointNormal)), 0) << k;
  EXPECT_EQ(std::set<int>(indices.begin(), indices.end()).size(), indices.size());
}

TEST(FilmstickingPP, PointsAreUnorganizedAndDense) {
  auto cloud = make_sphere<PointXYZ>(500);
  cloud->width = 50;
  cloud->height = 10;
  cloud->is_dense = false;
  cloud->sensor_origin_ = Eigen::Vector4f(1, 2, 3, 0);
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  const auto surface = run(filmsticking);
  EXPECT_EQ(surface.points.width, surface.points.size());
  EXPECT_EQ(surface.points.height, 1u);
  EXPECT_TRUE(surface.points.is_dense);
  EXPECT_EQ(surface.points.sensor_origin_, cloud->sensor_origin_);
}

TEST(FilmstickingPP, HeaderIsTheInputs) {
  const auto cloud = make_sphere<PointXYZ>(200);
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  const auto surface = run(filmsticking);
  for (const pcl::PCLHeader& header : {mesh.header, mesh.cloud.header, surface.points.header}) {
    EXPECT_EQ(header.frame_id, cloud->header.frame_id);
    EXPECT_EQ(header.stamp, cloud->header.stamp);
    EXPECT_EQ(header.seq, cloud->header.seq);
  }
}

TEST(FilmstickingPP, BothOverloadsMakeTheSameSurface) {
  pcl::FilmstickingPP<PointNormal> filmsticking;
  filmsticking.setInputCloud(load_bunny());
  const auto surface = run(filmsticking);
  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  EXPECT_EQ(corners(mesh.polygons), corners(surface.polygons));
  EXPECT_EQ(mesh.cloud.width, surface.points.size());
  EXPECT_EQ(mesh.cloud.height, 1u);
  EXPECT_TRUE(mesh.cloud.is_dense);
  EXPECT_EQ(mesh.cloud.fields.size(), 7u);
  pcl::PCLPointCloud2 expected;
  pcl::toPCLPointCloud2(surface.points, expected);
  EXPECT_EQ(mesh.cloud.data, expected.data);
  EXPECT_EQ(mesh.cloud.point_step, expected.point_step);
  EXPECT_EQ(mesh.cloud.row_step, expected.row_step);
  pcl::PointCloud<PointNormal> points;
  pcl::fromPCLPointCloud2(mesh.cloud, points);
  ASSERT_EQ(points.size(), surface.points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    ASSERT_TRUE(same_coordinates(points[k], surface.points[k]));
    ASSERT_EQ(points[k].curvature, surface.points[k].curvature);
  }
}

TEST(FilmstickingPP, BaseClassPointerWorks) {
  pcl::FilmstickingPP<PointXYZ>::Ptr object(new Class);
  pcl::SurfaceReconstruction<PointXYZ>::Ptr base = object;
  base->setInputCloud(make_sphere<PointXYZ>(200));
  pcl::PolygonMesh mesh;
  base->reconstruct(mesh);
  EXPECT_EQ(mesh.polygons.size(), 396u);
  EXPECT_EQ(base->getSearchMethod(), nullptr);  // none is built
}

TEST(FilmstickingPP, IndicesChooseThePoints) {
  const auto cloud = make_sphere<PointXYZ>(600);
  pcl::IndicesPtr even(new pcl::Indices);
  for (int i = 598; i >= 0; i -= 2) even->push_back(i);
  even->push_back(10);  // repeated
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  filmsticking.setIndices(even);
  const auto surface = run(filmsticking);
  ASSERT_EQ(filmsticking.getStatus(), Status::Ok) << filmsticking.getStatusMessage();
  expect_good_surface(to_mesh(surface));
  const pcl::Indices& indices = filmsticking.getVertexIndices();
  EXPECT_EQ(indices.size(), 300u);
  ASSERT_EQ(indices.size(), surface.points.size());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    EXPECT_EQ(indices[k] % 2, 0);
    EXPECT_TRUE(same_coordinates(surface.points[k], (*cloud)[indices[k]]));
  }
}

TEST(FilmstickingPP, EveryFormOfIndicesIsHonoured) {
  const auto cloud = make_sphere<PointXYZ>(600);
  cloud->width = 20;
  cloud->height = 30;
  pcl::Indices window;  // rows 5 to 19, columns 3 to 16
  for (int row = 5; row < 20; ++row)
    for (int column = 3; column < 17; ++column) window.push_back(20 * row + column);
  const pcl::IndicesPtr pointer(new pcl::Indices(window));
  const pcl::PointIndices::Ptr point_indices(new pcl::PointIndices);
  point_indices->indices = window;

  const auto run_with = [&](auto set) {
    Class filmsticking;
    filmsticking.setInputCloud(cloud);
    set(filmsticking);
    const auto surface = run(filmsticking);
    EXPECT_EQ(surface_fault(to_mesh(surface)), "");
    for (const int index : filmsticking.getVertexIndices())
      EXPECT_TRUE(std::binary_search(window.begin(), window.end(), index)) << index;
    return std::pair(filmsticking.getVertexIndices(), corners(surface.polygons));
  };
  const auto expected = run_with([&](Class& f) { f.setIndices(pointer); });
  EXPECT_EQ(expected.first.size(), window.size());
  EXPECT_EQ(run_with([&](Class& f) { f.setIndices(pcl::IndicesConstPtr(pointer)); }), expected);
  EXPECT_EQ(run_with([&](Class& f) { f.setIndices(pcl::PointIndices::ConstPtr(point_indices)); }), expected);
  EXPECT_EQ(run_with([&](Class& f) { f.setIndices(5, 3, 15, 14); }), expected);
  // The last set counts.
  EXPECT_EQ(run_with([&](Class& f) {
              f.setIndices(pcl::IndicesPtr(new pcl::Indices{1, 2, 3, 4, 5}));
              f.setIndices(pointer);
            }),
            expected);
}

TEST(FilmstickingPP, NullIndicesStandForAllPoints) {
  const auto forget = [](auto null) {
    Class filmsticking;
    filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
    filmsticking.setIndices(pcl::IndicesPtr(new pcl::Indices{1, 2, 3, 4, 5}));
    filmsticking.setIndices(null);
    return run(filmsticking).points.size();
  };
  EXPECT_EQ(forget(pcl::IndicesPtr()), 300u);
  EXPECT_EQ(forget(pcl::IndicesConstPtr()), 300u);
  EXPECT_EQ(forget(pcl::PointIndices::ConstPtr()), 300u);
}

TEST(FilmstickingPP, AWindowOutsideTheCloudFails) {
  const auto cloud = make_sphere<PointXYZ>(600);
  cloud->width = 20;
  cloud->height = 30;
  constexpr std::size_t kHuge = std::numeric_limits<std::size_t>::max();
  using Window = std::array<std::size_t, 4>;
  for (const Window& w : {Window{0, 0, 31, 20}, Window{0, 0, 30, 21}, Window{16, 0, 15, 20},
                          Window{0, kHuge, 30, 2}, Window{kHuge, 0, 2, 20}}) {
    Class filmsticking;
    filmsticking.setInputCloud(cloud);
    filmsticking.setIndices(w[0], w[1], w[2], w[3]);
    expect_failure(filmsticking, Status::InvalidInput);
    filmsticking.setIndices(0, 0, 30, 20);
    EXPECT_EQ(run(filmsticking).points.size(), 600u);
  }
  Class without_cloud;
  without_cloud.setIndices(0, 0, 1, 1);
  expect_failure(without_cloud, Status::InvalidInput);
}

TEST(FilmstickingPP, ACloudThatChangesIsReadAgain) {
  const auto cloud = make_sphere<PointXYZ>(300);
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  EXPECT_EQ(run(filmsticking).points.size(), 300u);
  *cloud = *make_sphere<PointXYZ>(200);
  EXPECT_EQ(run(filmsticking).points.size(), 200u);
}

TEST(FilmstickingPP, ANewCloudIsNotReadWithTheOldOnesIndices) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(600));
  EXPECT_EQ(run(filmsticking).points.size(), 600u);
  filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
  EXPECT_EQ(run(filmsticking).points.size(), 300u);
  filmsticking.setInputCloud(make_sphere<PointXYZ>(700));
  EXPECT_EQ(run(filmsticking).points.size(), 700u);
}

TEST(FilmstickingPP, FullOutputsAreReplaced) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(200));
  const auto expected = run(filmsticking);
  Surface<PointXYZ> surface;
  surface.points = *make_sphere<PointXYZ>(77);
  surface.polygons.resize(5000);
  filmsticking.reconstruct(surface.points, surface.polygons);
  EXPECT_EQ(surface.points.size(), 200u);
  EXPECT_EQ(corners(surface.polygons), corners(expected.polygons));
}

TEST(FilmstickingPP, TheInputCloudMayBeTheOutput) {
  const auto cloud = make_sphere<PointXYZ>(200);
  cloud->push_back(cloud->front());
  cloud->push_back(PointXYZ(kNan, 0, 0));
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  std::vector<pcl::Vertices> polygons;
  filmsticking.reconstruct(*cloud, polygons);
  EXPECT_EQ(filmsticking.getStatus(), Status::Ok) << filmsticking.getStatusMessage();
  EXPECT_EQ(cloud->size(), 200u);
  EXPECT_EQ(cloud->header.frame_id, "scanner");
  EXPECT_EQ(polygons.size(), 396u);
}

TEST(FilmstickingPP, NotFiniteAndRepeatedPointsAreLeftOut) {
  auto cloud = make_sphere<PointXYZ>(300);
  cloud->is_dense = false;
  cloud->push_back((*cloud)[5]);
  cloud->push_back(PointXYZ(kNan, 1, 1));
  cloud->push_back(PointXYZ(1, std::numeric_limits<float>::infinity(), 1));
  std::shuffle(cloud->begin(), cloud->end(), std::mt19937(1));
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  const auto surface = run(filmsticking);
  ASSERT_EQ(filmsticking.getStatus(), Status::Ok) << filmsticking.getStatusMessage();
  expect_good_surface(to_mesh(surface));
  EXPECT_EQ(surface.points.size(), 300u);
  EXPECT_EQ(filmsticking.getReport().non_finite, 2);
  EXPECT_EQ(filmsticking.getReport().duplicates, 1);
  for (std::size_t k = 0; k < surface.points.size(); ++k)
    EXPECT_TRUE(same_coordinates(surface.points[k], (*cloud)[filmsticking.getVertexIndices()[k]]));
}

TEST(FilmstickingPP, ResultDependsOnTheInputAlone) {
  pcl::FilmstickingPP<PointNormal> first, second;
  first.setInputCloud(load_bunny());
  second.setInputCloud(load_bunny());
  second.setNumberOfThreads(1);
  const auto expected = run(first);
  for (auto* object : {&first, &second}) {
    const auto surface = run(*object);
    EXPECT_EQ(corners(surface.polygons), corners(expected.polygons));
    EXPECT_EQ(object->getVertexIndices(), first.getVertexIndices());
  }
}

TEST(FilmstickingPP, AUsedObjectDoesAsANewOne) {
  const auto bunny = load_bunny();
  pcl::FilmstickingPP<PointNormal> fresh, used;
  fresh.setInputCloud(bunny);
  const auto expected = run(fresh);
  used.setInputCloud(make_sphere<PointNormal>(700));
  used.setIndices(pcl::IndicesPtr(new pcl::Indices{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  run(used);
  used.setIndices(pcl::IndicesPtr());
  run(used);
  used.setInputCloud(bunny);
  for (int turn = 0; turn < 2; ++turn) {
    const auto surface = run(used);
    EXPECT_EQ(corners(surface.polygons), corners(expected.polygons));
    EXPECT_EQ(used.getVertexIndices(), fresh.getVertexIndices());
  }
}

TEST(FilmstickingPP, ObjectsRunInParallelThreads) {
  const auto sphere = make_sphere<PointNormal>(700);
  const auto bunny = load_bunny();
  constexpr int kThreads = 4;
  // Copies of one object that ran before: nothing of it may be shared.
  pcl::FilmstickingPP<PointNormal> original;
  original.setInputCloud(sphere);
  const auto sphere_alone = run(original);
  std::vector<pcl::FilmstickingPP<PointNormal>> objects(kThreads, original);
  for (int k = 0; k < kThreads; k += 2) objects[k].setInputCloud(bunny);
  std::vector<Surface<PointNormal>> surfaces(kThreads);
  std::vector<std::thread> threads;
  for (int k = 0; k < kThreads; ++k)
    threads.emplace_back([&, k] { objects[k].reconstruct(surfaces[k].points, surfaces[k].polygons); });
  for (std::thread& thread : threads) thread.join();
  original.setInputCloud(bunny);
  const auto bunny_alone = run(original);
  for (int k = 0; k < kThreads; ++k) {
    EXPECT_EQ(objects[k].getStatus(), Status::Ok) << objects[k].getStatusMessage();
    EXPECT_EQ(corners(surfaces[k].polygons), corners((k % 2 ? sphere_alone : bunny_alone).polygons)) << k;
  }
}

TEST(FilmstickingPP, ASearchMethodIsKeptAndChangesNothing) {
  const auto bunny = load_bunny();
  pcl::FilmstickingPP<PointNormal> without, with;
  without.setInputCloud(bunny);
  with.setInputCloud(bunny);
  const pcl::search::KdTree<PointNormal>::Ptr tree(new pcl::search::KdTree<PointNormal>);
  const auto searched = make_sphere<PointNormal>(50);
  tree->setInputCloud(searched);
  with.setSearchMethod(tree);
  EXPECT_EQ(corners(run(with).polygons), corners(run(without).polygons));
  EXPECT_EQ(with.getSearchMethod(), tree);
  EXPECT_EQ(tree->getInputCloud(), searched);  // the caller's tree is left as it is
}

TEST(FilmstickingPP, NormalsAreKeptAndNotRead) {
  const auto bunny = load_bunny();
  const pcl::PointCloud<PointNormal>::Ptr wrong(new pcl::PointCloud<PointNormal>(*bunny));
  for (std::size_t i = 0; i < wrong->size(); ++i) {
    (*wrong)[i].getNormalVector3fMap() *= i % 2 ? -1 : 0;
    if (i % 5 == 0) (*wrong)[i].normal_x = kNan;
  }
  pcl::FilmstickingPP<PointNormal> first, second;
  first.setInputCloud(bunny);
  second.setInputCloud(wrong);
  EXPECT_EQ(corners(run(first).polygons), corners(run(second).polygons));
}

}  // namespace
}  // namespace filmsticking::test

// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of pcl::FilmstickingPP: options, and what they do.
#include <gtest/gtest.h>
#include <pcl/conversions.h>

#include <cmath>
#include <random>

#include "clouds.h"
#include "surface.h"

namespace filmsticking::test {
namespace {

TEST(FilmstickingPP, ACopyIsAnObjectOfItsOwn) {
  Class first;
  first.setInputCloud(make_sphere<PointXYZ>(300));
  first.setMaxRounds(2);
  Class second = first;
  second.setProgressCallback([&](double, const char*) { first.cancel(); });
  EXPECT_EQ(second.getMaxRounds(), 2);
  EXPECT_EQ(run(second).points.size(), 300u);
}

TEST(FilmstickingPP, NormalsAreOfAllInputPointsIfAskedFor) {
  const auto cloud = make_sphere<PointXYZ>(600);
  cloud->push_back(PointXYZ(std::nanf(""), 0, 0));
  cloud->width = 1, cloud->height = 601, cloud->is_dense = false;
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  pcl::IndicesPtr half(new pcl::Indices);
  for (int i = 0; i < 601; i += 2) half->push_back(i);
  filmsticking.setIndices(half);
  run(filmsticking);
  EXPECT_TRUE(filmsticking.getNormals().empty());
  filmsticking.setComputeNormals(true);
  run(filmsticking);
  const pcl::PointCloud<pcl::Normal> normals = filmsticking.getNormals();
  ASSERT_EQ(normals.size(), 601u);
  EXPECT_EQ(normals.height, 601u);
  EXPECT_FALSE(normals.is_dense);
  for (std::size_t i = 0; i < 600; ++i)
    EXPECT_GT(normals[i].getNormalVector3fMap().dot((*cloud)[i].getVector3fMap().normalized()), 0.9F);
  EXPECT_TRUE(std::isnan(normals[600].normal_x));

  pcl::PCLPointCloud2::Ptr blob(new pcl::PCLPointCloud2);
  pcl::toPCLPointCloud2(*cloud, *blob);
  filmsticking.setInputBlob(blob);
  run(filmsticking);
  ASSERT_EQ(filmsticking.getNormals().size(), 601u);
  for (std::size_t i = 0; i < 600; ++i)
    EXPECT_EQ(filmsticking.getNormals()[i].getNormalVector3fMap(), normals[i].getNormalVector3fMap());

  filmsticking.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 1, 2}));
  run(filmsticking);
  EXPECT_TRUE(filmsticking.getNormals().empty());  // of no surface
}

TEST(FilmstickingPP, OptionsAreKept) {
  Class filmsticking;
  const Options defaults;
  EXPECT_EQ(filmsticking.getMethod(), defaults.method);
  EXPECT_EQ(filmsticking.getFilmStart(), defaults.film_start);
  EXPECT_EQ(filmsticking.getVirtualSites(), defaults.virtual_sites);
  filmsticking.setFilmStart(FilmStart::Wrap);
  filmsticking.setFieldMethod(FieldMethod::Poisson);
  filmsticking.setRingChoice(RingChoice::Nearest);
  filmsticking.setVirtualSites(123);
  filmsticking.setUseWeights(false);
  filmsticking.setInsertLeftover(false);
  filmsticking.setOutputBoundary(true);
  filmsticking.setMaxHole(0.25);
  filmsticking.setKeepOutliers(true);
  filmsticking.setSharpEdges(false);
  filmsticking.setComputeStability(true);
  filmsticking.setMaxSteps(7);
  filmsticking.setMaxRounds(3);
  filmsticking.setNumberOfThreads(1);
  const Options& options = filmsticking.getOptions();
  EXPECT_EQ(options.method, Method::Film);
  EXPECT_EQ(options.film_start, FilmStart::Wrap);
  EXPECT_EQ(options.field, FieldMethod::Poisson);
  EXPECT_EQ(options.ring, RingChoice::Nearest);
  EXPECT_EQ(options.virtual_sites, 123);
  EXPECT_FALSE(options.weights);
  EXPECT_FALSE(options.insert_leftover);
  EXPECT_TRUE(options.open_boundary);
  EXPECT_EQ(options.max_hole, 0.25);
  EXPECT_EQ(filmsticking.getMaxHole(), 0.25);
  EXPECT_TRUE(options.keep_outliers);
  EXPECT_FALSE(options.sharp_edges);
  EXPECT_TRUE(options.stability && filmsticking.getComputeStability());
  EXPECT_EQ(options.max_steps, 7);
  EXPECT_EQ(options.max_rounds, 3);
  EXPECT_EQ(options.threads, 1);
  Class other;
  other.setOptions(options);
  EXPECT_EQ(other.getFilmStart(), FilmStart::Wrap);
  EXPECT_EQ(other.getFieldMethod(), FieldMethod::Poisson);
  EXPECT_EQ(other.getRingChoice(), RingChoice::Nearest);
  EXPECT_EQ(other.getVirtualSites(), 123);
  EXPECT_FALSE(other.getUseWeights());
  EXPECT_FALSE(other.getInsertLeftover());
  EXPECT_TRUE(other.getOutputBoundary());
  EXPECT_TRUE(other.getKeepOutliers());
  EXPECT_FALSE(other.getSharpEdges());
  EXPECT_EQ(other.getMaxSteps(), 7);
  EXPECT_EQ(other.getMaxRounds(), 3);
  EXPECT_EQ(other.getNumberOfThreads(), 1);
}

TEST(FilmstickingPP, OpensWhereThereAreNoPoints) {
  const auto whole = make_sphere<PointXYZ>(2000);
  pcl::PointCloud<PointXYZ>::Ptr half(new pcl::PointCloud<PointXYZ>);
  for (const PointXYZ& p : *whole)
    if (p.z > 0) half->push_back(p);
  Class filmsticking;
  filmsticking.setInputCloud(half);
  pcl::PolygonMesh closed, open;
  filmsticking.reconstruct(closed);
  ASSERT_EQ(filmsticking.getFaceGaps().size(), closed.polygons.size());
  EXPECT_TRUE(filmsticking.getFaceStability().empty());
  EXPECT_TRUE(filmsticking.getReport().closed);
  filmsticking.setComputeStability(true);
  filmsticking.reconstruct(closed);
  ASSERT_EQ(filmsticking.getFaceStability().size(), closed.polygons.size());
  filmsticking.setOutputBoundary(true);
  filmsticking.reconstruct(open);
  ASSERT_EQ(filmsticking.getFaceGaps().size(), open.polygons.size());
  EXPECT_FALSE(filmsticking.getReport().closed);
  EXPECT_TRUE(filmsticking.getReport().manifold);
  EXPECT_EQ(filmsticking.getReport().boundary_loops, 1);
  EXPECT_LT(open.polygons.size(), closed.polygons.size());
}

/// The share of the triangles that show their fronts to a point.
double fronts(const pcl::PointCloud<PointXYZ>& points, const std::vector<pcl::Vertices>& polygons,
              const Eigen::Vector3f& eye) {
  int with = 0;
  for (const pcl::Vertices& polygon : polygons) {
    const Eigen::Vector3f a = points[polygon.vertices[0]].getVector3fMap(),
                          b = points[polygon.vertices[1]].getVector3fMap(),
                          c = points[polygon.vertices[2]].getVector3fMap();
    with += (b - a).cross(c - a).dot(eye - a) > 0 ? 1 : 0;
  }
  return with / static_cast<double>(polygons.size());
}

TEST(FilmstickingPP, ADepthImageFacesItsSensor) {
  // A wall whose pixels are beside their places: only the viewpoint shows its front.
  pcl::PointCloud<PointXYZ>::Ptr wall(new pcl::PointCloud<PointXYZ>(40, 30));
  std::mt19937 random(1);
  const auto beside = [&] { return static_cast<float>(random() % 1000) / 2000 - 0.25F; };
  for (int v = 0; v < 30; ++v)
    for (int u = 0; u < 40; ++u) {
      const float x = (static_cast<float>(u) + beside() - 19.5F) / 40;
      const float y = (static_cast<float>(v) + beside() - 14.5F) / 40;
      const float z = 3 + 0.3F * x * x;
      wall->at(u, v) = PointXYZ(x * z, y * z, z);
    }
  Class filmsticking;
  filmsticking.setInputCloud(wall);
  filmsticking.setOutputBoundary(true);
  Eigen::Vector3f eye;
  filmsticking.getViewPoint(eye.x(), eye.y(), eye.z());
  EXPECT_EQ(eye, Eigen::Vector3f::Zero());
  auto surface = run(filmsticking);
  EXPECT_EQ(surface.points.size(), 1200u);
  EXPECT_EQ(fronts(surface.points, surface.polygons, eye), 1);

  pcl::PointCloud<PointXYZ>::Ptr moved(new pcl::PointCloud<PointXYZ>(*wall));
  for (PointXYZ& p : *moved) p.z = 10 - p.z;
  moved->sensor_origin_ << 0, 0, 10, 0;
  filmsticking.setInputCloud(moved);
  filmsticking.getViewPoint(eye.x(), eye.y(), eye.z());
  EXPECT_EQ(eye, Eigen::Vector3f(0, 0, 10));
  surface = run(filmsticking);
  EXPECT_EQ(fronts(surface.points, surface.polygons, eye), 1);

  filmsticking.setInputCloud(wall);
  filmsticking.setViewPoint(0, 0, 40);  // behind the wall
  filmsticking.getViewPoint(eye.x(), eye.y(), eye.z());
  EXPECT_EQ(eye, Eigen::Vector3f(0, 0, 40));
  surface = run(filmsticking);
  EXPECT_EQ(fronts(surface.points, surface.polygons, eye), 1);
  filmsticking.useSensorOriginAsViewPoint();
  surface = run(filmsticking);
  EXPECT_EQ(fronts(surface.points, surface.polygons, eye), 0);
}

TEST(FilmstickingPP, StartsFromAGivenSurface) {
  // The surface of a coarse sphere, twice as large.
  Class maker;
  maker.setInputCloud(make_sphere<PointXYZ>(60));
  pcl::PolygonMesh guide;
  maker.reconstruct(guide);
  pcl::PointCloud<PointXYZ> points;
  pcl::fromPCLPointCloud2(guide.cloud, points);
  for (PointXYZ& p : points) p.getVector3fMap() *= 2;
  pcl::toPCLPointCloud2(points, guide.cloud);

  Class filmsticking;
  filmsticking.setGuidingSurface(guide);
  EXPECT_EQ(filmsticking.getFilmStart(), FilmStart::Given);
  ASSERT_NE(filmsticking.getGuidingSurface(), nullptr);
  EXPECT_EQ(filmsticking.getGuidingSurface()->positions.size(), 60u);
  EXPECT_EQ(filmsticking.getGuidingSurface()->triangles.size(), 116u);
  filmsticking.setInputCloud(make_sphere<PointXYZ>(500));
  const auto surface = run(filmsticking);
  ASSERT_EQ(filmsticking.getStatus(), Status::Ok) << filmsticking.getStatusMessage();
  EXPECT_EQ(surface.points.size(), 500u);
  expect_good_surface(to_mesh(surface));
}

TEST(FilmstickingPP, ABrokenGivenSurfaceFails) {
  pcl::PolygonMesh guide;
  pcl::toPCLPointCloud2(*make_sphere<PointXYZ>(4), guide.cloud);
  guide.polygons.resize(1);
  for (const pcl::Indices& polygon :
       {pcl::Indices{0, 1, 2}, pcl::Indices{0, 1, 99}, pcl::Indices{0, 1, -5}}) {
    guide.polygons[0].vertices = polygon;
    Class filmsticking;
    filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
    filmsticking.setGuidingSurface(guide);
    expect_failure(filmsticking, Status::InvalidGuidingSurface);
  }
}

}  // namespace
}  // namespace filmsticking::test

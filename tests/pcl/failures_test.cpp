// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of pcl::FilmstickingPP: what cannot be reconstructed.
#include <gtest/gtest.h>

#include <limits>

#include "clouds.h"
#include "surface.h"

namespace filmsticking::test {
namespace {

TEST(FilmstickingPP, NoInputCloudFails) {
  Class filmsticking;
  expect_failure(filmsticking, Status::InvalidInput);
}

TEST(FilmstickingPP, AnEmptyCloudFails) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(0));
  expect_failure(filmsticking, Status::TooFewPoints);
}

TEST(FilmstickingPP, ThreePointsFail) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(3));
  expect_failure(filmsticking, Status::TooFewPoints);
}

TEST(FilmstickingPP, OnePointManyTimesFails) {
  pcl::PointCloud<PointXYZ>::Ptr cloud(new pcl::PointCloud<PointXYZ>(100, 1, PointXYZ(1, 2, 3)));
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  expect_failure(filmsticking, Status::TooFewPoints);
}

TEST(FilmstickingPP, OnlyNotFinitePointsFail) {
  pcl::PointCloud<PointXYZ>::Ptr cloud(new pcl::PointCloud<PointXYZ>(100, 1, PointXYZ(kNan, kNan, kNan)));
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  expect_failure(filmsticking, Status::TooFewPoints);
}

TEST(FilmstickingPP, CoplanarPointsFail) {
  pcl::PointCloud<PointXYZ>::Ptr cloud(new pcl::PointCloud<PointXYZ>);
  for (int i = 0; i < 100; ++i)
    cloud->push_back(PointXYZ(static_cast<float>(i % 10), static_cast<float>(i / 10), 2));
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  expect_failure(filmsticking, Status::Coplanar);
}

TEST(FilmstickingPP, CoplanarPointsFailHoweverTheyAreTurned) {
  pcl::PointCloud<PointXYZ>::Ptr cloud(new pcl::PointCloud<PointXYZ>);
  const Eigen::Quaternionf turn = Eigen::Quaternionf(1, 2, 3, 4).normalized();
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3f p = turn * Eigen::Vector3f(0.1f * (i % 20), 0.3f * (i / 20), 0);
    cloud->push_back(PointXYZ(p.x(), p.y(), p.z()));
  }
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  expect_failure(filmsticking, Status::Coplanar);
}

TEST(FilmstickingPP, CollinearPointsFail) {
  pcl::PointCloud<PointXYZ>::Ptr cloud(new pcl::PointCloud<PointXYZ>);
  for (int i = 0; i < 100; ++i) cloud->push_back(PointXYZ(1, 2, 0.1f * i));
  Class filmsticking;
  filmsticking.setInputCloud(cloud);
  expect_failure(filmsticking, Status::Coplanar);
}

TEST(FilmstickingPP, IndicesOutsideTheCloudFail) {
  for (const int wrong : {300, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    pcl::IndicesPtr indices(new pcl::Indices{0, 1, 2, 3, 4, wrong});
    Class filmsticking;
    filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
    filmsticking.setIndices(indices);
    expect_failure(filmsticking, Status::InvalidInput);
  }
}

TEST(FilmstickingPP, NoIndicesAtAllFail) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
  filmsticking.setIndices(pcl::IndicesPtr(new pcl::Indices));
  expect_failure(filmsticking, Status::TooFewPoints);
}

TEST(FilmstickingPP, WrongOptionsFail) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
  filmsticking.setMaxSteps(0);
  expect_failure(filmsticking, Status::InvalidOptions);
}

TEST(FilmstickingPP, WorksAgainAfterAFailure) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(3));
  ::testing::internal::CaptureStderr();
  run(filmsticking);
  ::testing::internal::GetCapturedStderr();
  filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
  EXPECT_EQ(run(filmsticking).points.size(), 300u);
  EXPECT_EQ(filmsticking.getStatus(), Status::Ok);
  EXPECT_TRUE(filmsticking.getStatusMessage().empty());
}

}  // namespace
}  // namespace filmsticking::test

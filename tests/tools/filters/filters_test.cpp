// SPDX-License-Identifier: GPL-3.0-or-later
// The filters that the programs share, against definitions written out here.
#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "filters/filter_chain.h"
#include "io/formats.h"
#include "support/clouds.h"
#include "support/model.h"

namespace filmsticking::filters {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;
using test::Model;

pcl::PCLPointCloud2 to_blob(const Cloud& cloud) {
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2(cloud, blob);
  return blob;
}

Cloud from_blob(const pcl::PCLPointCloud2& blob) {
  Cloud cloud;
  pcl::fromPCLPointCloud2(blob, cloud);
  return cloud;
}

Model filtered(const Model& cloud, const FilterOptions& options) {
  return filter(io::make_cloud(cloud.positions, cloud.colours), options);
}

FilterOptions options(const std::string& name, const std::string& text) {
  FilterOptions result;
  set_filter(result, name, text);
  return result;
}

Model milk() { return io::read_cloud(TEST_DATA "/milk.pcd"); }

Cloud random_cloud(int n, std::uint64_t seed) {
  test::Random random(seed);
  Cloud cloud;
  for (int i = 0; i < n; ++i) {
    pcl::PointXYZRGB p(static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(i % 251), 7);
    p.x = static_cast<float>(random.uniform(-1, 1));
    p.y = static_cast<float>(random.uniform(-1, 1));
    p.z = static_cast<float>(random.uniform(-1, 1));
    cloud.push_back(p);
  }
  return cloud;
}

TEST(FilterOptions, AreReadFromText) {
  FilterOptions all;
  EXPECT_FALSE(all.any());
  set_filter(all, "crop", "-1,-2.5,0,1,2,1e3");
  set_filter(all, "sor", "16,2.5");
  set_filter(all, "voxel", "0.01");
  set_filter(all, "mls", "3");
  EXPECT_EQ(all.crop->least, (Point{-1, -2.5, 0}));
  EXPECT_EQ(all.crop->most, (Point{1, 2, 1000}));
  EXPECT_EQ(all.outliers->neighbours, 16);
  EXPECT_EQ(all.outliers->deviations, 2.5);
  EXPECT_EQ(all.voxel, 0.01);
  EXPECT_EQ(all.smoothing, 3);
}

TEST(FilterOptions, NonsenseIsRefusedAndChangesNothing) {
  const std::vector<std::pair<const char*, const char*>> nonsense = {{"voxel", ""},
                                                                     {"voxel", "0"},
                                                                     {"voxel", "-1"},
                                                                     {"voxel", "nan"},
                                                                     {"voxel", "inf"},
                                                                     {"voxel", "1,2"},
                                                                     {"voxel", "1m"},
                                                                     {"voxel", "1e-40"},
                                                                     {"voxel", "1,"},
                                                                     {"sor", "16"},
                                                                     {"sor", "0,1"},
                                                                     {"sor", "1.5,1"},
                                                                     {"sor", "16,-1"},
                                                                     {"sor", "1e12,1"},
                                                                     {"sor", "16,2,3"},
                                                                     {"crop", "0,0,0,1,1"},
                                                                     {"crop", "0,0,2,1,1,1"},
                                                                     {"crop", "0 0 0 1 1 1"},
                                                                     {"crop", "a,b,c,d,e,f"},
                                                                     {"mls", "0"},
                                                                     {"mls", "wide"},
                                                                     {"sharpen", "1"},
                                                                     {"", "1"}};
  for (const auto& [name, text] : nonsense) {
    FilterOptions result;
    EXPECT_THROW(set_filter(result, name, text), FilterError) << name << " " << text;
    EXPECT_FALSE(result.any());
  }
}

TEST(Filters, WithoutAnyTheCloudStaysAsItIs) {
  Cloud cloud = random_cloud(10, 1);
  cloud[3].x = NAN;
  const pcl::PCLPointCloud2 blob = to_blob(cloud);
  EXPECT_EQ(filter(blob, {}).data, blob.data);
  EXPECT_EQ(filter(blob, {}).width, 10u);
}

TEST(Filters, CropKeepsWhatIsInTheBoxByteForByte) {
  const Model cloud = milk();
  const FilterOptions crop = options("crop", "-0.05,-0.1,0,0.05,0.1,0.8");
  std::vector<Point> expected;
  for (const Point& p : cloud.positions)
    if (std::abs(p[0]) <= 0.05 && std::abs(p[1]) <= 0.1 && p[2] >= 0 && p[2] <= 0.8) expected.push_back(p);
  ASSERT_GT(expected.size(), 100u);
  ASSERT_LT(expected.size(), cloud.positions.size());
  EXPECT_EQ(filtered(cloud, crop).positions, expected);
}

TEST(Filters, PaddedRowsAndPointsThatAreNotFiniteAreStood) {
  Cloud cloud = random_cloud(12, 2);
  cloud.width = 4;
  cloud.height = 3;
  cloud[5].y = INFINITY;
  cloud[11].z = NAN;
  const pcl::PCLPointCloud2 blob = to_blob(cloud);
  pcl::PCLPointCloud2 padded = blob;
  padded.row_step = blob.row_step + 24;
  padded.data.assign(std::size_t{3} * padded.row_step, 0x77);
  for (int row = 0; row < 3; ++row)
    std::copy_n(blob.data.data() + row * blob.row_step, blob.row_step,
                padded.data.data() + row * padded.row_step);
  const Cloud kept = from_blob(filter(padded, options("crop", "-9,-9,-9,9,9,9")));
  ASSERT_EQ(kept.size(), 10u);
  for (int i = 0, k = 0; i < 11; ++i) {
    if (i == 5) continue;
    EXPECT_EQ(kept[k].x, cloud[i].x);
    EXPECT_EQ(kept[k++].rgba, cloud[i].rgba);
  }
}

TEST(Filters, OutliersAreThoseOfTheDefinition) {
  Cloud cloud = random_cloud(400, 3);
  for (int i = 0; i < 12; ++i) cloud[i * 30].x += 3 + static_cast<float>(i);
  constexpr int kNeighbours = 8;
  std::vector<double> mean_distance;
  for (const auto& p : cloud) {
    std::vector<double> distances;
    for (const auto& q : cloud)
      distances.push_back((p.getVector3fMap() - q.getVector3fMap()).cast<double>().norm());
    std::sort(distances.begin(), distances.end());  // the first is the point itself
    mean_distance.push_back(std::accumulate(distances.begin() + 1, distances.begin() + 1 + kNeighbours, 0.0) /
                            kNeighbours);
  }
  const double n = static_cast<double>(cloud.size());
  const double mean = std::accumulate(mean_distance.begin(), mean_distance.end(), 0.0) / n;
  double variance = 0;
  for (const double d : mean_distance) variance += (d - mean) * (d - mean) / (n - 1);
  std::vector<float> expected;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (mean_distance[i] <= mean + 1.0 * std::sqrt(variance)) expected.push_back(cloud[i].x);

  std::vector<float> kept;
  for (const auto& p : from_blob(filter(to_blob(cloud), options("sor", "8,1")))) kept.push_back(p.x);
  ASSERT_LT(kept.size(), cloud.size() - 5);
  EXPECT_EQ(kept, expected);
}

TEST(Filters, MoreNeighboursThanPointsAreStood) {
  for (int n = 0; n < 5; ++n)
    EXPECT_LE(filter(to_blob(random_cloud(n, 4)), options("sor", "1000000,1")).width,
              static_cast<unsigned>(n));
}

TEST(Filters, AVoxelGivesTheMeanOfItsPoints) {
  const Cloud cloud = random_cloud(3000, 5);
  constexpr double kLeaf = 0.25;
  struct Sum {
    double n = 0, x = 0, red = 0;
  };
  std::map<std::array<int, 3>, Sum> cells;
  for (const auto& p : cloud) {
    Sum& sum = cells[{static_cast<int>(std::floor(p.x / kLeaf)), static_cast<int>(std::floor(p.y / kLeaf)),
                      static_cast<int>(std::floor(p.z / kLeaf))}];
    sum.n += 1;
    sum.x += p.x;
    sum.red += p.r;
  }
  const Cloud means = from_blob(filter(to_blob(cloud), options("voxel", "0.25")));
  ASSERT_EQ(means.size(), cells.size());
  for (const auto& p : means) {
    const auto found =
        cells.find({static_cast<int>(std::floor(p.x / kLeaf)), static_cast<int>(std::floor(p.y / kLeaf)),
                    static_cast<int>(std::floor(p.z / kLeaf))});
    ASSERT_NE(found, cells.end());
    EXPECT_NEAR(p.x, found->second.x / found->second.n, 1e-5);
    EXPECT_NEAR(p.r, found->second.red / found->second.n, 1.01);
    EXPECT_EQ(p.b, 7);
  }
}

TEST(Filters, AVoxelDropsFieldsWithoutAMean) {
  pcl::PCLPointCloud2 blob = to_blob(random_cloud(50, 6));
  pcl::PCLPointField ring;
  ring.name = "ring";
  ring.offset = blob.point_step - 2;  // the last two bytes of a point
  ring.datatype = pcl::PCLPointField::UINT16;
  ring.count = 1;
  blob.fields.push_back(ring);
  const auto has_ring = [](const pcl::PCLPointCloud2& cloud) {
    return std::any_of(cloud.fields.begin(), cloud.fields.end(),
                       [](const auto& f) { return f.name == "ring"; });
  };
  EXPECT_TRUE(has_ring(filter(blob, options("sor", "8,3"))));
  const pcl::PCLPointCloud2 means = filter(blob, options("voxel", "5"));
  EXPECT_FALSE(has_ring(means));
  EXPECT_EQ(means.width, 8u);  // the eight cells around the origin
}

TEST(Filters, AVoxelKeepsASensorOfItsPoints) {
  const std::vector<Point> points = {{0.1, 0.5, 0.5}, {0.4, 0.5, 0.5}, {0.5, 0.5, 0.5}, {2.5, 0.5, 0.5}};
  const std::vector<Point> sensors = {{0, 0, 9}, {0, 0, -9}, {0, 0, 9}, {7, 7, 7}};
  const pcl::PCLPointCloud2 seen = io::with_stations(io::make_cloud(points), sensors);
  for (const pcl::PCLPointCloud2& cloud : {seen, io::with_named_stations(seen)})  // of double precision
    EXPECT_EQ(io::viewpoints_of(filter(cloud, options("voxel", "1"))),
              (std::vector<Point>{{0, 0, -9}, {7, 7, 7}}));  // the mean is at 0.33
}

TEST(Filters, VoxelsThatCannotBeNumberedAreRefused) {
  EXPECT_THROW(filtered(milk(), options("voxel", "1e-6")), FilterError);
  Cloud far = random_cloud(20, 7);
  for (auto& p : far) p.x += 1e6F;
  EXPECT_THROW(filter(to_blob(far), options("voxel", "1e-4")), FilterError);
  EXPECT_NO_THROW(filter(to_blob(far), options("voxel", "0.1")));
  for (auto& p : far) p.y *= 1e29F;
  EXPECT_THROW(filter(to_blob(far), options("voxel", "1")), FilterError);
}

TEST(Filters, SmoothingBringsNoiseToTheSurface) {
  test::Random random(8);
  Cloud cloud;
  for (const Point& d : test::sphere(3000, 8)) {
    const double r = 1 + random.uniform(-0.03, 0.03);
    pcl::PointXYZRGB p(1, 2, static_cast<std::uint8_t>(cloud.size()));
    p.x = static_cast<float>(r * d[0]);
    p.y = static_cast<float>(r * d[1]);
    p.z = static_cast<float>(r * d[2]);
    cloud.push_back(p);
  }
  const auto roughness = [](const Cloud& points) {
    double sum = 0;
    for (const auto& p : points) sum += std::abs(p.getVector3fMap().norm() - 1.0);
    return sum / static_cast<double>(points.size());
  };
  const pcl::PCLPointCloud2 blob = filter(to_blob(cloud), options("mls", "0.25"));
  const Cloud smooth = from_blob(blob);
  ASSERT_EQ(smooth.size(), cloud.size());
  EXPECT_LT(roughness(smooth), roughness(cloud) / 2);
  for (std::size_t i = 0; i < smooth.size(); ++i) EXPECT_EQ(smooth[i].b, cloud[i].b);  // in the same order
  EXPECT_EQ(filter(to_blob(cloud), options("mls", "0.25")).data, blob.data);
}

TEST(Filters, AllOfThemOnARealScan) {
  const Model cloud = milk();
  FilterOptions all = options("sor", "16,2");
  set_filter(all, "crop", "-1,-1,0.5,1,1,2");
  set_filter(all, "voxel", "0.005");
  set_filter(all, "mls", "0.015");
  const Model kept = filtered(cloud, all);
  EXPECT_GT(kept.positions.size(), 500u);
  EXPECT_LT(kept.positions.size(), cloud.positions.size());
  for (const Point& p : kept.positions)
    for (const double x : p) ASSERT_TRUE(std::isfinite(x));
}

TEST(Filters, LargeDoubleCoordinatesAreKept) {
  Model cloud = milk();
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    Point& p = cloud.positions[i];
    p = {p[0] + 500000.1, p[1] + 4649776.7, p[2] + 123.4};
  }
  cloud.positions.push_back({NAN, 0, 0});
  cloud.colours.assign(cloud.positions.size(), {1, 2, 3});
  const std::set<Point> points(cloud.positions.begin(), cloud.positions.end() - 1);
  const Model clean = filtered(cloud, options("sor", "16,1"));
  ASSERT_GT(clean.positions.size(), cloud.positions.size() / 2);
  ASSERT_LT(clean.positions.size(), cloud.positions.size() - 1);
  for (const Point& p : clean.positions) ASSERT_TRUE(points.count(p));

  const Model means = filtered(cloud, options("voxel", "0.01"));
  ASSERT_GT(means.positions.size(), 100u);
  EXPECT_EQ(means.colours, std::vector<io::Colour>(means.positions.size(), {1, 2, 3}));
  for (const Point& mean : means.positions) {  // in single precision they would be off by 0.25
    double nearest = 1;
    for (const Point& p : points)
      nearest = std::min(nearest, std::hypot(p[0] - mean[0], p[1] - mean[1], p[2] - mean[2]));
    ASSERT_LT(nearest, 0.018);
  }
}

TEST(Filters, CropAndOutliersKeepAllFieldsOfDoublePositions) {
  const Model cloud = milk();
  std::vector<Point> positions = cloud.positions;
  for (Point& p : positions) p = {p[0] + 500000.1, p[1] + 4649776.7, p[2] + 123.4};
  pcl::PCLPointCloud2 blob = io::make_cloud(positions);
  ASSERT_EQ(blob.fields[0].datatype, pcl::PCLPointField::FLOAT64);
  // A field that no filter knows: the number of the point.
  blob = io::with_positions(blob, positions);
  blob.fields.push_back(io::make_field("number", 24, pcl::PCLPointField::UINT32));
  for (std::uint32_t i = 0; i < blob.width; ++i)
    std::memcpy(&blob.data[i * blob.point_step + 24], &i, sizeof i);
  FilterOptions both = options("sor", "16,1");
  set_filter(both, "crop", "500000,4649776,123,500001,4649777,125");
  const pcl::PCLPointCloud2 kept = filter(blob, both);
  ASSERT_GT(kept.width, 100u);
  ASSERT_LT(kept.width, blob.width);
  for (std::uint32_t k = 0; k < kept.width; ++k) {
    std::uint32_t number = 0;
    std::memcpy(&number, &kept.data[k * kept.point_step + 24], sizeof number);
    EXPECT_EQ(std::memcmp(&kept.data[k * kept.point_step], positions[number].data(), sizeof(Point)), 0);
  }
}

TEST(Filters, BrokenCloudsAreRefused) {
  const pcl::PCLPointCloud2 blob = to_blob(random_cloud(10, 9));
  const FilterOptions any = options("voxel", "1");
  const auto expect_refused = [&](auto&& breaks) {
    pcl::PCLPointCloud2 broken = blob;
    breaks(broken);
    EXPECT_THROW(filter(broken, any), FilterError);
  };
  expect_refused([](auto& cloud) { cloud.data.pop_back(); });
  expect_refused([](auto& cloud) { cloud.width = 4000000000U; });
  expect_refused([](auto& cloud) { cloud.fields.clear(); });
  expect_refused([](auto& cloud) { cloud.fields[2].name = "w"; });
  expect_refused([](auto& cloud) { cloud.fields[0].datatype = pcl::PCLPointField::FLOAT64; });
  expect_refused([](auto& cloud) { cloud.fields[0].offset = cloud.point_step - 3; });
  expect_refused([](auto& cloud) { cloud.point_step = 0; });
  expect_refused([](auto& cloud) { cloud.height = 2, cloud.row_step = 3; });
  expect_refused([](auto& cloud) { cloud.is_bigendian = 1; });
  pcl::PCLPointCloud2 none = blob;
  none.width = 0;
  none.data.clear();
  for (const auto& [name, text] : {std::pair{"voxel", "1"}, {"sor", "8,1"}, {"mls", "1"}})
    EXPECT_EQ(filter(none, options(name, text)).width, 0u);
}

}  // namespace
}  // namespace filmsticking::filters

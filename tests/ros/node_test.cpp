// SPDX-License-Identifier: GPL-3.0-or-later
// Talks to a running filmsticking_node as other nodes do. Started by rostest: see the files *.test.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <pcl_msgs/PolygonMesh.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <visualization_msgs/Marker.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "conversions.h"
#include "io/formats.h"
#include "support/clouds.h"
#include "support/facing.h"
#include "support/surface_check.h"

namespace filmsticking::stream {
namespace {

constexpr std::chrono::seconds kPatience(40);  // for what comes at once on an idle machine

/// The messages of a topic.
template <class Message>
class Inbox {
 public:
  explicit Inbox(const std::string& topic)
      : subscriber_(
            node_.subscribe<Message>(topic, 100, [this](const boost::shared_ptr<const Message>& message) {
              const std::lock_guard lock(mutex_);
              messages_.push_back(message);
              came_.notify_all();
            })) {}

  /// The first message that is as wanted, also of those that came before; null if none comes.
  template <class Wanted>
  boost::shared_ptr<const Message> wait(Wanted wanted) {
    std::unique_lock lock(mutex_);
    boost::shared_ptr<const Message> found;
    came_.wait_for(lock, kPatience, [&] {
      for (const auto& message : messages_)
        if (!found && wanted(*message)) found = message;
      return found != nullptr;
    });
    return found;
  }

  void clear() {
    const std::lock_guard lock(mutex_);
    messages_.clear();
  }

 private:
  ros::NodeHandle node_;
  std::mutex mutex_;
  std::condition_variable came_;
  std::vector<boost::shared_ptr<const Message>> messages_;
  ros::Subscriber subscriber_;
};

using MeshInbox = Inbox<pcl_msgs::PolygonMesh>;

std_srvs::Trigger::Response call(const std::string& service) {
  std_srvs::Trigger trigger;
  EXPECT_TRUE(ros::service::waitForService("filmsticking/" + service, ros::Duration(kPatience.count())));
  EXPECT_TRUE(ros::service::call("filmsticking/" + service, trigger)) << service;
  return trigger.response;
}

std::set<Point> as_set(const std::vector<Point>& points) { return {points.begin(), points.end()}; }

Mesh mesh_of(const pcl_msgs::PolygonMesh& message) {
  pcl::PolygonMesh mesh;
  pcl_conversions::toPCL(message, mesh);
  return {io::positions_of(mesh.cloud), io::triangles_of(mesh.polygons)};
}

std::vector<io::Colour> colours_of(const pcl_msgs::PolygonMesh& message) {
  pcl::PCLPointCloud2 cloud;
  pcl_conversions::toPCL(message.cloud, cloud);
  return io::colours_of(cloud);
}

/// Closed, manifold, outward, and with vertices out of `points`.
void expect_good_mesh(const Mesh& mesh, const std::vector<Point>& points) {
  EXPECT_EQ(test::surface_fault(mesh), "");
  EXPECT_GT(test::signed_volume(mesh), 0);
  const std::set<Point> known = as_set(points);
  for (const Point& p : mesh.positions) ASSERT_TRUE(known.count(p)) << p[0] << " " << p[1] << " " << p[2];
}

TEST(Demo, TheMeshOfTheFileArrives) {
  const pcl::PCLPointCloud2 cloud = io::read_cloud(TEST_DATA "/spot_10k.pcd").points;
  const std::vector<Point> points = io::positions_of(cloud);
  const std::vector<io::Colour> painted = io::colours_of(cloud);
  std::map<Point, io::Colour> colours;
  for (std::size_t k = 0; k < points.size(); ++k) colours[points[k]] = painted[k];

  MeshInbox meshes("filmsticking/mesh");
  const auto message = meshes.wait([](const pcl_msgs::PolygonMesh& mesh) { return !mesh.polygons.empty(); });
  ASSERT_TRUE(message);
  EXPECT_EQ(message->header.frame_id, "map");
  EXPECT_EQ(message->cloud.header.frame_id, "map");
  const Mesh mesh = mesh_of(*message);
  expect_good_mesh(mesh, points);
  EXPECT_GT(mesh.positions.size(), points.size() * 99 / 100);
  const std::vector<io::Colour> found = colours_of(*message);
  ASSERT_EQ(found.size(), mesh.positions.size());
  for (std::size_t k = 0; k < found.size(); ++k) ASSERT_EQ(found[k], colours.at(mesh.positions[k]));

  Inbox<visualization_msgs::Marker> markers("filmsticking/marker");  // latched: it was published before
  const auto marker = markers.wait([](const auto& any) { return !any.points.empty(); });
  ASSERT_TRUE(marker);
  EXPECT_EQ(marker->header.frame_id, "map");
  EXPECT_EQ(marker->points.size(), 3 * mesh.triangles.size());
  EXPECT_EQ(marker->colors.size(), marker->points.size());
}

TEST(Bag, ItsCloudsAreFused) {
  constexpr std::size_t kClouds = 12, kPoints = 150;  // as write_bag.py writes
  const ros::Time last(2000 + 0.25 * (kClouds - 1));
  MeshInbox meshes("filmsticking/mesh");
  const auto message = meshes.wait([last](const auto& mesh) { return mesh.header.stamp == last; });
  ASSERT_TRUE(message);
  EXPECT_EQ(message->header.frame_id, "map");
  const Mesh mesh = mesh_of(*message);
  EXPECT_EQ(test::surface_fault(mesh), "");
  EXPECT_GT(mesh.positions.size(), kClouds * kPoints * 99 / 100);  // none of the clouds was missed
  for (const Point& p : mesh.positions) EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1, 1e-5);
}

class NodeTest : public testing::Test {
 protected:
  NodeTest() : input(node.advertise<sensor_msgs::PointCloud2>("points", 1000)) {}

  void SetUp() override {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (input.getNumSubscribers() == 0 && std::chrono::steady_clock::now() < deadline)
      ros::WallDuration(0.01).sleep();
    ASSERT_GT(input.getNumSubscribers(), 0u);
    if (defaults.doubles.empty()) defaults = set({});
    set(defaults);
    ASSERT_TRUE(call("reset").success);
  }

  /// Sets parameters as dynamic_reconfigure's clients do; the answer is what holds now.
  static dynamic_reconfigure::Config set(const dynamic_reconfigure::Config& config) {
    dynamic_reconfigure::Reconfigure request;
    request.request.config = config;
    EXPECT_TRUE(
        ros::service::waitForService("filmsticking/set_parameters", ros::Duration(kPatience.count())));
    EXPECT_TRUE(ros::service::call("filmsticking/set_parameters", request));
    return request.response.config;
  }
  template <class Parameter, class Value>
  static void put(std::vector<Parameter>& parameters, const std::string& name, const Value& value) {
    Parameter parameter;
    parameter.name = name;
    parameter.value = value;
    parameters.push_back(parameter);
  }
  static void set(const std::string& name, int value) {
    dynamic_reconfigure::Config config;
    put(config.ints, name, value);
    set(config);
  }
  static void set(const std::string& name, bool value) {
    dynamic_reconfigure::Config config;
    put(config.bools, name, value);
    set(config);
  }
  static void set(const std::string& name, double value) {
    dynamic_reconfigure::Config config;
    put(config.doubles, name, value);
    set(config);
  }
  static std::string set(const std::string& name, const std::string& value) {
    dynamic_reconfigure::Config config;
    put(config.strs, name, value);
    for (const auto& parameter : set(config).strs)
      if (parameter.name == name) return parameter.value;
    return "?";
  }

  /// Publishes a cloud with a stamp of its own.
  ros::Time publish(const std::vector<Point>& points, const std::string& frame_id = "map") {
    return publish(io::make_cloud(points), frame_id);
  }
  ros::Time publish(const pcl::PCLPointCloud2& points, const std::string& frame_id = "map") {
    sensor_msgs::PointCloud2 cloud;
    pcl_conversions::fromPCL(points, cloud);
    cloud.header.frame_id = frame_id;
    cloud.header.stamp = ++stamp;
    input.publish(cloud);
    return cloud.header.stamp;
  }

  /// A sphere of points in single precision.
  static std::vector<Point> ball(int size, std::uint64_t seed = 1, Point centre = {0, 0, 0}) {
    std::vector<Point> points = test::sphere(size, seed, centre);
    for (Point& p : points)
      for (double& x : p) x = static_cast<float>(x);
    return points;
  }

  /// The message with that stamp; null if none comes.
  boost::shared_ptr<const pcl_msgs::PolygonMesh> message_at(ros::Time of) {
    const auto message = meshes.wait([of](const pcl_msgs::PolygonMesh& mesh) {
      return mesh.header.stamp == of && !mesh.polygons.empty();
    });
    EXPECT_TRUE(message);
    return message;
  }
  /// Its mesh.
  Mesh mesh_at(ros::Time of) {
    const auto message = message_at(of);
    return message ? mesh_of(*message) : Mesh();
  }

  /// Calls reconstruct until something was received.
  std_srvs::Trigger::Response reconstruct() {
    for (int attempt = 0;; ++attempt) {
      const auto response = call("reconstruct");
      if (response.message != "no points have come yet" || attempt == 400) return response;
      ros::WallDuration(0.05).sleep();
    }
  }

  /// A count that ++ makes a time of.
  struct Stamp {
    ros::Time operator++() { return ros::Time(1000 + ++count, 500); }
    std::uint32_t count = 0;
  };

  static Stamp stamp;
  static dynamic_reconfigure::Config defaults;
  ros::NodeHandle node;
  ros::Publisher input;
  MeshInbox meshes{"filmsticking/mesh"};
};

NodeTest::Stamp NodeTest::stamp;
dynamic_reconfigure::Config NodeTest::defaults;

TEST_F(NodeTest, AMeshForEachCloud) {
  for (int seed = 1; seed <= 3; ++seed) {
    const std::vector<Point> cloud = ball(1000, static_cast<std::uint64_t>(seed));
    const Mesh mesh = mesh_at(publish(cloud));
    expect_good_mesh(mesh, cloud);
    EXPECT_GT(mesh.positions.size(), 900u);
  }
}

TEST_F(NodeTest, AMeshKeepsEveryField) {
  const std::vector<Point> points = ball(1000);
  std::vector<pcl::PCLPointField> fields = io::make_cloud(points).fields;
  fields.push_back(io::make_field("reflectivity", 12, pcl::PCLPointField::FLOAT64));
  pcl::PCLPointCloud2 cloud = io::make_rows(fields, 20, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = points[i][0] / 3;
    io::PositionFields(cloud).store(points[i], &cloud.data[20 * i]);
    std::memcpy(&cloud.data[20 * i + 12], &value, sizeof value);
  }
  const auto message = message_at(publish(cloud));
  ASSERT_TRUE(message);
  pcl::PCLPointCloud2 vertices;
  pcl_conversions::toPCL(message->cloud, vertices);
  const std::vector<Point> positions = io::positions_of(vertices);
  const pcl::PCLPointField* kept = io::find_field(vertices, "reflectivity");
  ASSERT_TRUE(kept);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    double value = 0;
    std::memcpy(&value, &vertices.data[i * vertices.point_step + kept->offset], sizeof value);
    ASSERT_EQ(value, positions[i][0] / 3);
  }
}

TEST_F(NodeTest, ServicesAnswer) {
  const std::string path = std::string(std::getenv("ROS_HOME")) + "/saved.ply";
  std::remove(path.c_str());
  EXPECT_EQ(set("save_path", path), path);
  EXPECT_FALSE(call("reconstruct").success);
  EXPECT_FALSE(call("save").success);

  set("every_frames", 0);
  const std::vector<Point> cloud = ball(1000);
  publish(cloud);
  const auto response = reconstruct();
  EXPECT_TRUE(response.success) << response.message;
  EXPECT_NE(response.message.find("closed mesh"), std::string::npos) << response.message;

  const auto saved = call("save");
  ASSERT_TRUE(saved.success) << saved.message;
  const pcl::PolygonMesh file = io::read_mesh(path);
  expect_good_mesh({io::positions_of(file.cloud), io::triangles_of(file.polygons)}, cloud);
  set("save_path", std::string("/nowhere/mesh.ply"));
  EXPECT_FALSE(call("save").success);
  set("save_path", std::string("mesh.doc"));
  EXPECT_FALSE(call("save").success);

  meshes.clear();
  EXPECT_TRUE(call("reset").success);
  EXPECT_TRUE(meshes.wait([](const pcl_msgs::PolygonMesh& mesh) { return mesh.polygons.empty(); }));
  EXPECT_FALSE(call("reconstruct").success);
  EXPECT_FALSE(call("save").success);
}

TEST_F(NodeTest, CollectsAndFusesAsReconfigured) {
  set("window", 0);
  set("voxel", 0.25);
  set("every_frames", 5);
  std::vector<Point> points;
  ros::Time last;
  for (int seed = 1; seed <= 5; ++seed) {
    const std::vector<Point> cloud = ball(400, static_cast<std::uint64_t>(seed));
    points.insert(points.end(), cloud.begin(), cloud.end());
    last = publish(cloud);
  }
  const Mesh mesh = mesh_at(last);
  expect_good_mesh(mesh, points);
  std::set<Point> cells;
  for (const Point& p : mesh.positions)
    EXPECT_TRUE(
        cells.insert({std::floor(p[0] / 0.25), std::floor(p[1] / 0.25), std::floor(p[2] / 0.25)}).second);
  EXPECT_GT(cells.size(), 100u);
}

TEST_F(NodeTest, RefusesParametersThatMakeNoSense) {
  EXPECT_EQ(set("crop", std::string("-9,-9,-9,9,9,9")), "-9,-9,-9,9,9,9");
  EXPECT_EQ(set("crop", std::string("here")), "-9,-9,-9,9,9,9");
  EXPECT_EQ(set("sor", std::string("1,2,3,4")), "");
  const std::vector<Point> cloud = ball(500);
  expect_good_mesh(mesh_at(publish(cloud)), cloud);
}

TEST_F(NodeTest, RunsTheFilters) {
  set("crop", std::string("-2,-2,-2,2,2,2"));
  set("max_range", 20.0);
  std::vector<Point> cloud = ball(500);
  const std::vector<Point> inside = cloud;
  for (const Point& p : ball(300, 2, {5, 0, 0})) cloud.push_back(p);
  for (const Point& p : ball(300, 3, {50, 0, 0})) cloud.push_back(p);
  expect_good_mesh(mesh_at(publish(cloud)), inside);
}

TEST_F(NodeTest, LeavesASurfaceOpenIfAsked) {
  std::vector<Point> half;  // one side of a sphere
  for (const Point& p : ball(4000))
    if (p[2] > 0) half.push_back(p);
  expect_good_mesh(mesh_at(publish(half)), half);
  set("open", true);
  const Mesh mesh = mesh_at(publish(half));
  EXPECT_EQ(test::surface_fault(mesh, true), "");
  EXPECT_EQ(test::surface_fault(mesh), "an edge has one face only");
}

TEST_F(NodeTest, MovesCloudsToTheFixedFrame) {
  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.child_frame_id = "sensor";
  transform.transform.translation.x = 16;  // a sum that single precision holds
  transform.transform.rotation.w = 1;
  broadcaster.sendTransform(transform);
  set("fixed_frame", std::string("map"));

  std::vector<Point> cloud = ball(500);
  for (Point& p : cloud)
    for (double& x : p) x = std::round(x * 65536) / 65536;
  std::vector<Point> moved = cloud;
  for (Point& p : moved) p[0] += 16;
  const ros::Time at = publish(cloud, "sensor");
  expect_good_mesh(mesh_at(at), moved);
  const auto message = meshes.wait([at](const auto& mesh) { return mesh.header.stamp == at; });
  EXPECT_EQ(message->header.frame_id, "map");
}

TEST_F(NodeTest, AnOpenMeshFacesTheSensor) {
  tf2_ros::StaticTransformBroadcaster broadcaster;
  set("fixed_frame", std::string("map"));
  set("open", true);
  test::Random random(8);
  std::vector<Point> cloud;  // a wall, two in front of the sensor
  for (int i = 0; i < 2000; ++i)
    cloud.push_back({2 + random.uniform(0, 0.01), random.uniform(-1, 1), random.uniform(-1, 1)});
  for (const bool turned : {false, true}) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.child_frame_id = turned ? "turned" : "straight";
    transform.transform.translation.x = turned ? 20 : 16;
    transform.transform.rotation.z = turned ? 1 : 0;
    transform.transform.rotation.w = turned ? 0 : 1;
    broadcaster.sendTransform(transform);
    const Mesh mesh = mesh_at(publish(cloud, transform.child_frame_id));
    EXPECT_GT(mesh.positions.size(), 1900u);
    EXPECT_GT(test::facing_share(mesh,
                                 [&](const Point&) {
                                   return Point{turned ? 20.0 : 16.0, 0, 0};
                                 }),
              0.95);
  }
}

TEST_F(NodeTest, ABurstEndsWithTheNewestAndIsTold) {
  Inbox<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  ASSERT_TRUE(diagnostics.wait([](const auto&) { return true; }));
  const std::vector<Point> cloud = ball(3000);
  ros::Time last;
  for (int frame = 0; frame < 150; ++frame) last = publish(cloud);
  expect_good_mesh(mesh_at(last), cloud);
  EXPECT_TRUE(diagnostics.wait([](const diagnostic_msgs::DiagnosticArray& array) {
    for (const auto& status : array.status)
      if (status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
          status.message.find("falls behind") != std::string::npos)
        return true;
    return false;
  }));
}

TEST_F(NodeTest, HoldsNoMoreThanItMay) {
  set("max_points", 700);
  const std::vector<Point> cloud = ball(5000);
  const Mesh mesh = mesh_at(publish(cloud));
  expect_good_mesh(mesh, cloud);
  EXPECT_LE(mesh.positions.size(), 700u);
}

TEST_F(NodeTest, OutlivesBrokenClouds) {
  sensor_msgs::PointCloud2 cloud;
  input.publish(cloud);  // no frame
  cloud.header.frame_id = "map";
  input.publish(cloud);  // no fields
  pcl_conversions::fromPCL(io::make_cloud(ball(100)), cloud);
  cloud.header.frame_id = "map";
  cloud.width *= 1000;
  input.publish(cloud);  // too few bytes
  publish(std::vector<Point>());
  publish(ball(100), "a_frame_that_nobody_knows");
  publish(std::vector<Point>(50, {1, 2, 3}));
  const std::vector<Point> good = ball(500);
  expect_good_mesh(mesh_at(publish(good)), good);
}

/// The node as live_scanner.launch starts it.
class LiveTest : public NodeTest {};

TEST_F(LiveTest, MeshesWhatIsInRange) {
  for (int frame = 0; frame < 3; ++frame) {
    std::vector<Point> cloud = ball(2000, 1, {0, 0, 6});  // too far
    std::vector<Point> near = ball(2000, 2);
    for (Point& p : near) p = {p[0] / 4, p[1] / 4, static_cast<float>(p[2] / 4 + 1)};
    cloud.insert(cloud.end(), near.begin(), near.end());
    const Mesh mesh = mesh_at(publish(cloud, "camera"));
    expect_good_mesh(mesh, near);
    EXPECT_GT(mesh.positions.size(), 1000u);
  }
}

}  // namespace
}  // namespace filmsticking::stream

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "node_test");
  ros::NodeHandle keeps_ros_running;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  const int result = RUN_ALL_TESTS();
  ros::shutdown();
  return result;
}

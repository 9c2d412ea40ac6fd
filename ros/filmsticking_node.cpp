// SPDX-License-Identifier: GPL-3.0-or-later
// filmsticking_node: sensor_msgs/PointCloud2 in, closed meshes out. stream::LiveMesher does the work; this
// file has the topics, services, parameters and diagnostics of ROS 1.
#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <geometry_msgs/TransformStamped.h>
#include <pcl/console/print.h>
#include <pcl_msgs/PolygonMesh.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/Marker.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "conversions.h"
#include "filmsticking_pp/FilmstickingConfig.h"
#include "filters/filter_options.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "stream/frame_points.h"
#include "stream/live_mesher.h"

namespace {

using namespace filmsticking;
using namespace filmsticking::stream;
using filmsticking_pp::FilmstickingConfig;

/// Clouds that wait for the node, and for their transforms; beyond these the oldest are dropped.
constexpr int kQueue = 10;

/// Throws FilterError.
Settings settings_of(const FilmstickingConfig& config) {
  Settings settings;
  settings.bounds.voxel = config.voxel;
  settings.bounds.window = config.window;
  settings.bounds.max_points = static_cast<std::size_t>(config.max_points);
  settings.every_frames = config.every_frames;
  settings.every_seconds = config.every_seconds;
  settings.cancel_outdated = config.cancel_outdated;
  if (!config.crop.empty()) filters::set_filter(settings.filters, "crop", config.crop);
  if (!config.sor.empty()) filters::set_filter(settings.filters, "sor", config.sor);
  if (config.mls > 0) settings.filters.smoothing = config.mls;
  filters::check(settings.filters);
  settings.options.threads = config.threads;
  settings.options.open_boundary = config.open;
  settings.options.keep_outliers = config.keep_outliers;
  settings.options.sharp_edges = config.sharp_edges;
  return settings;
}

std::string summary_of(const LiveOutcome& outcome) {
  char text[200];
  std::snprintf(text, sizeof text, "a %s mesh of %zu vertices and %zu triangles from %ld points in %.2f s",
                outcome.report.closed ? "closed" : "open", io::size_of(outcome.mesh.cloud),
                outcome.mesh.polygons.size(), static_cast<long>(outcome.points), outcome.seconds);
  return text;
}

class Node {
 public:
  Node()
      : listener_(buffer_),
        transformed_(buffer_, "", kQueue, ros::getGlobalCallbackQueue()),
        mesh_publisher_(private_.advertise<pcl_msgs::PolygonMesh>("mesh", 1, true)),
        marker_publisher_(private_.advertise<visualization_msgs::Marker>("marker", 1, true)),
        mesher_([this](const LiveOutcome& outcome) { publish(outcome); }),
        patient_spinner_(1, &patient_queue_) {
    updater_.setHardwareID("none");
    updater_.add("reconstruction", this, &Node::diagnose);
    reconfigure_.setCallback([this](FilmstickingConfig& config, std::uint32_t) { configure(config); });

    transformed_.registerCallback([this](const sensor_msgs::PointCloud2ConstPtr& cloud) { take(*cloud); });
    transformed_.registerFailureCallback(
        [this](const sensor_msgs::PointCloud2ConstPtr& cloud, tf2_ros::FilterFailureReason) {
          drop(cloud->header.frame_id.empty() ? std::string("it has no frame_id")
                                              : "there is no transform from " + cloud->header.frame_id +
                                                    " to " + frame_id_ + " at its time");
        });
    input_ = private_.subscribe<sensor_msgs::PointCloud2>(
        "input", kQueue, [this](const sensor_msgs::PointCloud2ConstPtr& cloud) { receive(cloud); });
    timer_ = private_.createWallTimer(ros::WallDuration(0.05), [this](const ros::WallTimerEvent&) {
      mesher_.tick(LiveMesher::Clock::now());
      updater_.update();
    });
    reset_service_ = private_.advertiseService("reset", &Node::reset, this);

    // These two may take long, so they have a thread of their own.
    ros::NodeHandle patient("~");
    patient.setCallbackQueue(&patient_queue_);
    reconstruct_service_ = patient.advertiseService("reconstruct", &Node::reconstruct, this);
    save_service_ = patient.advertiseService("save", &Node::save, this);
    patient_spinner_.start();
  }

  ~Node() {
    mesher_.stop();  // ends the wait of a service
    patient_spinner_.stop();
  }

 private:
  void configure(FilmstickingConfig& config) {
    try {
      mesher_.set(settings_of(config));
    } catch (const filters::FilterError& error) {
      ROS_ERROR("The parameters stay as they were: %s.", error.what());
      if (configured_) {
        config = config_;
        return;
      }
      config.crop = config.sor = "";
      mesher_.set(settings_of(config));
    }
    const bool moved = configured_ && config.fixed_frame != config_.fixed_frame;
    config_ = config;
    if (moved || !configured_) use_frame(config.fixed_frame);
    configured_ = true;
    if (moved) mesher_.reset();
    const std::lock_guard<std::mutex> lock(save_path_mutex_);
    save_path_ = config.save_path;
  }

  void use_frame(const std::string& frame_id) {
    frame_id_ = frame_id;
    transformed_.clear();
    if (!frame_id.empty()) transformed_.setTargetFrame(frame_id);
  }

  void receive(const sensor_msgs::PointCloud2ConstPtr& cloud) {
    if (frame_id_.empty()) use_frame(cloud->header.frame_id);
    transformed_.add(cloud);
  }

  /// Adds a cloud that has a transform.
  void take(const sensor_msgs::PointCloud2& cloud) {
    try {
      Frame frame;
      frame.cloud = in_range(to_cloud(cloud), config_.min_range, config_.max_range);
      if (cloud.header.frame_id != frame_id_)
        frame.sensor_pose =
            to_pose(buffer_.lookupTransform(frame_id_, cloud.header.frame_id, cloud.header.stamp).transform);
      mesher_.add(frame, {frame_id_, static_cast<std::int64_t>(cloud.header.stamp.toNSec())},
                  LiveMesher::Clock::now());
    } catch (const std::runtime_error& error) {  // of the message or its transform
      drop(error.what());
    }
  }

  void drop(const std::string& reason) {
    ++dropped_;
    ROS_WARN_THROTTLE(5, "A cloud was left out: %s.", reason.c_str());
  }

  /// Called from the mesher's thread.
  void publish(const LiveOutcome& outcome) {
    if (outcome.status != Status::Ok) {
      ROS_WARN_THROTTLE(5, "No mesh: %s.", outcome.message.c_str());
      return;
    }
    const ros::Time stamp = ros::Time().fromNSec(static_cast<std::uint64_t>(outcome.origin.stamp));
    pcl_msgs::PolygonMesh mesh;
    pcl_conversions::fromPCL(outcome.mesh, mesh);
    mesh.header.frame_id = mesh.cloud.header.frame_id = outcome.origin.frame_id;
    mesh.header.stamp = mesh.cloud.header.stamp = stamp;
    visualization_msgs::Marker marker = to_marker(outcome.mesh);
    marker.header = mesh.header;
    mesh_publisher_.publish(mesh);
    marker_publisher_.publish(marker);
    if (outcome.ticket > 0) ROS_INFO_THROTTLE(5, "Published %s.", summary_of(outcome).c_str());
  }

  bool reconstruct(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const LiveMesher::Ticket ticket = mesher_.request();
    const std::shared_ptr<const LiveOutcome> outcome = ticket > 0 ? mesher_.wait(ticket) : nullptr;
    response.success = outcome && outcome->status == Status::Ok;
    response.message = ticket == 0         ? "no points have come yet"
                       : !outcome          ? "cancelled"
                       : !response.success ? outcome->message
                                           : summary_of(*outcome);
    return true;
  }

  bool reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    mesher_.reset();
    use_frame(config_.fixed_frame);
    response.success = true;
    response.message = "all points are forgotten";
    return true;
  }

  bool save(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const std::string path = [this] {
      const std::lock_guard<std::mutex> lock(save_path_mutex_);
      return save_path_;
    }();
    const std::shared_ptr<const LiveOutcome> outcome = mesher_.last_mesh();
    try {
      if (!outcome) throw io::IoError("there is no mesh yet");
      if (!io::can_write_mesh(path))
        throw io::IoError("its extension is none of " + io::extensions_of(io::mesh_formats()));
      io::write_mesh(path, outcome->mesh);
      response.success = true;
      response.message = "wrote " + std::filesystem::absolute(path).string();
    } catch (const std::exception& error) {
      response.message = path + ": " + error.what();
    }
    return true;
  }

  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
    const Facts facts = mesher_.facts();
    const std::shared_ptr<const LiveOutcome> last = mesher_.last();
    const auto superseded = facts.superseded - diagnosed_.superseded;
    const auto given_up = facts.given_up - diagnosed_.given_up;
    const auto dropped = dropped_ - diagnosed_dropped_;
    diagnosed_ = facts;
    diagnosed_dropped_ = dropped_;

    using diagnostic_msgs::DiagnosticStatus;
    status.summary(DiagnosticStatus::OK, facts.frames == 0 ? "no cloud has come yet" : "keeps up");
    if (superseded > 0)
      status.mergeSummaryf(DiagnosticStatus::WARN, "falls behind: %ld requests gave way to newer data",
                           static_cast<long>(superseded));
    if (given_up > 0)
      status.mergeSummaryf(DiagnosticStatus::WARN, "max_points is reached: %ld points were given up",
                           static_cast<long>(given_up));
    if (dropped > 0)
      status.mergeSummaryf(DiagnosticStatus::WARN, "%ld clouds were left out", static_cast<long>(dropped));
    if (last && last->status != Status::Ok)
      status.mergeSummary(DiagnosticStatus::ERROR, "no mesh: " + last->message);
    status.add("Clouds taken", facts.frames);
    status.add("Clouds left out", dropped_);
    status.add("Points held", facts.held);
    status.add("Points given up", facts.given_up);
    status.add("Meshes published", facts.meshes);
    status.add("Requests that gave way", facts.superseded);
    status.add("At work", facts.busy);
    if (!last) return;
    status.add("Last duration in seconds", last->seconds);
    status.add("Last vertices", io::size_of(last->mesh.cloud));
    status.add("Last triangles", last->mesh.polygons.size());
  }

  ros::NodeHandle private_{"~"};
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  tf2_ros::MessageFilter<sensor_msgs::PointCloud2> transformed_;
  std::string frame_id_;  // to collect points in; empty until the first cloud has come
  std::int64_t dropped_ = 0;

  FilmstickingConfig config_;
  bool configured_ = false;
  std::mutex save_path_mutex_;
  std::string save_path_;

  ros::Publisher mesh_publisher_, marker_publisher_;
  LiveMesher mesher_;  // uses the publishers
  diagnostic_updater::Updater updater_;
  Facts diagnosed_;
  std::int64_t diagnosed_dropped_ = 0;

  dynamic_reconfigure::Server<FilmstickingConfig> reconfigure_;
  ros::Subscriber input_;
  ros::WallTimer timer_;
  ros::CallbackQueue patient_queue_;  // before its services, which leave it when they end
  ros::ServiceServer reset_service_, reconstruct_service_, save_service_;
  ros::AsyncSpinner patient_spinner_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "filmsticking");
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // the node reports failures itself
  try {
    Node node;
    ros::spin();
    return 0;
  } catch (const std::exception& error) {
    ROS_FATAL("%s.", error.what());
    return 1;
  }
}

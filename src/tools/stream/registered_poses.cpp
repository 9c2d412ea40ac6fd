// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "frame_points.h"
#include "mean_cloud.h"
#include "pose_source.h"

namespace filmsticking::stream {
namespace {

using PointT = pcl::PointXYZ;
using Cloud = pcl::PointCloud<PointT>;

/// Enough points for a fit, and few enough for a quick one.
constexpr std::size_t kFramePoints = 5000, kModelCells = 60000;

/// A fit with this overlap is not tried again from another start.
constexpr double kGoodOverlap = 0.75;

/// PCL's tolerances are absolute, so all fits are scaled to cells of this width.
constexpr double kCell = 0.01;

std::vector<Point> thinned(const std::vector<Point>& points, double leaf) {
  MeanCloud cells(leaf, kModelCells);
  cells.add(points);
  return cells.positions();
}

class Registration {
 public:
  explicit Registration(const RegistrationOptions& options) : options_(options) {}

  Placement place(const std::vector<Point>& points) {
    if (!model_) {
      choose_cell(points);
      return accept(points, Pose::Identity());
    }
    const Cloud::Ptr source = to_cloud(thinned(points, cell_));
    const Cloud::Ptr target = to_cloud(model_->positions());
    pcl::search::KdTree<PointT>::Ptr tree(new pcl::search::KdTree<PointT>);
    tree->setInputCloud(target);

    // Either the sensor repeats its last motion, once a frame that was left out, too, or it stands still.
    Pose on = last_ * step_;
    for (int k = 0; k < left_out_; ++k) on = on * step_;
    double best = 0;
    std::optional<Pose> best_pose;
    for (const Pose& guess : {on, last_}) {
      const auto pose = fit(source, target, tree, guess);
      if (!pose) continue;
      const double overlap = overlap_of(*source, *tree, *pose);
      if (overlap <= best) continue;
      best = overlap;
      best_pose = pose;
      if (best > kGoodOverlap) break;
    }
    if (best_pose && best >= options_.min_overlap) return accept(points, *best_pose);
    ++left_out_;
    char reason[100];
    std::snprintf(reason, sizeof reason,
                  "it does not fit: only %.0f %% of it would lie on the frames before it", 100 * best);
    return {std::nullopt, reason};
  }

 private:
  /// Chooses the width in which a frame has at most kFramePoints cells, and the origin of all fits: the
  /// middle of the first frame.
  void choose_cell(const std::vector<Point>& points) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Point& p : points) middle += Eigen::Vector3d(p[0], p[1], p[2]);
    middle /= static_cast<double>(points.size());
    cell_ = mean_spacing(points);
    if (!(cell_ > 0)) cell_ = 1;
    while (thinned(points, cell_).size() > kFramePoints) cell_ *= 1.5;
    origin_ = Pose(Eigen::Translation3d(middle));
    model_.emplace(cell_, kModelCells);
  }

  /// The points relative to the origin, scaled to cells of width kCell.
  Cloud::Ptr to_cloud(const std::vector<Point>& points) const {
    Cloud::Ptr cloud(new Cloud);
    for (const Point& p : points) {
      const Eigen::Vector3d q = origin_.inverse() * Eigen::Vector3d(p[0], p[1], p[2]) * (kCell / cell_);
      cloud->push_back({static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())});
    }
    return cloud;
  }

  /// The same motion for such points.
  Eigen::Matrix4f to_fit(const Pose& pose) const {
    Pose local = origin_.inverse() * pose * origin_;
    local.translation() *= kCell / cell_;
    return local.matrix().cast<float>();
  }

  Pose from_fit(const Eigen::Matrix4f& matrix) const {
    Pose local;
    local.matrix() = matrix.cast<double>();
    local.linear() = Eigen::Quaterniond(local.linear()).normalized().toRotationMatrix();
    local.translation() *= cell_ / kCell;
    return origin_ * local * origin_.inverse();
  }

  /// The fit converges when an iteration moves less than a thousandth of a cell.
  std::unique_ptr<pcl::Registration<PointT, PointT>> make_fit() const {
    constexpr double kStill = kCell / 1000;
    if (options_.fit == Fit::Icp) {
      auto icp = std::make_unique<pcl::IterativeClosestPoint<PointT, PointT>>();
      icp->setTransformationEpsilon(kStill * kStill);  // PCL compares squares
      return icp;
    }
    auto gicp = std::make_unique<pcl::GeneralizedIterativeClosestPoint<PointT, PointT>>();
    gicp->setTransformationEpsilon(kStill);
    gicp->setRotationEpsilon(1e-4);
    return gicp;
  }

  /// Fits with a wide reach, then with a narrow one.
  std::optional<Pose> fit(const Cloud::Ptr& source, const Cloud::Ptr& target,
                          const pcl::search::KdTree<PointT>::Ptr& tree, const Pose& guess) const {
    if (source->size() < 20 || target->size() < 20) return std::nullopt;  // GICP needs 20 neighbours
    Eigen::Matrix4f pose = to_fit(guess);
    const auto method = make_fit();
    method->setInputSource(source);
    method->setInputTarget(target);
    method->setSearchMethodTarget(tree, true);
    method->setMaximumIterations(50);
    for (const double reach : {12.0, 4.0}) {
      method->setMaxCorrespondenceDistance(reach * kCell);
      Cloud ignored;
      try {
        method->align(ignored, pose);
      } catch (const pcl::PCLException&) {  // GICP throws it for degenerate clouds
        return std::nullopt;
      }
      if (!method->getFinalTransformation().allFinite()) return std::nullopt;
      pose = method->getFinalTransformation();
    }
    return from_fit(pose);
  }

  /// The share of the frame's points that are within a cell's width of a model point.
  double overlap_of(const Cloud& source, const pcl::search::KdTree<PointT>& tree, const Pose& pose) const {
    const Eigen::Affine3f motion(to_fit(pose));
    std::size_t near = 0;
    pcl::Indices neighbour;
    std::vector<float> square;
    for (const PointT& p : source) {
      const Eigen::Vector3f at = motion * Eigen::Vector3f(p.x, p.y, p.z);
      const PointT q(at.x(), at.y(), at.z());
      if (tree.nearestKSearch(q, 1, neighbour, square) == 1 && square[0] <= kCell * kCell) ++near;
    }
    return static_cast<double>(near) / static_cast<double>(source.size());
  }

  Placement accept(const std::vector<Point>& points, const Pose& pose) {
    if (left_out_ == 0) step_ = last_.inverse() * pose;  // else it would span several frames
    left_out_ = 0;
    last_ = pose;
    model_->add(moved(points, pose));
    cell_ = model_->width();  // the model may have become coarser
    return {pose, ""};
  }

  RegistrationOptions options_;
  double cell_ = 1;
  Pose origin_ = Pose::Identity();
  Pose last_ = Pose::Identity();
  Pose step_ = Pose::Identity();
  int left_out_ = 0;  ///< frames since the last one that fitted
  std::optional<MeanCloud> model_;
};

}  // namespace

PoseSource registered_poses(const RegistrationOptions& options) {
  return [registration = std::make_shared<Registration>(options)](
             const Frame&, const std::vector<Point>& points) { return registration->place(points); };
}

}  // namespace filmsticking::stream

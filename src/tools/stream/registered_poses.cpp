// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>

#include "frame_points.h"
#include "pose_source.h"
#include "voxel_map.h"

namespace filmsticking::capture {
namespace {

using PointT = pcl::PointXYZ;
using Cloud = pcl::PointCloud<PointT>;

/// Enough for a fit, and few enough to be quick.
constexpr std::size_t kFramePoints = 5000, kModelCells = 60000;

/// A frame that fits so well is not fitted from another start, too.
constexpr double kGoodOverlap = 0.75;

/// PCL's tolerances are absolute, so that all fits are made where a cell is this wide.
constexpr double kCell = 0.01;

io::Model thinned(const io::Model& points, double leaf) {
  VoxelMap map(leaf, kModelCells);
  map.add({points.positions, {}, {}});
  return map.points();
}

class RegisteredPoses : public PoseSource {
 public:
  explicit RegisteredPoses(const RegistrationOptions& options) : options_(options) {}

  Placement place(const Frame&, const io::Model& points) override {
    if (!model_) {
      choose_cell(points);
      return accept(points, Pose::Identity());
    }
    const Cloud::Ptr source = to_cloud(thinned(points, cell_));
    const Cloud::Ptr target = to_cloud(model_->points());
    pcl::search::KdTree<PointT>::Ptr tree(new pcl::search::KdTree<PointT>);
    tree->setInputCloud(target);

    // The sensor goes on as it did, also through frames that were left out, or it stands still.
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
  /// The cell in which a frame has at most kFramePoints points; the origin is where all is fitted around.
  void choose_cell(const io::Model& points) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Point& p : points.positions) middle += Eigen::Vector3d(p[0], p[1], p[2]);
    middle /= static_cast<double>(points.positions.size());
    cell_ = mean_spacing(points);
    if (!(cell_ > 0)) cell_ = 1;
    while (thinned(points, cell_).positions.size() > kFramePoints) cell_ *= 1.5;
    origin_ = Pose(Eigen::Translation3d(middle));
    model_.emplace(cell_, kModelCells);
  }

  /// The points around the origin, and scaled to cells of width kCell.
  Cloud::Ptr to_cloud(const io::Model& points) const {
    Cloud::Ptr cloud(new Cloud);
    for (const Point& p : points.positions) {
      const Eigen::Vector3d q = origin_.inverse() * Eigen::Vector3d(p[0], p[1], p[2]) * (kCell / cell_);
      cloud->push_back({static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())});
    }
    return cloud;
  }

  /// The same motion for scaled points around the origin.
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

  /// It ends when a round changes less than a thousandth of a cell.
  std::unique_ptr<pcl::Registration<PointT, PointT>> make_fit() const {
    constexpr double kStill = kCell / 1000;
    if (options_.fit == Fit::Icp) {
      auto icp = std::make_unique<pcl::IterativeClosestPoint<PointT, PointT>>();
      icp->setTransformationEpsilon(kStill * kStill);  // it compares squares
      return icp;
    }
    auto gicp = std::make_unique<pcl::GeneralizedIterativeClosestPoint<PointT, PointT>>();
    gicp->setTransformationEpsilon(kStill);
    gicp->setRotationEpsilon(1e-4);
    return gicp;
  }

  /// Coarse, then fine.
  std::optional<Pose> fit(const Cloud::Ptr& source, const Cloud::Ptr& target,
                          const pcl::search::KdTree<PointT>::Ptr& tree, const Pose& guess) const {
    if (source->size() < 20 || target->size() < 20) return std::nullopt;  // GICP takes 20 neighbours
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
      } catch (const pcl::PCLException&) {  // GICP's, for degenerate clouds
        return std::nullopt;
      }
      if (!method->getFinalTransformation().allFinite()) return std::nullopt;
      pose = method->getFinalTransformation();
    }
    return from_fit(pose);
  }

  /// The share of the frame's points with a model point as near as a cell is wide.
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

  Placement accept(const io::Model& points, const Pose& pose) {
    if (left_out_ == 0) step_ = last_.inverse() * pose;  // else it would be several
    left_out_ = 0;
    last_ = pose;
    model_->add(moved({points.positions, {}, {}}, pose));
    cell_ = model_->leaf();  // it may have got coarser
    return {pose, ""};
  }

  RegistrationOptions options_;
  double cell_ = 1;
  Pose origin_ = Pose::Identity();
  Pose last_ = Pose::Identity();
  Pose step_ = Pose::Identity();
  int left_out_ = 0;  ///< frames since the last that fitted
  std::optional<VoxelMap> model_;
};

}  // namespace

std::unique_ptr<PoseSource> registered_poses(const RegistrationOptions& options) {
  return std::make_unique<RegisteredPoses>(options);
}

}  // namespace filmsticking::capture

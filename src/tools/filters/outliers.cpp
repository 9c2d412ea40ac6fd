// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/filters/statistical_outlier_removal.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "steps.h"

namespace filmsticking::filters {

std::vector<int> inliers(const pcl::PCLPointCloud2& cloud, const OutlierRule& rule) {
  std::vector<int> kept(cloud.width);
  std::iota(kept.begin(), kept.end(), 0);
  const auto others = static_cast<int>(cloud.width) - 1;
  if (others < 1) return kept;  // nothing to compare with
  pcl::StatisticalOutlierRemoval<pcl::PCLPointCloud2> filter;
  filter.setInputCloud(std::make_shared<pcl::PCLPointCloud2>(cloud));
  filter.setMeanK(std::min(rule.neighbours, others));  // PCL reads past its neighbours otherwise
  filter.setStddevMulThresh(rule.deviations);
  filter.filter(kept);
  return kept;
}

}  // namespace filmsticking::filters

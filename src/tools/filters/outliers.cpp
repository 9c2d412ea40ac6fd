// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/filters/statistical_outlier_removal.h>

#include <algorithm>
#include <memory>

#include "steps.h"

namespace filmsticking::filters {

pcl::PCLPointCloud2 without_outliers(const pcl::PCLPointCloud2& cloud, const OutlierRule& rule) {
  const auto others = static_cast<int>(cloud.width) - 1;
  if (others < 1) return cloud;  // nothing to compare with
  pcl::StatisticalOutlierRemoval<pcl::PCLPointCloud2> filter;
  filter.setInputCloud(std::make_shared<pcl::PCLPointCloud2>(cloud));
  filter.setMeanK(std::min(rule.neighbours, others));  // PCL reads past its neighbours otherwise
  filter.setStddevMulThresh(rule.deviations);
  pcl::PCLPointCloud2 kept;
  filter.filter(kept);
  return kept;
}

}  // namespace filmsticking::filters

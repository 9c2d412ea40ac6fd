// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_chain.h"

#include "steps.h"

namespace filmsticking::filters {

pcl::PCLPointCloud2 filter(const pcl::PCLPointCloud2& cloud, const FilterOptions& options) {
  check(options);
  if (!options.any()) return cloud;
  pcl::PCLPointCloud2 kept = finite_points(cloud, options.crop);
  // Outliers go before the voxels: a lone point would get a voxel of its own, as heavy as any.
  if (options.outliers) kept = without_outliers(kept, *options.outliers);
  if (options.voxel) kept = one_point_a_voxel(kept, *options.voxel);
  if (options.smoothing) kept = smoothed(kept, *options.smoothing);
  return kept;
}

}  // namespace filmsticking::filters

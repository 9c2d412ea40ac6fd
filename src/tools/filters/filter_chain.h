// SPDX-License-Identifier: GPL-3.0-or-later
// PCL's filters one after the other, on clouds with any fields.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "filter_options.h"

namespace filmsticking::filters {

/// Runs the chosen filters on a cloud; without any, returns the cloud as it is.
///
/// x, y, z are all FLOAT32 or all FLOAT64. Organized clouds and rows with padding are accepted; the result is
/// one row in the order of the input (by cells after `voxel`). Points with a coordinate that is not finite,
/// or 1e30 and more, and points absurdly far from the others, are left out. `crop` and `sor` keep all bytes
/// of a point. `voxel` gives the mean of positions, colours and other FLOAT32 fields, as pcl::VoxelGrid with
/// downsample_all_data; fields of other types have no mean in PCL and are dropped. `mls` moves x, y, z and
/// keeps all other fields, normals too. FLOAT64 positions are moved to a local origin before PCL's single
/// precision; only `voxel` and `mls` round them. The same cloud gives the same result. The header is kept.
/// Throws FilterError, also for a cloud whose fields and bytes do not fit together, and where the cells of
/// `voxel` are too small to be numbered.
pcl::PCLPointCloud2 filter(const pcl::PCLPointCloud2& cloud, const FilterOptions& options);

}  // namespace filmsticking::filters

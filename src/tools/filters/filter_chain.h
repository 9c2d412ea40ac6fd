// SPDX-License-Identifier: GPL-3.0-or-later
// PCL's filters one after the other, on clouds with any fields.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "filter_options.h"

namespace filmsticking::filters {

/// Runs the chosen filters on a cloud; without any, gives back the cloud as it is.
///
/// x, y, z must be fields of single precision. Organised clouds and rows with padding are fine; the result is
/// one row in the order of the input (by cells after `voxel`). Points that are not finite are left out. All
/// fields are kept, with two exceptions: `voxel` gives the mean of fields of single precision and of rgb(a),
/// and drops all others, which have none; `mls` moves x, y, z and lets the other fields, normals too, be.
/// The same cloud gives the same result. The header is kept.
/// Throws FilterError, also for a cloud whose fields and bytes do not fit together, and where the cells of
/// `voxel` are too small to be numbered.
pcl::PCLPointCloud2 filter(const pcl::PCLPointCloud2& cloud, const FilterOptions& options);

}  // namespace filmsticking::filters

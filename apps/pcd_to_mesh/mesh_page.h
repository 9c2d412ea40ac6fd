// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::app {

/// Writes the page of --html: the mesh beside the points that it was made from. Throws IoError.
void write_mesh_page(const std::string& path, const std::string& title, const std::vector<Point>& points,
                     const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles);

}  // namespace filmsticking::app

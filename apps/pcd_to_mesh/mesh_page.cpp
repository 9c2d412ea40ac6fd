// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_page.h"

#include "io/cloud.h"
#include "page/page.h"

namespace filmsticking::app {

void write_mesh_page(const std::string& path, const std::string& title, const std::vector<Point>& points,
                     const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles) {
  const mesh_report::Surface mesh = mesh_report::make_surface(io::make_mesh(vertices, triangles));
  mesh_report::Report report = mesh_report::report_on(mesh);
  const mesh_report::CloudDistances distances = cloud_distances(mesh, points);
  report.cloud = cloud_fit_of(mesh, distances);
  page::write_page(path, {title, mesh, report, &distances});
}

}  // namespace filmsticking::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "report/cloud_fit.h"
#include "report/report.h"
#include "report/surface.h"

namespace filmsticking::page {

/// What a page shows.
struct Contents {
  std::string title;
  const mesh_report::Surface& mesh;
  const mesh_report::Report& report;
  const mesh_report::CloudDistances* cloud = nullptr;
  const mesh_report::Surface* truth = nullptr;
};

/// Browsers hold no longer texts than such a page.
constexpr std::size_t kMostFaces = 5'000'000;
/// Of a cloud with more, every nth is shown.
constexpr std::size_t kMostPoints = 1'000'000;

/// Writes one HTML file that needs neither a network nor other files: the mesh as it turns under the mouse
/// with its marks, distances as colours and histograms, the holes, the table of the report. The same contents
/// give the same bytes. Throws IoError, also for a mesh of more than kMostFaces.
void write_page(const std::string& path, const Contents& contents);

}  // namespace filmsticking::page

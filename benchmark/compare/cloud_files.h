// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "clouds/cloud_spec.h"
#include "filmsticking/types.h"
#include "input.h"
#include "row.h"

namespace filmsticking::bench {

/// A cloud on the disk, ready for the methods.
struct CloudFiles {
  std::string cloud;
  std::string truth;                    ///< the mesh that it was drawn from; empty: not known
  Row row;                              ///< the columns that say which cloud it is
  std::optional<Point> direction = {};  ///< in which a far sensor looked at it
};

/// Samples a mesh or a shape as `spec` says. A file without faces is a cloud already: its finite points are
/// taken as they are, or a random choice where it has more than `spec.points` and `thin_clouds` is set.
/// Writes into `folder`. Throws std::runtime_error.
CloudFiles prepare_cloud(const Input& input, const CloudSpec& spec, bool thin_clouds,
                         const std::string& folder);

/// The mesh, or the points, of a file or a shape; `points`: the number for which a shape has its size. Throws
/// io::IoError, std::invalid_argument.
Mesh read_input(const Input& input, std::int64_t points);

/// The columns of `prepare_cloud` for a mesh or a shape, without the work.
Row cloud_row(const Input& input, const CloudSpec& spec);

}  // namespace filmsticking::bench

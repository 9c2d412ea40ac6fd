// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_chain.h"
#include "io/model.h"

namespace filmsticking::filters {

/// The filter of clouds for the former type of clouds; drops its triangles.
inline io::Model filter(const io::Model& model, const FilterOptions& options) {
  check(options);
  if (!options.any()) return model;
  return io::Cloud{filter(io::make_cloud(model.positions, model.colours), options), model.viewpoint};
}

}  // namespace filmsticking::filters

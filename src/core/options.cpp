// SPDX-License-Identifier: GPL-3.0-or-later
#include "filmsticking/options.h"

namespace filmsticking {

Options Options::paper() {
  Options options;
  options.method = Method::Film;
  options.field = FieldMethod::Poisson;
  options.virtual_sites = 1000;
  options.insert_leftover = false;
  options.sharp_edges = false;
  options.max_rounds = 1;
  return options;
}

}  // namespace filmsticking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filmsticking/options.h"

namespace filmsticking {

Options Options::paper() {
  Options options;
  options.method = Method::Film;
  options.field = FieldMethod::Poisson;
  options.virtual_sites = 1000;
  options.max_rounds = 1;
  return options;
}

Options Options::rd() {
  Options options;
  options.method = Method::Film;
  options.field = FieldMethod::Sculpt;
  options.ring = RingChoice::Nearest;
  options.virtual_sites = 0;
  options.weights = false;
  return options;
}

}  // namespace filmsticking

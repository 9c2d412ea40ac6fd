// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_arguments.h"

namespace filmsticking::app {

void add_filters(Arguments& arguments, filters::FilterOptions& options) {
  arguments.group("Filters, in the order in which they run; none runs unless asked for");
  for (const filters::FilterChoice& choice : filters::filter_choices())
    arguments.option(std::string("--") + choice.name, choice.value, choice.help,
                     [&options, name = choice.name](const std::string& text) {
                       try {
                         filters::set_filter(options, name, text);
                       } catch (const filters::FilterError& error) {
                         throw UsageError(std::string("--") + error.what());
                       }
                     });
}

std::string names_of(const filters::FilterOptions& options) {
  std::string names;
  const auto add = [&names](bool on, const char* name) {
    if (on) names += (names.empty() ? "" : ", ") + std::string(name);
  };
  add(options.crop.has_value(), "crop");
  add(options.outliers.has_value(), "sor");
  add(options.voxel.has_value(), "voxel");
  add(options.smoothing.has_value(), "mls");
  return names;
}

}  // namespace filmsticking::app

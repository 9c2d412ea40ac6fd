// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_arguments.h"

namespace po = boost::program_options;

namespace filmsticking::app {

po::options_description filter_arguments() {
  po::options_description options("Filters, in the order in which they run; none unless asked for", 100);
  for (const filters::FilterChoice& choice : filters::filter_choices())
    options.add_options()(choice.name, po::value<std::string>()->value_name(choice.value), choice.help);
  return options;
}

filters::FilterOptions filter_options(const Arguments& given) {
  filters::FilterOptions options;
  for (const filters::FilterChoice& choice : filters::filter_choices())
    given.with(choice.name, [&](const std::string& name, const std::string& text) {
      try {
        filters::set_filter(options, name, text);
      } catch (const filters::FilterError& error) {
        throw UsageError(std::string("--") + error.what());
      }
    });
  return options;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/parsers.hpp>
#include <boost/program_options/positional_options.hpp>
#include <charconv>
#include <cmath>

namespace po = boost::program_options;

namespace filmsticking::app {

Arguments::Arguments(int argc, const char* const* argv, const po::options_description& options) {
  po::options_description all;
  all.add(options).add_options()("file", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("file", -1);
  try {
    using namespace po::command_line_style;
    const int style = allow_long | long_allow_adjacent | long_allow_next;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given_);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
  if (has("file")) files_ = given_["file"].as<std::vector<std::string>>();
}

int parse_count(const std::string& option, const std::string& text, int least) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < least)
    throw UsageError("--" + option + " takes a whole number from " + std::to_string(least) + " on, not '" +
                     text + "'");
  return value;
}

double parse_positive(const std::string& option, const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value) || value <= 0)
    throw UsageError("--" + option + " takes a number above zero, not '" + text + "'");
  return value;
}

}  // namespace filmsticking::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ground_argument.h"

#include "filters/filter_error.h"
#include "filters/filter_options.h"

namespace filmsticking::app {

void add_ground(Arguments& arguments, const std::string& help, filters::GroundChoice& ground) {
  const auto is_plane = [](const std::string& word) { return filters::parse_numbers(word).size() > 1; };
  arguments.optional("--ground", "[A,B,C,D]", help, "auto", is_plane, [&ground](const std::string& text) {
    try {
      ground = filters::parse_ground(text);
    } catch (const filters::FilterError& error) {
      throw UsageError(std::string("--") + error.what());
    }
  });
}

}  // namespace filmsticking::app

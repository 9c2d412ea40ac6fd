// SPDX-License-Identifier: GPL-3.0-or-later
#include "method_choice.h"

#include <algorithm>

#include "command_line.h"

namespace filmsticking::bench {

std::vector<std::string> choose_methods(const std::vector<std::string>& asked,
                                        const std::map<std::string, MethodEntry>& all) {
  std::vector<std::string> usual;
  for (const auto& [name, entry] : all)
    if (entry.makes_mesh && !entry.needs_sight && name.rfind("fault-", 0) != 0) usual.push_back(name);
  std::stable_partition(usual.begin(), usual.end(),
                        [](const std::string& name) { return name.rfind("ours", 0) == 0; });
  if (asked.empty()) return usual;
  for (const std::string& name : asked)
    if (!all.count(name)) {
      std::string names;
      for (const std::string& other : usual) names += (names.empty() ? "" : ", ") + other;
      throw UsageError("there is no method \"" + name + "\" here; there are " + names);
    }
  return asked;
}

}  // namespace filmsticking::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace filmsticking::test {

/// Calls fault(i) for every i from `first` to before `last`, by all processors, and prints each i for which
/// it returns a text. A crash or a hang (no end in `patience` seconds) prints its i and ends the program.
/// Returns how many faults there were; after `most` of them it stops.
int sweep(const std::string& name, std::uint64_t first, std::uint64_t last, int patience, int most,
          const std::function<std::string(std::uint64_t)>& fault);

}  // namespace filmsticking::test

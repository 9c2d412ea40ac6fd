// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud_list.h"

namespace filmsticking::bench {

std::vector<CloudPlan> list_clouds(const CommandLine& command) {
  const std::vector<Input> inputs = make_inputs(command.inputs);
  std::vector<CloudPlan> plans;
  for (const Sampling sampling : command.samplings)
    for (const Noise& noise : command.noise)
      for (const double outliers : command.outliers)
        for (const double missing : command.missing)
          for (const std::int64_t points : command.points)
            for (const std::uint64_t seed : command.seeds)
              for (const Input& input : inputs)
                plans.push_back({input, {sampling, points, seed, noise, outliers, missing}});
  return plans;
}

}  // namespace filmsticking::bench

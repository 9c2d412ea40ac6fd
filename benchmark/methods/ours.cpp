// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <stdexcept>
#include <utility>

#include "filmsticking/reconstruct.h"
#include "peers.h"

namespace filmsticking::bench {
namespace {

Outcome run(const std::vector<Point>& points, Options options, int threads) {
  options.threads = threads;
  Stopwatch watch;
  Result result = reconstruct(points, options);
  Outcome outcome;
  outcome.seconds = watch.lap();
  if (result.status != Status::Ok)
    throw std::runtime_error(result.message.empty() ? describe(result.status) : result.message);
  outcome.steps = static_cast<int>(result.report.steps.size());
  outcome.fields = result.report.rounds;
  outcome.warning = std::move(result.report.warning);
  outcome.rooms = std::move(result.report.rooms);
  outcome.mesh.triangles = std::move(result.triangles);
  for (const std::int32_t i : result.vertices) outcome.mesh.positions.push_back(points[i]);
  return outcome;
}

Outcome run_seen(const SeenCloud& cloud, Options options, int threads) {
  if (!cloud.sensors.empty()) options.viewpoints = std::make_shared<const std::vector<Point>>(cloud.sensors);
  options.view_direction = cloud.direction;
  return run(cloud.points, std::move(options), threads);
}

}  // namespace

Outcome run_ours(const std::vector<Point>& points, int threads) { return run(points, Options(), threads); }

Outcome run_ours_paper(const std::vector<Point>& points, int threads) {
  return run(points, Options::paper(), threads);
}

Outcome run_ours_rd(const std::vector<Point>& points, int threads) {
  return run(points, Options::rd(), threads);
}

Outcome run_paper_no_weights(const std::vector<Point>& points, int threads) {
  Options options = Options::paper();
  options.weights = false;
  return run(points, options, threads);
}

Outcome run_paper_no_virtual(const std::vector<Point>& points, int threads) {
  Options options = Options::paper();
  options.virtual_sites = 0;
  return run(points, options, threads);
}

Outcome run_paper_no_smooth(const std::vector<Point>& points, int threads) {
  Options options = Options::paper();
  options.ring = RingChoice::Nearest;
  return run(points, options, threads);
}

Outcome run_paper_no_field(const std::vector<Point>& points, int threads) {
  Options options = Options::paper();
  options.field = FieldMethod::None;
  return run(points, options, threads);
}

Outcome run_ours_open(const std::vector<Point>& points, int threads) {
  Options options;
  options.open_boundary = true;
  return run(points, options, threads);
}

Outcome run_ours_open_origin(const std::vector<Point>& points, int threads) {
  Options options;
  options.open_boundary = true;
  options.viewpoint = Point{0, 0, 0};
  return run(points, options, threads);
}

Outcome run_ours_sight(const SeenCloud& cloud, int threads) { return run_seen(cloud, Options(), threads); }

Outcome run_ours_open_sight(const SeenCloud& cloud, int threads) {
  Options options;
  options.open_boundary = true;
  return run_seen(cloud, std::move(options), threads);
}

}  // namespace filmsticking::bench

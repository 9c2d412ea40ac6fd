// SPDX-License-Identifier: GPL-3.0-or-later
#include "reconstruction_arguments.h"

#include <optional>

#include "filters/filter_options.h"

namespace po = boost::program_options;

namespace filmsticking::app {

po::options_description reconstruction_arguments() {
  po::options_description options("Reconstruction", 100);
  options.add_options()(
      "open", "leave out the faces that no points support: the surface that was seen, with its borders")(
      "viewpoint", po::value<std::string>()->value_name("X,Y,Z"),
      "where all points may have been seen from; the default is what a PCD file says")(
      "keep-outliers", "bring on points that are far from all others, too")(
      "no-sharp-edges", "do not flip edges of the mesh to lie along the sharp edges of the shape")(
      "max-memory", po::value<std::string>()->value_name("MB"),
      "end with a message where the reconstruction would need more memory than this")(
      "preset", po::value<std::string>()->value_name("default|paper"),
      "where the options start from; paper: sphere, 1000 virtual sites, one Poisson round")(
      "init", po::value<std::string>()->value_name("sphere|wrap|carve"),
      "carve (the default): no film; else the surface that a film starts from")(
      "field", po::value<std::string>()->value_name("poisson|sculpt|none"),
      "how dangling plates are removed and the topology is corrected")(
      "ring", po::value<std::string>()->value_name("smooth|nearest"),
      "the ring that a point with several regions keeps")(
      "virtual-sites", po::value<std::string>()->value_name("N|adaptive"), "virtual sites")(
      "no-weights", "attract points by the Voronoi diagram alone")(
      "no-insert", "leave out the points that are off at the end")(
      "max-steps", po::value<std::string>()->value_name("N"), "film steps before the first field")(
      "max-rounds", po::value<std::string>()->value_name("N"), "rounds of field and film")(
      "threads", po::value<std::string>()->value_name("N"), "threads; 0: all; the mesh is the same");
  return options;
}

Options reconstruction_options(const Arguments& given) {
  Options options;
  given.with("preset", [&](const auto& name, const auto& text) {
    if (parse_choice<bool>(name, text, {{"default", false}, {"paper", true}})) options = Options::paper();
  });
  given.with("init", [&](const auto& name, const auto& text) {
    const auto start = parse_choice<std::optional<FilmStart>>(
        name, text, {{"sphere", FilmStart::Sphere}, {"wrap", FilmStart::Wrap}, {"carve", std::nullopt}});
    options.method = start ? Method::Film : Method::Labelling;
    options.film_start = start.value_or(FilmStart::Sphere);
  });
  given.with("field", [&](const auto& name, const auto& text) {
    options.field = parse_choice<FieldMethod>(
        name, text,
        {{"poisson", FieldMethod::Poisson}, {"sculpt", FieldMethod::Sculpt}, {"none", FieldMethod::None}});
  });
  given.with("ring", [&](const auto& name, const auto& text) {
    options.ring = parse_choice<RingChoice>(
        name, text, {{"smooth", RingChoice::Smooth}, {"nearest", RingChoice::Nearest}});
  });
  given.with("virtual-sites", [&](const auto& name, const auto& text) {
    options.virtual_sites = text == "adaptive" ? Options::kAdaptiveVirtualSites : parse_count(name, text, 0);
  });
  given.with("max-steps",
             [&](const auto& name, const auto& text) { options.max_steps = parse_count(name, text, 1); });
  given.with("max-rounds",
             [&](const auto& name, const auto& text) { options.max_rounds = parse_count(name, text, 1); });
  given.with("threads",
             [&](const auto& name, const auto& text) { options.threads = parse_count(name, text, 0); });
  given.with("max-memory", [&](const auto& name, const auto& text) {
    options.max_memory = std::int64_t{1000000} * parse_count(name, text, 1);
  });
  given.with("viewpoint", [&](const auto& name, const auto& text) {
    const std::vector<double> place = filters::parse_numbers(text);
    if (place.size() != 3) throw UsageError("--" + name + " takes X,Y,Z, not '" + text + "'");
    options.viewpoint = Point{place[0], place[1], place[2]};
  });
  options.open_boundary = given.has("open");
  options.keep_outliers = given.has("keep-outliers");
  if (given.has("no-sharp-edges")) options.sharp_edges = false;
  if (given.has("no-weights")) options.weights = false;
  if (given.has("no-insert")) options.insert_leftover = false;
  return options;
}

}  // namespace filmsticking::app

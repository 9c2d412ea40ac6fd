// SPDX-License-Identifier: GPL-3.0-or-later
#include "reconstruction_arguments.h"

#include <optional>

#include "filters/filter_options.h"

namespace filmsticking::app {
namespace {

Point parse_place(const std::string& name, const std::string& text) {
  const std::vector<double> place = filters::parse_numbers(text);
  if (place.size() != 3) throw UsageError(name + " takes X,Y,Z, not '" + text + "'");
  return {place[0], place[1], place[2]};
}

void add_surface(Arguments& arguments, Options& options) {
  arguments.flag("--open",
                 "leave out the faces that no points support: the surface that was seen, with its borders",
                 options.open_boundary);
  arguments.option(
      "--viewpoint", "X,Y,Z", "where all points may have been seen from; the default is what a PCD file says",
      [&options](const std::string& text) { options.viewpoint = parse_place("--viewpoint", text); });
  arguments.option("--view-direction", "X,Y,Z", "the way in which a far sensor looked at all points",
                   [&options](const std::string& text) {
                     options.view_direction = parse_place("--view-direction", text);
                   });
  arguments.action("--from-above", "the same as --view-direction 0,0,-1: height fields, aerial scans",
                   [&options] {
                     options.view_direction = Point{0, 0, -1};
                   });
  arguments.flag("--keep-outliers", "keep points that are far from all others", options.keep_outliers);
  arguments.flag("--no-sharp-edges", "do not flip edges of the mesh onto the sharp edges of the shape",
                 options.sharp_edges, false);
}

void add_film(Arguments& arguments, Options& options) {
  arguments.option(
      "--init", "sphere|wrap|carve",
      "carve (the default): label tetrahedra, without a film; else the surface that the film starts as",
      [&options](const std::string& text) {
        const auto start = parse_choice<std::optional<FilmStart>>(
            "--init", text,
            {{"sphere", FilmStart::Sphere}, {"wrap", FilmStart::Wrap}, {"carve", std::nullopt}});
        options.method = start ? Method::Film : Method::Labelling;
        options.film_start = start.value_or(FilmStart::Sphere);
      });
  arguments.choice(
      "--field", "poisson|sculpt|none", "how dangling plates are removed and the topology is corrected",
      options.field,
      {{"poisson", FieldMethod::Poisson}, {"sculpt", FieldMethod::Sculpt}, {"none", FieldMethod::None}});
  arguments.choice("--ring", "smooth|nearest", "the ring that a point with several regions keeps",
                   options.ring, {{"smooth", RingChoice::Smooth}, {"nearest", RingChoice::Nearest}});
  arguments.option("--virtual-sites", "N|adaptive", "number of virtual sites",
                   [&options](const std::string& text) {
                     options.virtual_sites = text == "adaptive"
                                                 ? Options::kAdaptiveVirtualSites
                                                 : static_cast<int>(parse_count("--virtual-sites", text, 0));
                   });
  arguments.flag("--no-weights", "attract points by the Voronoi diagram alone", options.weights, false);
  arguments.flag("--no-insert", "leave out the points that the mesh does not interpolate at the end",
                 options.insert_leftover, false);
  arguments.count("--max-steps", "N", "film steps before the first field", options.max_steps, 1);
  arguments.count("--max-rounds", "N", "rounds of field and cut", options.max_rounds, 1);
}

}  // namespace

void add_reconstruction(Arguments& arguments, Options& options) {
  arguments.group("Reconstruction");
  // First, since it replaces all options; the others then change what it says.
  arguments.option(
      "--preset", "default|paper|rd",
      "values of the other options to start from; paper: Filmsticking++ as published, rd: its predecessor",
      [&options](const std::string& text) {
        using Preset = Options (*)();
        const auto preset = parse_choice<Preset>(
            "--preset", text, {{"default", nullptr}, {"paper", &Options::paper}, {"rd", &Options::rd}});
        if (preset != nullptr) options = preset();
      });
  add_surface(arguments, options);
  add_film(arguments, options);
  constexpr std::int64_t kMegabyte = 1000000;
  arguments.option("--max-memory", "MB",
                   "end with a message if the reconstruction would need more memory than this",
                   [&options](const std::string& text) {
                     options.max_memory = kMegabyte * parse_count("--max-memory", text, 1);
                   });
  arguments.count("--threads", "N", "threads; 0: all; the mesh does not depend on it", options.threads, 0);
}

}  // namespace filmsticking::app

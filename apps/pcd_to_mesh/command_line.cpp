// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <boost/program_options.hpp>
#include <charconv>
#include <sstream>
#include <vector>

namespace po = boost::program_options;

namespace filmsticking::app {
namespace {

po::options_description visible_options() {
  po::options_description options("Options", 100);
  options.add_options()("report", po::value<std::string>()->value_name("FILE.json"),
                        "write what was done as JSON")(
      "dump-steps", po::value<std::string>()->value_name("DIR"), "write the film after each step as PLY")(
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
      "threads", po::value<std::string>()->value_name("N"), "threads; 0: all; the mesh is the same")(
      "help", "print this text")("version", "print the version");
  return options;
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

/// One of several words, each with its meaning.
template <typename Meaning>
struct Choice {
  const char* word;
  Meaning meaning;
};

template <typename Meaning>
Meaning parse_choice(const std::string& option, const std::string& text,
                     const std::vector<Choice<Meaning>>& choices) {
  std::string words;
  for (const Choice<Meaning>& choice : choices) {
    if (text == choice.word) return choice.meaning;
    words += (words.empty() ? "" : ", ") + std::string(choice.word);
  }
  throw UsageError("--" + option + " takes one of " + words + ", not '" + text + "'");
}

Options to_options(const po::variables_map& given) {
  // Each present option is handed to its reader by name, so that the name stands once.
  const auto with = [&given](const char* name, auto&& use) {
    if (given.count(name)) use(std::string(name), given[name].as<std::string>());
  };
  Options options;
  with("preset", [&](const auto& name, const auto& text) {
    if (parse_choice<bool>(name, text, {{"default", false}, {"paper", true}})) options = Options::paper();
  });
  with("init", [&](const auto& name, const auto& text) {
    options.initial_surface = parse_choice<InitialSurface>(name, text,
                                                           {{"sphere", InitialSurface::Sphere},
                                                            {"wrap", InitialSurface::Wrap},
                                                            {"carve", InitialSurface::Carve}});
  });
  with("field", [&](const auto& name, const auto& text) {
    options.field = parse_choice<FieldMethod>(
        name, text,
        {{"poisson", FieldMethod::Poisson}, {"sculpt", FieldMethod::Sculpt}, {"none", FieldMethod::None}});
  });
  with("ring", [&](const auto& name, const auto& text) {
    options.ring = parse_choice<RingChoice>(
        name, text, {{"smooth", RingChoice::Smooth}, {"nearest", RingChoice::Nearest}});
  });
  with("virtual-sites", [&](const auto& name, const auto& text) {
    options.virtual_sites = text == "adaptive" ? Options::kAdaptiveVirtualSites : parse_count(name, text, 0);
  });
  with("max-steps",
       [&](const auto& name, const auto& text) { options.max_steps = parse_count(name, text, 1); });
  with("max-rounds",
       [&](const auto& name, const auto& text) { options.max_rounds = parse_count(name, text, 1); });
  with("threads", [&](const auto& name, const auto& text) { options.threads = parse_count(name, text, 0); });
  if (given.count("no-weights")) options.weights = false;
  if (given.count("no-insert")) options.insert_leftover = false;
  return options;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  po::options_description all = visible_options();
  all.add_options()("file", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("file", -1);
  po::variables_map given;
  try {
    using namespace po::command_line_style;
    const int style = allow_long | long_allow_adjacent | long_allow_next;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }

  CommandLine command;
  command.help = given.count("help") > 0;
  command.version = given.count("version") > 0;
  if (command.help || command.version) return command;
  const auto files =
      given.count("file") ? given["file"].as<std::vector<std::string>>() : std::vector<std::string>();
  if (files.size() != 2) throw UsageError("an INPUT and an OUTPUT file are needed; --help tells more");
  command.input = files[0];
  command.output = files[1];
  if (given.count("report")) command.report = given["report"].as<std::string>();
  if (given.count("dump-steps")) command.dump_steps = given["dump-steps"].as<std::string>();
  command.options = to_options(given);
  return command;
}

std::string usage() {
  std::ostringstream text;
  text << "usage: pcd_to_mesh INPUT OUTPUT [options]\n\n"
          "Turns a point cloud without normals into a closed manifold triangle mesh through its points.\n"
          "  INPUT   .pcd .ply .obj .stl .xyz .txt (of a mesh, the vertices)\n"
          "  OUTPUT  .ply (binary) .obj .stl .vtk; coordinates keep all digits, colours go into .ply .obj "
          ".vtk\n\n"
       << visible_options()
       << "\nExit status: 0 with a mesh written, 2 for a wrong command line, 130 if interrupted, else 1.\n";
  return text.str();
}

}  // namespace filmsticking::app

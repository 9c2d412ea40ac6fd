// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <boost/program_options.hpp>
#include <charconv>
#include <cmath>
#include <sstream>

#include "input.h"

namespace po = boost::program_options;

namespace filmsticking::bench {
namespace {

constexpr int kMostThreads = 4096;

po::value_semantic* text(std::string* to, const char* name) { return po::value(to)->value_name(name); }

/// The texts of the options that hold lists.
struct Lists {
  std::vector<std::string> files, where;
  std::string methods, points, sampling = "monte-carlo", seeds = "1", noise = "0", outliers = "0",
                               missing = "0";
};

po::options_description options(CommandLine& command, Lists& lists) {
  po::options_description clouds("Clouds (lists are separated by commas; all combinations are made)", 100);
  clouds.add_options()(
      "list", po::value(&lists.files)->value_name("FILE"),
      "take the inputs from a file: one path a line, or a .tsv table with a column \"file\"")(
      "where", po::value(&lists.where)->value_name("COLUMN=VALUE"),
      "only such rows of a .tsv table; repeatable")(
      "points", text(&lists.points, "N,.."), "how many, like 10K; speed: default 10K,50K,100K,200K,500K,1M")(
      "sampling", text(&lists.sampling, "S,.."),
      "monte-carlo (default), poisson-disk, mixed-density, vertices, depth-view, depth-frame")(
      "seeds", text(&lists.seeds, "N,.."), "default 1")("noise", text(&lists.noise, "X,.."),
                                                        "Gaussian, its deviation as a share of the diagonal, "
                                                        "or with an s behind it, of the spacing; default 0")(
      "outliers", text(&lists.outliers, "X,.."), "share of the points; default 0")(
      "missing", text(&lists.missing, "X,.."), "share of the surface, in round patches; default 0");

  po::options_description runs("Runs", 100);
  runs.add_options()("methods", text(&lists.methods, "M,.."),
                     "default: all that make a mesh; --help lists them")(
      "threads", po::value(&command.threads)->value_name("N"),
      "for every method that has threads; 0, the default: all")(
      "jobs", po::value(&command.jobs)->value_name("N"),
      "clouds at once; the timings are then unfit and say so")(
      "runs", po::value(&command.runs)->value_name("N"), "speed: runs of each, interleaved; default 3")(
      "time-limit", po::value(&command.limits.seconds)->value_name("SECONDS"),
      "for one run; default 600, 0: none")("memory-limit",
                                           po::value(&command.limits.memory_mb)->value_name("MB"),
                                           "address space of one run; default 0: none");

  po::options_description results("Results", 100);
  results.add_options()("csv", text(&command.csv, "FILE"),
                        "one row a run; what is in it already is not done again")(
      "fresh", po::bool_switch(&command.fresh), "do all again")("markdown", text(&command.markdown, "FILE"),
                                                                "the tables; default: printed")(
      "peer", text(&command.peer, "METHOD"), "what ratios are taken against; default cgal-advancing-front")(
      "by-shape", po::bool_switch(&command.by_shape),
      "quality: a table for every shape, not the mean over them")("keep", text(&command.keep, "DIR"),
                                                                  "keep the clouds and the meshes there")(
      "output,o", text(&command.output, "FILE"), "sheet: the picture; sample: the cloud")(
      "view", text(&command.view, "AZ,EL"), "sheet: as for mesh_snapshot")(
      "up", text(&command.up, "y|z"), "sheet: as for mesh_snapshot")("help", "print this text");

  po::options_description all;
  all.add(clouds).add(runs).add(results);
  return all;
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');)
    if (!word.empty()) words.push_back(word);
  return words;
}

template <class Number>
Number number(const std::string& word, const std::string& option) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw UsageError("--" + option + " does not take \"" + word + "\"");
  return value;
}

/// A whole number, perhaps with a K or an M behind it.
std::int64_t count(const std::string& word) {
  std::string digits = word;
  std::int64_t unit = 1;
  if (!digits.empty() && (digits.back() == 'K' || digits.back() == 'M')) {
    unit = digits.back() == 'K' ? 1000 : 1000000;
    digits.pop_back();
  }
  const auto value = number<std::int64_t>(digits, "points");
  if (value < 1 || value > 100000000) throw UsageError("--points takes numbers from 1 to 100M");
  return value * unit;
}

std::vector<double> shares(const std::string& list, const std::string& option) {
  std::vector<double> values;
  for (const std::string& word : split(list)) {
    values.push_back(number<double>(word, option));
    if (!(values.back() >= 0 && values.back() <= 1))
      throw UsageError("--" + option + " takes shares from 0 to 1");
  }
  if (values.empty()) throw UsageError("--" + option + " needs a value");
  return values;
}

std::vector<Noise> noises(const std::string& list) {
  std::vector<Noise> values;
  for (std::string word : split(list)) {
    const bool in_spacings = word.back() == 's';
    if (in_spacings) word.pop_back();
    values.push_back({shares(word, "noise").front(), in_spacings});
  }
  if (values.empty()) throw UsageError("--noise needs a value");
  return values;
}

CommandLine::Mode mode_of(const std::string& word) {
  if (word == "quality") return CommandLine::Mode::Quality;
  if (word == "speed") return CommandLine::Mode::Speed;
  if (word == "sheet") return CommandLine::Mode::Sheet;
  if (word == "sample") return CommandLine::Mode::Sample;
  throw UsageError("\"" + word + "\" is none of quality, speed, sheet, sample; --help tells more");
}

void read_lists(CommandLine& command, const Lists& lists) {
  std::vector<std::pair<std::string, std::string>> where;
  for (const std::string& wish : lists.where) {
    const std::size_t at = wish.find('=');
    if (at == std::string::npos) throw UsageError("--where takes COLUMN=VALUE");
    where.emplace_back(wish.substr(0, at), wish.substr(at + 1));
  }
  for (const std::string& file : lists.files)
    for (std::string& path : read_list(file, where)) command.inputs.push_back(std::move(path));
  command.methods = split(lists.methods);
  const bool speed = command.mode == CommandLine::Mode::Speed;
  const std::string sizes = !lists.points.empty() ? lists.points
                            : speed               ? "10K,50K,100K,200K,500K,1M"
                                                  : "10K";
  for (const std::string& word : split(sizes)) command.points.push_back(count(word));
  for (const std::string& word : split(lists.seeds))
    command.seeds.push_back(number<std::uint64_t>(word, "seeds"));
  try {
    for (const std::string& word : split(lists.sampling)) command.samplings.push_back(sampling_of(word));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  command.noise = noises(lists.noise);
  command.outliers = shares(lists.outliers, "outliers");
  command.missing = shares(lists.missing, "missing");
  if (command.points.empty() || command.seeds.empty() || command.samplings.empty())
    throw UsageError("--points, --seeds and --sampling need a value");
}

void check(const CommandLine& command) {
  using Mode = CommandLine::Mode;
  if (command.inputs.empty()) throw UsageError("a mesh, a cloud or a shape is needed; --help tells more");
  if (command.threads < 0 || command.threads > kMostThreads)
    throw UsageError("--threads takes numbers from 0 on");
  if (command.jobs < 1 || command.jobs > kMostThreads) throw UsageError("--jobs takes numbers from 1 on");
  if (command.runs < 1) throw UsageError("--runs takes numbers from 1 on");
  if (!(command.limits.seconds >= 0) || command.limits.memory_mb < 0)
    throw UsageError("a limit is a number from 0 on");
  const bool one_file = command.mode == Mode::Sheet || command.mode == Mode::Sample;
  if (one_file && command.output.empty()) throw UsageError("-o FILE is needed; --help tells more");
  if (one_file && command.points.size() * command.seeds.size() * command.samplings.size() *
                          command.noise.size() * command.outliers.size() * command.missing.size() >
                      1)
    throw UsageError("this takes one kind of cloud only");
  if (command.mode == Mode::Sample && command.inputs.size() > 1)
    throw UsageError("this takes one input only");
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine command;
  command.peer = "cgal-advancing-front";
  command.limits.seconds = 600;
  Lists lists;
  po::options_description all = options(command, lists);
  std::vector<std::string> words;
  all.add_options()("input", po::value(&words));
  po::positional_options_description positional;
  positional.add("input", -1);
  try {
    using namespace po::command_line_style;
    const int style = allow_long | long_allow_adjacent | long_allow_next | allow_short |
                      allow_dash_for_short | short_allow_next;
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given);
    po::notify(given);
    if (given.count("help")) return command;
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
  if (words.empty()) throw UsageError("quality, speed, sheet or sample must come first; --help tells more");
  command.mode = mode_of(words[0]);
  command.inputs.assign(words.begin() + 1, words.end());
  read_lists(command, lists);
  check(command);
  return command;
}

std::string usage() {
  CommandLine command;
  Lists lists;
  std::ostringstream out;
  out << "usage: compare quality INPUT.. [options]       every method on every cloud, judged by mesh_report\n"
         "       compare speed INPUT [options]           ours beside Delaunay and advancing front, by size\n"
         "       compare sheet INPUT.. -o OUT.png        pictures: a row a cloud, a column a method\n"
         "       compare sample INPUT -o CLOUD.ply       the cloud alone\n\n"
         "An INPUT is a mesh to sample, a cloud, or one of the shapes that the README lists.\n\n"
      << options(command, lists);
  return out.str();
}

}  // namespace filmsticking::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <sstream>

#include "clouds/scan_kinds.h"
#include "common/arguments.h"
#include "input.h"

namespace filmsticking::bench {
namespace {

using app::Arguments;

constexpr int kMostThreads = 4096;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The texts of the options that hold lists.
struct Lists {
  std::vector<std::string> files, where;
  std::string methods, kinds, points, sampling = "monte-carlo", seeds = "1", noise = "0", outliers = "0",
                                      missing = "0";
};

void add_clouds(Arguments& arguments, Lists& lists) {
  arguments.group("Clouds (lists are separated by commas; all combinations are made)");
  arguments.repeatable("--list", "FILE",
                       "take the inputs from a file: one path a line, or a .tsv table with a column \"file\"",
                       lists.files);
  arguments.repeatable("--where", "COLUMN=VALUE", "only such rows of a .tsv table; repeatable", lists.where);
  arguments.option("--points", "N,..", "how many, like 10K; speed: default 10K,50K,100K,200K,500K,1M",
                   lists.points);
  arguments.option("--sampling", "S,..",
                   "monte-carlo (default), poisson-disk, mixed-density, vertices, depth-view, depth-frame",
                   lists.sampling);
  arguments.option("--seeds", "N,..", "default 1", lists.seeds);
  arguments.option("--noise", "X,..",
                   "Gaussian, its deviation as a share of the diagonal, or with an s behind it, of the "
                   "spacing; default 0",
                   lists.noise);
  arguments.option("--outliers", "X,..", "share of the points; default 0", lists.outliers);
  arguments.option("--missing", "X,..", "share of the surface, in round patches; default 0", lists.missing);
  arguments.option("--kinds", "K,..", "scans: default all; --help lists them", lists.kinds);
}

void add_runs(Arguments& arguments, CommandLine& command, Lists& lists) {
  arguments.group("Runs");
  arguments.option("--methods", "M,..", "default: all that make a mesh; --help lists them", lists.methods);
  arguments.count("--threads", "N", "for every method that has threads; 0, the default: all", command.threads,
                  0, kMostThreads);
  arguments.count("--jobs", "N", "clouds at once; the timings are then unfit and say so", command.jobs, 1,
                  kMostThreads);
  arguments.count("--runs", "N", "speed: runs of each, interleaved; default 3", command.runs, 1);
  arguments.number("--time-limit", "SECONDS", "for one run; default 600, 0: none", command.limits.seconds, 0,
                   kNoLimit);
  arguments.count("--memory-limit", "MB", "address space of one run; default 0: none",
                  command.limits.memory_mb, 0);
}

void add_results(Arguments& arguments, CommandLine& command) {
  arguments.group("Results");
  arguments.option("--csv", "FILE", "one row a run; a run that is in it already is not done again",
                   command.csv);
  arguments.flag("--fresh", "do all again", command.fresh);
  arguments.option("--markdown", "FILE", "the tables; default: printed", command.markdown);
  arguments.option("--peer", "METHOD", "what ratios are taken against; default cgal-advancing-front",
                   command.peer);
  arguments.flag("--by-shape", "quality: a table for every shape, not the mean over them", command.by_shape);
  arguments.option("--keep", "DIR", "keep the clouds and the meshes there", command.keep);
  arguments.option("-o,--output", "FILE", "sheet: the picture; sample: the cloud", command.output);
  arguments.option("--view", "AZ,EL", "sheet: as for mesh_snapshot", command.view);
  arguments.option("--up", "y|z", "sheet: as for mesh_snapshot", command.up);
}

void add_options(Arguments& arguments, CommandLine& command, Lists& lists) {
  arguments.only_flag("--help", "print this text", command.help);
  add_clouds(arguments, lists);
  add_runs(arguments, command, lists);
  add_results(arguments, command);
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
  for (const std::string& word : split_list(list)) {
    values.push_back(number<double>(word, option));
    if (!(values.back() >= 0 && values.back() <= 1))
      throw UsageError("--" + option + " takes shares from 0 to 1");
  }
  if (values.empty()) throw UsageError("--" + option + " needs a value");
  return values;
}

std::vector<Noise> noises(const std::string& list) {
  std::vector<Noise> values;
  for (std::string word : split_list(list)) {
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
  if (word == "scans") return CommandLine::Mode::Scans;
  if (word == "normals") return CommandLine::Mode::Normals;
  if (word == "berger") return CommandLine::Mode::Berger;
  throw UsageError("\"" + word +
                   "\" is none of quality, speed, sheet, sample, scans, normals, berger; see --help");
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
  command.methods = split_list(lists.methods);
  command.kinds = split_list(lists.kinds);
  const bool speed = command.mode == CommandLine::Mode::Speed;
  const std::string sizes = !lists.points.empty() ? lists.points
                            : speed               ? "10K,50K,100K,200K,500K,1M"
                                                  : "10K";
  for (const std::string& word : split_list(sizes)) command.points.push_back(count(word));
  for (const std::string& word : split_list(lists.seeds))
    command.seeds.push_back(number<std::uint64_t>(word, "seeds"));
  try {
    for (const std::string& word : split_list(lists.sampling)) command.samplings.push_back(sampling_of(word));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  command.noise = noises(lists.noise);
  command.outliers = shares(lists.outliers, "outliers");
  command.missing = shares(lists.missing, "missing");
  if (command.points.empty() || command.seeds.empty() || command.samplings.empty())
    throw UsageError("--points, --seeds and --sampling need a value");
}

void check_kinds(const CommandLine& command) {
  if (!command.inputs.empty()) throw UsageError("scans takes no inputs; --kinds chooses");
  const std::vector<ScanKind> known = scan_kinds();
  for (const std::string& name : command.kinds)
    if (std::none_of(known.begin(), known.end(), [&](const ScanKind& kind) { return name == kind.name; }))
      throw UsageError("there is no kind of scan \"" + name + "\"; see --help");
}

void check(const CommandLine& command) {
  using Mode = CommandLine::Mode;
  if (command.mode == Mode::Scans) return check_kinds(command);
  if (!command.kinds.empty()) throw UsageError("--kinds is for scans only");
  if (command.mode == Mode::Berger && command.inputs.size() != 1)
    throw UsageError("berger takes one folder; see --help");
  if (command.inputs.empty()) throw UsageError("a mesh, a cloud or a shape is needed; see --help");
  const bool one_file = command.mode == Mode::Sheet || command.mode == Mode::Sample;
  if (one_file && command.output.empty()) throw UsageError("-o FILE is needed; see --help");
  if (one_file && command.points.size() * command.seeds.size() * command.samplings.size() *
                          command.noise.size() * command.outliers.size() * command.missing.size() >
                      1)
    throw UsageError("this takes one kind of cloud only");
  if (command.mode == Mode::Sample && command.inputs.size() > 1)
    throw UsageError("this takes one input only");
}

}  // namespace

std::vector<std::string> split_list(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');)
    if (!word.empty()) words.push_back(word);
  return words;
}

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine command;
  Lists lists;
  Arguments arguments;
  add_options(arguments, command, lists);
  if (!arguments.parse(argc, argv)) return command;
  const std::vector<std::string>& words = arguments.files();
  if (words.empty())
    throw UsageError("quality, speed, sheet, sample, scans, normals or berger must come first; see --help");
  command.mode = mode_of(words[0]);
  command.inputs.assign(words.begin() + 1, words.end());
  read_lists(command, lists);
  check(command);
  return command;
}

std::string usage() {
  CommandLine command;
  Lists lists;
  Arguments arguments;
  add_options(arguments, command, lists);
  return R"(usage: compare quality INPUT.. [options]       every method on every cloud, judged by mesh_report
       compare speed INPUT [options]           ours beside Delaunay and advancing front, by size
       compare sheet INPUT.. -o OUT.png        pictures: a row a cloud, a column a method
       compare sample INPUT -o CLOUD.ply       the cloud alone
       compare scans [options]                 kinds of scans whose right answer is known
       compare normals INPUT.. [options]       signs of oriented normals: ours, PCL's and CGAL's
       compare berger FOLDER [options]         scans with their cameras: overlap with the true solids

An INPUT is a mesh to sample, a cloud, or one of the shapes that the README lists.
)" + arguments.help();
}

}  // namespace filmsticking::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed_table.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include "markdown.h"
#include "statistics.h"

namespace filmsticking::bench {
namespace {

constexpr char kDelaunay[] = "delaunay";

std::string threads_text(int threads) { return threads > 0 ? std::to_string(threads) : "all"; }

std::string title_of(const Series& series) {
  if (series.method.rfind("ours", 0) != 0) return series.method;
  return series.method +
         (series.threads == 1 ? ", 1 thread" : ", " + threads_text(series.threads) + " threads");
}

/// The runs on one shape and kind of cloud.
class Board {
 public:
  void add(const Row& row) {
    const auto points = row.number("points");
    if (!points) return;
    sizes_[*points];
    if (row.ended_well()) cells_[{row.text("method"), row.text("threads")}][*points].push_back(&row);
  }

  std::vector<double> sizes() const {
    std::vector<double> all;
    for (const auto& entry : sizes_) all.push_back(entry.first);
    return all;
  }

  std::optional<double> median_of(const Series& series, double points, const std::string& column) const {
    std::vector<double> values;
    for (const Row* row : runs(series, points))
      if (const auto value = row->number(column)) values.push_back(*value);
    return median(values);
  }

  /// The stages of the run whose time is the median (the lower of the two middle ones).
  std::vector<std::pair<std::string, double>> stages(const Series& series, double points) const {
    std::vector<const Row*> all = runs(series, points);
    if (all.empty()) return {};
    std::sort(all.begin(), all.end(),
              [](const Row* a, const Row* b) { return a->number("seconds") < b->number("seconds"); });
    std::vector<std::pair<std::string, double>> stages;
    std::istringstream list(all[(all.size() - 1) / 2]->text("rooms"));
    for (std::string entry; std::getline(list, entry, ';');) {
      const std::size_t at = entry.rfind('=');
      if (at != std::string::npos)
        stages.emplace_back(entry.substr(0, at), std::strtod(entry.c_str() + at + 1, nullptr));
    }
    return stages;
  }

 private:
  std::vector<const Row*> runs(const Series& series, double points) const {
    const auto cell = cells_.find({series.method, threads_text(series.threads)});
    if (cell == cells_.end()) return {};
    const auto found = cell->second.find(points);
    return found == cell->second.end() ? std::vector<const Row*>() : found->second;
  }

  std::map<double, int> sizes_;
  std::map<std::pair<std::string, std::string>, std::map<double, std::vector<const Row*>>> cells_;
};

std::optional<double> over(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b || !(*b > 0)) return std::nullopt;
  return *a / *b;
}

std::string size_text(double points) { return std::to_string(static_cast<long long>(points)); }

/// A row a size; the cells of `series` by `cell`.
template <class Cell>
std::string table_by_size(const Board& board, const std::vector<Series>& series, const std::string& what,
                          const Cell& cell) {
  std::vector<std::vector<std::string>> table = {{"points"}};
  for (const Series& one : series) table[0].push_back(title_of(one));
  for (const double points : board.sizes()) {
    table.push_back({size_text(points)});
    for (const Series& one : series) table.back().push_back(rounded(cell(one, points), 3));
  }
  return what + "\n\n" + markdown_table(table) + "\n";
}

std::string growth_table(const Board& board, const std::vector<Series>& series) {
  std::vector<std::vector<std::string>> table = {{"method", "exponent of growth"}};
  for (const Series& one : series) {
    std::vector<std::pair<double, double>> points;
    for (const double n : board.sizes())
      if (const auto seconds = board.median_of(one, n, "seconds"); seconds && *seconds > 0)
        points.emplace_back(n, *seconds);
    table.push_back({title_of(one), rounded(growth_exponent(points), 3)});
  }
  return "How the seconds grow: the p of seconds = c points^p, least squares on the logarithms.\n\n" +
         markdown_table(table) + "\n";
}

std::string stage_table(const Board& board, const Series& series) {
  std::vector<std::string> names;
  for (const double points : board.sizes())
    for (const auto& stage : board.stages(series, points))
      if (std::find(names.begin(), names.end(), stage.first) == names.end()) names.push_back(stage.first);
  if (names.empty()) return "";
  std::vector<std::vector<std::string>> table = {{"stage"}};
  for (const double points : board.sizes()) table[0].push_back(size_text(points));
  for (const std::string& name : names) {
    table.push_back({name});
    for (const double points : board.sizes()) {
      double all = 0, own = 0;
      for (const auto& [stage, seconds] : board.stages(series, points)) {
        all += seconds;
        if (stage == name) own += seconds;
      }
      table.back().push_back(all > 0 ? rounded(100 * own / all, 3) : "-");
    }
  }
  return "Stages of " + title_of(series) + ", % of the time in all of them, by points.\n\n" +
         markdown_table(table) + "\n";
}

}  // namespace

std::string speed_tables(const std::vector<Row>& rows, const std::vector<Series>& series,
                         const std::string& peer) {
  std::map<std::string, Board> boards;
  std::vector<std::string> titles;
  for (const Row& row : rows) {
    const std::string title = row.text("shape") + ", " + row.text("kind");
    if (!boards.count(title)) titles.push_back(title);
    boards[title].add(row);
  }
  // The peers run on one thread or on what was asked for; a ratio is to their own entry.
  const auto seconds_of = [&](const Board& board, const std::string& method, double points) {
    for (const Series& one : series)
      if (one.method == method)
        if (const auto seconds = board.median_of(one, points, "seconds")) return seconds;
    return std::optional<double>();
  };

  std::string text;
  for (const std::string& title : titles) {
    const Board& board = boards[title];
    const auto seconds = [&](const Series& one, double points) {
      return board.median_of(one, points, "seconds");
    };
    text += "### " + title + "\n\n";
    text += table_by_size(board, series, "Seconds, median of the runs.", seconds);
    text +=
        table_by_size(board, series, "Seconds over those of the Delaunay triangulation of the same points.",
                      [&](const Series& one, double points) {
                        return over(seconds(one, points), seconds_of(board, kDelaunay, points));
                      });
    text += table_by_size(board, series, "Seconds over those of " + peer + ".",
                          [&](const Series& one, double points) {
                            return over(seconds(one, points), seconds_of(board, peer, points));
                          });
    text += table_by_size(
        board, series, "Memory in bytes a point: the peak less what the process held before.",
        [&](const Series& one, double points) { return board.median_of(one, points, "bytes_per_point"); });
    text += growth_table(board, series);
    for (const Series& one : series) text += stage_table(board, one);
  }
  return text;
}

}  // namespace filmsticking::bench

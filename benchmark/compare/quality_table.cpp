// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality_table.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "markdown.h"
#include "statistics.h"

namespace filmsticking::bench {
namespace {

using Rows = std::vector<const Row*>;

/// Of the rows that know the column.
std::vector<double> values_of(const Rows& rows, const std::string& column) {
  std::vector<double> values;
  for (const Row* row : rows)
    if (const auto value = row->number(column)) values.push_back(*value);
  return values;
}

std::optional<double> mean_of(const Rows& rows, const std::string& column) {
  return mean(values_of(rows, column));
}

/// Mean and standard deviation.
std::string spread_of(const Rows& rows, const std::string& column, int digits) {
  const std::vector<double> values = values_of(rows, column);
  const auto deviation = standard_deviation(values);
  return rounded(mean(values), digits) + (deviation ? " ± " + rounded(deviation, digits) : "");
}

/// Percent of all rows, so that a run that failed counts against its method; nothing where no row can know.
std::optional<double> share_of(const Rows& rows, const std::string& needed,
                               const std::function<bool(const Row&)>& good) {
  const auto knows = [&](const Row* row) { return !row->text(needed).empty(); };
  if (std::none_of(rows.begin(), rows.end(), knows)) return std::nullopt;
  const auto count =
      std::count_if(rows.begin(), rows.end(), [&](const Row* row) { return knows(row) && good(*row); });
  return 100.0 * static_cast<double>(count) / static_cast<double>(rows.size());
}

std::string cloud_of(const Row& row) {
  return row.text("shape") + '\n' + row.text("kind") + '\n' + row.text("points") + '\n' + row.text("seed");
}

/// The geometric mean of the ratios on the clouds where both have a positive value.
std::optional<double> ratio(const Rows& rows, const Rows& peer, const std::string& column) {
  std::map<std::string, double> of_peer;
  for (const Row* row : peer)
    if (const auto value = row->number(column)) of_peer[cloud_of(*row)] = *value;
  std::vector<double> ratios;
  for (const Row* row : rows) {
    const auto value = row->number(column);
    const auto other = of_peer.find(cloud_of(*row));
    if (value && *value > 0 && other != of_peer.end() && other->second > 0)
      ratios.push_back(*value / other->second);
  }
  return geometric_mean(ratios);
}

/// Has the cloud as many points as its file, rather than as many as were asked for?
bool own_size(const Row& row) {
  return row.is("kind", "as it is") || row.text("kind").rfind("vertices", 0) == 0;
}

bool is_true(const Row& row, const char* column) { return row.is(column, "true"); }

std::vector<std::string> quality_cells(const std::string& method, const Rows& rows, const Rows& peer) {
  const auto ended =
      std::count_if(rows.begin(), rows.end(), [](const Row* row) { return row->ended_well(); });
  const auto percent = [](const std::optional<double>& value) { return rounded(value, 3); };
  return {
      method,
      std::to_string(ended) + " of " + std::to_string(rows.size()),
      percent(share_of(rows, "closed",
                       [](const Row& r) { return is_true(r, "closed") && is_true(r, "manifold"); })),
      percent(share_of(rows, "topology_right", [](const Row& r) { return is_true(r, "topology_right"); })),
      percent(share_of(rows, "self_intersections",
                       [](const Row& r) { return r.number("self_intersections") == 0.0; })),
      rounded(mean_of(rows, "interpolated"), 5),
      rounded(mean_of(rows, "boundary_edges"), 3),
      rounded(mean_of(rows, "non_manifold_edges"), 3),
      rounded(mean_of(rows, "non_manifold_vertices"), 3),
      rounded(mean_of(rows, "self_intersections"), 3),
      rounded(mean_of(rows, "components"), 3),
      rounded(mean_of(rows, "chamfer_e3"), 4),
      rounded(ratio(rows, peer, "chamfer_e3"), 3),
      rounded(mean_of(rows, "f_score"), 4),
      rounded(mean_of(rows, "normal_consistency"), 4),
      rounded(mean_of(rows, "turned_over"), 3),
      rounded(mean_of(rows, "hausdorff"), 3),
      rounded(mean_of(rows, "sharp_edges_restored"), 4)};
}

std::vector<std::string> cost_cells(const std::string& method, const Rows& rows, const Rows& peer) {
  return {method,
          rounded(mean_of(rows, "seconds"), 3),
          rounded(mean_of(rows, "seconds_with_needs"), 3),
          rounded(ratio(rows, peer, "seconds_with_needs"), 3),
          rounded(mean_of(rows, "cpu_seconds"), 3),
          rounded(mean_of(rows, "memory_mb"), 3)};
}

/// As in the tables of the paper (section 6).
std::vector<std::string> spread_cells(const std::string& method, const Rows& rows) {
  return {method,
          spread_of(rows, "normal_consistency", 4),
          spread_of(rows, "chamfer_e3", 4),
          spread_of(rows, "f_score", 4),
          spread_of(rows, "steps", 3),
          rounded(mean_of(rows, "fields"), 3)};
}

/// What went wrong, if something did.
std::string failures(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows)
    if (!row.ended_well())
      text += "- " + row.text("method") + " on " + row.text("shape") + ", " + row.text("kind") + ", " +
              row.text("points") + " points, seed " + row.text("seed") + ": " + row.text("status") +
              (row.text("message").empty() ? "" : " (" + row.text("message") + ")") + "\n";
  return text.empty() ? "" : "Runs without a result:\n\n" + text;
}

}  // namespace

std::string quality_tables(const std::vector<Row>& rows, const std::vector<std::string>& methods,
                           const std::string& peer, bool by_shape) {
  std::map<std::string, std::map<std::string, Rows>> groups;  // title, method
  std::vector<std::string> titles;
  for (const Row& row : rows) {
    const std::string title = (by_shape ? row.text("shape") + ", " : "") + row.text("kind") + ", " +
                              (own_size(row) ? "" : row.text("points") + " ") + "points";
    if (!groups.count(title)) titles.push_back(title);
    groups[title][row.text("method")].push_back(&row);
  }

  std::string text;
  for (const std::string& title : titles) {
    std::map<std::string, Rows>& group = groups[title];
    std::vector<std::vector<std::string>> quality = {
        {"method", "clouds", "closed and manifold %", "topology right %", "no self-intersection %",
         "interpolated %", "boundary edges", "non-manifold edges", "non-manifold vertices",
         "intersecting pairs", "components", "Chamfer x1e3", "x peer", "F-score", "normals %",
         "turned over %", "Hausdorff", "sharp edges %"}};
    std::vector<std::vector<std::string>> cost = {
        {"method", "seconds alone", "with needs", "x peer", "CPU seconds", "peak MB"}};
    std::vector<std::vector<std::string>> spread = {
        {"method", "normals %", "Chamfer x1e3", "F-score", "film steps", "fields"}};
    for (const std::string& method : methods) {
      quality.push_back(quality_cells(method, group[method], group[peer]));
      cost.push_back(cost_cells(method, group[method], group[peer]));
      spread.push_back(spread_cells(method, group[method]));
    }
    text += "### " + title + "\n\n" + markdown_table(quality) + "\n" + markdown_table(cost) +
            "\nMean ± standard deviation over the clouds:\n\n" + markdown_table(spread) + "\n";
  }
  text += "x peer: ratio to " + peer + ", geometric mean over the clouds that both ended on.\n";
  if (std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.is("timing", "unfit"); }))
    text += "Several clouds were worked on at once: the seconds are not fit to be compared.\n";
  const std::string wrong = failures(rows);
  return text + (wrong.empty() ? "" : "\n" + wrong);
}

}  // namespace filmsticking::bench

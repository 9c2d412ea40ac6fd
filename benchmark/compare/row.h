// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace filmsticking::bench {

/// The columns of the table in their order; the README explains them. The first identify the run: no two rows
/// agree in all of them.
const std::vector<std::string>& columns();

/// The last of them, which mesh_report gives under the same names.
const std::vector<std::string>& judged_columns();
constexpr std::size_t kKeyColumns = 7;

/// One run of one method on one cloud: texts by column; an empty text: unknown.
class Row {
 public:
  void set(const std::string& column, const std::string& text);
  void set(const std::string& column, double value);
  const std::string& text(const std::string& column) const;
  std::optional<double> number(const std::string& column) const;  ///< nothing where it is not a number
  bool is(const std::string& column, const std::string& text) const { return this->text(column) == text; }
  bool ended_well() const { return is("status", "ok"); }

  /// The run that the row is a result of.
  std::string key() const;

 private:
  std::map<std::string, std::string> texts_;
};

/// A number in the fewest digits that read back as the same.
std::string to_text(double value);

}  // namespace filmsticking::bench

// SPDX-License-Identifier: GPL-3.0-or-later
// The small parts that the tables are made with.
#include "compare/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/csv.h"
#include "compare/markdown.h"
#include "compare/row.h"

namespace filmsticking::bench {
namespace {

TEST(Statistics, Means) {
  EXPECT_FALSE(mean({}));
  EXPECT_FALSE(median({}));
  EXPECT_FALSE(geometric_mean({}));
  EXPECT_DOUBLE_EQ(*mean({1, 2, 6}), 3);
  EXPECT_DOUBLE_EQ(*median({9, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(*median({9, 1, 2, 4}), 3);
  EXPECT_NEAR(*geometric_mean({1, 4, 16}), 4, 1e-12);
  EXPECT_FALSE(standard_deviation({}));
  EXPECT_DOUBLE_EQ(*standard_deviation({3}), 0);
  EXPECT_DOUBLE_EQ(*standard_deviation({1, 3, 5, 7}), std::sqrt(5));
}

TEST(Statistics, GrowthExponent) {
  EXPECT_FALSE(growth_exponent({}));
  EXPECT_FALSE(growth_exponent({{10, 1}, {10, 2}}));
  EXPECT_NEAR(*growth_exponent({{1e4, 3}, {1e5, 3 * std::pow(10, 1.2)}, {1e6, 3 * std::pow(100, 1.2)}}), 1.2,
              1e-12);
}

TEST(Statistics, CsvComesBackAsItWas) {
  const std::vector<std::string> fields = {"", "plain", "a, b", "say \"no\"", "", "\"", "x"};
  const std::string line = csv_line(fields);
  ASSERT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_EQ(csv_fields(line.substr(0, line.size() - 1)), fields);
  EXPECT_EQ(csv_line({"two\nlines"}), "\"two lines\"\n");
}

TEST(Statistics, NumbersForPeople) {
  EXPECT_EQ(rounded(std::nullopt, 3), "-");
  EXPECT_EQ(rounded(0.0, 3), "0");
  EXPECT_EQ(rounded(1234.5, 3), "1234");
  EXPECT_EQ(rounded(12.34, 3), "12.3");
  EXPECT_EQ(rounded(-1.234, 3), "-1.23");
  EXPECT_EQ(rounded(0.01234, 3), "0.0123");
}

TEST(Statistics, ARowKnowsNumbersFromTexts) {
  Row row;
  row.set("genus", 2.0);
  row.set("message", "2 of them");
  EXPECT_EQ(row.number("genus"), 2.0);
  EXPECT_FALSE(row.number("message"));
  EXPECT_FALSE(row.number("seconds"));
  EXPECT_THROW(row.set("no such column", 1.0), std::logic_error);
}

}  // namespace
}  // namespace filmsticking::bench

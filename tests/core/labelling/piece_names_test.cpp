// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/piece_names.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

// Pieces of one label among the tetrahedra of a part and beside it, by a search of the whole mesh.
std::set<Index> pieces_near(const Setting& s, const std::vector<char>& inside, const Move& part, char label) {
  std::vector<Index> piece;
  label_pieces(s.mesh, inside, piece);
  std::set<Index> near;
  for (Index t : part) {
    if (inside[t] == label) near.insert(piece[t]);
    for (Index u : s.mesh.tets.neighbours[t])
      if (inside[u] == label) near.insert(piece[u]);
  }
  return near;
}

TEST(PieceNames, AreTheSameWhereTetrahedraAreConnected) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::torus(120, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed, 1 + static_cast<int>(seed % 3)));
    PieceNames names;
    names.name(l.labelling);
    std::vector<Index> piece;
    EXPECT_EQ(names.count(), label_pieces(s.mesh, l.inside, piece));
    for (std::size_t t = 0; t < s.mesh.size(); ++t)
      for (std::size_t u = 0; u < s.mesh.size(); u += 37)
        ASSERT_EQ(names.of(static_cast<Index>(t)) == names.of(static_cast<Index>(u)), piece[t] == piece[u]);
  }
}

TEST(PieceNames, PartedIsWhatASearchOfTheWholeMeshSays) {
  int parted = 0, whole = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Setting s(test::torus(150, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed, 1 + static_cast<int>(seed % 4)));
    test::Random random(seed);
    PieceNames names;
    names.name(l.labelling);
    for (int i = 0; i < 40; ++i) {
      const Move part = test::random_part(s, l.inside, random, 1 + i % 9);
      std::size_t pieces = 0;
      for (const char label : {char{0}, char{1}}) {
        const std::size_t near = pieces_near(s, l.inside, part, label).size();
        pieces += near;
        EXPECT_EQ(names.parted(l.labelling, part, label, std::numeric_limits<std::size_t>::max()), near > 1);
        ++(near > 1 ? parted : whole);
        EXPECT_FALSE(names.parted(l.labelling, part, label, 0));
      }
      EXPECT_EQ(names.count_around(l.labelling, part), static_cast<int>(pieces));
    }
  }
  EXPECT_GT(parted, 100);
  EXPECT_GT(whole, 100);
}

// A part is relabelled where that joins pieces, and the names follow.
TEST(PieceNames, FollowAPartThatJoinsPieces) {
  int joined = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Setting s(test::torus(150, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed, 1 + static_cast<int>(seed % 4)));
    test::Random random(seed);
    PieceNames names;
    names.name(l.labelling);
    for (int i = 0; i < 60; ++i) {
      const Move part = test::random_part(s, l.inside, random, 1 + i % 3);
      for (Index t : part) l.labelling.flip(t);
      if (pieces_near(s, l.inside, part, 0).size() > 1 || pieces_near(s, l.inside, part, 1).size() > 1) {
        for (Index t : part) l.labelling.flip(t);
        continue;
      }
      ++joined;
      names.unite_around(l.labelling, part);
      std::vector<Index> piece;
      label_pieces(s.mesh, l.inside, piece);
      for (std::size_t t = 0; t < s.mesh.size(); ++t)
        for (Index u : s.mesh.tets.neighbours[t])
          ASSERT_EQ(names.of(static_cast<Index>(t)) == names.of(u), piece[t] == piece[u]) << seed;
    }
  }
  EXPECT_GT(joined, 20);
}

}  // namespace
}  // namespace filmsticking

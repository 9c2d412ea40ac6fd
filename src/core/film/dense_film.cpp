// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/dense_film.h"

#include <algorithm>
#include <utility>

#include "evidence/ball.h"
#include "film/power_complex.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

/// Takes what the rules take. `inside`: 1, or 0 once a tetrahedron has left.
class DenseFilm {
 public:
  DenseFilm(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites, const std::vector<double>& spacing,
            double width)
      : mesh_(mesh), wide_(wide_facets(mesh, sites, spacing, width)), inside_(mesh.size(), 1) {
    for (std::size_t t = 0; t < mesh.size(); ++t)
      if (mesh.tets.infinite(static_cast<Index>(t))) leave(static_cast<Index>(t));
  }

  const std::vector<char>& inside() const { return inside_; }
  void search(const std::vector<Vec3>& sites) { flow_ = flow_map(mesh_, sites, inside_); }

  // Through wide facets, from all that left since the last call. `layers`: at most so many facets deep.
  bool through_wide_facets(int layers) {
    bool any = false;
    for (; layers > 0 && !front_.empty(); --layers) {
      std::vector<Index> front = std::exchange(front_, {});
      for (const Index t : front)
        for (int k = 0; k < 4; ++k)
          if (const Index u = mesh_.tets.neighbours[t][k]; inside_[u] && (wide_[t] >> k & 1))
            leave(u), any = true;
    }
    return any;
  }

  // By one film step.
  bool step() {
    std::vector<char> leaves(inside_.size(), 0);
    parallel_each(leaves.size(),
                  [&](std::size_t t) { leaves[t] = static_cast<char>(inside_[t] && !inside_[flow_[t]]); });
    bool any = false;
    for (std::size_t t = 0; t < leaves.size(); ++t)
      if (leaves[t]) leave(static_cast<Index>(t)), any = true;
    return any;
  }

 private:
  static std::vector<char> wide_facets(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                       const std::vector<double>& spacing, double width) {
    std::vector<char> wide(mesh.size(), 0);
    parallel_each(mesh.size(), [&](std::size_t t) {
      for (int k = 0; k < 4; ++k)
        if (facet_width(mesh, sites, spacing, static_cast<Index>(t), k) >= width)
          wide[t] = static_cast<char>(wide[t] | 1 << k);
    });
    return wide;
  }

  void leave(Index t) { inside_[t] = 0, front_.push_back(t); }

  const TetrahedralMesh& mesh_;
  const std::vector<char> wide_;  // [tetrahedron]: its wide facets, as bits
  std::vector<char> inside_;
  std::vector<Index> front_;  // left, and nothing has followed through their facets yet
  UnsetVector<Index> flow_;   // of those that were inside at search()
};

}  // namespace

std::vector<char> dense_film(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                             const std::vector<double>& spacing, double width,
                             const std::function<void(const std::vector<char>&)>& after_step) {
  DenseFilm film(mesh, sites, spacing, width);
  constexpr int kAll = 1 << 30;
  const int layers = after_step ? 1 : kAll;
  if (!after_step) film.through_wide_facets(kAll);  // spares the search for most of the outside
  film.search(sites);
  // Ends: each turn but the last takes a tetrahedron.
  for (bool moved = true; moved;) {
    moved = film.through_wide_facets(layers);
    moved = film.step() || moved;
    if (after_step && moved) after_step(film.inside());
  }
  return film.inside();
}

}  // namespace filmsticking

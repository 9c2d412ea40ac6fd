// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a closed manifold, sites and weights: film steps end, on a closed film.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "film/attraction_weights.h"
#include "film/film_step.h"
#include "film/initial_surface.h"
#include "filmsticking/reconstruct.h"
#include "geometry/triangle_adjacency.h"
#include "target.h"

namespace filmsticking::test {
namespace {

constexpr std::size_t kMostTriangles = 120, kMostSites = 40;

/// A number from -2 to 2; sixteenths, so that ties are common.
double coordinate(ByteReader& bytes) { return bytes.take<std::int8_t>() / 64.0; }

/// Now and then any number at all that is finite.
double far_coordinate(ByteReader& bytes) {
  const double x = bytes.take<double>();
  return std::isfinite(x) ? x : 0;
}

Vec3 place(ByteReader& bytes, bool far) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = far ? far_coordinate(bytes) : coordinate(bytes);
  return p;
}

/// A closed oriented manifold that changes step by step and stays one.
class Clay {
 public:
  Clay() { add_tetrahedron(); }

  std::vector<Corners> triangles;
  Index vertices = 0;

  void add_tetrahedron() {
    const Index v = vertices;
    vertices += 4;
    for (const Corners& t : {Corners{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      triangles.push_back({v + t[0], v + t[1], v + t[2]});
  }

  /// A vertex in the middle of a face.
  void split(int face) {
    const auto [a, b, c] = triangles[face];
    const Index v = vertices++;
    triangles[face] = {a, b, v};
    for (const Corners& t : {Corners{b, c, v}, {c, a, v}}) triangles.push_back(t);
  }

  /// The other diagonal of two neighbouring faces; nothing where it is an edge already.
  void flip(int face, int corner) {
    const auto [a, b, c] = turned(triangles[face], corner);
    for (Corners& other : triangles)
      for (int k = 0; k < 3; ++k) {
        const auto [e, f, d] = turned(other, k);
        if (e != b || f != a) continue;
        if (c == d || has_edge(c, d)) return;
        other = {d, c, a};
        triangles[face] = {c, d, b};
        return;
      }
  }

  /// A tube between two faces: a handle, or a bridge between two parts. Nothing where that would not be a
  /// manifold.
  void join(int first, int second) {
    const Corners one = triangles[first], two = triangles[second];
    for (const Index v : one)
      for (const Index w : two)
        if (v == w || has_edge(v, w)) return;
    const auto [a, b, c] = one;
    const auto [d, e, f] = two;
    triangles.erase(triangles.begin() + std::max(first, second));
    triangles.erase(triangles.begin() + std::min(first, second));
    for (const Corners& t : {Corners{a, b, f}, {a, f, d}, {b, c, e}, {b, e, f}, {c, a, d}, {c, d, e}})
      triangles.push_back(t);
  }

 private:
  static Corners turned(const Corners& t, int k) { return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]}; }

  bool has_edge(Index v, Index w) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](const Corners& t) {
      return std::count(t.begin(), t.end(), v) > 0 && std::count(t.begin(), t.end(), w) > 0;
    });
  }
};

Clay take_clay(ByteReader& bytes) {
  Clay clay;
  for (int work = bytes.below(200); work > 0 && clay.triangles.size() < kMostTriangles; --work) {
    const int faces = static_cast<int>(clay.triangles.size());
    const int face = bytes.below(faces);
    switch (bytes.take<std::uint8_t>() % 8) {
      case 0:
        clay.add_tetrahedron();
        break;
      case 1:
        clay.join(face, bytes.below(faces));
        break;
      case 2:
      case 3:
        clay.split(face);
        break;
      default:
        clay.flip(face, bytes.below(3));
    }
  }
  return clay;
}

std::string fault_of(const LabelledFilm& film) {
  const Tetrahedra& tets = film.complex->tetrahedra();
  if (film.inside.size() != tets.size()) return "a tetrahedron has no label";
  for (std::size_t t = 0; t < tets.size(); ++t)
    if (film.inside[t] && tets.infinite(static_cast<Index>(t))) return "the film is not closed";
  return "";
}

/// Steps by any weights, then by those that attract.
void step(const Surface& first, const std::vector<Vec3>& sites, ByteReader& bytes) {
  std::vector<double> weights;
  for (std::size_t s = 0; s < sites.size(); ++s) weights.push_back(bytes.take<std::int8_t>() / 16.0);
  const std::vector<double> spacing(sites.size(), 0.1);
  const auto complex_of = [&] {
    return std::make_shared<const PowerComplex>(sites, weights, TriangulationLimits{});
  };
  auto complex = complex_of();
  if (complex->size() == 0) return;
  LabelledFilm film = film_within(enclosure(first), complex);
  for (int k = 0; k < 4; ++k) {
    std::int64_t held = 0;
    film = film_step(film, complex, spacing, k % 2 == 0, held);
    require_no_fault(fault_of(film));
    std::vector<Index> off;
    const std::vector<char> sides = site_sides(film);
    for (std::size_t s = 0; s < sites.size(); ++s)
      if (sides[s] != kOnFilm) off.push_back(static_cast<Index>(s));
    weights = attraction_weights(film_surface(film, sites.size()), sites, off);
    complex = complex_of();
    if (complex->size() == 0) return;
  }
}

/// The same by the library's entry.
void reconstruct_from(const Surface& film, const std::vector<Vec3>& sites) {
  std::vector<Point> points;
  for (const Vec3& p : sites) points.push_back({p.x(), p.y(), p.z()});
  Mesh mesh;
  for (const Vec3& p : film.positions) mesh.positions.push_back({p.x(), p.y(), p.z()});
  mesh.triangles.assign(film.triangles.begin(), film.triangles.end());
  Options options;
  options.threads = 1;
  options.method = Method::Film;
  options.film_start = FilmStart::Given;
  options.guiding_surface = std::make_shared<Mesh>(mesh);
  options.max_steps = 8, options.max_rounds = 1;
  const Result result = reconstruct(points, options);
  if (result.status == Status::Ok) {
    require_no_fault(check_manifold(result.triangles, static_cast<Index>(result.vertices.size())).ok()
                         ? ""
                         : "the result is no closed manifold");
  } else {
    require_no_fault(
        result.triangles.empty() && !result.message.empty() ? "" : "a failure has a mesh or no message");
    require_no_fault(result.status == Status::InternalError || result.status == Status::InvalidGuidingSurface
                         ? result.message
                         : "");
  }
}

}  // namespace
}  // namespace filmsticking::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace filmsticking;
  test::ByteReader bytes(data, size);
  const auto choices = bytes.take<std::uint8_t>();
  const bool whole = (choices & 1) != 0, far_film = (choices & 2) != 0,
             far_sites = (choices & 12) == 12 && whole;

  std::vector<Vec3> sites;
  for (int n = 4 + bytes.below(static_cast<int>(test::kMostSites) - 4); n > 0; --n)
    sites.push_back(test::place(bytes, far_sites));
  const test::Clay clay = test::take_clay(bytes);
  if (!check_manifold(clay.triangles, clay.vertices).ok()) std::abort();  // a fault of this file
  Surface film;
  film.triangles = clay.triangles;
  for (Index v = 0; v < clay.vertices; ++v) {
    const bool stands_on_site = !whole && v < static_cast<Index>(sites.size()) && bytes.below(2) == 1;
    film.site.push_back(stands_on_site ? v : kNone);
    film.positions.push_back(stands_on_site ? sites[v] : test::place(bytes, far_film));
  }
  if (whole) {
    test::reconstruct_from(film, sites);
  } else {
    test::step(film, sites, bytes);
  }
  return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/depth_image.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "evidence/layers.h"
#include "evidence/raster_viewpoint.h"
#include "geometry/every_nth.h"
#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/quantile.h"
#include "geometry/triangle_adjacency.h"
#include "surface/open_surface.h"

namespace filmsticking {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = Kernel::Point_2;

// Cosine of the widest angle from an image's middle to its pixels. Wider, the viewpoint may be inside a
// shape, which is visible wholly from there as well.
constexpr double kWidest = 0.17;
// The same for unevenly spaced pixels. Wider, the viewpoint may be just behind a sheet.
constexpr double kWide = 0.55;
// A pixel is too near to another if it is nearer than kTooNear of the median among the kAround nearest
// pixels. Of a sample of kLookedAt pixels at most kFewTooNear may be.
constexpr double kTooNear = 0.5, kFewTooNear = 0.005;
constexpr std::size_t kAround = 12, kLookedAt = 4000;
// Pixels of the smallest image: fewer points are evenly spaced by chance.
constexpr std::size_t kFewest = 100;
// Pixels between two checks of the cancel.
constexpr std::size_t kAtATime = 64;
// In a camera's image the fourth neighbour of kMostSquare of the pixels is within kSquare times the
// distance of the first.
constexpr double kSquare = 1.5, kMostSquare = 0.9;
// Farthest viewpoint, in box sides: from farther, rounding moves the directions.
constexpr double kFarthest = 100;
// Most sites that an image may miss, and most components and handles, by the number of sites. Images
// measured: 0.001 and 0.0004.
constexpr double kFewOff = 0.01, kFewParts = 0.005;
// Most disagreement (SurfaceQuality) of an image. kSteps: with depths in steps; measured 0.43, two surfaces
// 0.58 and more. kRough: where only even spacing speaks for an image; measured 0.13, regular plates 0.21 and
// more.
constexpr double kSteps = 0.5, kRough = 0.17;
// An image with unevenly spaced pixels misses at most kHardlyOff of the sites, and has at most kBetween of
// them between two layers (share_between_layers()). Measured between layers: 0.016 thinned or with noise of
// half the spacing, 0.02 to 0.16 with depth steps as wide as the cells, 0.14 and more with two surfaces in a
// quarter of the image.
constexpr double kHardlyOff = 0.003, kBetween = 0.05;
// Least height of a triangle in the image, over its longest edge, for its front to count as visible.
constexpr double kFront = 0.01;
// A flip shortens the edge by more than rounding, so that flips end.
constexpr double kShorter = 1 - 1e-9;

std::vector<Vec3> directions(const std::vector<Vec3>& places, const Vec3& viewpoint) {
  std::vector<Vec3> seen(places.size());
  parallel_each(seen.size(), [&](std::size_t i) { seen[i] = (places[i] - viewpoint).stableNormalized(); });
  return seen;
}

Vec3 middle_of(const std::vector<Vec3>& seen) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& u : seen) sum += u;
  return sum.stableNormalized();
}

bool within(double cosine, const std::vector<Vec3>& seen) {
  const Vec3 middle = middle_of(seen);
  return std::all_of(seen.begin(), seen.end(), [&](const Vec3& u) { return u.dot(middle) > cosine; });
}

/// How evenly pixels are spaced, seen from a viewpoint.
struct Spread {
  bool apart;    // hardly one is too near to another
  bool squares;  // most have four neighbours at about the same distance, as in a camera's image
};

Spread spread_of(const std::vector<Vec3>& seen, const Cancel& cancel) {
  if (seen.size() < kFewest) return {false, false};
  const PointTree tree(seen);
  const auto distance = [&](Index i, std::size_t rank) {
    const std::vector<Index> near = tree.nearest(seen[i], rank + 1);
    return (seen[i] - seen[near.back()]).norm();
  };
  const EveryNth looked(seen.size(), kLookedAt);
  const double most = kFewTooNear * static_cast<double>(looked.size());
  double too_near = 0, in_square = 0;
  // In small batches, to stop early: if all pixels are in one direction, each search visits all of them.
  for (std::size_t begin = 0; begin < looked.size() && too_near <= most; begin += kAtATime) {
    cancel();
    const std::size_t end = std::min(looked.size(), begin + kAtATime);
    too_near += parallel_sum(end - begin, [&](std::size_t k) {
      const auto i = static_cast<Index>(looked[begin + k]);
      const double own = distance(i, 1);
      if (!(own > 0)) return 1;
      std::vector<double> usual;
      for (const Index j : tree.nearest(seen[i], kAround + 1)) usual.push_back(distance(j, 1));
      return own > kTooNear * median(usual.begin(), usual.end()) ? 0 : 1;
    });
    if (too_near > most) break;
    in_square += parallel_sum(end - begin, [&](std::size_t k) {
      const auto i = static_cast<Index>(looked[begin + k]);
      return distance(i, 4) < kSquare * distance(i, 1) ? 1 : 0;
    });
  }
  return {too_near <= most, in_square >= kMostSquare * static_cast<double>(looked.size())};
}

// The pixels: where the lines of sight cross a plane before the viewpoint.
std::vector<Point2> flat_image(const std::vector<Vec3>& places, const Vec3& viewpoint) {
  const std::vector<Vec3> seen = directions(places, viewpoint);
  const Vec3 ahead = middle_of(seen), x = ahead.unitOrthogonal(), y = ahead.cross(x);
  std::vector<Point2> pixels(places.size());
  parallel_each(pixels.size(), [&](std::size_t i) {
    const double depth = ahead.dot(seen[i]);
    pixels[i] = Point2(x.dot(seen[i]) / depth, y.dot(seen[i]) / depth);
  });
  return pixels;
}

/// Tests whether a triangle shows its front to the viewpoint. False edge-on, as for three pixels in a row.
class Fronts {
 public:
  Fronts(const std::vector<Vec3>& places, const Vec3& viewpoint) : seen_(directions(places, viewpoint)) {}
  bool operator()(Index a, Index b, Index c) const {
    const Vec3 ab = seen_[b] - seen_[a], bc = seen_[c] - seen_[b], ca = seen_[a] - seen_[c];
    const double longest2 = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
    return seen_[a].dot(ab.cross(ca)) > kFront * longest2;
  }

 private:
  std::vector<Vec3> seen_;
};

// Triangles of sites, clockwise on the plane, so that they face the viewpoint.
std::vector<Corners> delaunay_triangles(const std::vector<Point2>& pixels,
                                        const std::vector<double>& distance, const Cancel& cancel) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
  std::vector<std::size_t> order(pixels.size());
  std::iota(order.begin(), order.end(), 0);
  using Map = CGAL::Pointer_property_map<Point2>::const_type;
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(CGAL::make_property_map(pixels)));
  Triangulation triangulation;
  Triangulation::Face_handle near;
  std::size_t turns = 0;
  for (const std::size_t i : order) {
    if (turns++ % 4096 == 0) cancel();
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(pixels[i], near);
    near = vertex->face();
    if (triangulation.number_of_vertices() > before || distance[i] < distance[vertex->info()])
      vertex->info() = static_cast<Index>(i);
  }
  std::vector<Corners> triangles;
  triangles.reserve(triangulation.number_of_faces());
  for (const auto face : triangulation.finite_face_handles())
    triangles.push_back({face->vertex(0)->info(), face->vertex(2)->info(), face->vertex(1)->info()});
  return triangles;
}

// The triangulated image in space.
Surface image_surface(const std::vector<Vec3>& places, const Vec3& viewpoint,
                      const std::vector<Point2>& pixels, const Cancel& cancel) {
  std::vector<double> distance(places.size());
  parallel_each(places.size(), [&](std::size_t i) { distance[i] = (places[i] - viewpoint).norm(); });
  std::vector<Corners> triangles = delaunay_triangles(pixels, distance, cancel);
  // At the image's rim the Delaunay triangulation makes triangles of pixels in a row.
  const Fronts shows_front(places, viewpoint);
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [&](const Corners& t) { return !shows_front(t[0], t[1], t[2]); }),
                  triangles.end());
  return surface_of_sites(std::move(triangles), places);
}

// Flips edges if the other diagonal is shorter in space and both new faces show their fronts.
void flip_to_shorter(Surface& surface, const Fronts& shows_front, const Cancel& cancel) {
  std::vector<Index> twin = half_edge_twins(surface.triangles, static_cast<Index>(surface.positions.size()));
  const auto origin = [&](Index h) { return surface.triangles[h / 3][h % 3]; };
  const auto front = [&](Index a, Index b, Index c) {
    return shows_front(surface.site[a], surface.site[b], surface.site[c]);
  };
  const auto length = [&](Index a, Index b) { return (surface.positions[a] - surface.positions[b]).norm(); };
  std::vector<Index> waiting(twin.size());
  std::iota(waiting.rbegin(), waiting.rend(), 0);
  for (std::size_t turns = 0; !waiting.empty(); ++turns) {
    if (turns % 65536 == 0) cancel();
    const Index h = waiting.back(), g = twin[h];
    waiting.pop_back();
    if (g == kNone) continue;
    const Index a = origin(h), b = origin(g), c = origin(prev_in_face(h)), d = origin(prev_in_face(g));
    if (length(c, d) >= kShorter * length(a, b) || !front(d, c, a) || !front(c, d, b)) continue;
    flip_edge(surface.triangles, twin, h);
    for (int k = 0; k < 3; ++k) waiting.push_back(h - h % 3 + k), waiting.push_back(g - g % 3 + k);
  }
}

// Of each face the larger of its gaps (face_gaps()) in space and in the image. At a grazing angle some pixels
// are far from all others, so a neighbour's spacing counts if it is smaller.
std::vector<float> wider_gaps(const Surface& surface, const std::vector<Point2>& pixels,
                              const SiteGeometry& geometry) {
  SiteGeometry in_space;
  in_space.spacing.resize(pixels.size());
  std::vector<Vec3> flat(pixels.size());
  parallel_each(pixels.size(), [&](std::size_t i) {
    in_space.spacing[i] = std::min(geometry.spacing[i], near_spacing(geometry, static_cast<Index>(i)));
    flat[i] = {pixels[i].x(), pixels[i].y(), 0};
  });
  std::vector<float> gaps = face_gaps(surface, in_space);
  Surface image = surface;
  for (std::size_t v = 0; v < surface.site.size(); ++v) image.positions[v] = flat[surface.site[v]];
  const std::vector<float> in_image = face_gaps(image, site_geometry(flat));
  for (std::size_t t = 0; t < gaps.size(); ++t) gaps[t] = std::max(gaps[t], in_image[t]);
  return gaps;
}

// The image if all places are visible from `viewpoint`, evenly spaced or not.
std::optional<DepthImage> image_from(const std::vector<Vec3>& places, const Vec3& viewpoint,
                                     const SiteGeometry& geometry, const Cancel& cancel) {
  if (!(viewpoint.norm() < kFarthest) || !within(kWidest, directions(places, viewpoint))) return {};
  DepthImage image{viewpoint, depth_image_surface(places, viewpoint, geometry, cancel), {}};
  image.quality = surface_quality(image.surface, geometry);
  const double sites = static_cast<double>(places.size());
  if (static_cast<double>(image.quality.off) > kFewOff * sites ||
      static_cast<double>(image.quality.complexity) > kFewParts * sites ||
      image.quality.disagreement > kSteps)
    return {};
  return image;
}

}  // namespace

std::optional<DepthImage> depth_image(const std::vector<Vec3>& places, const SiteGeometry& geometry,
                                      const std::optional<Vec3>& guess, const Cancel& cancel) {
  // Rows that meet at the guess leave open which side is the front, as those of a far sensor do: it says
  // that.
  const std::optional<Vec3> found = raster_viewpoint(places, geometry);
  const bool first = guess && found && raster_viewpoint(places, geometry, guess) == guess;
  for (const std::optional<Vec3>& viewpoint : {first ? guess : found, first ? found : guess}) {
    if (!viewpoint) continue;
    std::optional<DepthImage> image = image_from(places, *viewpoint, geometry, cancel);
    if (!image) continue;
    const std::vector<Vec3> seen = directions(places, *viewpoint);
    const Spread spread = spread_of(seen, cancel);
    if (spread.apart && (viewpoint == found || spread.squares || image->quality.disagreement <= kRough))
      return image;
    if (within(kWide, seen) &&
        static_cast<double>(image->quality.off) <= kHardlyOff * static_cast<double>(places.size()) &&
        share_between_layers(image->surface, places, geometry, cancel) <= kBetween)
      return image;
  }
  return {};
}

Surface depth_image_surface(const std::vector<Vec3>& places, const Vec3& viewpoint,
                            const SiteGeometry& geometry, const Cancel& cancel) {
  const std::vector<Point2> pixels = flat_image(places, viewpoint);
  Surface surface = image_surface(places, viewpoint, pixels, cancel);
  flip_to_shorter(surface, Fronts(places, viewpoint), cancel);
  remove_bridges(surface, wider_gaps(surface, pixels, geometry), geometry);
  return surface;
}

}  // namespace filmsticking

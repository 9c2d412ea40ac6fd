// SPDX-License-Identifier: GPL-3.0-or-later
// Adjacency, first surfaces, orientation.
#include <gtest/gtest.h>

#include "film/initial_surface.h"
#include "geometry/enclosed_volume.h"
#include "geometry/meeting.h"
#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "surface/cap_faces.h"
#include "surface/meeting_faces.h"
#include "surface/orientation.h"
#include "surface/pinholes.h"
#include "surface/surface_normals.h"
#include "surface/viewpoint.h"

namespace filmsticking {
namespace {

const std::vector<Corners> kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(TriangleAdjacency, AcceptsAClosedManifold) { EXPECT_TRUE(check_manifold(kTetrahedron, 4).ok()); }

TEST(TriangleAdjacency, SeesEveryKindOfFault) {
  EXPECT_FALSE(check_manifold({}, 0).ok());
  EXPECT_FALSE(check_manifold({{0, 1, 9}}, 3).indices_valid);
  EXPECT_FALSE(check_manifold({{0, 1, 1}}, 3).indices_valid);
  auto open = kTetrahedron;
  open.pop_back();
  EXPECT_FALSE(check_manifold(open, 4).closed);
  auto turned = kTetrahedron;
  std::swap(turned[0][0], turned[0][1]);
  EXPECT_FALSE(check_manifold(turned, 4).oriented);
  auto bow_tie = kTetrahedron;  // two tetrahedra that share corner 0 only
  for (const Corners& t : kTetrahedron) {
    Corners u;
    for (int k = 0; k < 3; ++k) u[k] = t[k] == 0 ? 0 : t[k] + 3;
    bow_tie.push_back(u);
  }
  const ManifoldCheck check = check_manifold(bow_tie, 7);
  EXPECT_TRUE(check.closed && check.oriented);
  EXPECT_FALSE(check.single_rings);
  std::vector<Index> component;
  EXPECT_EQ(connected_components(half_edge_twins(bow_tie, 7), component), 2);
}

TEST(Surface, SphereHoldsTheSites) {
  const SiteSet set = make_site_set(test::grid(4));
  const Surface sphere = bounding_sphere(set.perturbed);
  EXPECT_TRUE(check_manifold(sphere.triangles, static_cast<Index>(sphere.positions.size())).ok());
  EXPECT_GT(signed_volume6(sphere), 0);
  for (const Corners& t : sphere.triangles) {
    const Vec3 &a = sphere.positions[t[0]], &b = sphere.positions[t[1]], &c = sphere.positions[t[2]];
    const Vec3 outward = (b - a).cross(c - a);
    for (const Vec3& p : set.perturbed) EXPECT_LT(outward.dot(p - a), 0);
  }
}

TEST(FilmNormals, AreOutwardAndLeaveOtherSitesAlone) {
  Surface sphere = bounding_sphere(make_site_set(test::grid(2)).perturbed);
  const std::size_t n = sphere.positions.size();
  for (std::size_t v = 0; v < n; ++v) sphere.site[v] = static_cast<Index>(v + 1);  // site 0 is off it
  const Vec3 otherwise(0, 0.6, -0.8);
  const std::vector<Vec3> normals = surface_normals(sphere, std::vector<Vec3>(n + 1, otherwise));
  EXPECT_EQ(normals[0], otherwise);
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_NEAR(normals[v + 1].norm(), 1, 1e-12);
    EXPECT_GT(normals[v + 1].dot(sphere.positions[v].normalized()), 0.999);
  }
  for (Vec3& p : sphere.positions) p = {p.x(), 0, 0};  // flat: there is no normal
  for (const Vec3& normal : surface_normals(sphere, std::vector<Vec3>(n + 1, otherwise)))
    EXPECT_EQ(normal, otherwise);
}

TEST(Surface, WrapIsClosedAndHoldsTheSites) {
  const SiteSet set = make_site_set(test::torus(3000, 3));
  const Surface wrap = alpha_wrap(set.perturbed, 0.1);
  EXPECT_TRUE(check_manifold(wrap.triangles, static_cast<Index>(wrap.positions.size())).ok());
  std::vector<Index> all;
  for (std::size_t t = 0; t < wrap.triangles.size(); ++t) all.push_back(static_cast<Index>(t));
  for (std::size_t s = 0; s < set.size(); s += 50)
    EXPECT_NEAR(solid_angle_winding(wrap, all, set.perturbed[s]), 1, 1e-6);
}

std::vector<Point> places_of(const Surface& surface) {
  std::vector<Point> places;
  for (const Vec3& p : surface.positions) places.push_back({p.x(), p.y(), p.z()});
  return places;
}

TEST(Orientation, TheTruePlacesSayWhatIsOutward) {
  Surface surface;  // perturbed, the tip came out on the other side of its base
  surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1e-8}};
  surface.site.assign(4, kNone);
  surface.triangles.assign(std::begin(kTetrahedron), std::end(kTetrahedron));
  for (const double tip : {1e-12, -1e-12, 1e-300, -1e-300}) {
    const std::vector<Point> places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, tip}};
    EXPECT_TRUE(orient_components(surface, places, SurfaceTopology(surface.triangles, 4)));
    EXPECT_EQ(enclosed_volume_sign(surface.triangles, places), 1);
  }
  const std::vector<Point> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0}};
  EXPECT_FALSE(orient_components(surface, flat, SurfaceTopology(surface.triangles, 4)));
}

// A solid with a corner between the sides of one that is flat but for the perturbation was turned as its
// cavity.
TEST(Orientation, Regression_AFlatComponentHoldsNothing) {
  Surface surface;
  surface.positions = {{-4, -4, 0},  {4, -4, 0},    {0, 4, 0},     {0, 0, 1e-8},
                       {0, 0, 1e-9}, {0.5, 0, 0.5}, {0, 0.5, 0.5}, {0, 0, 0.7}};
  surface.site.assign(8, kNone);
  for (const Index first : {0, 4})
    for (const Corners& t : kTetrahedron)
      surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  std::vector<Point> places = places_of(surface);
  places[3] = {0, 0, 0};
  EXPECT_TRUE(orient_components(surface, places, SurfaceTopology(surface.triangles, 8)));
  EXPECT_EQ(enclosed_volume_sign({surface.triangles.begin() + 4, surface.triangles.end()}, places), 1);
}

TEST(EnclosedVolume, IsExactAtEveryScale) {
  const std::vector<Corners> triangles(std::begin(kTetrahedron), std::end(kTetrahedron));
  const auto sign = [&](double x, double y, double z, const Point& o) {
    return enclosed_volume_sign(
        triangles,
        std::vector<Point>{o, {o[0] + x, o[1], o[2]}, {o[0], o[1] + y, o[2]}, {o[0], o[1], o[2] + z}});
  };
  const int outward = sign(1, 1, 1, {0, 0, 0});
  EXPECT_EQ(std::abs(outward), 1);
  EXPECT_EQ(sign(1, 1, -1, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1, 1, 0, {0, 0, 0}), 0);
  EXPECT_EQ(sign(1e308, 1e308, -1e308, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1e308, 1e-200, 1e-200, {0, 0, 0}), outward);
  EXPECT_EQ(sign(5e-324, -5e-324, 5e-324, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1e300, 1e300, 1e300, {-1e308, 1e308, 1e308}), outward);
  EXPECT_EQ(sign(1, 1, 1e-9, {1e6, 1e6, 1e6}), outward);
  EXPECT_EQ(sign(1, 1, 1e-12, {1e6, 1e6, 1e6}), 0);  // rounded away already
  EXPECT_EQ(enclosed_volume_sign({}, std::vector<Point>()), 0);
}

TEST(Orientation, TurnsSolidsOutwardAndCavitiesInward) {
  Surface nested;
  for (const double size : {4.0, 1.0, 0.2}) {  // solid, cavity, solid in the cavity
    const Index first = static_cast<Index>(nested.positions.size());
    for (const Vec3& p : {Vec3(-1, -1, -1), Vec3(1, 1, -1), Vec3(1, -1, 1), Vec3(-1, 1, 1)})
      nested.positions.push_back(size * p), nested.site.push_back(kNone);
    for (const Corners& t : kTetrahedron)
      nested.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  for (int flips = 0; flips < 8; ++flips) {
    Surface turned = nested;
    for (std::size_t t = 0; t < turned.triangles.size(); ++t)
      if (flips >> (t / 4) & 1) std::swap(turned.triangles[t][1], turned.triangles[t][2]);
    const SurfaceTopology topology(turned.triangles, static_cast<Index>(turned.positions.size()));
    EXPECT_TRUE(orient_components(turned, places_of(turned), topology));
    for (int part = 0; part < 3; ++part) {
      Surface one = turned;
      one.triangles.assign(turned.triangles.begin() + 4 * part, turned.triangles.begin() + 4 * part + 4);
      EXPECT_EQ(signed_volume6(one) > 0, part != 1) << flips << ' ' << part;
    }
  }
}

Surface film_of(std::vector<Vec3> positions, std::vector<Corners> triangles) {
  Surface film{std::move(positions), {}, std::move(triangles)};
  for (std::size_t v = 0; v < film.positions.size(); ++v) film.site.push_back(static_cast<Index>(v));
  return film;
}

std::int64_t caps_removed(Surface& film) {
  const auto vertices = static_cast<Index>(film.positions.size());
  const std::int64_t removed = remove_cap_faces(film, half_edge_twins(film.triangles, vertices));
  EXPECT_TRUE(check_manifold(film.triangles, vertices).manifold());
  std::vector<char> on(film.positions.size(), 0);
  for (const Corners& t : film.triangles)
    for (Index v : t) on[v] = 1;
  EXPECT_EQ(std::count(on.begin(), on.end(), 0), 0);
  return removed;
}

Vec3 normal(const Surface& film, Index t) {
  return (film.corner(t, 1) - film.corner(t, 0)).cross(film.corner(t, 2) - film.corner(t, 0));
}

double area(const Surface& film) {
  double sum = 0;
  for (std::size_t t = 0; t < film.triangles.size(); ++t)
    sum += normal(film, static_cast<Index>(t)).norm() / 2;
  return sum;
}

// 2 on the edge of 0 and 1; 3 above it, 4 below.
const std::vector<Vec3> kOnAnEdge = {{0, 0, 0}, {0.2, 0, 0}, {0.1, 1e-9, 0}, {0.1, 0.1, 0}, {0.1, -0.1, 0}};

TEST(Caps, AreFlippedIntoTheFaceAcross) {
  Surface film = film_of(kOnAnEdge, {{0, 1, 3}, {1, 0, 2}, {0, 4, 2}, {4, 1, 2}});
  const double before = area(film);
  EXPECT_EQ(caps_removed(film), 1);
  EXPECT_EQ(film.triangles.size(), 4u);
  EXPECT_NEAR(area(film), before, 1e-8);
  EXPECT_EQ(caps_removed(film), 0);
}

TEST(Caps, AreLeftOutAtTheBorder) {
  // 2 is inside: its faces form a ring.
  Surface film =
      film_of({{0, 0, 0}, {0.2, 0, 0}, {0.1, 1e-9, 0}, {0.1, -0.1, 0}}, {{1, 0, 2}, {0, 3, 2}, {3, 1, 2}});
  EXPECT_EQ(caps_removed(film), 1);
  EXPECT_EQ(film.triangles.size(), 2u);
}

TEST(Caps, StayWhereTheBorderWouldMeetItself) {
  Surface film = film_of({{0, 0, 0}, {0.2, 0, 0}, {0.1, 0, 0}, {0, -0.1, 0}, {0.2, -0.1, 0}},
                         {{1, 0, 2}, {0, 3, 2}, {4, 1, 2}});
  const std::vector<Corners> before = film.triangles;
  EXPECT_EQ(caps_removed(film), 0);
  EXPECT_EQ(film.triangles, before);
}

// An edge that was flipped and flipped back left its faces turned on, and their twins were those of others.
TEST(Caps, Regression_ThoseThatStayChangeNothing) {
  Surface film = film_of({{0, 0, 0}, {0.3, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0.1, 0.1, 0}, {0.1, -0.1, 0}},
                         {{0, 1, 3}, {1, 0, 2}, {0, 5, 2}, {2, 5, 1}, {0, 3, 4}, {3, 1, 4}});
  const std::vector<Corners> before = film.triangles;
  EXPECT_EQ(caps_removed(film), 0);
  EXPECT_EQ(film.triangles, before);
}

TEST(Caps, GoWhereSeveralLieOnOneEdge) {
  Surface film = film_of({{0, 0, 0}, {0.3, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0.1, 0.1, 0}, {0.1, -0.1, 0}},
                         {{0, 1, 4}, {1, 0, 3}, {3, 0, 2}, {0, 5, 2}, {2, 5, 3}, {3, 5, 1}});
  const double before = area(film);
  EXPECT_EQ(caps_removed(film), 2);
  EXPECT_NEAR(area(film), before, 1e-12);
  EXPECT_EQ(caps_removed(film), 0);
}

// A ball of faces about `spacing` wide without those that `away` says of, by their middles.
template <class Away>
Surface ball_without(const Away& away) {
  Surface film = bounding_sphere({Vec3(0.5, 0.5, 0.5)});
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < film.triangles.size(); ++t) {
    const auto i = static_cast<Index>(t);
    if (!away((film.corner(i, 0) + film.corner(i, 1) + film.corner(i, 2)) / 3))
      triangles.push_back(film.triangles[t]);
  }
  return film_of(std::move(film.positions), std::move(triangles));
}

std::int64_t holes_filled(Surface& film, double spacing) {
  const auto vertices = static_cast<Index>(film.positions.size());
  SiteGeometry geometry;
  geometry.spacing.assign(film.positions.size(), spacing);
  const std::int64_t filled = fill_pinholes(film, half_edge_twins(film.triangles, vertices), geometry);
  EXPECT_TRUE(check_manifold(film.triangles, vertices).manifold());
  return filled;
}

std::int64_t border_edges(const Surface& film) {
  return check_manifold(film.triangles, static_cast<Index>(film.positions.size())).boundary_edges;
}

TEST(Pinholes, AreFilledIfTheyAreNotWide) {
  const Surface whole = ball_without([](const Vec3&) { return false; });
  const double spacing = std::sqrt(area(whole) / static_cast<double>(whole.positions.size()));
  const Vec3 a = whole.corner(7, 0),
             b = (whole.corner(40, 0) + whole.corner(40, 1) + whole.corner(40, 2)) / 3;
  const auto near = [&](const Vec3& p) {
    return (p - a).norm() < 0.9 * spacing || (p - b).norm() < 0.1 * spacing;  // a ring of faces, and one face
  };
  Surface film = ball_without(near);
  const std::int64_t edges = border_edges(film);
  ASSERT_GE(edges, 7);
  EXPECT_EQ(holes_filled(film, spacing / 5), 0);  // the same hole is five times as many spacings wide
  EXPECT_EQ(border_edges(film), edges);
  EXPECT_EQ(holes_filled(film, spacing), 2);
  EXPECT_EQ(border_edges(film), 0);
  EXPECT_NEAR(area(film), area(whole), 0.01 * area(whole));
}

TEST(Pinholes, TheRimOfAPieceIsNone) {
  const Surface whole = ball_without([](const Vec3&) { return false; });
  const double spacing = std::sqrt(area(whole) / static_cast<double>(whole.positions.size()));
  const Vec3 a = whole.corner(7, 0);
  Surface film = ball_without([&](const Vec3& p) { return (p - a).norm() > 0.9 * spacing; });
  const std::int64_t edges = border_edges(film);
  ASSERT_GE(edges, 5);
  EXPECT_EQ(holes_filled(film, spacing), 0);
  EXPECT_EQ(border_edges(film), edges);
}

// A wall through the hole.
TEST(Pinholes, StayWhereTheFillingWouldMeetAnother) {
  const Surface whole = ball_without([](const Vec3&) { return false; });
  const double spacing = std::sqrt(area(whole) / static_cast<double>(whole.positions.size()));
  const Vec3 a = whole.corner(7, 0);
  Surface film = ball_without([&](const Vec3& p) { return (p - a).norm() < 0.9 * spacing; });
  const auto n = static_cast<Index>(film.positions.size());
  const Vec3 across = spacing / 20 * a.unitOrthogonal();
  for (const Vec3& p : {Vec3(0.5 * a), Vec3(2 * a + across), Vec3(2 * a - across)})
    film.positions.push_back(p), film.site.push_back(static_cast<Index>(film.site.size()));
  film.triangles.push_back({n, n + 1, n + 2});
  EXPECT_EQ(holes_filled(film, spacing), 0);
}

std::int64_t meeting_faces(Surface& film) {
  SiteGeometry geometry;
  geometry.spacing.assign(film.positions.size(), 0.1);
  return remove_meeting_faces(film, geometry);
}

bool some_meet(const Surface& film) {
  for (std::size_t t = 0; t < film.triangles.size(); ++t)
    for (std::size_t u = 0; u < t; ++u)
      if (!Meeting(film.positions, film.triangles[t], film.triangles[u], kMeetingMargin)
               .in_common_corners_only())
        return true;
  return false;
}

// A square grid in a plane, of which some inner vertices are moved two cells on: their faces fold over.
Surface folded_sheet(std::uint64_t seed, int folds) {
  constexpr int n = 12;
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) positions.emplace_back(i / 16.0, j / 16.0, 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + n + 1;
      triangles.push_back({a, b, b + 1}), triangles.push_back({a, b + 1, a + 1});
    }
  test::Random random(seed);
  for (int k = 0; k < folds; ++k) {
    const int i = static_cast<int>(random.uniform(2, n - 2)), j = static_cast<int>(random.uniform(2, n - 2));
    positions[i * (n + 1) + j] += Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0) / 8;
  }
  return film_of(std::move(positions), std::move(triangles));
}

// Rows of pixels that lie in a plane exactly came with faces folded over onto others.
TEST(MeetingFaces, Regression_FoldsInExactPlanesAreTakenAway) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Surface sheet = folded_sheet(seed, 3);
    Surface film = sheet;
    ASSERT_EQ(meeting_faces(film) > 0, some_meet(sheet)) << seed;
    EXPECT_FALSE(some_meet(film)) << seed;
    EXPECT_TRUE(check_manifold(film.triangles, static_cast<Index>(film.positions.size())).manifold()) << seed;
    EXPECT_GE(film.triangles.size() + 3 * 12, sheet.triangles.size()) << seed;
    EXPECT_EQ(meeting_faces(film), 0) << seed;
  }
}

TEST(MeetingFaces, NoNumberingChangesWhatStays) {
  const auto sites = [](const Surface& film) {
    std::vector<std::array<Index, 3>> all;
    for (const Corners& t : film.triangles) {
      all.push_back({film.site[t[0]], film.site[t[1]], film.site[t[2]]});
      std::sort(all.back().begin(), all.back().end());
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Surface film = folded_sheet(seed, 3), other = film;
    std::reverse(other.triangles.begin(), other.triangles.end());
    for (Corners& t : other.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
    meeting_faces(film), meeting_faces(other);
    EXPECT_EQ(sites(film), sites(other)) << seed;
  }
}

// All pairs of a large film would not fit into memory.
TEST(MeetingFaces, VeryManyThatMeetAllOthersGo) {
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  test::Random random(1);
  for (Index t = 0; t < 5000; ++t) {
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * std::acos(-1) * (k + random.uniform(0, 0.3)) / 3;
      positions.emplace_back(std::cos(angle) / 2, std::sin(angle) / 2, 0);
    }
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  Surface film = film_of(std::move(positions), std::move(triangles));
  EXPECT_EQ(meeting_faces(film), 5000);
  EXPECT_TRUE(film.triangles.empty());
}

TEST(MeetingFaces, ThoseThatMeetNoOtherStay) {
  Surface film = ball_without([](const Vec3& p) { return p.z() > 0.5; });
  const std::vector<Corners> before = film.triangles;
  EXPECT_EQ(meeting_faces(film), 0);
  EXPECT_EQ(film.triangles, before);
}

// Squares across z, some turned to -z, bent so that +z is their convex side.
Surface squares(const std::vector<std::pair<Vec3, bool>>& places, double side) {
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  for (const auto& [place, back] : places) {
    const auto n = static_cast<Index>(positions.size());
    for (const Vec3& p :
         {Vec3(0, 0, 0), Vec3(side, 0, -side / 4), Vec3(side, side, 0), Vec3(0, side, -side / 4)})
      positions.push_back(place + p);
    for (Corners t : {Corners{n, n + 1, n + 2}, Corners{n, n + 2, n + 3}}) {
      if (back) std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
  }
  return film_of(std::move(positions), std::move(triangles));
}

Index turned(Surface& film) {
  return turn_to_viewpoint(film, SurfaceTopology(film.triangles, static_cast<Index>(film.positions.size())));
}

TEST(Viewpoint, SeesTheFrontsOfAllPieces) {
  for (const bool back : {false, true}) {
    Surface film = squares({{{0, 0, 0}, back}, {{-0.3, 0.1, -0.5}, true}, {{0.9, 0, -0.2}, false}}, 0.25);
    film.positions[2] += Vec3(1e-3, 1e-3, 0);  // the first is the largest
    EXPECT_EQ(turned(film), 1 + back);
    for (Index t = 0; t < 6; ++t) EXPECT_GT(normal(film, t).z(), 0) << t;
    EXPECT_EQ(turned(film), 0);
  }
}

// Three sides of a box, one with most of the faces, of which half are turned over: all three are seen, not
// just the one from straight ahead.
TEST(Viewpoint, IsInViewOfAllThatCanBeSeenWhicheverWayItIsTurned) {
  for (const bool some_turned : {false, true}) {
    std::vector<Vec3> positions, outward;
    std::vector<Corners> triangles;
    for (int side = 0; side < 3; ++side) {
      const auto first = static_cast<Index>(positions.size());
      const int n = side == 0 ? 24 : 8;
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
          positions.push_back(Vec3::Ones());
          positions.back()[(side + 1) % 3] -= i / 16.0, positions.back()[(side + 2) % 3] -= j / 16.0;
        }
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const Index a = first + i * (n + 1) + j, b = a + n + 1;
          for (Corners t : {Corners{a, b, b + 1}, Corners{a, b + 1, a + 1}}) {
            if (some_turned && i >= n / 2) std::swap(t[1], t[2]);
            triangles.push_back(t);
            outward.emplace_back(Vec3::Unit(side));
          }
        }
    }
    const Surface film = film_of(std::move(positions), std::move(triangles));
    const Vec3 eye = common_viewpoint(film);
    EXPECT_TRUE(is_seen_once(film, eye));
    EXPECT_NEAR(turned_away_share(film, eye), some_turned ? 0.5 : 0, 1e-9);
    // From before all three or from behind them.
    std::size_t before = 0;
    for (std::size_t t = 0; t < outward.size(); ++t)
      before += outward[t].dot(eye - film.corner(static_cast<Index>(t), 0)) > 0;
    EXPECT_TRUE(before == 0 || before == outward.size()) << before << " of " << outward.size();
  }
}

// All of its bends are right angles, which were taken for folds.
TEST(Viewpoint, Regression_ABoxShowsItsOutside) {
  // A cube's sides but the one at z = 0, each of two faces.
  std::vector<Vec3> positions;
  for (int i = 0; i < 8; ++i) positions.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  const std::vector<Corners> outward = {{4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4}, {1, 3, 7},
                                        {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}};
  for (const bool inward : {false, true}) {
    std::vector<Corners> triangles = outward;
    if (inward)
      for (Corners& t : triangles) std::swap(t[1], t[2]);
    Surface film = film_of(positions, std::move(triangles));
    EXPECT_EQ(turned(film), inward ? 1 : 0);
    EXPECT_GT(normal(film, 0).z(), 0);
  }
}

TEST(Viewpoint, SeesABallTwiceAndHalfOfItOnce) {
  const Surface ball = bounding_sphere({Vec3(0.5, 0.5, 0.5)});
  EXPECT_FALSE(is_seen_once(ball, common_viewpoint(ball)));
  EXPECT_FALSE(is_seen_once(ball, Vec3(0, 0, 9)));
  Surface half = ball;
  half.triangles.clear();
  for (const Corners& t : ball.triangles)
    if ((ball.positions[t[0]] + ball.positions[t[1]] + ball.positions[t[2]]).z() > 0)
      half.triangles.push_back(t);
  EXPECT_TRUE(is_seen_once(half, Vec3(0, 0, 9)));
  EXPECT_FALSE(is_seen_once(half, Vec3(9, 0, 0)));
  EXPECT_LE(odd_crossing_share(ball, Vec3(0, 0, 9)), 0.01);  // a line may meet a vertex
  EXPECT_GE(odd_crossing_share(half, Vec3(0, 0, 9)), 0.8);   // and the rim goes to and fro
  EXPECT_NEAR(turned_away_share(half, Vec3(0, 0, 99)), 0, 0.02);
  EXPECT_NEAR(turned_away_share(half, Vec3(99, 0, 0)), 0.5, 0.02);
}

TEST(Viewpoint, OfNothingIsNoMatter) {
  const Surface none;
  EXPECT_TRUE(common_viewpoint(none).allFinite());
  EXPECT_TRUE(is_seen_once(none, Vec3::Zero()));
  EXPECT_EQ(odd_crossing_share(none, Vec3::Zero()), 0);
  EXPECT_EQ(turned_away_share(none, Vec3::Zero()), 0);
}

// All sides of a ball but a part of one: no point sees them.
TEST(Viewpoint, TurnsNoOtherWhereThereIsNone) {
  Surface film = squares({{{2, 0, 0}, true}}, 0.25);
  const Surface ball = bounding_sphere({Vec3(0.5, 0.5, 0.5)});
  std::vector<Vec3> positions = film.positions;
  std::vector<Corners> triangles = film.triangles;
  const auto first = static_cast<Index>(positions.size());
  positions.insert(positions.end(), ball.positions.begin(), ball.positions.end());
  for (std::size_t t = 1; t < ball.triangles.size(); ++t) {
    Corners c = ball.triangles[t];
    for (Index& v : c) v += first;
    triangles.push_back(c);
  }
  film = film_of(std::move(positions), std::move(triangles));
  EXPECT_EQ(turned(film), 0);
  EXPECT_LT(normal(film, 0).z(), 0);
}

}  // namespace
}  // namespace filmsticking

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cutter.h"
#include "evidence/depth_image.h"

namespace filmsticking {

/// What a pipeline finds: a surface of sites, a manifold, or empty.
struct FoundSurface {
  Surface surface;
  std::optional<Vec3> viewpoint;  ///< of a depth image: the point to which all of its faces show their front
  std::vector<float> stability;   ///< site_stability(); empty for a surface that is not of tetrahedra
};

/// Chooses a surface of the sites. Method::Labelling: beliefs of inside and outside are cut, and the
/// candidate of least energy is taken. Method::Film: FilmMethod.
class Pipeline {
 public:
  /// `points`: what the sites were made of. All arguments must outlive the pipeline.
  Pipeline(const PointsView& points, const SiteSet& sites, const SiteGeometry& geometry,
           const Options& options, Monitor& monitor, Report& report);

  /// Returns a closed manifold; with may_be_open() it may have a boundary. Empty if no surface is
  /// found. Once only. `tetrahedra`: the Delaunay triangulation of the perturbed sites.
  FoundSurface run(Tetrahedra tetrahedra);

  /// Instead of run(): returns the open surface of a depth image without triangulating; returns nothing if
  /// the sites form no depth image.
  std::optional<FoundSurface> visible_surface();

  /// The last resort, after run(): the tetrahedron of largest volume, grown to the sites that it reaches. A
  /// closed manifold; empty only if all tetrahedra are flat.
  Surface around_one_tetrahedron();

 private:
  Candidate labelling();
  std::vector<Candidate> starts(Candidate first);
  Candidate two_sides(const Candidate* rival);
  Candidate seen_from(const Vec3& viewpoint);
  Candidate with_view(Candidate best, const DepthImage& view);
  std::vector<char> film_from_sphere();

  std::vector<Vec3> exact_places() const;
  std::optional<Vec3> given_viewpoint() const;
  std::optional<DepthImage> image_of(const std::vector<Vec3>& places);
  std::optional<DepthImage> given_view();

  const PointsView& points_;
  const SiteSet& sites_;
  const SiteGeometry& geometry_;
  const Options& options_;
  Monitor& monitor_;
  Report& report_;
  Cutter cutter_;
  const bool open_;  // may_be_open()
};

}  // namespace filmsticking

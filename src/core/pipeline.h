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
  std::vector<Vec3> viewpoints;   ///< [site] where its sensor was; empty if unknown or contradicted
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
  bool look(std::vector<Vec3> from);
  Candidate labelling();
  Candidate without_gaps(Candidate clear);
  std::vector<Candidate> starts(Candidate first);
  Candidate or_blind(Candidate seen, std::vector<double> guess);
  Candidate or_seen(Candidate first, std::vector<double> guess);
  Candidate or_room(Candidate best);
  Candidate two_sides(const Candidate* rival);
  std::vector<char> film_from_sphere();

  std::vector<Vec3> exact_places() const;
  std::optional<Vec3> given_viewpoint() const;
  std::optional<DepthImage> image_of(const std::vector<Vec3>& places);

  const PointsView& points_;
  const SiteSet& sites_;
  const SiteGeometry& geometry_;
  const Options& options_;
  Monitor& monitor_;
  Report& report_;
  Cutter cutter_;
  std::vector<Vec3> viewpoints_;  // of the sites, where sight is used
  bool inside_ = false;           // the sensors are inside the hull
  const bool open_;               // may_be_open()
  const bool guessed_;            // the viewpoint is a guess
};

}  // namespace filmsticking

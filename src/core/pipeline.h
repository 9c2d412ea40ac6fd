// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "delaunay/power_diagram.h"
#include "delaunay/tetrahedral_mesh.h"
#include "evidence/depth_image.h"
#include "evidence/facet_evidence.h"
#include "filmsticking/options.h"
#include "geometry/monitor.h"
#include "geometry/surface.h"
#include "labelling/two_sides.h"
#include "points/site_geometry.h"
#include "points/site_set.h"
#include "surface/surface_quality.h"

namespace filmsticking {

/// From sites to the final film: the first film, its evolution, rounds of field and film, insertion.
class Pipeline {
 public:
  /// `points`: what the sites were made of.
  Pipeline(const PointsView& points, const SiteSet& sites, const SiteGeometry& geometry,
           const Options& options, Monitor& monitor, Report& report);

  /// Closed manifold of sites, or empty. `tetrahedra`: of the perturbed sites.
  Surface run(Tetrahedra tetrahedra);

  /// Instead of run(): the depth image that the sites are, with its open surface, or nothing.
  std::optional<DepthImage> visible_surface();

  /// After either: where the open surface was seen from, all of it, if it is a depth image's
  /// (depth_image_surface()).
  const std::optional<Vec3>& viewpoint() const { return viewpoint_; }

  /// The last resort, after run(): the tetrahedron of largest volume, and what sites it reaches. Closed
  /// manifold of sites that encloses it; empty only if all tetrahedra are flat.
  Surface around_one_tetrahedron();

 private:
  struct Candidate {
    Surface film;
    SurfaceQuality quality;  ///< after insertion
    std::int64_t inserted = 0;
    double weak = 0;           ///< share of the sites that its first cut left off
    std::vector<char> labels;  ///< of the tetrahedra, if it was cut
    std::vector<double> hold;  ///< what these cost (LabelCosts)
    double score() const;      ///< lower is better
  };

  void prepare(Tetrahedra tetrahedra);
  std::vector<std::function<Surface()>> first_surfaces() const;
  Surface film_from_outside();
  void show(const Surface& film) const;
  Surface evolve(Surface film, const std::vector<Vec3>& sites, int max_steps, bool weights);
  std::vector<Vec3> with_virtual_sites(const Surface& film) const;
  Candidate finish(Surface film);
  Candidate cut(const std::vector<double>& belief, double conviction, bool open = false);
  Candidate cut_sides(const RimRule& rim, const Vec3* viewpoint, bool open);
  Candidate cut_two_sides();
  std::vector<Vec3> exact_places() const;
  std::optional<Vec3> given_viewpoint() const;
  std::optional<DepthImage> image_of(const std::vector<Vec3>& places);
  std::optional<DepthImage> given_view();
  bool is_better_view(const DepthImage& image, Surface found) const;
  double looseness(const SurfaceQuality& quality) const;
  double looseness_closed(const SurfaceQuality& quality) const;
  static bool has_shape(const Candidate& candidate);
  Candidate with_sides(Candidate best, Candidate sides);
  Candidate closed_if_torn(Candidate open, Candidate closed);
  Candidate by_widths(Candidate best, bool& two_sided);
  Candidate carve_further(Candidate best, bool two_sided);
  Candidate cut_image(const Vec3& viewpoint);
  // By plugs alone, which is quick, or by all that may help.
  enum class Mend { Plugs, All };
  Candidate without_gaps(Candidate candidate, Mend mend = Mend::All);
  Surface film_of(const std::vector<char>& labels) const;
  std::vector<char> exempt(const std::vector<char>& labels) const;
  std::vector<double> off_prices() const;
  std::vector<double> carve_belief(double limit, double slope) const;
  std::vector<double> winding_belief(const Surface& film) const;
  std::vector<double> film_belief(const Surface& film) const;
  Candidate judged(Candidate candidate) const;
  bool settled(const Candidate& candidate) const;
  Candidate carve();
  Candidate refined(Candidate best);
  void rounds(Candidate& best);

  const PointsView& points_;
  const SiteSet& sites_;
  const SiteGeometry& geometry_;
  const Options& options_;
  Monitor& monitor_;
  Report& report_;
  bool open_;  // is the surface that is sought for allowed to be? As the options say, but while it is closed
               // anew
  PowerDiagram voronoi_;
  TetrahedralMesh mesh_;
  FacetEvidence evidence_;
  std::optional<Vec3> viewpoint_;
  std::vector<double> guess_;  // the belief that the signed field starts from
};

}  // namespace filmsticking

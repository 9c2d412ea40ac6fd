// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "evidence/depth_image.h"
#include "evidence/facet_evidence.h"
#include "film/film.h"
#include "filmsticking/options.h"
#include "geometry/monitor.h"
#include "geometry/surface.h"
#include "labelling/two_sides.h"
#include "points/site_geometry.h"
#include "points/site_set.h"
#include "surface/surface_quality.h"

namespace filmsticking {

/// What a pipeline finds: a surface of sites, a manifold, or empty.
struct FoundSurface {
  Surface surface;
  std::optional<Vec3> viewpoint;  ///< of a depth image: the point to which all of its faces show their front
  std::vector<float> stability;   ///< site_stability(); empty for a surface that is not of tetrahedra
};

/// Chooses a surface of the sites. Method::Labelling: several starts are labelled by minimum cuts and
/// compared. Method::Film: a film evolves, then rounds of field and cut correct it.
class Pipeline {
 public:
  /// `points`: what the sites were made of. All arguments must outlive the pipeline.
  Pipeline(const PointsView& points, const SiteSet& sites, const SiteGeometry& geometry,
           const Options& options, Monitor& monitor, Report& report);

  /// Returns a closed manifold; with Options::open_boundary it may have a boundary. Empty if no surface is
  /// found. Once only. `tetrahedra`: the Delaunay triangulation of the perturbed sites.
  FoundSurface run(Tetrahedra tetrahedra);

  /// Instead of run(): returns the open surface of a depth image without triangulating; returns nothing if
  /// the sites form no depth image.
  std::optional<FoundSurface> visible_surface();

  /// The last resort, after run(): the tetrahedron of largest volume, grown to the sites that it reaches. A
  /// closed manifold; empty only if all tetrahedra are flat.
  Surface around_one_tetrahedron();

 private:
  struct Candidate {
    Surface surface;
    bool open = false;          ///< bridge faces are removed from the surface
    SurfaceQuality quality;     ///< after insertion
    std::int64_t inserted = 0;  ///< sites that joined the surface at the end, by insertion or moves
    double missed = 0;          ///< fraction of the sites that the first cut missed
    std::vector<char> labels;   ///< [tetrahedron]: 1 inside; empty if there was no cut
    /// [tetrahedron]: the penalty of the label that its sign opposes; positive favours inside, negative
    /// favours outside (LabelCosts).
    std::vector<double> hold;
    std::optional<Vec3> viewpoint{};  ///< of a depth image
    double score() const;             ///< lower is better
  };
  // The labels of several cuts by one belief.
  struct Cuts {
    /// `first`: the first cut that keeps 80 % of the sites, else the best. `best`: the cut that keeps most.
    std::vector<char> first, best;
    double missed = 0;       ///< fraction of the sites that the first of all cuts missed
    bool has_shape = false;  ///< the best keeps at least half of the sites
  };
  enum class Mend {
    Plugs,  ///< only plugs: quick
    All,    ///< all moves
  };

  // Evidence.
  std::vector<double> prepare(Tetrahedra tetrahedra);
  std::vector<double> off_prices() const;
  std::vector<double> ball_belief(double limit, double slope) const;
  std::vector<double> winding_belief(const Surface& film) const;
  std::vector<double> belief_of(const std::vector<char>& labels) const;
  std::vector<double> held(std::vector<double> belief, double conviction) const;
  void use_normals_of(const Surface& surface);
  std::vector<char> film_from_sphere();

  // Labellings.
  Candidate labelling(std::vector<double> guess);
  Candidate beyond_first(Candidate best);
  Candidate or_solid(Candidate first, Candidate found);
  Candidate cut(const std::vector<double>& belief, double conviction, bool open,
                bool reaches_infinity = false);
  Cuts several_cuts(const std::vector<double>& hold, bool reaches_infinity);
  Candidate cut_sides(const RimRule& rim, const Vec3* viewpoint, bool open, bool reaches_infinity);
  Candidate cut_two_sides();
  Candidate cut_image(const Vec3& viewpoint);
  Candidate with_sides(Candidate best, Candidate sides);
  Candidate closed_if_torn(Candidate open, Candidate closed);
  Candidate by_widths(Candidate best, bool& two_sided);
  Candidate carve_further(Candidate best, bool two_sided);
  Candidate refined(Candidate best);
  Candidate mended(Candidate candidate, Mend mend = Mend::All);
  Surface surface_of(const std::vector<char>& labels, bool open) const;
  std::vector<char> exempt(const std::vector<char>& labels, bool open) const;

  // Depth images.
  std::vector<Vec3> exact_places() const;
  std::optional<Vec3> given_viewpoint() const;
  std::optional<DepthImage> image_of(const std::vector<Vec3>& places);
  std::optional<DepthImage> given_view();
  bool is_better_view(const DepthImage& image, Surface found) const;

  // Comparisons.
  Candidate measured(Candidate candidate) const;
  double open_surface_score(const SurfaceQuality& quality) const;    // lower is better
  double closed_surface_score(const SurfaceQuality& quality) const;  // lower is better
  static bool has_shape(const Candidate& candidate);
  static bool needs_no_round(const Candidate& candidate);

  // The paper's film.
  std::vector<std::function<Surface()>> first_films() const;
  FilmOptions film_options();
  Candidate film_from_outside();
  Candidate manifold_film(std::vector<char> labels);
  Candidate without_dangling(const Candidate& film);
  Candidate after_last_step(Candidate candidate);
  void rounds(Candidate& best);
  void show(const Surface& surface) const;

  const PointsView& points_;
  const SiteSet& sites_;
  const SiteGeometry& geometry_;
  const Options& options_;
  Monitor& monitor_;
  Report& report_;
  const bool open_;  // Options::open_boundary
  TetrahedralMesh mesh_;
  // By the normals of neighbourhoods at first; refined() replaces it by the normals of its best surface.
  FacetEvidence evidence_;
};

}  // namespace filmsticking

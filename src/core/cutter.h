// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "evidence/facet_evidence.h"
#include "filmsticking/options.h"
#include "geometry/monitor.h"
#include "geometry/surface.h"
#include "points/site_geometry.h"
#include "points/site_set.h"
#include "surface/surface_quality.h"

namespace filmsticking {

class Labelling;

/// A surface that is compared with others by its energy.
struct Candidate {
  Surface surface;
  SurfaceQuality quality;  ///< of the surface
  /// surface_energy(), by the normals of neighbourhoods. The least is the best; infinite for no surface.
  double energy = std::numeric_limits<double>::infinity();
  bool open = false;          ///< bridge faces are removed from the surface
  std::int64_t inserted = 0;  ///< sites that joined the surface at the end, by insertion or moves
  double missed = 0;          ///< fraction of the sites that the first cut missed
  std::vector<char> labels;   ///< [tetrahedron]: 1 inside; empty if there was no cut
  /// [tetrahedron]: the penalty of the label that its sign opposes; positive favours inside, negative
  /// favours outside (LabelCosts).
  std::vector<double> hold;
  std::optional<Vec3> viewpoint{};  ///< of a depth image

  bool empty() const { return surface.triangles.empty(); }
};

/// By energy.
inline bool less(const Candidate& a, const Candidate& b) { return a.energy < b.energy; }

/// Weight of a belief against the facets' evidence, per area.
constexpr double kConviction = 0.1;

/// How far the inside of a cut may reach, and which candidate it must be able to beat.
struct CutLimits {
  bool reaches_infinity = false;     ///< the inside may
  const Candidate* rival = nullptr;  ///< it cannot become better than this
};

/// Makes candidates: it labels the Delaunay tetrahedra by minimum cuts, makes the labels a manifold, mends
/// them, and measures their surface. All its functions throw Cancelled.
class Cutter {
 public:
  /// `points`: what the sites were made of. All arguments must outlive it.
  Cutter(const PointsView& points, const SiteSet& sites, const SiteGeometry& geometry, const Options& options,
         Monitor& monitor);

  /// Before anything else: the Delaunay triangulation of the perturbed sites.
  void take(Tetrahedra tetrahedra);
  /// What is known of tetrahedra by sight, from now on a term of every cut and of the energy.
  void use_sight(std::vector<float> votes);
  /// Gives sight up, and returns its votes.
  std::vector<float> forget_sight();
  /// What sight takes for outside is inside from now on: that of a room. Returns the belief by sight alone.
  std::vector<double> turn_sight_over();
  const TetrahedralMesh& mesh() const { return mesh_; }
  const FacetEvidence& evidence() const { return evidence_; }

  /// Cuts by a belief, per tetrahedron: about 1 inside, -1 outside. `conviction`: its weight. `open`: bridge
  /// faces are removed. Empty if the best cut keeps fewer than half of the sites, or by the limits.
  Candidate cut(std::vector<double> belief, double conviction, bool open, const CutLimits& limits = {});
  /// Cuts by local evidence alone: the signed field from a guess.
  Candidate cut_field(std::vector<double> guess, bool open);
  /// Cuts by the ball that carves the outside and does not enter places narrower than `width` spacings.
  Candidate cut_ball(double width, double conviction, bool open);
  /// Cuts by the two sides of an open surface, which are known from the facets alone.
  Candidate cut_sides(const Vec3* viewpoint, bool open, const Candidate* rival = nullptr);

  /// Cuts again by evidence from the surface's own normals, while that lowers the energy. They are better
  /// than those of neighbourhoods, which reach across thin walls and edges. Leaves them as the evidence.
  /// Gaps are filled later: a surface with filled gaps would keep the errors beside them in the next cut.
  Candidate refined(Candidate candidate);

  /// Closes most chance gaps, quickly.
  Candidate plugged(Candidate candidate);
  /// Of a plugged one: closes other chance gaps, joins shards, opens cavities.
  Candidate mended(Candidate candidate);

  /// The labels of a film: a manifold, with the sites that are near.
  Candidate by_film(std::vector<char> labels, const UnsetVector<std::array<float, 4>>& prices);
  /// A candidate drawn as far towards an aim as its topology allows.
  Candidate warped(Candidate candidate, const std::vector<char>& aim);

  /// Sets the quality and the energy.
  Candidate measured(Candidate candidate) const;
  /// Evidence by a surface's own normals from now on.
  void use_normals_of(const Surface& surface);

  /// The last resort: the tetrahedron of largest volume, grown to the sites that it reaches, which are
  /// counted as inserted. A closed manifold; empty only if all tetrahedra are flat.
  Candidate around_one_tetrahedron();

 private:
  struct Cuts;
  Candidate moved(Candidate candidate, const std::function<bool(Labelling&)>& moves);
  void settle(Labelling& labelling, Candidate& candidate) const;
  double least_energy(const std::vector<char>& labels, bool open) const;
  Cuts several_cuts(const std::vector<double>& hold, const CutLimits& limits);
  std::vector<double> off_prices() const;
  double blocked_lines(const std::vector<char>& labels) const;
  std::vector<char> exempt(const std::vector<char>& labels, bool open) const;
  Surface surface_of(const std::vector<char>& labels, bool open) const;

  const PointsView& points_;
  const SiteSet& sites_;
  const SiteGeometry& geometry_;
  const Options& options_;
  Monitor& monitor_;
  TetrahedralMesh mesh_;
  // By the normals of neighbourhoods at first.
  FacetEvidence evidence_;
  // Sight: in lines, and as areas. Both empty if nothing is known.
  std::vector<float> sight_;
  std::vector<double> known_;
};

/// 1 for inside and -1 for outside.
std::vector<double> belief_of(const std::vector<char>& labels);

}  // namespace filmsticking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/facet_evidence.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

constexpr double kVotePrice[4] = {1.0, 0.6, 0.25, 0.02};
constexpr double kQualityPrice = 0.3;

// Does the segment from p to p + along, or the ray, cross the plane through v within `reach` of v?
bool crosses(const Vec3& p, const Vec3& along, bool ray, const Vec3& v, const Vec3& normal, double reach) {
  const double hp = normal.dot(p - v), step = normal.dot(along);
  if (step == 0) return false;
  const double s = -hp / step;
  if (s < 0 || (!ray && s > 1)) return false;
  return (p + s * along - v).squaredNorm() <= reach * reach;
}

// Of the angle between a facet and the circumsphere of t.
double cosine(const TetrahedralMesh& mesh, Index t, const Vec3& corner, const Vec3& unit_normal_away) {
  if (mesh.tets.infinite(t)) return 1;
  const double r = mesh.circumradius[t];
  return r > 0 ? std::clamp(-unit_normal_away.dot(mesh.circumcentre[t] - corner) / r, -1.0, 1.0) : -1;
}

}  // namespace

double sampled_area(const TetrahedralMesh& mesh, const FacetEvidence& evidence, const SiteGeometry& geometry,
                    std::size_t t, int k) {
  double spacing = 0;
  for (const int j : kFacet[k])
    if (const Index v = mesh.tets.corners[t][j]; v != kNone) spacing = std::max(spacing, geometry.spacing[v]);
  return std::min(double{evidence.area[t][k]}, kMostSamples * spacing * spacing);
}

FacetEvidence facet_evidence(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                             const SiteGeometry& geometry) {
  FacetEvidence evidence;
  evidence.area.resize(mesh.size());
  evidence.votes.resize(mesh.size());
  evidence.cost.resize(mesh.size());
  parallel_each(mesh.size(), [&](std::size_t ti) {
    const Index t = static_cast<Index>(ti);
    evidence.area[t] = {0, 0, 0, 0}, evidence.votes[t] = {0, 0, 0, 0}, evidence.cost[t] = {0, 0, 0, 0};
    for (int k = 0; k < 4; ++k) {
      const Index mirror = mesh.mirror[t][k], u = mirror / 4;
      if (mirror < 4 * t + k) continue;  // the other side computes this facet
      const auto& corners = mesh.tets.corners[t];
      const Index ids[3] = {corners[kFacet[k][0]], corners[kFacet[k][1]], corners[kFacet[k][2]]};
      if (ids[0] == kNone || ids[1] == kNone || ids[2] == kNone) continue;
      const Vec3& a = sites[ids[0]];
      Vec3 normal = (sites[ids[1]] - a).cross(sites[ids[2]] - a);  // out of t
      const double area = normal.norm() / 2;
      if (area > 0) normal /= 2 * area;
      const double quality = 1 - std::min(cosine(mesh, t, a, normal), cosine(mesh, u, a, Vec3(-normal)));
      const bool infinite_t = mesh.tets.infinite(t), infinite_u = mesh.tets.infinite(u);
      int votes = 0;
      if (!(infinite_t && infinite_u)) {
        const Vec3 from = mesh.circumcentre[infinite_t ? u : t];
        const bool ray = infinite_t || infinite_u;
        const Vec3 along = infinite_t   ? Vec3(-normal)
                           : infinite_u ? normal
                                        : Vec3(mesh.circumcentre[u] - from);
        for (Index v : ids)
          votes += crosses(from, along, ray, sites[v], geometry.normal[v], 2 * geometry.spacing[v]);
      }
      evidence.area[t][k] = static_cast<float>(area);
      evidence.votes[t][k] = static_cast<signed char>(votes);
      evidence.cost[t][k] = static_cast<float>(area * (kVotePrice[votes] + kQualityPrice * quality));
    }
  });
  // Copy to the mirror facets.
  parallel_each(mesh.size(), [&](std::size_t ti) {
    const Index t = static_cast<Index>(ti);
    for (int k = 0; k < 4; ++k) {
      const Index mirror = mesh.mirror[t][k];
      if (mirror > 4 * t + k) continue;
      evidence.area[t][k] = evidence.area[mirror / 4][mirror % 4];
      evidence.votes[t][k] = evidence.votes[mirror / 4][mirror % 4];
      evidence.cost[t][k] = evidence.cost[mirror / 4][mirror % 4];
    }
  });
  return evidence;
}

}  // namespace filmsticking

// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what each stage of the core makes of a cloud, as coloured PLY files that mesh_snapshot draws. The
// figures of docs/method.md come from here; docs/pictures/stages/draw.sh has the commands.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "evidence/facet_evidence.h"
#include "evidence/signed_field.h"
#include "film/dense_film.h"
#include "geometry/triangle_adjacency.h"
#include "io/cloud.h"
#include "io/formats.h"
#include "labelling/labelling.h"
#include "labelling/mend.h"
#include "labelling/reach.h"
#include "labelling/repair.h"
#include "labelling/sculpt.h"
#include "labelling/surface_sheets.h"
#include "labelling/unfold.h"
#include "labelling/warp.h"
#include "points/site_set.h"
#include "surface/energy.h"
#include "surface/feature_flips.h"
#include "surface/surface_normals.h"
#include "surface/surface_quality.h"

namespace filmsticking {
namespace {

constexpr io::Colour kPlain{224, 219, 209}, kBlue{44, 127, 184}, kRed{222, 45, 38}, kOrange{253, 174, 97};
constexpr io::Colour kVotes[] = {kPlain, kOrange, {127, 188, 120}, kBlue};

/// Faces with a colour each, in the coordinates of the input.
class Picture {
 public:
  explicit Picture(const SiteSet& sites) : sites_(sites) {}

  void add(std::vector<Vec3> polygon, const io::Colour& colour) {
    polygons_.push_back(std::move(polygon));
    colours_.push_back(colour);
  }
  void add(const Corners& face, const io::Colour& colour) {
    add({sites_.perturbed[face[0]], sites_.perturbed[face[1]], sites_.perturbed[face[2]]}, colour);
  }

  /// Triangles share no vertices, so that each has one colour; each is written with its back, so that
  /// mesh_snapshot draws no rims around it.
  void write(const std::string& path) const {
    std::vector<Point> positions;
    std::vector<io::Colour> colours;
    std::vector<Triangle> triangles;
    for (std::size_t f = 0; f < polygons_.size(); ++f)
      for (std::size_t v = 2; v < polygons_[f].size(); ++v) {
        const auto first = static_cast<std::int32_t>(positions.size());
        for (const std::size_t corner : {std::size_t{0}, v - 1, v}) {
          positions.push_back(sites_.to_input(polygons_[f][corner]));
          colours.push_back(colours_[f]);
        }
        triangles.push_back({first, first + 1, first + 2});
        triangles.push_back({first, first + 2, first + 1});
      }
    io::write_mesh(path, io::make_cloud(positions, colours), triangles);
  }

 private:
  const SiteSet& sites_;
  std::vector<std::vector<Vec3>> polygons_;
  std::vector<io::Colour> colours_;
};

/// The stages of the default method as far as a plain closed surface needs them, in the order of Pipeline.
class Stages {
 public:
  explicit Stages(const std::vector<Point>& cloud)
      : set_(make_site_set(cloud)), sites_(set_.perturbed), geometry_(site_geometry(sites_)) {
    mesh_ = make_tetrahedral_mesh(delaunay_tetrahedra(sites_), sites_);
    evidence_ = facet_evidence(mesh_, sites_, geometry_);
    for (const char inside : dense_film(mesh_, sites_, geometry_.spacing, 2))
      guess_.push_back(inside != 0 ? 1 : -1);
    field_ = signed_field(mesh_, evidence_, geometry_, guess_);
    cut_again();
    cut_by_own_normals();
  }

  const std::vector<double>& guess() const { return guess_; }
  const std::vector<double>& field() const { return field_; }

  /// A small tetrahedron at every site.
  void write_points(const std::string& path) const {
    constexpr int kSigns[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    Picture picture(set_);
    for (std::size_t v = 0; v < sites_.size(); ++v)
      for (const auto& face : kFacet) {
        std::vector<Vec3> corners;
        for (const int k : face)
          corners.push_back(sites_[v] +
                            0.15 * geometry_.spacing[v] * Vec3(kSigns[k][0], kSigns[k][1], kSigns[k][2]));
        picture.add(std::move(corners), kBlue);
      }
    picture.write(path);
  }

  /// Facets with votes: one orange, two green, three blue.
  void write_votes(const std::string& path) const {
    Picture picture(set_);
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      for (int k = 0; k < 4; ++k) {
        const auto& c = mesh_.tets.corners[t];
        const int votes = evidence_.votes[t][k];
        if (votes > 0 && mesh_.mirror[t][k] > 4 * static_cast<Index>(t) + k)  // once, of its two sides
          picture.add({c[kFacet[k][0]], c[kFacet[k][1]], c[kFacet[k][2]]}, kVotes[votes]);
      }
    picture.write(path);
  }

  /// A section of the tetrahedra at half the height, coloured by a value each from -1 to 1, and the surface
  /// below it.
  void write_slice(const std::string& path, const std::vector<double>& value, const Surface& surface) const {
    Picture picture(set_);
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      if (!mesh_.tets.infinite(static_cast<Index>(t))) picture.add(section(t), colour_of(value[t]));
    for (const Corners& face : surface.triangles) {
      const Corners corners = in_sites(surface, face);
      if (std::all_of(corners.begin(), corners.end(), [&](Index v) { return height(sites_[v]) < 0; }))
        picture.add(corners, kPlain);
    }
    picture.write(path);
  }

  /// Faces at sites where the surface is no disc are red.
  void write_cut(const std::string& path) const {
    const std::vector<Sheets> sheets = surface_sheets(mesh_, cut_, sites_.size());
    std::printf("%s: %td sites missed, %td where the surface is no disc\n", path.c_str(),
                std::count(sheets.begin(), sheets.end(), Sheets::None),
                std::count(sheets.begin(), sheets.end(), Sheets::Other));
    Picture picture(set_);
    for (const Corners& face : tetrahedral_boundary(mesh_, cut_))
      picture.add(face,
                  std::any_of(face.begin(), face.end(), [&](Index v) { return sheets[v] == Sheets::Other; })
                      ? kRed
                      : kPlain);
    picture.write(path);
  }

  /// The cut made a manifold and warped to its sites, then mended. In both files the faces that were not
  /// there before are blue. Returns the surface.
  Surface write_mended(const std::string& repaired, const std::string& mended) {
    const LabelCosts costs = prices();
    std::vector<char> labels = cut_;
    Labelling labelling(mesh_, geometry_, costs, labels);
    repair_and_warp(labelling);
    const Surface first = surface_of(labels);
    write_changes(repaired, faces_of(surface_of(cut_)), first);
    mend(labelling, sites_);
    unfold(labelling);
    reach(labelling);
    const Surface second = surface_of(labels);
    write_changes(mended, faces_of(first), second);
    return second;
  }

  void write_sharp(const std::string& path, Surface surface) const {
    std::vector<Index> twins =
        half_edge_twins(surface.triangles, static_cast<Index>(surface.positions.size()));
    flip_to_features(surface, twins);
    write_changes(path, faces_of(surface), surface);
  }

 private:
  std::vector<char> sites_missed(const std::vector<char>& labels) const {
    std::vector<char> sides(sites_.size(), 0), missed(sites_.size());
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      for (const Index v : mesh_.tets.corners[t])
        if (v != kNone) sides[v] = static_cast<char>(sides[v] | (labels[t] ? 1 : 2));
    for (std::size_t v = 0; v < missed.size(); ++v) missed[v] = sides[v] != 3;
    return missed;
  }

  LabelCosts prices() const {
    LabelCosts costs{evidence_.cost, hold_, {}};
    for (const double spacing : geometry_.spacing)
      costs.off.push_back(EnergyPrices().off * spacing * spacing);
    return costs;
  }

  void repair_and_warp(Labelling& labelling) const {
    repair(labelling);
    warp(labelling, aim_);
    unfold(labelling);
    reach(labelling);
  }

  // Cuts again by the normals of the first surface.
  void cut_by_own_normals() {
    const LabelCosts costs = prices();
    std::vector<char> labels = cut_;
    Labelling labelling(mesh_, geometry_, costs, labels);
    repair_and_warp(labelling);
    SiteGeometry own = geometry_;
    own.normal = surface_normals(surface_of(labels), std::move(own.normal));
    evidence_ = facet_evidence(mesh_, sites_, own);
    std::vector<double> belief;
    for (const char inside : labels) belief.push_back(inside != 0 ? 1 : -1);
    field_ = signed_field(mesh_, evidence_, geometry_, std::move(belief));
    cut_again();
  }

  // The first cut, and the last of those that hold four times as firmly to the field around missed sites.
  void cut_again() {
    hold_.resize(mesh_.size());
    for (std::size_t t = 0; t < mesh_.size(); ++t) {
      const auto& area = evidence_.area[t];
      hold_[t] = 0.1 * (double{area[0]} + area[1] + area[2] + area[3]) * field_[t];
    }
    Sculptor sculptor(mesh_, evidence_, hold_);
    std::vector<double> hold = hold_;
    cut_ = aim_ = sculptor.cut();
    for (int cut = 1; cut < 6; ++cut) {
      const std::vector<char> missed = sites_missed(aim_);
      for (std::size_t t = 0; t < mesh_.size(); ++t) {
        const auto& c = mesh_.tets.corners[t];
        if (std::none_of(c.begin(), c.end(), [&](Index v) { return v != kNone && missed[v]; })) continue;
        sculptor.hold_firmly(static_cast<Index>(t), hold[t], 4 * hold[t]);
        hold[t] *= 4;
      }
      aim_ = sculptor.cut();
    }
  }

  Surface surface_of(const std::vector<char>& labels) const {
    return unsorted_surface_of_sites(tetrahedral_boundary(mesh_, labels), sites_);
  }

  using Faces = std::set<Corners>;  // of sites in rising order

  static Corners sorted(Corners face) {
    std::sort(face.begin(), face.end());
    return face;
  }
  static Corners in_sites(const Surface& surface, Corners face) {
    for (Index& v : face) v = surface.site[v];
    return face;
  }
  static Faces faces_of(const Surface& surface) {
    Faces found;
    for (const Corners& face : surface.triangles) found.insert(sorted(in_sites(surface, face)));
    return found;
  }

  void write_changes(const std::string& path, const Faces& before, const Surface& surface) const {
    Picture picture(set_);
    for (const Corners& face : surface.triangles) {
      const Corners corners = in_sites(surface, face);
      picture.add(corners, before.count(sorted(corners)) ? kPlain : kBlue);
    }
    picture.write(path);
    const SurfaceQuality quality = surface_quality(surface, geometry_);
    std::printf("%s: %zu sites, %td handles\n", path.c_str(), surface.site.size(), quality.handles);
  }

  /// White where the value is 0, blue at 1 (inside), orange at -1.
  static io::Colour colour_of(double value) {
    const double share = std::min(1.0, std::abs(value));
    const io::Colour& end = value > 0 ? kBlue : kOrange;
    io::Colour colour{};
    for (int k = 0; k < 3; ++k) colour[k] = static_cast<std::uint8_t>(255 + share * (end[k] - 255.0));
    return colour;
  }

  /// Above the middle of the cloud's box, along the input's y.
  double height(const Vec3& p) const { return set_.turn.back(p).y(); }

  /// Where the plane of height 0 cuts a tetrahedron: three corners, four, or none.
  std::vector<Vec3> section(std::size_t t) const {
    std::vector<Vec3> above, below, corners;
    for (const Index v : mesh_.tets.corners[t]) (height(sites_[v]) > 0 ? above : below).push_back(sites_[v]);
    for (std::size_t a = 0; a < above.size(); ++a)
      for (std::size_t i = 0; i < below.size(); ++i) {
        const std::size_t b = a % 2 == 0 ? i : below.size() - 1 - i;  // around a quadrangle
        const double share = height(above[a]) / (height(above[a]) - height(below[b]));
        corners.push_back(above[a] + share * (below[b] - above[a]));
      }
    return corners;
  }

  const SiteSet set_;
  const std::vector<Vec3>& sites_;
  const SiteGeometry geometry_;
  TetrahedralMesh mesh_;
  FacetEvidence evidence_;
  std::vector<double> guess_, field_, hold_;
  std::vector<char> cut_, aim_;
};

void draw(const std::string& cloud, const std::string& folder) {
  Stages stages(io::positions_of(io::read_cloud(cloud).points));
  stages.write_votes(folder + "/votes.ply");
  stages.write_cut(folder + "/cut.ply");
  stages.write_points(folder + "/points.ply");
  Surface surface = stages.write_mended(folder + "/repaired.ply", folder + "/mended.ply");
  stages.write_slice(folder + "/guess.ply", stages.guess(), surface);
  stages.write_slice(folder + "/field.ply", stages.field(), surface);
  stages.write_sharp(folder + "/sharp.ply", std::move(surface));
}

}  // namespace
}  // namespace filmsticking

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s CLOUD.(ply|pcd|xyz) FOLDER\n", argv[0]);
    return 2;
  }
  try {
    filmsticking::draw(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "draw_stages: %s\n", error.what());
    return 1;
  }
}

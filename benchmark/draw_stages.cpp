// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what each stage of the core makes of a cloud, as coloured PLY files that mesh_snapshot draws. The
// figures of docs/method.md come from here; the commands are in docs/figures.md.
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "delaunay/delaunay.h"
#include "evidence/ball.h"
#include "evidence/facet_evidence.h"
#include "evidence/signed_field.h"
#include "geometry/triangle_adjacency.h"
#include "io/model_file.h"
#include "labelling/manifold_labels.h"
#include "labelling/sculpt.h"
#include "labelling/surface_sheets.h"
#include "points/site_set.h"
#include "surface/feature_flips.h"

namespace filmsticking {
namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kPlain{224, 219, 209}, kBlue{44, 127, 184}, kRed{222, 45, 38}, kOrange{253, 174, 97};
// Two votes and three; one vote is orange.
constexpr Colour kVotes[] = {kPlain, kOrange, {127, 188, 120}, kBlue};

/// Faces with a colour each, in the coordinates of the input.
class Picture {
 public:
  explicit Picture(const SiteSet& sites) : sites_(sites) {}

  void add(const Corners& face, const Colour& colour) {
    faces_.push_back(face);
    colours_.push_back(colour);
  }

  /// Faces share no vertices, so that each has one colour; each is written with its back, so that
  /// mesh_snapshot draws no rims around it.
  void write(const std::string& path) const {
    io::Model model;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const auto first = static_cast<std::int32_t>(model.positions.size());
      for (const Index v : faces_[f]) {
        model.positions.push_back(sites_.to_input(sites_.perturbed[v]));
        model.colours.push_back(colours_[f]);
      }
      model.triangles.push_back({first, first + 1, first + 2});
      model.triangles.push_back({first, first + 2, first + 1});
    }
    io::write_model(path, model);
    std::printf("%s: %zu faces\n", path.c_str(), faces_.size());
  }

 private:
  const SiteSet& sites_;
  std::vector<Corners> faces_;
  std::vector<Colour> colours_;
};

/// The stages of the default method as far as a plain closed surface needs them, in the order of Pipeline.
class Stages {
 public:
  explicit Stages(const std::vector<Point>& cloud)
      : set_(make_site_set(cloud)), sites_(set_.perturbed), geometry_(site_geometry(sites_)) {
    mesh_ = make_tetrahedral_mesh(delaunay_tetrahedra(sites_), sites_);
    evidence_ = facet_evidence(mesh_, sites_, geometry_);
    guess_ = carve_widths(mesh_, sites_, geometry_.spacing, 1, 3);
    for (double& width : guess_) width = std::clamp((2 - width) * 3, -1.0, 1.0);
    field_ = signed_field(mesh_, evidence_, guess_);
    hold_.resize(mesh_.size());
    for (std::size_t t = 0; t < mesh_.size(); ++t) {
      const auto& area = evidence_.area[t];
      hold_[t] = 0.1 * (double{area[0]} + area[1] + area[2] + area[3]) * field_[t];
    }
    cut_ = Sculptor(mesh_, evidence_, hold_).cut();
  }

  void write_votes(const std::string& path) const {
    Picture picture(set_);
    each_facet([&](std::size_t t, int k, std::size_t) {
      const int votes = evidence_.votes[t][k];
      if (votes > 0) picture.add(facet(t, k), kVotes[votes]);
    });
    picture.write(path);
  }

  /// The tetrahedra behind the middle of the cloud, coloured by a value each from -1 to 1.
  void write_half(const std::string& path, const std::vector<double>& value) const {
    Picture picture(set_);
    std::vector<char> behind(mesh_.size());
    for (std::size_t t = 0; t < mesh_.size(); ++t) behind[t] = is_behind(t);
    each_facet([&](std::size_t t, int k, std::size_t other) {
      if (behind[t] == behind[other]) return;
      picture.add(facet(t, k), colour_of(value[behind[t] ? t : other]));
    });
    picture.write(path);
  }

  void write_guess(const std::string& path) const { write_half(path, guess_); }
  void write_field(const std::string& path) const { write_half(path, field_); }

  /// Faces at sites where the surface is no disc are red.
  void write_cut(const std::string& path) const {
    const std::vector<Sheets> sheets = surface_sheets(mesh_, cut_, sites_.size());
    Picture picture(set_);
    for (const Corners& face : tetrahedral_boundary(mesh_, cut_))
      picture.add(face,
                  std::any_of(face.begin(), face.end(), [&](Index v) { return sheets[v] == Sheets::Other; })
                      ? kRed
                      : kPlain);
    picture.write(path);
  }

  /// Faces that the cut did not have are blue. Returns the surface.
  Surface write_mended(const std::string& path) {
    LabelCosts costs{evidence_.cost, hold_, {}};
    for (const double spacing : geometry_.spacing) costs.off.push_back(5 * spacing * spacing);
    std::vector<char> labels = cut_;
    ManifoldLabels manifold(mesh_, geometry_, costs, labels);
    manifold.repair();
    manifold.unfold();
    manifold.reach();
    Surface surface = unsorted_surface_of_sites(tetrahedral_boundary(mesh_, labels), sites_);
    write_changes(path, corners_of(tetrahedral_boundary(mesh_, cut_)), surface);
    return surface;
  }

  /// Faces that were not there before the flips are blue.
  void write_sharp(const std::string& path, Surface surface) const {
    const std::map<Corners, int> before = faces_of(surface);
    std::vector<Index> twins =
        half_edge_twins(surface.triangles, static_cast<Index>(surface.positions.size()));
    flip_to_features(surface, twins);
    write_changes(path, before, surface);
  }

 private:
  static Corners sorted(Corners face) {
    std::sort(face.begin(), face.end());
    return face;
  }
  static std::map<Corners, int> corners_of(const std::vector<Corners>& faces) {
    std::map<Corners, int> found;
    for (const Corners& face : faces) ++found[sorted(face)];
    return found;
  }
  static Corners in_sites(const Surface& surface, Corners face) {
    for (Index& v : face) v = surface.site[v];
    return face;
  }
  static std::map<Corners, int> faces_of(const Surface& surface) {
    std::map<Corners, int> found;
    for (const Corners& face : surface.triangles) ++found[sorted(in_sites(surface, face))];
    return found;
  }
  void write_changes(const std::string& path, const std::map<Corners, int>& before,
                     const Surface& surface) const {
    Picture picture(set_);
    for (const Corners& face : surface.triangles) {
      const Corners corners = in_sites(surface, face);
      picture.add(corners, before.count(sorted(corners)) ? kPlain : kBlue);
    }
    picture.write(path);
  }

  /// White where the value is 0, blue at 1 (inside), orange at -1.
  static Colour colour_of(double value) {
    const double share = std::min(1.0, std::abs(value));
    const Colour& end = value > 0 ? kBlue : kOrange;
    Colour colour{};
    for (int k = 0; k < 3; ++k) colour[k] = static_cast<std::uint8_t>(255 + share * (end[k] - 255.0));
    return colour;
  }

  bool is_behind(std::size_t t) const {
    if (mesh_.tets.infinite(static_cast<Index>(t))) return false;
    double z = 0;
    for (const Index v : mesh_.tets.corners[t]) z += set_.to_input(sites_[v])[2] / 4;
    return z < set_.centre.z();
  }

  Corners facet(std::size_t t, int k) const {
    const auto& corners = mesh_.tets.corners[t];
    return {corners[kFacet[k][0]], corners[kFacet[k][1]], corners[kFacet[k][2]]};
  }

  /// Every finite facet once, from a finite tetrahedron.
  void each_facet(const std::function<void(std::size_t, int, std::size_t)>& visit) const {
    for (std::size_t t = 0; t < mesh_.size(); ++t) {
      if (mesh_.tets.infinite(static_cast<Index>(t))) continue;
      for (int k = 0; k < 4; ++k) {
        const Index other = mesh_.tets.neighbours[t][k];
        if (mesh_.tets.infinite(other) || static_cast<std::size_t>(other) > t)
          visit(t, k, static_cast<std::size_t>(other));
      }
    }
  }

  const SiteSet set_;
  const std::vector<Vec3>& sites_;
  const SiteGeometry geometry_;
  TetrahedralMesh mesh_;
  FacetEvidence evidence_;
  std::vector<double> guess_, field_, hold_;
  std::vector<char> cut_;
};

void draw(const std::string& cloud, const std::string& folder) {
  Stages stages(io::read_cloud(cloud).positions);
  stages.write_votes(folder + "/votes.ply");
  stages.write_guess(folder + "/guess.ply");
  stages.write_field(folder + "/field.ply");
  stages.write_cut(folder + "/cut.ply");
  Surface surface = stages.write_mended(folder + "/mended.ply");
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <boost/program_options.hpp>
#include <charconv>
#include <sstream>
#include <vector>

namespace po = boost::program_options;

namespace filmsticking::app {
namespace {

po::options_description visible_options() {
  po::options_description options("Options", 100);
  options.add_options()("points", po::value<std::string>()->value_name("CLOUD"),
                        "the points that the mesh was made from")(
      "truth", po::value<std::string>()->value_name("MESH"), "the true surface")(
      "samples", po::value<std::string>()->value_name("N"),
      "points on each of the two surfaces for the distances between them; default 100000, at most 1000000")(
      "json", "print one JSON object")("help", "print this text");
  return options;
}

std::size_t parse_samples(const std::string& text) {
  std::size_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < 1 || value > mesh_report::kMostSamples)
    throw UsageError("--samples takes a whole number from 1 to 1000000, not '" + text + "'");
  return value;
}

const char* const kDefinitions = R"(
The mesh (names of JSON members in brackets)
  Vertices at the very same place count as one, faces that then repeat a vertex and vertices without a face
  not at all; neither does a face with a corner that is not finite or farther out than 1e100.
  closed              no edge has only one face [boundary_edges]
  manifold            no edge has more than two faces [non_manifold_edges], and the faces around every vertex
                      are one ring or one fan [non_manifold_vertices: where not, or on such an edge]
  oriented            the two faces of every edge run along it in opposite directions
  outward             closed, oriented, and the volume is positive
  components          pieces that share no vertex
  genus               handles of all components together; null unless closed, manifold and two-sided
  self_intersections  pairs of faces that meet elsewhere than in the corners and edges they share; counted up
                      to 10000000
  area, volume        in the mesh's unit; volume is signed, and null unless closed and oriented

With --points
  points              distinct finite positions in the cloud
  interpolated        percent of them with a vertex within 1e-7 of the diagonal of the cloud's box
  cloud_distance_mean, cloud_distance_max   from the points to the mesh, in the cloud's unit

With --truth
  Both surfaces are moved and scaled by what brings the truth's box to the origin and its longest side to 1;
  N points spread evenly over the area of each are measured to the other. Same files, same points.
  chamfer_e3          mean of the two mean distances, x 1000
  f_score             percent: harmonic mean of the two shares of points nearer than 0.005
  normal_consistency  percent: mean of the two mean |cosines| between the normals of a point's own face and
                      of the nearest
  turned_over         percent of the mesh whose faces look the other way than the nearest of the truth, or
                      that do not, whichever is less
  hausdorff           the largest of the distances
  sharp_edges         edges of the truth that bend by more than 30 degrees, both ends vertices of the mesh
  sharp_edges_restored  percent of them that are edges of the mesh; null without any
  genus_right, components_right   as the truth has it; a surface without a genus is never right
  topology_right      both are
  The distances are null where one of the two has no area.
)";

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  po::options_description all = visible_options();
  all.add_options()("file", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("file", -1);
  po::variables_map given;
  try {
    using namespace po::command_line_style;
    const int style = allow_long | long_allow_adjacent | long_allow_next;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }

  CommandLine command;
  command.help = given.count("help") > 0;
  if (command.help) return command;
  if (!given.count("file") || given["file"].as<std::vector<std::string>>().size() != 1)
    throw UsageError("one MESH is needed; --help tells more");
  command.mesh = given["file"].as<std::vector<std::string>>()[0];
  if (given.count("truth")) command.truth = given["truth"].as<std::string>();
  if (given.count("points")) command.points = given["points"].as<std::string>();
  if (given.count("samples")) command.samples = parse_samples(given["samples"].as<std::string>());
  command.json = given.count("json") > 0;
  return command;
}

std::string usage() {
  std::ostringstream text;
  text << "usage: mesh_report MESH [options]\n\n"
          "Tells whether a mesh is closed, manifold and free of self-intersections, how near it is to the "
          "points\n"
          "it was made from, and how near to the true surface.\n"
          "  MESH   .ply .obj .stl .vtk (and clouds, as meshes without faces)\n"
          "  CLOUD  .pcd .ply .obj .stl .xyz .txt (of a mesh, the vertices)\n\n"
       << visible_options() << kDefinitions
       << "\nExit status: 0 with a report, whatever it says; 2 for a wrong command line, else 1.\n";
  return text.str();
}

}  // namespace filmsticking::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include "common/arguments.h"
#include "common/ground_argument.h"
#include "common/html_argument.h"

namespace filmsticking::app {
namespace {

void add_options(Arguments& arguments, CommandLine& command) {
  arguments.only_flag("--help", "print this text", command.help);
  arguments.option("--points", "CLOUD", "the points that the mesh was made from", command.points);
  arguments.option("--truth", "MESH", "the true surface", command.truth);
  arguments.count("--samples", "N",
                  "points on each of the two surfaces for the distances between them; default 100000, at "
                  "most 1000000",
                  command.samples, 1, mesh_report::kMostSamples);
  arguments.choice("--unit", "mm|cm|m", "the unit of the mesh's coordinates, to be printed with figures",
                   command.unit, std::vector<Choice<std::string>>{{"mm", "mm"}, {"cm", "cm"}, {"m", "m"}});
  add_ground(
      arguments,
      "measure volumes above and below the ground: the plane with the most points, of the cloud if there is "
      "one, or Ax + By + Cz + D = 0, where (A, B, C) points up",
      command.ground);
  add_html(arguments, "write a page to look at, without a network: the mesh with its marks, distances, holes",
           command.html);
  arguments.flag("--json", "print one JSON object", command.json);
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
  component_list      of each component, the largest area first: faces, closed, area, volume

With --ground
  ground              A, B, C, D of the plane, with (A, B, C) of length 1
  volume_above, volume_below   between the surface and the plane, on either side of it; null unless oriented.
                      Faces that look down count negative. The rim of an open surface goes straight to the plane
  volume_net          of an open surface above less below, where noise of the ground cancels; of a closed one
                      their sum

With --points
  points              distinct finite positions in the cloud
  interpolated        percent of them with a vertex within 1e-7 of the diagonal of the cloud's box
  cloud_distance_mean, cloud_distance_max   from the points to the mesh, in the cloud's unit

With --truth
  Both surfaces are moved and scaled alike, so that the box of the truth is at the origin and its longest
  side is 1; N points spread evenly over the area of each are measured to the other. Same files, same points.
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
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  if (!arguments.parse(argc, argv)) return command;
  if (arguments.files().size() != 1) throw UsageError("one MESH is needed; see --help");
  command.mesh = arguments.files()[0];
  return command;
}

std::string usage() {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  return R"(usage: mesh_report MESH [options]

Says whether a mesh is closed, manifold and free of self-intersections, how near it is to the points
it was made from, and how near to the true surface.
  MESH   .ply .obj .stl .vtk (and clouds, as meshes without faces)
  CLOUD  .pcd .ply .obj .stl .xyz .txt (of a mesh, the vertices)
)" + arguments.help() +
         kDefinitions +
         "\nExit status: 0 with a report, whatever it says; 2 for a wrong command line, else 1.\n";
}

}  // namespace filmsticking::app

// SPDX-License-Identifier: GPL-3.0-or-later
// filmsticking._core: reconstruct() for NumPy arrays. filmsticking/__init__.py checks its arguments.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "filmsticking/normals.h"
#include "filmsticking/reconstruct.h"
#include "interruptible.h"

namespace py = pybind11;

namespace filmsticking::python {
namespace {

// An array of the vector's numbers, which it keeps alive. Nothing is copied.
template <class Number, class Element>
py::array array_of(std::vector<Element>&& elements) {
  constexpr std::size_t kColumns = sizeof(Element) / sizeof(Number);
  auto* kept = new std::vector<Element>(std::move(elements));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Element>*>(p); });
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(kept->size())};
  if (kColumns > 1) shape.push_back(static_cast<py::ssize_t>(kColumns));
  return py::array(py::dtype::of<Number>(), shape, reinterpret_cast<const Number*>(kept->data()), owner);
}

PointsView view_of(const py::array& points) {
  const bool has_rows = points.ndim() == 2 && points.shape(1) == 3;
  if (!has_rows || (points.shape(0) > 0 && (points.strides(1) != points.itemsize() || points.strides(0) < 0)))
    throw py::value_error("points must be (n, 3), and the numbers of a point side by side");
  const auto stride = static_cast<std::size_t>(points.strides(0));
  const auto size = static_cast<std::size_t>(points.shape(0));
  if (py::isinstance<py::array_t<float>>(points))
    return {static_cast<const float*>(points.data()), stride, size};
  if (py::isinstance<py::array_t<double>>(points))
    return {static_cast<const double*>(points.data()), stride, size};
  throw py::type_error("points must be float32 or float64");
}

struct PyResult {
  Status status;
  std::string message;
  Report report;
  py::array vertices, triangles, gaps, stability;
};

std::unique_ptr<PyResult> run(const py::array& points, const Options& options, const py::object& progress) {
  const PointsView view = view_of(points);
  Result result = interruptible(
      [&](const Execution& execution) { return reconstruct(view, options, execution); }, progress);
  return std::unique_ptr<PyResult>(new PyResult{
      result.status, std::move(result.message), std::move(result.report),
      array_of<std::int32_t>(std::move(result.vertices)), array_of<std::int32_t>(std::move(result.triangles)),
      array_of<float>(std::move(result.gaps)), array_of<float>(std::move(result.stability))});
}

// (n, 3) float32. The mesh is copied: its arrays may be the caller's.
py::array normals_of(const py::array& points, const py::array_t<std::int32_t, py::array::c_style>& vertices,
                     const py::array_t<std::int32_t, py::array::c_style>& triangles, int threads) {
  const PointsView view = view_of(points);
  if (vertices.ndim() != 1 || triangles.ndim() != 2 || triangles.shape(1) != 3)
    throw py::value_error("vertices must be (v,), and triangles (t, 3)");
  const std::vector<std::int32_t> ids(vertices.data(), vertices.data() + vertices.size());
  std::vector<Triangle> faces(static_cast<std::size_t>(triangles.shape(0)));
  std::copy_n(triangles.data(), 3 * faces.size(), faces.empty() ? nullptr : faces[0].data());
  std::vector<Normal> normals;
  const Result outcome = interruptible(
      [&](const Execution& execution) {
        Result result;
        result.status = point_normals(view, ids, faces, normals, threads, execution.cancel);
        return result;
      },
      py::none());
  if (outcome.status == Status::OutOfMemory) throw std::bad_alloc();
  if (outcome.status != Status::Ok) throw py::value_error(describe(outcome.status));
  return array_of<float>(std::move(normals));
}

void add_status(py::module_& module) {
  py::enum_<Status>(module, "Status", "How a reconstruction ended.")
      .value("Ok", Status::Ok)
      .value("TooFewPoints", Status::TooFewPoints)
      .value("Coplanar", Status::Coplanar)
      .value("InvalidInput", Status::InvalidInput)
      .value("InvalidOptions", Status::InvalidOptions)
      .value("InvalidGuidingSurface", Status::InvalidGuidingSurface)
      .value("NoSurface", Status::NoSurface)
      .value("TooComplex", Status::TooComplex)
      .value("Cancelled", Status::Cancelled)
      .value("OutOfMemory", Status::OutOfMemory)
      .value("InternalError", Status::InternalError);
}

void add_options(py::module_& module) {
  py::class_<Options>(module, "Options")
      .def(py::init<>())
      .def_readwrite("open_boundary", &Options::open_boundary)
      .def_readwrite("max_hole", &Options::max_hole)
      .def_readwrite("viewpoint", &Options::viewpoint)
      .def_readwrite("view_direction", &Options::view_direction)
      .def_readwrite("keep_outliers", &Options::keep_outliers)
      .def_readwrite("sharp_edges", &Options::sharp_edges)
      .def_readwrite("stability", &Options::stability)
      .def_readwrite("threads", &Options::threads)
      .def_readwrite("max_memory", &Options::max_memory);
  // Rows of three, contiguous.
  module.def("set_viewpoints", [](Options& options, const py::array_t<double>& places) {
    const auto rows = places.unchecked<2>();
    std::vector<Point> copy;
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) copy.push_back({rows(i, 0), rows(i, 1), rows(i, 2)});
    options.viewpoints = std::make_shared<const std::vector<Point>>(std::move(copy));
  });
}

void add_report(py::module_& module) {
  py::class_<Hole>(module, "Hole", "A hole of a surface; lengths in the unit of the points.")
      .def_readonly("length", &Hole::length, "Of its rim.")
      .def_readonly("diameter", &Hole::diameter, "Of the smallest ball around its rim.")
      .def_readonly("area", &Hole::area, "Of its rim, projected along its mean normal.")
      .def_readonly("centre", &Hole::centre, "(3,) mean place of its rim.")
      .def_readonly("edges", &Hole::edges, "Of its rim.")
      .def_readonly("closed", &Hole::closed, "It has got a lid.")
      .def_readonly("normal", &Hole::normal, "(3,) unit normal of a lid that winds as the faces around it.");
  py::class_<Report>(module, "Report", "What a reconstruction did; after a failure, filled up to it.")
      .def_readonly("points", &Report::points, "Input points.")
      .def_readonly("sites", &Report::sites, "Distinct finite points.")
      .def_readonly("non_finite", &Report::non_finite, "Points skipped: a coordinate is NaN or infinite.")
      .def_readonly("duplicates", &Report::duplicates, "Points skipped: equal to an earlier one.")
      .def_readonly("interpolated", &Report::interpolated, "Sites that are vertices of the mesh.")
      .def_readonly("outliers", &Report::outliers, "Sites left out because no others are near.")
      .def_readonly("tetrahedra", &Report::tetrahedra, "Of the Delaunay triangulation.")
      .def_readonly("inserted", &Report::inserted, "Insertions of single sites that the cut had missed.")
      .def_readonly("flips", &Report::flips, "Edges flipped along sharp edges and bends.")
      .def_readonly("triangles", &Report::triangles, "Of the mesh.")
      .def_readonly("components", &Report::components, "Of the mesh.")
      .def_readonly("genus", &Report::genus, "Sum over the components.")
      .def_readonly("boundary_edges", &Report::boundary_edges, "Edges with one face.")
      .def_readonly("boundary_loops", &Report::boundary_loops, "Loops of such edges.")
      .def_readonly("holes", &Report::holes, "Of an open surface, also those with a lid; the widest first.")
      .def_readonly("closed", &Report::closed, "Every edge has two faces.")
      .def_readonly("manifold", &Report::manifold, "Oriented, and every vertex has one ring or fan.")
      .def_readonly("seconds", &Report::seconds, "Wall time.")
      .def_readonly("warning", &Report::warning, "One sentence if the mesh is doubtful, else empty.")
      .def_property_readonly(
          "stages",
          [](const Report& report) {
            py::dict seconds;
            for (const RoomSeconds& stage : report.rooms) seconds[stage.room.c_str()] = stage.seconds;
            return seconds;
          },
          "Seconds of each stage, in the order of first entry.");
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The core of FilmstickingPP for NumPy arrays; use the package filmsticking.";
  module.attr("__version__") = FILMSTICKING_VERSION;
  add_status(module);
  add_options(module);
  add_report(module);
  py::class_<PyResult>(module, "Result")
      .def_readonly("status", &PyResult::status)
      .def_readonly("message", &PyResult::message)
      .def_readonly("report", &PyResult::report)
      .def_readonly("vertices", &PyResult::vertices)
      .def_readonly("triangles", &PyResult::triangles)
      .def_readonly("gaps", &PyResult::gaps)
      .def_readonly("stability", &PyResult::stability);
  module.def("reconstruct", &run, py::arg("points"), py::arg("options"), py::arg("progress"));
  module.def("point_normals", &normals_of, py::arg("points"), py::arg("vertices"), py::arg("triangles"),
             py::arg("threads"));
}

}  // namespace filmsticking::python

#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include <pybind11/stl.h>

#include "array_memory.h"
#include "bound_points.h"
#include "long_jobs.h"
#include "parts.h"
#include "viscera/coordinates/weights_binding.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/stiff_binding.h"
#include "viscera/deformation/tetrahedralise.h"

namespace viscera::python {

void requirePose(const BoundPoints& bound, const Points& pose) {
  const Eigen::Index wanted = bound.handles.positions.rows();
  if (pose.rows() != wanted)
    throw DataError("it has " + std::to_string(pose.rows()) + " rows", "handles",
                    "the points are bound to " + std::to_string(wanted));
  if (!pose.allFinite())
    throw DataError("a position is not a finite number", "handles");
}

namespace {

namespace py = pybind11;
using coordinates::CoordinateSystem;
using GivenOptions = std::map<std::string, std::variant<double, std::string>>;
using Groups = std::vector<std::pair<std::string, std::vector<int>>>;

coordinates::ParameterValues valuesFrom(const CoordinateSystem& system, const GivenOptions& given) {
  const auto offered = system.parameters();
  coordinates::ParameterValues values;
  for (const auto& [name, value] : given)
    if (const auto* text = std::get_if<std::string>(&value))
      values.setFromText(offered, name, *text);
    else
      values.set(name, std::get<double>(value));
  values.requireWithin(offered);
  return values;
}

coordinates::HandleSet handleSet(const py::handle& handles, const py::object& cage, const Groups& groups) {
  coordinates::HandleSet set;
  set.positions = *pointsFrom(handles, "handles");
  if (!cage.is_none())
    set.cage = *trianglesFrom(cage, "triangles");
  for (const auto& [name, members] : groups) {
    for (const int handle : members)
      if (handle < 0 || handle >= set.positions.rows())
        throw DataError("there is no handle " + std::to_string(handle), "group " + name,
                        "there are " + std::to_string(set.positions.rows()));
    set.groups.push_back({name, members});
  }
  return set;
}

std::shared_ptr<BoundPoints> bind(const py::object& points, const py::object& handles,
                                  std::shared_ptr<CoordinateSystem> system, const py::object& cage,
                                  const Groups& groups, const GivenOptions& parameters, bool partial,
                                  int threads, const py::object& listener) {
  auto bound = std::make_shared<BoundPoints>();
  bound->system = std::move(system);
  bound->handles = handleSet(handles, cage, groups);
  bound->points = pointsFrom(points, "points");
  bound->options.parameters = valuesFrom(*bound->system, parameters);
  bound->options.threads.count = threads;
  runLong(listener, [&](Progress& progress) {
    const BoundPoints& b = *bound;
    bound->binding = partial ? std::shared_ptr<const coordinates::Binding>(b.system->bind(
                                   b.handles, *b.points, deformation::withTetgen(b.options), progress))
                             : deformation::bindOrgan(*b.system, b.handles, *b.points, b.options, progress);
  });
  return bound;
}

py::array poseBound(const BoundPoints& bound, const py::object& handles, const py::object& out, int threads) {
  const auto posed = pointsFrom(handles, "handles");
  requirePose(bound, *posed);
  if (out.is_none()) {
    Points points;
    unlocked([&] { bound.binding->deform(*posed, points, {threads}); });
    return handOver(std::move(points));
  }
  Points& points = writable(out, bound.binding->pointCount());
  unlocked([&] { bound.binding->deform(*posed, points, {threads}); });
  return py::reinterpret_borrow<py::array>(out);
}

void requireHandle(const BoundPoints& bound, int handle) {
  const Eigen::Index count = bound.binding->handleCount();
  if (handle < 0 || handle >= count)
    throw UsageError("there is no handle " + std::to_string(handle), {},
                     "there are " + std::to_string(count));
}

py::array moveHandle(const BoundPoints& bound, const py::object& handles, int handle, const py::object& delta,
                     const py::object& points, int threads) {
  const auto posed = pointsFrom(handles, "handles");
  requirePose(bound, *posed);
  requireHandle(bound, handle);
  const Vec3 by = vectorFrom(delta, "delta");
  Points& moved = writable(points, bound.binding->pointCount());
  unlocked([&] { bound.binding->moveHandle(*posed, handle, by, moved, {threads}); });
  return py::reinterpret_borrow<py::array>(points);
}

py::array pullBack(const BoundPoints& bound, const py::object& handles, const py::object& pointGradient,
                   int threads) {
  const auto posed = pointsFrom(handles, "handles");
  requirePose(bound, *posed);
  const auto gradient = pointsFrom(pointGradient, "point_gradient");
  if (gradient->rows() != bound.binding->pointCount())
    throw DataError("it has " + std::to_string(gradient->rows()) + " rows", "point_gradient",
                    "one a bound point is wanted: " + std::to_string(bound.binding->pointCount()));
  Points atHandles;
  unlocked([&] { bound.binding->pullBack(*posed, *gradient, atHandles, {threads}); });
  return handOver(std::move(atHandles));
}

py::array weights(const BoundPoints& bound) {
  using Weights = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto& binding = *bound.binding;
  Weights all(binding.pointCount(), binding.handleCount());
  unlocked([&] {
    for (int handle = 0; handle < binding.handleCount(); ++handle)
      all.col(handle) = binding.influence(handle);
  });
  return handOver(std::move(all));
}

py::object weightTiles(const std::shared_ptr<BoundPoints>& bound) {
  const auto* own = dynamic_cast<const coordinates::WeightsBinding*>(bound->binding.get());
  if (!own)
    return py::none();
  const auto& weights = own->weights();
  constexpr py::ssize_t kTile = coordinates::TiledWeights::kTile;
  const auto shown = [&](const auto* first, py::ssize_t rows) {
    using Number = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
    constexpr py::ssize_t kNumber = sizeof(Number);
    py::array_t<Number> tiles({py::ssize_t(weights.tiles()), py::ssize_t(weights.handles()), kTile},
                              {rows * kTile * kNumber, kTile * kNumber, kNumber}, first, py::cast(bound));
    tiles.attr("flags").attr("writeable") = false;
    return py::object(std::move(tiles));
  };
  // Each tile of single precision ends with the factors of its points.
  return weights.single() ? shown(weights.singleTile(0), weights.handles() + 1)
                          : shown(weights.tile(0), weights.handles());
}

std::shared_ptr<BoundPoints> rigid(const BoundPoints& bound, const py::object& triangles) {
  geometry::TriangleMesh mesh{*bound.points, *trianglesFrom(triangles, "triangles"), {}};
  geometry::requireValid(mesh, "the surface");
  auto stiff = std::make_shared<BoundPoints>(bound);
  stiff->binding = deformation::rigidBinding(bound.binding, mesh);
  return stiff;
}

py::array influence(const BoundPoints& bound, int handle) {
  requireHandle(bound, handle);
  return handOver(bound.binding->influence(handle));
}

/// The derivatives as an array `points x rows x 3` on the memory of the system's answer.
py::array gradients(const BoundPoints& bound, const py::object& at, const py::object& listener) {
  const auto points = at.is_none() ? bound.points : pointsFrom(at, "points");
  auto found = resultOfLong(listener, [&](Progress& progress) {
    return bound.system->gradients(bound.handles, *points, deformation::withTetgen(bound.options), progress);
  });
  const Eigen::Index rows = points->rows() > 0 ? found.values.rows() / points->rows() : 0;
  return handOver(std::move(found.values))
      .reshape({py::ssize_t(points->rows()), py::ssize_t(rows), py::ssize_t(3)});
}

py::dict report(const BoundPoints& bound) {
  const auto& found = bound.binding->report();
  py::dict all;
  all["identity_error"] = found.identityError;
  all["unity_error"] = found.unityError;
  all["min_weight"] = found.minWeight;
  all["failures"] = py::array_t<int>(py::ssize_t(found.failures.size()), found.failures.data());
  all["seconds"] = found.seconds;
  all["threads"] = found.threads;
  all["notes"] = inEnglish(found.notes);
  return all;
}

} // namespace

void addBinding(py::module_& module) {
  py::class_<BoundPoints, std::shared_ptr<BoundPoints>>(
      module, "Binding",
      "The coordinates of n points with respect to h handles at rest: maps a pose of the handles (h x 3, mm) "
      "to "
      "the points (n x 3, mm). Immutable; may be used from several threads. Made by `bind`.")
      .def_property_readonly(
          "system", [](const BoundPoints& b) { return b.system->id(); }, "The system's id.")
      .def_property_readonly(
          "handles", [](const BoundPoints& b) { return handOver(Points(b.handles.positions)); },
          "The handles at rest, h x 3 mm; a copy.")
      .def_property_readonly(
          "points", [](const BoundPoints& b) { return share<Points>(b.points); },
          "The points at rest, n x 3 mm; no copy, read only.")
      .def_property_readonly(
          "weights", &weights,
          "n x h: row p holds the coordinates of point p. A copy, gathered anew each time.")
      .def_property_readonly(
          "weight_tiles", &weightTiles,
          "The same numbers where they lie, without a copy: t x h x 16 for points 16 t to 16 t + 15, the "
          "last "
          "tile padded with zeros. None for systems whose points are not sums over the handles alone. Of 32 "
          "bits where the report notes single precision: to be divided by their sum over the handles.")
      .def_property_readonly(
          "report", &report,
          "How exactly the binding reproduces what it was made from: identity_error (mm), "
          "unity_error, min_weight, failures (rows of points without coordinates), seconds, "
          "threads, notes.")
      .def("rigid", &rigid, py::arg("triangles"),
           "The binding of the same points as a rigid body, for bones: a pose turns and shifts them as a "
           "whole, "
           "as near as possible to where this binding takes them. `triangles` (m x 3) are their surface, "
           "whose "
           "area weights the fit. `gradients` and `weights` stay those of tissue that bends.")
      .def("influence", &influence, py::arg("handle"), "The n coordinates of one handle.")
      .def("pose", &poseBound, py::arg("handles"), py::arg("out") = py::none(), py::arg("threads") = 0,
           "The points (n x 3, mm) at a pose of the handles (h x 3, mm). O(n h). With `out`, an array that "
           "`pose` "
           "or `as_points` returned, nothing is allocated.")
      .def("move_handle", &moveHandle, py::arg("handles"), py::arg("handle"), py::arg("delta"),
           py::arg("points"), py::arg("threads") = 0,
           "Updates `points` (n x 3, from `pose`), which belong to `handles`, in place for one handle moved "
           "by "
           "`delta` (3, mm). O(n). Returns `points`.")
      .def("pull_back", &pullBack, py::arg("handles"), py::arg("point_gradient"), py::arg("threads") = 0,
           "From the derivative of a number with respect to every point (n x 3) that with respect to every "
           "handle (h x 3), at the pose `handles`.")
      .def(
          "gradients", &gradients, py::arg("points") = py::none(), py::arg("progress") = py::none(),
          "The derivatives of the coordinates at m points (m x 3 mm; none: the bound ones): m x r x 3, 1/mm. "
          "r is h, or more where a system extends a pose by rows of its own. Zero where there are none.")
      .def("__repr__", [](const BoundPoints& b) {
        return "<Binding of " + std::to_string(b.binding->pointCount()) + " points to " +
               std::to_string(b.binding->handleCount()) + " handles by " + b.system->id() + ">";
      });
  module.def("bind", &bind, py::arg("points"), py::arg("handles"), py::arg("system"), py::arg("cage"),
             py::arg("groups"), py::arg("parameters"), py::arg("partial"), py::arg("threads"),
             py::arg("progress"), "What `viscera.bind` calls.");
  module.def(
      "as_points", [](const py::object& array) { return share<Points>(pointsFrom(array, "points"), true); },
      py::arg("array"),
      "n x 3 numbers in memory that the functions here take without a copy: `array` itself when it is such.");
  module.def(
      "as_triangles",
      [](const py::object& array) { return share<Triangles>(trianglesFrom(array, "triangles"), true); },
      py::arg("array"), "m x 3 vertex indices, likewise.");
}

} // namespace viscera::python

#include "viscera/deformation/volume_lock.h"

#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "array_memory.h"
#include "bound_points.h"
#include "long_jobs.h"
#include "parts.h"
#include "surface_from.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using deformation::RestoredPose;
using deformation::VolumeLock;

/// A lock with the handles at rest that all its surfaces are bound to.
struct Lock {
  std::shared_ptr<const BoundPoints> first;
  VolumeLock volumes;
};

/// Binding, triangles, volume (mm^3) or nothing for that at rest.
using Locked = std::tuple<std::shared_ptr<BoundPoints>, py::object, std::optional<double>>;

std::shared_ptr<Lock> lockOf(const std::vector<Locked>& surfaces, int threads) {
  if (surfaces.empty())
    throw UsageError("there is no surface to lock");
  std::vector<deformation::LockedSurface> locked;
  const auto first = std::get<0>(surfaces.front());
  for (const auto& [bound, triangles, target] : surfaces) {
    auto mesh = std::make_shared<geometry::TriangleMesh>();
    mesh->points = *bound->points;
    mesh->triangles = *trianglesFrom(triangles, "triangles");
    geometry::requireValid(*mesh, "the surface");
    if (bound->handles.positions != first->handles.positions)
      throw UsageError("the surfaces are bound to different handles", {},
                       "bind all of them to the same ones");
    const double volume = target ? *target : geometry::volume(mesh->points, mesh->triangles, {threads});
    locked.push_back({"surface " + std::to_string(locked.size() + 1), mesh, bound->binding, volume});
  }
  return std::make_shared<Lock>(Lock{first, VolumeLock(std::move(locked), {threads})});
}

std::vector<int> freeOf(const Lock& lock, const Points& pose, const std::optional<std::vector<int>>& free) {
  std::vector<int> chosen = free ? *free : deformation::restingHandles(lock.first->handles.positions, pose);
  std::sort(chosen.begin(), chosen.end());
  if (chosen.empty())
    throw UsageError("no handle is left to compensate the change of volume", "free",
                     "name some, or leave some at rest");
  if (chosen.front() < 0 || chosen.back() >= pose.rows())
    throw UsageError(
        "there is no handle " + std::to_string(chosen.front() < 0 ? chosen.front() : chosen.back()), "free");
  return chosen;
}

RestoredPose restore(const Lock& lock, const py::object& handles, const std::optional<std::vector<int>>& free,
                     std::optional<double> limit) {
  const auto pose = pointsFrom(handles, "handles");
  requirePose(*lock.first, *pose);
  const std::vector<int> chosen = freeOf(lock, *pose, free);
  const double most = limit ? *limit : boundsOf(lock.first->handles.positions).diagonal();
  RestoredPose restored =
      unlocked([&] { return lock.volumes.restore(*pose, chosen, deformation::LeastDisplacement(), most); });
  if (!restored.restored)
    throw DataError(restored.reason, "volume",
                    "let more handles compensate, or ask for a volume nearer to the present one");
  return restored;
}

py::array volumes(const Lock& lock, const py::object& handles) {
  const auto pose = pointsFrom(handles, "handles");
  requirePose(*lock.first, *pose);
  const auto found = unlocked([&] { return lock.volumes.volumes(*pose); });
  return py::array_t<double>(py::ssize_t(found.size()), found.data());
}

py::array translationGradient(const Lock& lock, const py::object& handles, const std::vector<int>& moved) {
  const auto pose = pointsFrom(handles, "handles");
  requirePose(*lock.first, *pose);
  for (const int handle : moved)
    if (handle < 0 || handle >= pose->rows())
      throw UsageError("there is no handle " + std::to_string(handle), "selection");
  return handOver(unlocked([&] { return lock.volumes.translationGradient(*pose, moved); }));
}

std::vector<double> targetsOf(const Lock& lock) {
  std::vector<double> targets;
  for (const auto& surface : lock.volumes.surfaces())
    targets.push_back(surface.targetMm3);
  return targets;
}

std::shared_ptr<Lock> withTargets(const Lock& lock, const std::vector<double>& targets) {
  if (targets.size() != lock.volumes.surfaces().size())
    throw UsageError("there are " + std::to_string(targets.size()) + " volumes", "targets",
                     "one a surface is wanted: " + std::to_string(lock.volumes.surfaces().size()));
  auto other = std::make_shared<Lock>(lock);
  for (std::size_t surface = 0; surface < targets.size(); ++surface)
    other->volumes.setTarget(surface, targets[surface]);
  return other;
}

} // namespace

void addVolumeLock(py::module_& module) {
  py::class_<RestoredPose>(module, "RestoredPose", "A pose that has the locked volumes.")
      .def_property_readonly(
          "handles", [](const RestoredPose& pose) { return handOver(Points(pose.pose)); }, "h x 3, mm.")
      .def_readonly("largest_shift", &RestoredPose::largestShiftMm,
                    "How far a compensating handle had to move, mm.")
      .def_readonly("relative_error", &RestoredPose::relativeError,
                    "The largest |V - V*| / V* over the surfaces.");
  py::class_<Lock, std::shared_ptr<Lock>>(
      module, "VolumeLock",
      "Keeps the volumes of closed surfaces exactly, or at values asked for, while their handles move: the "
      "volume "
      "is a cubic along any motion of the handles, and its root is exact. May be used from several threads.")
      .def(py::init(&lockOf), py::arg("surfaces"), py::arg("threads") = 0,
           "`surfaces`: (binding, triangles, volume in mm^3 or None for that at rest), all of them bound to "
           "the "
           "same handles.")
      .def_property_readonly("targets", &targetsOf, "The volumes that are kept, mm^3.")
      .def("with_targets", &withTargets, py::arg("targets"),
           "The same lock for other volumes (mm^3, one a surface); costs nothing.")
      .def("volumes", &volumes, py::arg("handles"), "The volumes at a pose (h x 3, mm), mm^3.")
      .def("translation_gradient", &translationGradient, py::arg("handles"), py::arg("selection"),
           "How much the volumes change at a pose (h x 3, mm) when the handles `selection` move together: "
           "surfaces x 3, "
           "mm^2.")
      .def("restore", &restore, py::arg("handles"), py::arg("free") = py::none(),
           py::arg("limit") = py::none(),
           "Moves the handles `free` (none: those of the pose that are at rest) by the least that gives the "
           "pose "
           "(h x 3, mm) the locked volumes, at most `limit` mm (none: the size of the rig). Raises DataError "
           "when "
           "that cannot be.");
}

} // namespace viscera::python

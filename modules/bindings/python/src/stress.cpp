#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "array_memory.h"
#include "bound_points.h"
#include "long_jobs.h"
#include "material_stress.h"
#include "parts.h"
#include "viscera/core/error.h"
#include "viscera/deformation/witness_gradients.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using deformation::StressMap;
using deformation::WitnessGradients;

/// The derivatives at some points, with the binding whose handles a pose must have.
struct StressPoints {
  std::shared_ptr<const BoundPoints> bound;
  std::shared_ptr<const WitnessGradients> gradients;
};

std::shared_ptr<StressPoints> stressPoints(const std::shared_ptr<BoundPoints>& bound, const py::object& at,
                                           const py::object& listener) {
  const auto points = at.is_none() ? bound->points : pointsFrom(at, "points");
  if (!points->allFinite())
    throw DataError("a position is not a finite number", "points");
  auto gradients = resultOfLong(listener, [&](Progress& progress) {
    return deformation::bindWitnesses(*bound->system, bound->handles, *points, bound->options, progress);
  });
  return std::make_shared<StressPoints>(StressPoints{bound, std::move(gradients)});
}

std::shared_ptr<StressMap> evaluate(const StressPoints& points, const py::object& handles, int threads) {
  const auto pose = pointsFrom(handles, "handles");
  requirePose(*points.bound, *pose);
  auto map = std::make_shared<StressMap>();
  unlocked([&] { points.gradients->evaluate(*pose, *map, {threads}); });
  return map;
}

py::array deformationGradients(const StressPoints& points, const py::object& handles) {
  const auto pose = pointsFrom(handles, "handles");
  requirePose(*points.bound, *pose);
  const Eigen::Index count = points.gradients->witnesses();
  Points rows(3 * count, 3);
  unlocked([&] {
    for (Eigen::Index i = 0; i < count; ++i)
      rows.middleRows<3>(3 * i) = points.gradients->deformationGradient(i, *pose);
  });
  return handOver(std::move(rows)).reshape({py::ssize_t(count), py::ssize_t(3), py::ssize_t(3)});
}

py::dict statistics(const StressMap& map) {
  const auto found = deformation::statisticsOf(map, map.rotationalStress.size());
  py::dict all;
  all["min"] = found.min;
  all["mean"] = found.mean;
  all["p95"] = found.percentile95;
  all["max"] = found.max;
  all["folded"] = found.folded;
  return all;
}

/// One column of a map, which stays alive with it.
template <Values StressMap::*kColumn>
py::array column(const std::shared_ptr<StressMap>& map) {
  return share<Values>(std::shared_ptr<const Values>(map, &((*map).*kColumn)));
}

template <StressOfMaterial kWhich>
py::array pascals(const StressMap& map, const std::optional<std::string>& tissue,
                  std::optional<double> youngKpa, double poisson) {
  return handOver(ofMaterial(map, tissue, youngKpa, poisson, kWhich));
}

} // namespace

void addStress(py::module_& module) {
  py::class_<StressMap, std::shared_ptr<StressMap>>(
      module, "StressMap",
      "How a pose distorts tissue at m points. Arrays of m numbers, read only, no copies.")
      .def_property_readonly("rotational_stress", &column<&StressMap::rotationalStress>,
                             "The largest angle between a direction and its image under the stretch, rad.")
      .def_property_readonly("volume_ratio", &column<&StressMap::volumeRatio>,
                             "The local change of volume, det M; at most 0 where tissue is folded.")
      .def_property_readonly("stretch_max", &column<&StressMap::stretchMax>, "The largest stretch.")
      .def_property_readonly("stretch_min", &column<&StressMap::stretchMin>, "The smallest stretch.")
      .def("von_mises_kpa", &pascals<StressOfMaterial::vonMises>, py::arg("material") = py::none(),
           py::kw_only(), py::arg("young") = py::none(), py::arg("poisson") = 0.49,
           "The von Mises stress of a stated material, kPa: a tissue of `tissues()`, or `young` in kPa. NaN "
           "where "
           "tissue is folded. Raises UsageError without a material.")
      .def("strain_energy_kpa", &pascals<StressOfMaterial::energy>, py::arg("material") = py::none(),
           py::kw_only(), py::arg("young") = py::none(), py::arg("poisson") = 0.49,
           "The strain energy per volume at rest of a stated material, kPa (= mJ/ml), with what the change "
           "of volume "
           "takes. NaN where tissue is folded. Raises UsageError without a material.")
      .def_readonly("folded", &StressMap::folded, "Points with a volume ratio of at most 0.")
      .def_property_readonly("statistics", &statistics,
                             "min, mean, p95, max (rad), of points that are not folded, and folded.");
  py::class_<StressPoints, std::shared_ptr<StressPoints>>(
      module, "StressPoints",
      "Points inside an organ at which distortion is measured, ready for any number of poses.")
      .def(py::init(&stressPoints), py::arg("binding"), py::arg("points") = py::none(),
           py::arg("progress") = py::none(),
           "`points`: m x 3 mm, at rest, inside the handles' hull; none: the bound ones. Memory: m x h x 24 "
           "bytes.")
      .def_property_readonly(
          "closed_form", [](const StressPoints& points) { return points.gradients->closedForm(); },
          "Whether the derivatives are exact; else they are central differences.")
      .def_property_readonly(
          "failures", [](const StressPoints& points) { return points.gradients->failures(); },
          "Rows of points without coordinates: they are not distorted.")
      .def("evaluate", &evaluate, py::arg("handles"), py::arg("threads") = 0,
           "The distortion in a pose (h x 3, mm). O(m h).")
      .def("deformation_gradients", &deformationGradients, py::arg("handles"),
           "The deformation gradient M at every point in a pose: m x 3 x 3.");
}

} // namespace viscera::python

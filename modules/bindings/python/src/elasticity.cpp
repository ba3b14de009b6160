#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "array_memory.h"
#include "long_jobs.h"
#include "material_stress.h"
#include "parts.h"
#include "surface_from.h"
#include "viscera/core/error.h"
#include "viscera/elasticity/elastic_organ.h"
#include "viscera/elasticity/stated_material.h"
#include "viscera/elasticity/static_solution.h"
#include "viscera/elasticity/tissues.h"

namespace viscera::python {
namespace {

namespace py = pybind11;

/// How a job of `elasticity` is asked for.
struct ElasticRequest {
  elasticity::StatedMaterial material;
  double poisson = elasticity::kUsualPoisson;
  elasticity::GripOptions grips;
  elasticity::OrganOptions organ;
  Threads threads;
};

/// What comes of it.
struct ElasticAnswer {
  Points moved;
  Eigen::Index tetrahedra = 0;
  elasticity::Grips grips;
  elasticity::StaticSolution solution;
  elasticity::TissueStress stress;
};

elasticity::StatedMaterial statedBy(const std::optional<std::string>& tissue, std::optional<double> youngKpa,
                                    double poisson) {
  if (tissue && youngKpa)
    throw UsageError("A material is a tissue or Young's modulus, not both");
  if (tissue)
    return elasticity::materialOf(*tissue, poisson);
  return youngKpa ? elasticity::ownMaterial(*youngKpa, poisson) : elasticity::StatedMaterial();
}

ElasticAnswer solved(const geometry::TriangleMesh& surface, const Points& rest, const Points& pose,
                     const ElasticRequest& request, Progress& progress) {
  // The modulus is arbitrary where none is stated: it scales forces, and no displacement.
  const double young = request.material.stated() ? request.material.youngKpa : 1;
  const elasticity::ElasticOrgan organ(surface, request.organ,
                                       std::make_shared<const elasticity::NeoHookean>(young, request.poisson),
                                       progress);
  ElasticAnswer answer;
  answer.grips = elasticity::gripsOf(organ, rest, pose, request.grips);
  elasticity::SolveOptions options;
  options.threads = request.threads;
  answer.solution = elasticity::solveStatic(organ.body(), {answer.grips.prescribed, {}}, options, progress);
  answer.moved = surface.points + organ.atSurface(answer.solution.displacements);
  answer.tetrahedra = organ.body().mesh().tetrahedra.rows();
  if (request.material.stated())
    answer.stress = elasticity::tissueStress(organ.body(), answer.solution.state);
  return answer;
}

py::dict dictOf(ElasticAnswer answer, const ElasticRequest& request) {
  py::dict found;
  found["points"] = handOver(std::move(answer.moved));
  found["tetrahedra"] = answer.tetrahedra;
  found["patches_moved"] = answer.grips.moved;
  found["patches_held"] = answer.grips.held;
  found["drag_mm"] = answer.grips.dragMm;
  found["volume_ratio_min"] = answer.solution.smallestJacobian;
  found["volume_ratio_max"] = answer.solution.largestJacobian;
  found["load_steps"] = answer.solution.loadSteps;
  found["iterations"] = answer.solution.iterations;
  found["poisson"] = request.poisson;
  if (!request.material.stated())
    return found;
  found["tissue"] = request.material.tissue;
  found["young_kpa"] = request.material.youngKpa;
  found["energy_mj"] = answer.solution.energyMj;
  py::dict stress;
  stress["mean"] = answer.stress.mean;
  stress["p95"] = answer.stress.p95;
  stress["max"] = answer.stress.max;
  found["von_mises_kpa"] = stress;
  return found;
}

py::dict elasticityOf(const py::object& points, const py::object& triangles, const py::object& handles,
                      const py::object& pose, const std::optional<std::string>& material,
                      std::optional<double> youngKpa, double poisson, const std::string& others,
                      int tetrahedra, int threads, const py::object& listener) {
  const geometry::TriangleMesh surface = meshFrom(points, triangles);
  const auto rest = pointsFrom(handles, "handles");
  const auto moved = pointsFrom(pose, "pose");
  if (rest->rows() != moved->rows())
    throw DataError("The pose has another number of handles", "pose");
  if (others != "held" && others != "free")
    throw UsageError("The others are \"held\" or \"free\"");
  ElasticRequest request;
  request.material = statedBy(material, youngKpa, poisson);
  request.poisson = poisson;
  request.organ.tetrahedra = tetrahedra;
  request.threads = {threads};
  if (others == "free")
    request.grips.others = elasticity::GripOptions::Others::free;
  ElasticAnswer answer = resultOfLong(
      listener, [&](Progress& progress) { return solved(surface, *rest, *moved, request, progress); });
  return dictOf(std::move(answer), request);
}

py::list tissuesKnown() {
  py::list all;
  for (const elasticity::Tissue& tissue : elasticity::tissues()) {
    py::dict one;
    one["name"] = std::string(tissue.name);
    one["young_kpa"] = tissue.youngKpa;
    one["measure"] = std::string(tissue.measure);
    one["doi"] = std::string(tissue.doi);
    all.append(one);
  }
  return all;
}

} // namespace

Values ofMaterial(const deformation::StressMap& map, const std::optional<std::string>& tissue,
                  std::optional<double> youngKpa, double poisson, StressOfMaterial which) {
  const elasticity::StatedMaterial material = statedBy(tissue, youngKpa, poisson);
  if (!material.stated())
    throw UsageError("There are no pascals without a stated material", {},
                     "give material=\"liver\" or young=5.0");
  Values values(map.volumeRatio.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const elasticity::LocalStretch at{map.stretchMax[i], map.stretchMin[i], map.volumeRatio[i]};
    values[i] = which == StressOfMaterial::vonMises ? elasticity::vonMisesKpa(material, at)
                                                    : elasticity::energyKpa(material, at);
  }
  return values;
}

void addElasticity(py::module_& module) {
  module.def(
      "elasticity", &elasticityOf, py::arg("points"), py::arg("triangles"), py::arg("handles"),
      py::arg("pose"), py::kw_only(), py::arg("material") = py::none(), py::arg("young") = py::none(),
      py::arg("poisson") = elasticity::kUsualPoisson, py::arg("others") = "held", py::arg("tetrahedra") = 600,
      py::arg("threads") = 0, py::arg("progress") = py::none(),
      "The closed surface (points n x 3 mm, triangles m x 3) as a nearly incompressible elastic body that "
      "the handles (h x 3 mm, at rest and in the pose) grip.\n\n"
      "`others`: the patches of handles that the pose leaves at rest are \"held\" or \"free\". The dict has "
      "points (n x 3 mm, the moved vertices), tetrahedra, patches_moved, patches_held, drag_mm, "
      "volume_ratio_min, volume_ratio_max, load_steps, iterations, poisson. Of a stated material (a tissue "
      "of "
      "`tissues()`, or `young` in kPa) also tissue, young_kpa, energy_mj and von_mises_kpa (mean, p95, max). "
      "Needs TetGen's worker. Raises DataError where no handle moves or no equilibrium is found, UsageError, "
      "TetrahedraError, Cancelled. Seconds.");
  module.def("tissues", &tissuesKnown,
             "The tissues whose stiffness is published: name, young_kpa, measure and doi of each.");
}

} // namespace viscera::python

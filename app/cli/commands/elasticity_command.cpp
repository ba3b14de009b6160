#include "cli/commands/all_commands.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/bound_input.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/elasticity/elastic_organ.h"
#include "viscera/elasticity/tissues.h"
#include "viscera/live/elastic_comparison.h"
#include "viscera/live/tissue_energy.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::app::cli {
namespace {

constexpr const char* kHeld = "held";
constexpr const char* kHandle = "handle";
constexpr const char* kSurface = "surface";

/// Writes a difference as `differenceMm` and `differencePercentOfDrag` into `json`.
void addDifference(const live::SurfacesApart& difference, double dragMm, nlohmann::ordered_json& json) {
  const double perCent = 100 / dragMm;
  json["differenceMm"] = {
      {"median", difference.medianMm}, {"p95", difference.p95Mm}, {"max", difference.maxMm}};
  json["differencePercentOfDrag"] = {{"median", perCent * difference.medianMm},
                                     {"p95", perCent * difference.p95Mm},
                                     {"max", perCent * difference.maxMm}};
}

/// The same for reading, after what is compared.
void listDifference(const char* name, const live::SurfacesApart& difference, double dragMm,
                    Listing& listing) {
  const double perCent = 100 / dragMm;
  listing
      .add(name, fixed(difference.medianMm, 2) + " mm (median), 95 % below " + fixed(difference.p95Mm, 2) +
                     " mm, at most " + fixed(difference.maxMm, 2) + " mm")
      .add("of the drag", fixed(perCent * difference.medianMm, 1) + " % (median), 95 % below " +
                              fixed(perCent * difference.p95Mm, 1) + " %, at most " +
                              fixed(perCent * difference.maxMm, 1) + " %");
}

/// Where the tetrahedra get smaller: one entry for each mesh.
void addMeshes(const live::MeshConvergence& convergence, double dragMm, nlohmann::ordered_json& json) {
  const auto perCent = [dragMm](const live::SurfacesApart& apart) {
    return nlohmann::ordered_json{{"median", 100 / dragMm * apart.medianMm},
                                  {"p95", 100 / dragMm * apart.p95Mm},
                                  {"max", 100 / dragMm * apart.maxMm}};
  };
  json["meshes"] = nlohmann::ordered_json::array();
  for (const live::MeshOfSize& mesh : convergence.meshes)
    json["meshes"].push_back({{"tetrahedra", mesh.tetrahedra},
                              {"edgeMm", mesh.edgeMm},
                              {"fromFinestPercentOfDrag", perCent(mesh.fromFinest)},
                              {"differencePercentOfDrag", perCent(mesh.fromPose)},
                              {"volumeRatioMin", mesh.smallestJacobian},
                              {"seconds", mesh.seconds}});
  json["order"] = nullptr;
  if (std::isfinite(convergence.order))
    json["order"] = convergence.order;
}

std::string listMeshes(const live::MeshConvergence& convergence, double dragMm) {
  Listing listing;
  for (const live::MeshOfSize& mesh : convergence.meshes)
    listing.add(std::to_string(mesh.tetrahedra) + " tetrahedra",
                "from the finest " + fixed(100 / dragMm * mesh.fromFinest.medianMm, 2) +
                    " % of the drag (median), 95 % below " + fixed(100 / dragMm * mesh.fromFinest.p95Mm, 2) +
                    " %; from the pose " + fixed(100 / dragMm * mesh.fromPose.medianMm, 2) + " %, " +
                    fixed(100 / dragMm * mesh.fromPose.p95Mm, 2) + " %; " + fixed(mesh.seconds, 1) + " s");
  if (std::isfinite(convergence.order))
    listing.add("order", fixed(convergence.order, 1));
  return listing.text();
}

/// `viscera elasticity`: the organ as an elastic body that the handles grip, beside the pose of the handles.
class ElasticityCommand final : public Command {
public:
  std::string name() const override { return "elasticity"; }
  std::string summary() const override {
    return "Compare a pose with an elastic organ that the handles grip";
  }
  std::vector<OutputOption> outputs() const override { return {{"--output"}}; }

  void addOptions(CLI::App& options) override {
    input_.addTo(options, true);
    CLI::Option* young = options
                             .add_option("--young", youngKpa_,
                                         "Young's modulus of the tissue; without it and --material there "
                                         "are displacements only, which do not depend on it")
                             ->type_name("KPA")
                             ->check(above(0));
    options
        .add_option(
            "--material", material_,
            "A tissue whose stiffness is published: liver, myocardium, kidney, spleen, pancreas, stomach")
        ->type_name("NAME")
        ->excludes(young);
    options.add_option("--poisson", poisson_, "Poisson's ratio; 0.5 would be incompressible")
        ->type_name("NU")
        ->check(between(0.01, 0.4999))
        ->capture_default_str();
    options
        .add_option("--others", others_,
                    "What becomes of the organ's surface at handles that the pose leaves at rest: held or "
                    "free")
        ->check(CLI::IsMember({kHeld, "free"}))
        ->type_name("HOW")
        ->capture_default_str();
    options
        .add_option("--grips", grips_,
                    "How a patch moves: as its handle, or as the surface does there in the handles' pose, "
                    "which compares what is between the patches alone: handle or surface")
        ->check(CLI::IsMember({kHandle, kSurface}))
        ->type_name("HOW")
        ->capture_default_str();
    options
        .add_option("--hold", hold_,
                    "Hold the organ's surface at these handles only, of those that the pose leaves at rest")
        ->type_name("LABEL");
    options.add_flag("--free-handles-follow", follow_,
                     "Compare also the pose in which the handles without a grip go to where the elastic "
                     "energy is least");
    options.add_option("--tetrahedra", organOptions_.tetrahedra, "About how many tetrahedra the organ has")
        ->type_name("N")
        ->check(wholeBetween(50, 20'000))
        ->capture_default_str();
    options
        .add_option(
            "--meshes", meshes_,
            "Solve also with about these numbers of tetrahedra, two at least, and say how far each is "
            "from the finest")
        ->type_name("N")
        ->check(wholeBetween(50, 20'000));
    options.add_option("-o,--output", output_, "Surface file for the organ as elasticity moves it")
        ->type_name("FILE");
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    Outcome outcome;
    const BoundInput input = input_.read(context, outcome.warnings);
    const auto binding = deformation::bindOrgan(*input.system, input.handles, input.organ.mesh->points,
                                                deformation::withTetgen(input.options), context.progress);
    Points posed;
    binding->deform(input.pose, posed, context.threads);
    const elasticity::ElasticOrgan organ(*input.organ.mesh, organOptions_, material(), context.progress);
    elasticity::GripOptions gripOptions;
    if (others_ != kHeld)
      gripOptions.others = elasticity::GripOptions::Others::free;
    for (const std::string& label : hold_)
      gripOptions.holding.push_back(rowOfHandle(input.rig, label));
    live::ElasticQuestion question{.surface = input.organ.mesh->points,
                                   .posed = posed,
                                   .rest = input.handles.positions,
                                   .pose = input.pose,
                                   .grips = gripOptions,
                                   .gripSurface = grips_ == kSurface,
                                   .threads = context.threads};
    const live::ElasticComparison beside = live::besideElasticity(organ, question, context.progress);
    tell(input, organ, beside, outcome);
    if (follow_)
      tellFollowed(input, organ, beside, *binding, gripOptions, outcome, context);
    if (!meshes_.empty()) {
      const live::MeshConvergence convergence =
          live::meshConvergence(*input.organ.mesh, material(), meshes_, question, context.progress);
      addMeshes(convergence, beside.grips.dragMm, outcome.json);
      outcome.text += listMeshes(convergence, beside.grips.dragMm);
    }
    if (!output_.empty()) {
      medical_io::writeSurface(output_,
                               {beside.elastic, input.organ.mesh->triangles, input.organ.mesh->colors},
                               {.name = input.organ.name});
      outcome.json["file"] = output_;
    }
    outcome.json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    outcome.warnings.insert(outcome.warnings.end(), input.organ.warnings.begin(), input.organ.warnings.end());
    outcome.json["warnings"] = outcome.warnings;
    return outcome;
  }

private:
  bool stated() const { return youngKpa_ || !material_.empty(); }

  std::shared_ptr<const elasticity::Material> material() const {
    // The modulus is arbitrary where none is stated: it scales forces, and no displacement.
    const double young =
        !material_.empty() ? elasticity::tissueNamed(material_).youngKpa : youngKpa_.value_or(1);
    return std::make_shared<const elasticity::NeoHookean>(young, poisson_);
  }

  void tell(const BoundInput& input, const elasticity::ElasticOrgan& organ,
            const live::ElasticComparison& beside, Outcome& outcome) const {
    const elasticity::Grips& grips = beside.grips;
    const elasticity::StaticSolution& solution = beside.solution;
    outcome.json = {{"organ", input.organ.name},
                    {"system", input.system->id()},
                    {"tetrahedra", organ.body().mesh().tetrahedra.rows()},
                    {"others", others_},
                    {"grips", grips_},
                    {"patches", {{"moved", grips.moved}, {"held", grips.held}}},
                    {"poisson", poisson_},
                    {"dragMm", grips.dragMm}};
    addDifference(beside.apart, grips.dragMm, outcome.json);
    outcome.json["volumeRatio"] = {{"min", solution.smallestJacobian}, {"max", solution.largestJacobian}};
    outcome.json["loadSteps"] = solution.loadSteps;
    outcome.json["iterations"] = solution.iterations;
    Listing listing;
    listing.add("elastic organ", std::to_string(organ.body().mesh().tetrahedra.rows()) + " tetrahedra")
        .add("grips", std::to_string(grips.moved) + " moved, " +
                          (others_ == kHeld ? std::to_string(grips.held) + " held" : "all others free"))
        .add("largest drag", fixed(grips.dragMm, 2) + " mm");
    listDifference("difference", beside.apart, grips.dragMm, listing);
    listing.add("volume ratio",
                fixed(solution.smallestJacobian, 3) + " to " + fixed(solution.largestJacobian, 3));
    if (stated())
      tellStress(organ, solution, outcome, listing);
    outcome.text = listing.text();
  }

  /// Pascals, which exist only of a stated material.
  void tellStress(const elasticity::ElasticOrgan& organ, const elasticity::StaticSolution& solution,
                  Outcome& outcome, Listing& listing) const {
    nlohmann::ordered_json material = {{"youngKpa", youngKpa_.value_or(0)}};
    std::string words = fixed(youngKpa_.value_or(0), 2) + " kPa";
    if (!material_.empty()) {
      const elasticity::Tissue& tissue = elasticity::tissueNamed(material_);
      material = {{"name", std::string(tissue.name)},
                  {"youngKpa", tissue.youngKpa},
                  {"measure", std::string(tissue.measure)},
                  {"doi", std::string(tissue.doi)}};
      words = material_ + ", " + fixed(tissue.youngKpa, 2) + " kPa (doi:" + std::string(tissue.doi) + ")";
    }
    const elasticity::TissueStress stress = elasticity::tissueStress(organ.body(), solution.state);
    outcome.json["material"] = material;
    outcome.json["energyMj"] = solution.energyMj;
    outcome.json["vonMisesKpa"] = {{"mean", stress.mean}, {"p95", stress.p95}, {"max", stress.max}};
    listing.add("Young's modulus", words)
        .add("elastic energy", fixed(solution.energyMj, 3) + " mJ")
        .add("von Mises stress", fixed(stress.mean, 3) + " kPa on average, 95 % below " +
                                     fixed(stress.p95, 3) + ", at most " + fixed(stress.max, 3));
  }

  /// The pose in which the handles without a grip follow, beside elasticity.
  void tellFollowed(const BoundInput& input, const elasticity::ElasticOrgan& organ,
                    const live::ElasticComparison& before, const coordinates::Binding& binding,
                    const elasticity::GripOptions& gripOptions, Outcome& outcome,
                    CommandContext& context) const {
    const elasticity::Grips& grips = before.grips;
    const auto tissue = live::tissueEnergy({input.organ.mesh}, *input.system, input.handles,
                                           deformation::withTetgen(input.options), context.progress);
    const auto begin = std::chrono::steady_clock::now();
    const elasticity::RelaxedPose relaxed = tissue->relax(input.pose, grips.loose);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    Points posed;
    binding.deform(relaxed.pose, posed, context.threads);
    live::SurfacesApart difference = live::surfacesApart(before.elastic, posed);
    if (grips_ == kSurface) // Its patches are elsewhere.
      difference = live::besideElasticity(organ,
                                          {.surface = input.organ.mesh->points,
                                           .posed = posed,
                                           .rest = input.handles.positions,
                                           .pose = input.pose,
                                           .grips = gripOptions,
                                           .gripSurface = true,
                                           .threads = context.threads},
                                          context.progress)
                       .apart;
    nlohmann::ordered_json& json = outcome.json["leastEnergy"];
    json = {{"followingHandles", grips.loose.size()},
            {"witnesses", tissue->witnesses()},
            {"energyRatio", relaxed.energy / tissue->energy(input.pose)}};
    addDifference(difference, grips.dragMm, json);
    json["seconds"] = taken.count();
    Listing listing;
    listing.add("free handles follow", std::to_string(grips.loose.size()) + " of " +
                                           std::to_string(input.rig.handles.size()) + ", in " +
                                           fixed(taken.count(), 3) + " s");
    listDifference("difference then", difference, grips.dragMm, listing);
    outcome.text += listing.text();
  }

  BoundInputOptions input_;
  std::optional<double> youngKpa_;
  std::string material_;
  double poisson_ = 0.49;
  std::string others_ = kHeld;
  std::string grips_ = kHandle;
  std::vector<std::string> hold_;
  bool follow_ = false;
  elasticity::OrganOptions organOptions_;
  std::vector<int> meshes_;
  std::string output_;
};

} // namespace

std::unique_ptr<Command> elasticityCommand() {
  return std::make_unique<ElasticityCommand>();
}

} // namespace viscera::app::cli

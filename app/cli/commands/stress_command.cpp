#include "cli/commands/all_commands.h"

#include <cctype>
#include <chrono>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/bound_input.h"
#include "cli/listing.h"
#include "cli/material_options.h"
#include "cli/number_bounds.h"
#include "cli/stress_marks.h"
#include "cli/stress_over_poses.h"
#include "viscera/core/error.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/live/stress_files.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/medical_io/cell_file.h"

namespace viscera::app::cli {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

const char* nameOf(live::WitnessOrigin origin) {
  switch (origin) {
  case live::WitnessOrigin::surface:
    return "surface";
  case live::WitnessOrigin::repairedSurface:
    return "repaired";
  case live::WitnessOrigin::grid:
    return "grid";
  }
  return "";
}

/// The stress map at all points of the mesh, witnesses first.
struct Measured {
  WitnessedOrgan interior;
  Points posed; ///< The points in the pose, mm.
  deformation::StressMap map;
  deformation::StressStatistics statistics;

  const deformation::WitnessMesh& mesh() const { return interior.mesh(); }
};

Measured measure(WitnessedOrgan interior, const BoundInput& input, Progress& progress) {
  Measured measured;
  measured.interior = std::move(interior);
  input.system->bind(input.handles, measured.mesh().points, deformation::withTetgen(input.options), progress)
      ->deform(input.pose, measured.posed, input.options.threads);
  measured.interior.gradients->evaluate(input.pose, measured.map, input.options.threads);
  measured.statistics = deformation::statisticsOf(measured.map, measured.mesh().witnesses);
  return measured;
}

Outcome outcomeOf(const Measured& measured, const std::string& organ, const std::string& system,
                  double seconds) {
  const auto& s = measured.statistics;
  const auto witnesses = measured.mesh().witnesses;
  const auto ratio = measured.map.volumeRatio.head(witnesses);
  const std::string method = measured.interior.gradients->closedForm() ? "analytic" : "differences";
  Outcome outcome;
  outcome.json = {
      {"organ", organ},
      {"system", system},
      {"witnesses", witnesses},
      {"surfacePoints", measured.mesh().points.rows() - witnesses},
      {"tetrahedra", measured.mesh().tetrahedra.rows()},
      {"sampling", measured.interior.ownCells ? "cells" : nameOf(measured.interior.sample.origin)},
      {"folded", s.folded},
      {"stressDegrees",
       {{"min", kDegrees * s.min},
        {"mean", kDegrees * s.mean},
        {"p95", kDegrees * s.percentile95},
        {"max", kDegrees * s.max}}},
      {"volumeRatio", {{"min", ratio.minCoeff()}, {"max", ratio.maxCoeff()}}},
      {"stretch",
       {{"min", measured.map.stretchMin.head(witnesses).minCoeff()},
        {"max", measured.map.stretchMax.head(witnesses).maxCoeff()}}},
      {"method", method},
      {"seconds", seconds}};
  outcome.text =
      Listing()
          .add("witness points", std::to_string(witnesses) + " in " +
                                     std::to_string(measured.mesh().tetrahedra.rows()) + " tetrahedra")
          .add("rotational stress", fixed(kDegrees * s.mean, 2) + " deg on average, 95 % below " +
                                        fixed(kDegrees * s.percentile95, 2) + ", at most " +
                                        fixed(kDegrees * s.max, 2))
          .add("volume ratio", fixed(ratio.minCoeff(), 3) + " to " + fixed(ratio.maxCoeff(), 3))
          .add("folded", std::to_string(s.folded))
          .add("derivatives", method)
          .text();
  return outcome;
}

/// `viscera stress`: computes the distortion of the tissue by a pose, at witness points inside the organ.
class StressCommand final : public Command {
public:
  std::string name() const override { return "stress"; }
  std::string summary() const override { return "Measure how a pose distorts the tissue inside an organ"; }
  std::vector<OutputOption> outputs() const override {
    std::vector<OutputOption> all = {{"--output"},
                                     tableOutput("--csv"),
                                     tableOutput("--histogram"),
                                     tableOutput("--probes-csv"),
                                     tableOutput("--profile-csv")};
    for (const OutputOption& option : StressOverPosesOptions::outputs())
      all.push_back(option);
    return all;
  }

  void addOptions(CLI::App& options) override {
    input_.addTo(options, true);
    witnessCount_ = options
                        .add_option("--witnesses", witnesses_.wanted,
                                    "Witness points inside the organ, 200 to 200000; without it a mesh of "
                                    "cells keeps its own tetrahedra")
                        ->type_name("N")
                        ->capture_default_str();
    options
        .add_option("--quality", witnesses_.radiusEdgeRatio,
                    "Largest ratio of circumradius to shortest edge of the tetrahedra, 1.1 (best) to 10")
        ->type_name("RATIO")
        ->capture_default_str();
    options
        .add_option("--time-limit", witnesses_.timeLimitSeconds,
                    "Time limit for one run of TetGen, in seconds")
        ->type_name("S")
        ->capture_default_str();
    options.add_option("--memory-limit", memoryMb_, "Memory limit for TetGen, in MB")
        ->type_name("MB")
        ->check(between(1.0, 1e7))
        ->capture_default_str();
    options.add_option("-o,--output", output_, "The solid with all values, for ParaView (.vtu)")
        ->type_name("FILE");
    options.add_option("--csv", csv_, "The values at the witness points as a table")->type_name("FILE");
    options
        .add_option("--histogram", histogram_,
                    "How the quantity is spread over the points, as a table (.csv)")
        ->type_name("FILE");
    options
        .add_option(
            "--cavity", cavities_,
            "A closed surface inside the organ that holds no tissue, such as a ventricle; may be repeated")
        ->type_name("ORGAN")
        ->expected(1)
        ->take_all();
    std::vector<std::string> quantities;
    for (const live::StressQuantityDescription& quantity : live::stressQuantities())
      quantities.push_back(quantity.id);
    options
        .add_option("--quantity", quantity_,
                    "What the summary and --histogram are of; von-mises and strain-energy need a material")
        ->check(CLI::IsMember(quantities))
        ->type_name("QUANTITY")
        ->capture_default_str();
    materialOptions_.addTo(options);
    marks_.addTo(options);
    poses_.addTo(options);
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    marks_.check();
    poses_.check();
    const live::StressMeasure asked = measureAsked();
    std::vector<Text> warnings;
    const BoundInput input = input_.read(context, warnings);
    live::WitnessOptions witnesses = witnesses_;
    if (input.organ.mobility == document::Mobility::rigid)
      warnings.push_back(input.organ.name +
                         " is a bone, which moves as a rigid body and has no stress; these are "
                         "the values of soft tissue in its place");
    witnesses.memoryLimitBytes = static_cast<std::uint64_t>(memoryMb_ * 1024 * 1024);
    witnesses.threads = context.threads;
    std::vector<std::shared_ptr<const geometry::TriangleMesh>> hollow;
    for (const std::string& cavity : cavities_)
      hollow.push_back(organInput(cavity, context.samples, context.progress).mesh);
    const Measured measured =
        measure(interiorOf(input, witnesses, warnings, context.progress, hollow, ownCells(input)), input,
                context.progress);
    context.progress.throwIfCancelled();
    const elasticity::StatedMaterial& material = asked.material;
    if (!output_.empty())
      live::writeStressSolid(output_, measured.mesh(), measured.posed, measured.map, material);
    if (!csv_.empty())
      live::writeStressTable(csv_, measured.mesh(), measured.posed, measured.map, material);
    if (!histogram_.empty())
      writeHistogram(measured, asked);
    Outcome outcome =
        outcomeOf(measured, input.organ.name, input.system->id(),
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    tellOf(measured, asked, outcome);
    outcome.json["mobility"] = document::nameOf(input.organ.mobility);
    if (!output_.empty())
      outcome.json["file"] = output_;
    if (!csv_.empty())
      outcome.json["csv"] = csv_;
    if (!histogram_.empty())
      outcome.json["histogram"] = histogram_;
    if (const Text remark = live::volumeRemark(measured.map, measured.mesh().witnesses); !remark.empty())
      warnings.push_back(remark);
    warnings.insert(warnings.end(), input.organ.warnings.begin(), input.organ.warnings.end());
    outcome.warnings = std::move(warnings);
    outcome.json["warnings"] = outcome.warnings;
    marks_.read(measured.interior.sample.mesh, measured.posed, measured.map, material, outcome);
    poses_.compute({input, measured.interior, measured.posed, measured.map, material}, marks_.probePlaces(),
                   context, outcome);
    return outcome;
  }

private:
  /// The tetrahedra of the organ's own file, unless other witness points are asked for.
  std::shared_ptr<const deformation::WitnessMesh> ownCells(const BoundInput& input) const {
    if (witnessCount_->count() > 0 || input.organ.file.empty())
      return nullptr;
    auto cells = medical_io::readCells(input.organ.file);
    return cells ? std::make_shared<const deformation::WitnessMesh>(std::move(*cells)) : nullptr;
  }

  /// Throws `UsageError` for a quantity of a material without one.
  live::StressMeasure measureAsked() const {
    const live::StressMeasure asked(live::stressQuantityFromId(quantity_), materialOptions_.material());
    if (!asked.known())
      throw UsageError("There are no pascals without a stated material", "--quantity " + quantity_,
                       "add --material NAME or --young KPA");
    return asked;
  }

  void writeHistogram(const Measured& measured, const live::StressMeasure& asked) const {
    Values values;
    live::quantityOf(measured.map, asked, values);
    live::writeStressHistogram(
        histogram_, live::histogramOf(values, measured.mesh().witnesses, live::kHistogramBars), asked);
  }

  /// The quantity that was asked for, and what a stated material feels.
  static void tellOf(const Measured& measured, const live::StressMeasure& asked, Outcome& outcome) {
    Listing listing;
    Values values;
    const auto add = [&](const live::StressMeasure& measure, const char* key) {
      const live::StressQuantityDescription& quantity = live::describe(measure.quantity);
      live::quantityOf(measured.map, measure, values);
      const live::QuantitySummary summary = live::summaryOf(values, measured.mesh().witnesses);
      outcome.json[key] = {
          {"min", summary.min}, {"mean", summary.mean}, {"p95", summary.percentile95}, {"max", summary.max}};
      std::string name = quantity.name;
      name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
      const std::string unit = measure.unit().english();
      listing.add(name, fixed(summary.mean, quantity.decimals) + " on average, 95 % below " +
                            fixed(summary.percentile95, quantity.decimals) + ", at most " +
                            fixed(summary.max, quantity.decimals) + (unit.empty() ? "" : ' ' + unit));
    };
    if (asked.material.stated()) {
      outcome.json["material"] = materialJson(asked.material);
      add({live::StressQuantity::vonMises, asked.material}, "vonMisesKpa");
      add({live::StressQuantity::energy, asked.material}, "strainEnergyKpa");
    }
    if (asked.quantity != live::StressQuantity::rotationalStress) {
      outcome.json["quantity"] = live::describe(asked.quantity).id;
      if (!live::describe(asked.quantity).ofMaterial)
        add(asked, "ofQuantity");
    }
    outcome.text += listing.text();
  }

  BoundInputOptions input_;
  CLI::Option* witnessCount_ = nullptr;
  std::string output_;
  std::string csv_;
  std::string histogram_;
  std::string quantity_ = live::describe(live::StressQuantity::rotationalStress).id;
  MaterialOptions materialOptions_;
  std::vector<std::string> cavities_;
  StressMarkOptions marks_;
  StressOverPosesOptions poses_;
  double memoryMb_ = 2048;
  live::WitnessOptions witnesses_;
};

} // namespace

std::unique_ptr<Command> stressCommand() {
  return std::make_unique<StressCommand>();
}

} // namespace viscera::app::cli

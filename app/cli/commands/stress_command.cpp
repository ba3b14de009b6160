#include "cli/commands/all_commands.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/bound_input.h"
#include "cli/listing.h"
#include "viscera/core/atomic_file.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/medical_io/solid_file.h"

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

/// What is measured, at all points of the mesh: the witnesses first.
struct Measured {
  Interior interior;
  Points posed; ///< The points in the pose, mm.
  deformation::StressMap map;
  deformation::StressStatistics statistics;

  const deformation::WitnessMesh& mesh() const { return interior.mesh(); }
};

std::vector<std::uint8_t> foldedFlags(const deformation::StressMap& map) {
  std::vector<std::uint8_t> flags;
  for (const double ratio : map.volumeRatio)
    flags.push_back(ratio <= 0 ? 1 : 0);
  return flags;
}

void writeVtu(const std::string& file, const Measured& measured) {
  std::vector<std::uint8_t> witness(static_cast<std::size_t>(measured.mesh().points.rows()), 0);
  std::fill_n(witness.begin(), measured.mesh().witnesses, std::uint8_t{1});
  medical_io::writeSolid(file, measured.posed, measured.mesh().tetrahedra,
                         {{"RotationalStress_deg", Values(kDegrees * measured.map.rotationalStress)},
                          {"VolumeRatio", measured.map.volumeRatio},
                          {"StretchMax", measured.map.stretchMax},
                          {"StretchMin", measured.map.stretchMin},
                          {"Folded", foldedFlags(measured.map)},
                          {"Witness", witness},
                          {"Displacement_mm", Points(measured.posed - measured.mesh().points)}});
}

/// One row a witness: its place at rest and in the pose, and what is measured there.
void writeCsv(const std::string& file, const Measured& measured) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm,RotationalStress_deg,VolumeRatio,StretchMax,"
              "StretchMin,Folded\n";
    for (Eigen::Index i = 0; i < measured.mesh().witnesses; ++i) {
      const auto rest = measured.mesh().points.row(i), now = measured.posed.row(i);
      const double ratio = measured.map.volumeRatio[i];
      char line[400];
      std::snprintf(line, sizeof line, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%d\n", rest[0],
                    rest[1], rest[2], now[0], now[1], now[2], kDegrees * measured.map.rotationalStress[i],
                    ratio, measured.map.stretchMax[i], measured.map.stretchMin[i], ratio <= 0 ? 1 : 0);
      stream << line;
    }
  });
}

Measured measure(Interior interior, const BoundInput& input, Progress& progress) {
  Measured measured;
  measured.interior = std::move(interior);
  input.system
      ->bind(input.rig.handles, measured.mesh().points, deformation::withTetgen(input.options), progress)
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
  outcome.json = {{"organ", organ},
                  {"system", system},
                  {"witnesses", witnesses},
                  {"surfacePoints", measured.mesh().points.rows() - witnesses},
                  {"tetrahedra", measured.mesh().tetrahedra.rows()},
                  {"sampling", nameOf(measured.interior.sample.origin)},
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

/// `viscera stress`: the distortion that a pose means for the tissue, at witness points inside the organ.
class StressCommand final : public Command {
public:
  std::string name() const override { return "stress"; }
  std::string summary() const override { return "Measure how a pose distorts the tissue inside an organ"; }

  void addOptions(CLI::App& options) override {
    input_.addTo(options, true);
    options.add_option("--witnesses", witnesses_.wanted, "Witness points inside the organ, 200 to 200000")
        ->type_name("N")
        ->capture_default_str();
    options
        .add_option("--quality", witnesses_.radiusEdgeRatio,
                    "Of the tetrahedra: largest circumradius by shortest edge, from 1.1")
        ->type_name("RATIO")
        ->capture_default_str();
    options.add_option("--time-limit", witnesses_.timeLimitSeconds, "For one run of TetGen, s")
        ->type_name("S")
        ->capture_default_str();
    options.add_option("--memory-limit", memoryMb_, "For TetGen, MB")
        ->type_name("MB")
        ->check(CLI::Range(1.0, 1e7))
        ->capture_default_str();
    options.add_option("-o,--output", output_, "The solid with all values, for ParaView (.vtu)")
        ->type_name("FILE");
    options.add_option("--csv", csv_, "The values at the witness points as a table")->type_name("FILE");
  }

  Outcome run(Surroundings& surroundings) override {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::string> warnings;
    const BoundInput input = input_.read(surroundings, warnings);
    live::WitnessOptions witnesses = witnesses_;
    witnesses.memoryLimitBytes = static_cast<std::uint64_t>(memoryMb_ * 1024 * 1024);
    witnesses.threads = surroundings.threads;
    const Measured measured =
        measure(interiorOf(input, witnesses, warnings, surroundings.progress), input, surroundings.progress);
    surroundings.progress.throwIfCancelled();
    if (!output_.empty())
      writeVtu(output_, measured);
    if (!csv_.empty())
      writeCsv(csv_, measured);
    Outcome outcome =
        outcomeOf(measured, input.organ.name, input.system->id(),
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    if (!output_.empty())
      outcome.json["file"] = output_;
    if (!csv_.empty())
      outcome.json["csv"] = csv_;
    warnings.insert(warnings.end(), input.organ.warnings.begin(), input.organ.warnings.end());
    outcome.warnings = std::move(warnings);
    return outcome;
  }

private:
  BoundInputOptions input_;
  std::string output_;
  std::string csv_;
  double memoryMb_ = 2048;
  live::WitnessOptions witnesses_;
};

} // namespace

std::unique_ptr<Command> stressCommand() {
  return std::make_unique<StressCommand>();
}

} // namespace viscera::app::cli

#include "cli/commands/all_commands.h"

#include <bit>
#include <cstdint>
#include <ostream>
#include <string>

#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include "cli/bound_input.h"
#include "cli/listing.h"
#include "viscera/core/atomic_file.h"
#include "viscera/deformation/bind_organ.h"

namespace viscera::app::cli {
namespace {

/// `points x handles` coordinates, row major.
using Weights = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t kAlignment = 64; ///< Alignment of the data in the file, as the format requires.

/// The header of a file in NumPy's own format, version 1.0:
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
std::string header(Eigen::Index rows, Eigen::Index cols) {
  static_assert(std::endian::native == std::endian::little, "the header below says little-endian");
  std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", " +
                     std::to_string(cols) + "), }";
  const std::string magic("\x93NUMPY\x01\x00", 8);
  const std::size_t before = magic.size() + sizeof(std::uint16_t);
  text.append(kAlignment - (before + text.size() + 1) % kAlignment, ' ');
  text += '\n';
  const auto size = static_cast<std::uint16_t>(text.size());
  return magic + static_cast<char>(size & 0xff) + static_cast<char>(size >> 8) + text;
}

/// `numpy.load` gives `rows x cols` of float64.
void writeNpy(const std::filesystem::path& file, const Weights& matrix) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << header(matrix.rows(), matrix.cols());
    stream.write(reinterpret_cast<const char*>(matrix.data()),
                 static_cast<std::streamsize>(matrix.size() * static_cast<Eigen::Index>(sizeof(double))));
  });
}

/// `points x handles`, row by row as NumPy likes it.
Weights weightsOf(const coordinates::Binding& binding) {
  Weights weights(binding.pointCount(), binding.handleCount());
  for (Eigen::Index handle = 0; handle < weights.cols(); ++handle)
    weights.col(handle) = binding.influence(static_cast<int>(handle));
  return weights;
}

/// `viscera bind`: computes coordinates and reports their errors.
class BindCommand final : public Command {
public:
  std::string name() const override { return "bind"; }
  std::string summary() const override { return "Compute an organ's coordinates"; }
  std::vector<OutputOption> outputs() const override { return {{"--output", {".npy"}}}; }

  void addOptions(CLI::App& options) override {
    input_.addTo(options, false);
    options
        .add_option("-o,--output", output_,
                    "NumPy file for the coordinates: vertices x handles, 64 bit (.npy)")
        ->type_name("FILE");
  }

  Outcome run(CommandContext& context) override {
    Outcome outcome;
    const auto [system, options, rig, handles, pose, organ] = input_.read(context, outcome.warnings);
    const auto binding =
        deformation::bindOrgan(*system, handles, organ.mesh->points, options, context.progress);
    const coordinates::BindingReport& report = binding->report();
    const double identity = report.identityError / boundsOf(organ.mesh->points).diagonal();
    if (!output_.empty()) {
      context.progress.throwIfCancelled();
      writeNpy(output_, weightsOf(*binding));
    }

    outcome.json = {{"system", system->id()},
                    {"organ", organ.name},
                    {"vertices", binding->pointCount()},
                    {"handles", binding->handleCount()},
                    {"seconds", report.seconds},
                    {"threads", report.threads},
                    {"identityError", identity},
                    {"unityError", report.unityError},
                    {"minWeight", report.minWeight},
                    {"failures", report.failures.size()}};
    Listing listing;
    listing.add("system", system->name())
        .add("vertices", std::to_string(binding->pointCount()))
        .add("handles", std::to_string(binding->handleCount()))
        .add("time", fixed(report.seconds * 1e3, 1) + " ms, " + std::to_string(report.threads) + " threads")
        .add("identity error", significant(identity) + " of the organ's diagonal")
        .add("unity error", significant(report.unityError))
        .add("smallest weight", significant(report.minWeight))
        .add("failures", std::to_string(report.failures.size()));
    if (!output_.empty()) {
      outcome.json["file"] = output_;
      listing.add("file", output_);
    }
    outcome.text = listing.text();
    outcome.warnings.insert(outcome.warnings.end(), organ.warnings.begin(), organ.warnings.end());
    const auto& notes = report.notes;
    outcome.warnings.insert(outcome.warnings.end(), notes.begin(), notes.end());
    outcome.json["warnings"] = outcome.warnings;
    return outcome;
  }

private:
  BoundInputOptions input_;
  std::string output_;
};

} // namespace

std::unique_ptr<Command> bindCommand() {
  return std::make_unique<BindCommand>();
}

} // namespace viscera::app::cli

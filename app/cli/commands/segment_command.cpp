#include "cli/commands/all_commands.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <optional>
#include <set>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "cli/patient_info.h"
#include "viscera/core/error.h"
#include "viscera/core/output_folder.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

constexpr int kMostSegmentTriangles = 2'000'000;
constexpr double kSmoothest = 2;
constexpr std::size_t kLongestName = 100;

/// "left_kidney" for "Left kidney / lower": names that work in every file system and shell, and are unique.
class FileNames {
public:
  std::string of(const std::string& label, const std::string& ending) {
    std::string stem;
    for (const char c : label.substr(0, kLongestName)) {
      const bool plain =
          std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.' || (c & '\x80') != 0;
      if (plain || (!stem.empty() && stem.back() != '_'))
        stem += plain ? c : '_';
    }
    while (stem.ends_with('_') || stem.ends_with('.'))
      stem.pop_back();
    stem.erase(0, std::min(stem.find_first_not_of('.'), stem.size()));
    if (stem.empty())
      stem = "label";
    std::string name = stem;
    for (int number = 2; !taken_.insert(lowered(name)).second; ++number)
      name = stem + "_" + std::to_string(number);
    return name + "." + ending;
  }

private:
  /// Some file systems do not distinguish upper and lower case.
  static std::string lowered(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  }
  std::set<std::string> taken_;
};

void paint(geometry::TriangleMesh& mesh, const Vec3& color) {
  const Eigen::Matrix<std::uint8_t, 1, 3> bytes =
      (255 * color).array().round().matrix().cast<std::uint8_t>().transpose();
  mesh.colors = bytes.replicate(mesh.points.rows(), 1);
}

ordered_json rowOf(const medical_io::Segment& segment, const medical_io::LabelSurface& surface,
                   const std::filesystem::path& file) {
  return {{"name", segment.name},
          {"label", segment.label},
          {"file", file.string()},
          {"vertices", surface.mesh.points.rows()},
          {"triangles", surface.mesh.triangles.rows()},
          {"closed", surface.report.closed()},
          {"manifold", surface.report.manifold()},
          {"pieces", surface.pieces},
          {"volumeMl", surface.volumeMm3 / kMm3PerMl},
          {"voxelVolumeMl", surface.voxelVolumeMm3 / kMm3PerMl},
          {"cutBy", surface.cut ? ordered_json(surface.cut->edges) : ordered_json::array()},
          {"color", {segment.color.x(), segment.color.y(), segment.color.z()}}};
}

/// `viscera segment LABELMAP -o DIR`: a label map's organs as surfaces.
class SegmentCommand final : public Command {
public:
  std::string name() const override { return "segment"; }
  std::string summary() const override { return "Make organ surfaces of a label map"; }
  std::vector<OutputOption> outputs() const override { return {{"--output"}}; }

  void addOptions(CLI::App& options) override {
    options.add_option("LABELMAP", file_, "A label map, or a folder with a mask for each organ")->required();
    options.add_option("-o,--output", folder_, "Folder to write surfaces into; made when it is not there")
        ->type_name("DIR")
        ->required();
    options.add_option("--labels", labels_, "Only these labels, by name or value: liver,spleen,7")
        ->type_name("NAMES")
        ->delimiter(',');
    options.add_option("--phase", phase_, "Of several label maps over time; the first is 0")
        ->type_name("N")
        ->check(CLI::NonNegativeNumber);
    options.add_option("--triangles", options_.triangles, "About as many as a surface may have; 0: all")
        ->type_name("N")
        ->check(wholeBetween(0, kMostSegmentTriangles))
        ->capture_default_str();
    options
        .add_option("--smoothing", options_.smoothing,
                    "0: the voxels' steps stay; 0.5: gentle; 2: very smooth")
        ->check(between(0.0, kSmoothest))
        ->capture_default_str();
    options.add_flag("--largest-piece", options_.largestPieceOnly, "Leave out the smaller pieces of a label");
    options.add_option("--format", format_, "Kind of file")
        ->check(CLI::IsMember({"vtp", "stl", "obj", "ply", "off", "vtk", "glb"}))
        ->capture_default_str();
  }

  Outcome run(CommandContext& context) override {
    const auto start = std::chrono::steady_clock::now();
    Progress& progress = context.progress;
    const medical_io::LabelMap map = medical_io::readLabelMap(file_, progress, phase_);
    options_.segments = medical_io::segmentsNamed(map, labels_, file_);
    OutputFolder folder(folder_);
    std::vector<medical_io::LabelSurface> surfaces =
        medical_io::labelSurfaces(map, options_, progress, context.threads);

    Outcome outcome;
    for (const Text& warning : map.warnings)
      outcome.warnings.push_back(phrase("%1: %2", file_, warning));
    ordered_json organs = ordered_json::array();
    Listing listing;
    FileNames names;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      progress.report(static_cast<double>(i) / static_cast<double>(surfaces.size()), "writing");
      progress.throwIfCancelled();
      medical_io::LabelSurface& surface = surfaces[i];
      const medical_io::Segment& segment = map.segments[surface.segment];
      paint(surface.mesh, segment.color);
      const auto file = folder.place(names.of(segment.name, format_));
      medical_io::writeSurface(file, surface.mesh, {.name = segment.name});
      organs.push_back(rowOf(segment, surface, file));
      listing.add(segment.name, std::to_string(surface.mesh.triangles.rows()) + " triangles, " +
                                    fixed(surface.volumeMm3 / kMm3PerMl, 2) + " ml, " + file.string());
      for (const Text& warning : surface.warnings)
        outcome.warnings.push_back(phrase("%1: %2", segment.name, warning));
    }
    folder.keep();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    outcome.json = {
        {"file", file_}, {"organs", organs}, {"seconds", seconds.count()}, {"warnings", outcome.warnings}};
    appendPatient(outcome, medical_io::placedOrgans(map));
    outcome.text = listing.add("time", fixed(seconds.count(), 1) + " s").text();
    return outcome;
  }

private:
  std::string file_;
  std::string folder_;
  std::vector<std::string> labels_;
  std::optional<int> phase_;
  std::string format_ = "vtp";
  medical_io::LabelSurfaceOptions options_;
};

} // namespace

std::unique_ptr<Command> segmentCommand() {
  return std::make_unique<SegmentCommand>();
}

} // namespace viscera::app::cli

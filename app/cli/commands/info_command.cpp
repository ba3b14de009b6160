#include "cli/commands/all_commands.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <CLI/CLI.hpp>

#include "cli/cine_info.h"
#include "cli/inputs.h"
#include "cli/listing.h"
#include "cli/patient_info.h"
#include "cli/scan_input.h"
#include "cli/session_input.h"
#include "viscera/document/open_files.h"
#include "viscera/document/session_file.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/assess_surface.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/image_beside.h"
#include "viscera/medical_io/image_cut.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_series.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

constexpr double kMm2PerCm2 = 100.0;

std::string spaceName(medical_io::Space space) {
  return space == medical_io::Space::ras ? "RAS" : "LPS";
}

ordered_json boundsJson(const Bounds& bounds) {
  return {bounds.low.x(), bounds.high.x(), bounds.low.y(), bounds.high.y(), bounds.low.z(), bounds.high.z()};
}

std::string boundsText(const Bounds& bounds) {
  const Vec3 size = bounds.high - bounds.low;
  return fixed(size.x(), 1) + " x " + fixed(size.y(), 1) + " x " + fixed(size.z(), 1) + " mm around (" +
         fixed(bounds.center().x(), 1) + ", " + fixed(bounds.center().y(), 1) + ", " +
         fixed(bounds.center().z(), 1) + ")";
}

std::string yesNo(bool value) {
  return value ? "yes" : "no";
}

/// Describes a surface as read from its file, without further repairs.
Outcome describe(const medical_io::SurfaceFile& surface, const std::string& file, CommandContext& context) {
  const medical_io::SurfaceAssessment assessment = medical_io::assessSurface(
      surface.mesh, surface.report,
      {surface.name, surface.spaceStated ? std::optional(surface.space) : std::nullopt}, context.progress,
      context.threads);
  const geometry::SurfaceReport& report = assessment.report;
  const Bounds bounds = boundsOf(surface.mesh.points);
  const double volumeMl = report.volumeMm3 / kMm3PerMl;
  const double areaCm2 = report.areaMm2 / kMm2PerCm2;
  std::vector<Text> warnings = surface.warnings;
  appendFindings(warnings, assessment.findings);
  for (Text& fault : geometry::faults(report))
    if (std::find(warnings.begin(), warnings.end(), fault) == warnings.end())
      warnings.push_back(std::move(fault));

  Outcome outcome;
  outcome.json = {{"kind", "organ"},
                  {"file", file},
                  {"name", surface.name},
                  {"vertices", surface.mesh.points.rows()},
                  {"triangles", surface.mesh.triangles.rows()},
                  {"closed", report.closed()},
                  {"manifold", report.manifold()},
                  {"components", report.components},
                  {"outward", report.outward()},
                  {"boundaryEdges", report.boundaryEdges},
                  {"nonManifoldEdges", report.nonManifoldEdges},
                  {"selfIntersections", assessment.selfIntersections},
                  {"volumeMl", report.closed() ? ordered_json(volumeMl) : ordered_json(nullptr)},
                  {"areaCm2", areaCm2},
                  {"boundsMm", boundsJson(bounds)},
                  {"space", spaceName(surface.space)},
                  {"spaceStated", surface.spaceStated},
                  {"findings", findingsJson(assessment.findings)},
                  {"warnings", warnings}};
  outcome.text =
      Listing()
          .add("kind", "organ")
          .add("name", surface.name)
          .add("vertices", std::to_string(surface.mesh.points.rows()))
          .add("triangles", std::to_string(surface.mesh.triangles.rows()))
          .add("closed", yesNo(report.closed()))
          .add("manifold", yesNo(report.manifold()))
          .add("components", std::to_string(report.components))
          .add("outward", yesNo(report.outward()))
          .add("crossings", std::to_string(assessment.selfIntersections))
          .add("volume", report.closed() ? fixed(volumeMl, 1) + " ml" : "none: the surface is open")
          .add("area", significant(areaCm2, 4) + " cm2")
          .add("size", boundsText(bounds))
          .add("space",
               spaceName(surface.space) + (surface.spaceStated ? "" : " (assumed; the file does not say)"))
          .text();
  outcome.warnings = std::move(warnings);
  return outcome;
}

/// Describes the organs of a surface file that holds several.
Outcome describe(const std::vector<medical_io::SurfacePart>& parts, const std::string& file) {
  const medical_io::SurfaceFile& first = parts.front().surface;
  Bounds all = boundsOf(first.mesh.points);
  ordered_json organs = ordered_json::array();
  std::vector<medical_io::PlacedOrgan> placed;
  Outcome outcome;
  Listing listing;
  listing.add("kind", "organs").add("organs", std::to_string(parts.size()));
  for (const medical_io::SurfacePart& part : parts) {
    const medical_io::SurfaceFile& surface = part.surface;
    const geometry::SurfaceReport& report = surface.report;
    const Bounds bounds = boundsOf(surface.mesh.points);
    all = {all.low.cwiseMin(bounds.low), all.high.cwiseMax(bounds.high)};
    const double volumeMl = report.volumeMm3 / kMm3PerMl;
    placed.push_back({surface.name, bounds, report.closed() ? std::abs(volumeMl) : 0});
    organs.push_back(
        {{"name", surface.name},
         {"vertices", surface.mesh.points.rows()},
         {"triangles", surface.mesh.triangles.rows()},
         {"closed", report.closed()},
         {"manifold", report.manifold()},
         {"components", report.components},
         {"outward", report.outward()},
         {"volumeMl", report.closed() ? ordered_json(volumeMl) : ordered_json(nullptr)},
         {"areaCm2", report.areaMm2 / kMm2PerCm2},
         {"boundsMm", boundsJson(bounds)},
         {"color", part.color ? numbersJson(*part.color) : ordered_json(nullptr)},
         {"opacity", part.opacity},
         {"cavityOf", part.cavityOf < 0
                          ? ordered_json(nullptr)
                          : ordered_json(parts[static_cast<std::size_t>(part.cavityOf)].surface.name)},
         {"warnings", surface.warnings}});
    listing.add("  " + surface.name,
                report.closed() ? fixed(volumeMl, 2) + " ml" : "no volume: the surface is open");
    for (const Text& warning : surface.warnings)
      outcome.warnings.push_back(phrase("%1: %2", surface.name, warning));
  }
  outcome.text = listing.add("size", boundsText(all))
                     .add("space", spaceName(first.space) +
                                       (first.spaceStated ? "" : " (assumed; the file does not say)"))
                     .text();
  outcome.json = {{"kind", "organs"},
                  {"file", file},
                  {"organs", organs},
                  {"boundsMm", boundsJson(all)},
                  {"space", spaceName(first.space)},
                  {"spaceStated", first.spaceStated},
                  {"warnings", outcome.warnings}};
  appendPatient(outcome, placed);
  return outcome;
}

Outcome describe(const medical_io::HandleFile& handles, const std::string& file) {
  const Bounds bounds = boundsOf(handles.positions());
  ordered_json groups = ordered_json::array();
  Listing listing;
  listing.add("kind", "handles").add("handles", std::to_string(handles.count()));
  for (const medical_io::HandleGroupRecord& group : handles.groups) {
    groups.push_back({{"name", group.name}, {"handles", group.handles.size()}});
    listing.add("group", group.name + ": " + std::to_string(group.handles.size()));
  }
  listing.add("size", boundsText(bounds)).add("space", "LPS");
  Outcome outcome;
  outcome.json = {{"kind", "handles"},
                  {"file", file},
                  {"handles", handles.count()},
                  {"groups", groups},
                  {"labels", handles.labels()},
                  {"boundsMm", boundsJson(bounds)},
                  {"space", "LPS"},
                  {"warnings", handles.warnings}};
  outcome.text = listing.text();
  outcome.warnings = handles.warnings;
  return outcome;
}

/// "0, 40, 80".
std::string timesText(const std::vector<double>& times) {
  std::string text;
  for (const double time : times)
    text += (text.empty() ? "" : ", ") + significant(time, 4);
  return text;
}

Outcome describe(const medical_io::LabelMap& map, const std::string& file, Progress& progress) {
  const Bounds bounds = map.bounds();
  const Vec3 spacing = map.spacing();
  ordered_json labels = ordered_json::array();
  const std::string times = " x ";
  Listing listing;
  listing.add("kind", "label map")
      .add("voxels", std::to_string(map.size[0]) + times + std::to_string(map.size[1]) + times +
                         std::to_string(map.size[2]))
      .add("spacing", significant(spacing.x(), 4) + times + significant(spacing.y(), 4) + times +
                          significant(spacing.z(), 4) + " mm")
      .add("size", boundsText(bounds))
      .add("space", map.space)
      .add("layers", std::to_string(map.layers.size()))
      .add("labels", std::to_string(map.segments.size()));
  if (!map.phaseTimesMs.empty())
    listing.add("phase", std::to_string(map.phase) + " of " + std::to_string(map.phaseTimesMs.size()) +
                             ", at " + timesText(map.phaseTimesMs) + " ms");
  std::vector<Text> warnings = map.warnings;
  for (std::size_t i = 0; i < map.segments.size(); ++i) {
    const medical_io::Segment& segment = map.segments[i];
    const double volumeMl = map.volumeMl(segment);
    const auto cut = medical_io::imageCut(map, i);
    if (cut)
      warnings.push_back(phrase("%1: %2", named(segment.name), cut->text()));
    labels.push_back({{"label", segment.label},
                      {"name", segment.name},
                      {"named", segment.named},
                      {"layer", segment.layer},
                      {"voxels", segment.voxels},
                      {"volumeMl", volumeMl},
                      {"cutBy", cut ? ordered_json(cut->edges) : ordered_json::array()},
                      {"color", numbersJson(segment.color)}});
    listing.add("  " + std::to_string(segment.label), segment.name + ", " + fixed(volumeMl, 2) + " ml");
  }
  ordered_json directions = ordered_json::array();
  for (int axis = 0; axis < 3; ++axis)
    directions.push_back(numbersJson(map.indexToLps.linear().col(axis) / spacing[axis]));
  const auto scan = medical_io::imageBeside(file, medical_io::ImageContents::values, progress);
  if (scan)
    listing.add("scan", scan->string() + ", beside it");
  Outcome outcome;
  outcome.json = {{"kind", "label map"},
                  {"file", file},
                  {"beside", scan ? ordered_json(scan->string()) : ordered_json(nullptr)},
                  {"size", map.size},
                  {"spacingMm", numbersJson(spacing)},
                  {"originMm", numbersJson(map.indexToLps.translation())},
                  {"directions", directions},
                  {"layers", map.layers.size()},
                  {"phases", std::max<std::size_t>(map.phaseTimesMs.size(), 1)},
                  {"phase", map.phase},
                  {"phaseTimesMs", map.phaseTimesMs},
                  {"labels", labels},
                  {"boundsMm", boundsJson(bounds)},
                  {"space", map.space},
                  {"warnings", warnings}};
  outcome.text = listing.text();
  outcome.warnings = std::move(warnings);
  if (!map.phaseTimesMs.empty())
    outcome.warnings.push_back(phrase(
        "It has %1 label maps over time, of which this is one; viscera track follows the motion over all",
        map.phaseTimesMs.size()));
  appendPatient(outcome, medical_io::placedOrgans(map));
  return outcome;
}

/// `viscera info FILE`: describes the contents of an organ, label map or handle file.
class InfoCommand final : public Command {
public:
  std::string name() const override { return "info"; }
  std::string summary() const override {
    return "Say what is in an organ, label map, scan, handle or session file";
  }

  void addOptions(CLI::App& options) override {
    options
        .add_option(
            "FILE", files_,
            "A file of surfaces, one of its organs (FILE/NAME), a label map or folder of masks, a scan, a "
            "handle file, a session, or sample:NAME; several files, or a folder of surfaces: one patient")
        ->required();
    scan_.addChoiceTo(options);
  }

  Outcome run(CommandContext& context) override {
    if (files_.size() > 1 || surfacesIn(files_.front()).size() > 1)
      return describePatient(files_, context);
    file_ = files_.front();
    return describeOne(context);
  }

private:
  Outcome describeOne(CommandContext& context) {
    if (isSample(file_) || namesLabel(file_)) {
      const document::Organ organ = organInput(file_, context.samples, context.progress);
      medical_io::SurfaceFile surface;
      surface.mesh = *organ.mesh;
      surface.report = geometry::checkSurface(surface.mesh);
      surface.name = organ.name;
      surface.spaceStated = true;
      surface.warnings = organ.warnings;
      return describe(surface, file_, context);
    }
    if (const auto part = surfacePartInput(file_))
      return describe(part->surface, file_, context);
    if (document::isSessionFile(file_))
      return describeSession(file_, context);
    if (document::isHandleFile(file_))
      return describe(medical_io::readHandles(file_), file_);
    if (medical_io::isScan(file_))
      return describeImage(context);
    if (medical_io::isLabelMap(file_))
      return describe(medical_io::readLabelMap(file_, context.progress), file_, context.progress);
    if (const auto only = onlyFileIn(file_)) {
      file_ = only->string();
      return describeOne(context);
    }
    const std::vector<medical_io::SurfacePart> parts = medical_io::readSurfaces(file_);
    return parts.size() == 1 ? describe(parts.front().surface, file_, context) : describe(parts, file_);
  }

  /// The file of a folder that holds one thing, such as an archive's export of one structure set.
  static std::optional<std::filesystem::path> onlyFileIn(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error), end;
    if (error || entry == end || !entry->is_regular_file(error))
      return std::nullopt;
    const std::filesystem::path file = entry->path();
    return entry.increment(error) == end ? std::optional(file) : std::nullopt;
  }

  /// Describes a cine study, unless the user asks for one series or phase of it; else the first of several
  /// volumes, as of a scan.
  Outcome describeImage(CommandContext& context) const {
    std::vector<Text> warnings;
    if (scan_.chosen().series.empty() && !scan_.chosenPhase())
      if (auto study = describeCine(file_, context, warnings))
        return std::move(*study);
    Outcome outcome = describeOneImage(context);
    if (!warnings.empty()) {
      outcome.warnings.insert(outcome.warnings.begin(), warnings.begin(), warnings.end());
      outcome.json["warnings"] = outcome.warnings;
    }
    return outcome;
  }

  Outcome describeOneImage(CommandContext& context) const {
    const auto read = [&](std::optional<int> phase) {
      return medical_io::readScanOrLabels(file_, scan_.chosen(), context.progress, phase);
    };
    medical_io::ScanOrLabels image =
        read(medical_io::volumesIn(file_) > 1 ? scan_.chosen().phase : scan_.chosenPhase());
    if (const auto* scan = std::get_if<medical_io::Scan>(&image))
      return describeScan(*scan, file_, scan_.chosen(), context);
    return describe(std::get<medical_io::LabelMap>(image), file_, context.progress);
  }

  std::vector<std::string> files_;
  std::string file_; ///< The only one.
  ScanInputOptions scan_;
};

} // namespace

std::unique_ptr<Command> infoCommand() {
  return std::make_unique<InfoCommand>();
}

} // namespace viscera::app::cli

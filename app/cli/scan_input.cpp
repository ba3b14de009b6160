#include "cli/scan_input.h"

#include <array>
#include <string_view>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/image_beside.h"
#include "viscera/medical_io/scan_over_time.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

constexpr double kMsOfASecond = 1000;

std::string sizeText(const std::array<int, 3>& size) {
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

std::string spacingText(const Vec3& spacing) {
  return significant(spacing.x(), 4) + " x " + significant(spacing.y(), 4) + " x " +
         significant(spacing.z(), 4) + " mm";
}

std::string_view nameOf(medical_io::ScanFinding::Kind kind) {
  // Names in the order of the enumeration.
  static constexpr std::array<std::string_view, 10> kNames = {
      "missing-slice", "doubled-slice", "uneven-spacing", "tilt",      "order",
      "mixed-sizes",   "damaged",       "other",          "part-read", "resampled"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// "slices 1 to 14 of 28"; nothing where all are read as they are.
std::string sliceText(const medical_io::SliceRange& slices) {
  if (slices.resampled)
    return "all " + std::to_string(slices.all) + " slices, resampled";
  if (slices.last - slices.first + 1 >= slices.all)
    return {};
  return "slices " + std::to_string(slices.first) + " to " + std::to_string(slices.last) + " of " +
         std::to_string(slices.all);
}

ordered_json slicesJson(const medical_io::SliceRange& slices) {
  return {
      {"first", slices.first}, {"last", slices.last}, {"all", slices.all}, {"resampled", slices.resampled}};
}

ordered_json scanFindingsJson(const medical_io::Scan& scan) {
  ordered_json list = ordered_json::array();
  for (const medical_io::ScanFinding& finding : scan.findings)
    list.push_back({{"kind", nameOf(finding.kind)}, {"text", finding.sentence.english()}});
  return list;
}

ordered_json seriesJson(const std::vector<medical_io::ScanSeries>& all) {
  ordered_json list = ordered_json::array();
  for (const medical_io::ScanSeries& series : all)
    list.push_back({{"id", series.id},
                    {"description", series.description},
                    {"modality", series.modality},
                    {"size", series.size},
                    {"spacingMm", numbersJson(series.spacing)},
                    {"phases", series.phases},
                    {"slices", slicesJson(series.slices)},
                    {"files", series.files.size()}});
  return list;
}

Listing listingOf(const medical_io::Scan& scan, const std::array<double, 2>& range) {
  const std::string unit = scan.unit.empty() ? "" : " " + scan.unit;
  Listing listing;
  listing.add("kind", "scan");
  if (!scan.modality.empty())
    listing.add("modality", scan.modality);
  if (!scan.description.empty())
    listing.add("series", scan.description);
  listing.add("voxels", sizeText(scan.size))
      .add("spacing", spacingText(scan.spacing()))
      .add("values", significant(range[0], 5) + " to " + significant(range[1], 5) + unit)
      .add("space", scan.space);
  if (!scan.phaseTimesMs.empty())
    listing.add("phase", std::to_string(scan.phase) + " of " + std::to_string(scan.phaseTimesMs.size()));
  if (!scan.transferSyntax.empty())
    listing.add("packed as", scan.transferSyntax);
  return listing;
}

/// All phases of a scan over time, also where some are damaged; none for a scan of one instant.
std::optional<medical_io::ScanOverTime> phasesIn(const std::string& file, const medical_io::Scan& scan,
                                                 const medical_io::ScanOptions& chosen, Outcome& outcome,
                                                 CommandContext& context) {
  if (scan.phaseTimesMs.size() < 2)
    return std::nullopt;
  auto time = medical_io::readScanOverTime(file, chosen, context.progress);
  if (time)
    outcome.warnings.insert(outcome.warnings.end(), time->findings.begin(), time->findings.end());
  return time;
}

ordered_json timeJson(const medical_io::ScanOverTime& time) {
  return {{"phases", time.phasesInCycle()},
          {"fractions", time.fractions},
          {"missingFractions", time.missing},
          {"intervalMs",
           time.periodSeconds > 0 ? ordered_json(kMsOfASecond * time.periodSeconds) : ordered_json(nullptr)},
          {"findings", time.findings}};
}

/// "20 phases in 800 ms", "19 of 20 phases".
std::string timeText(const medical_io::ScanOverTime& time) {
  return std::to_string(time.fractions.size()) +
         (time.missing.empty() ? "" : " of " + std::to_string(time.phasesInCycle())) + " phases" +
         (time.periodSeconds > 0 ? " in " + significant(kMsOfASecond * time.periodSeconds, 4) + " ms" : "");
}

} // namespace

void ScanInputOptions::addTo(CLI::App& options) {
  options
      .add_option("SCAN", file_,
                  "A NIfTI, NRRD, MetaImage, FreeSurfer or GIPL file, a DICOM folder or a file of it")
      ->required();
  addChoiceTo(options);
}

void ScanInputOptions::addChoiceTo(CLI::App& options) {
  options
      .add_option(
          "--series", chosen_.series,
          "Of a DICOM folder with several series; viscera info lists them. Behind it, or alone for the "
          "largest: @2 for the next even part of slices that are not even, @all for all of them "
          "resampled")
      ->type_name("ID");
  options
      .add_option_function<int>(
          "--phase",
          [this](int phase) {
            chosen_.phase = phase;
            phase_ = phase;
          },
          "Of a scan or label maps with several volumes in time; the first is 0")
      ->type_name("N")
      ->check(atLeast(0));
}

medical_io::Scan ScanInputOptions::read(const std::string& file, Progress& progress) const {
  return medical_io::readScan(file, chosen_, progress);
}

void appendFindings(std::vector<Text>& warnings, const medical_io::Scan& scan) {
  for (const medical_io::ScanFinding& finding : scan.findings)
    if (finding.kind != medical_io::ScanFinding::Kind::order)
      warnings.push_back(finding.sentence);
}

Outcome describeScan(const medical_io::Scan& scan, const std::string& file,
                     const medical_io::ScanOptions& chosen, CommandContext& context) {
  const std::vector<medical_io::ScanSeries> series = medical_io::listScans(file, context.progress);
  const std::array<double, 2> range = scan.range();
  const medical_io::ValueWindow window = scan.firstWindow();
  const Bounds bounds = scan.bounds();
  ordered_json directions = ordered_json::array();
  for (int axis = 0; axis < 3; ++axis)
    directions.push_back(numbersJson(scan.indexToLps.linear().col(axis).normalized()));
  Outcome outcome;
  appendFindings(outcome.warnings, scan);
  const auto time = phasesIn(file, scan, chosen, outcome, context);
  const auto labels = medical_io::imageBeside(file, medical_io::ImageContents::labels, context.progress);
  outcome.json = {
      {"kind", "scan"},
      {"file", file},
      {"beside", labels ? ordered_json(labels->string()) : ordered_json(nullptr)},
      {"size", scan.size},
      {"spacingMm", numbersJson(scan.spacing())},
      {"originMm", numbersJson(scan.indexToLps.translation())},
      {"directions", directions},
      {"boundsMm",
       {bounds.low.x(), bounds.high.x(), bounds.low.y(), bounds.high.y(), bounds.low.z(), bounds.high.z()}},
      {"space", scan.space},
      {"modality", scan.modality},
      {"description", scan.description},
      {"unit", scan.unit},
      {"minimum", range[0]},
      {"maximum", range[1]},
      {"level", window.level},
      {"window", window.width},
      {"phases", std::max<std::size_t>(scan.phaseTimesMs.size(), 1)},
      {"phaseTimesMs", scan.phaseTimesMs},
      {"time", time ? timeJson(*time) : ordered_json(nullptr)},
      {"transferSyntax", scan.transferSyntax},
      {"series", seriesJson(series)},
      {"findings", scanFindingsJson(scan)},
      {"warnings", outcome.warnings}};
  Listing listing = listingOf(scan, range);
  if (time)
    listing.add("time", timeText(*time));
  if (labels)
    listing.add("label map", labels->string() + ", beside it");
  if (series.size() > 1)
    for (const medical_io::ScanSeries& one : series) {
      const std::string slices = sliceText(one.slices);
      listing.add("  " + one.id, one.description + ", " + one.modality + ", " + sizeText(one.size) + ", " +
                                     spacingText(one.spacing) + (slices.empty() ? "" : ", " + slices));
    }
  outcome.text = listing.text();
  return outcome;
}

} // namespace viscera::app::cli

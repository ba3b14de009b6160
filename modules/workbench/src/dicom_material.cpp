#include <algorithm>
#include <ctime>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/document/scan_item.h"
#include "viscera/medical_io/scan.h"
#include "viscera/workbench/dicom_export.h"

namespace viscera::workbench {
namespace {

constexpr int kMostPhases = 200;
constexpr double kSecondsOfMinute = 60;

std::string timeNow() {
  const std::time_t now = std::time(nullptr);
  std::tm local = {};
  localtime_r(&now, &local);
  char text[16] = {};
  std::strftime(text, sizeof text, "%Y%m%d%H%M%S", &local);
  return text;
}

std::vector<std::shared_ptr<const document::Organ>>
chosenOrgans(Workbench& bench, const std::vector<std::string>& names, std::vector<Text>& warnings) {
  std::vector<std::shared_ptr<const document::Organ>> chosen;
  if (names.empty())
    chosen = *bench.state().organs;
  for (const std::string& name : names)
    chosen.push_back(bench.state().organ(bench.organ(name)));
  std::erase_if(chosen, [&](const auto& organ) {
    if (!organ->closed())
      warnings.push_back(phrase("%1 is left out: its surface is open", organ->name));
    return !organ->closed();
  });
  if (chosen.empty())
    throw DataError("There is no organ with a closed surface to write as DICOM", {}, "close it first");
  return chosen;
}

/// Distances and angles in the pose that is shown.
void appendFindings(Workbench& bench, std::vector<clinic::MeasuredOrgan>& findings) {
  for (const document::Measurement& measurement : *bench.state().measurements) {
    if (document::isRegion(measurement.kind))
      continue;
    const double value = bench.measure(measurement).now;
    clinic::MeasuredOrgan finding;
    finding.name = measurement.name.empty() ? document::nameOf(measurement.kind) : measurement.name;
    finding.trackingUid = clinic::newUid();
    if (document::isLength(measurement.kind))
      finding.measurements.push_back({clinic::quantities::kLength, value, "mm", "millimeter", ""});
    else
      finding.measurements.push_back({clinic::quantities::kAngle, value, "deg", "degree", ""});
    findings.push_back(std::move(finding));
  }
}

void takeIdentity(Workbench& bench, DicomExport& what, std::vector<Text>& warnings, Progress& progress) {
  what.identity = clinic::newStudyIdentity();
  const auto& scan = bench.state().scan;
  if (!scan)
    return;
  what.alsoPrivate.push_back(scan->scan->patientName);
  try {
    what.identity = studyIdentityOf(scan->file, scan->series, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) { // Not DICOM, or no longer there.
    warnings.push_back("the scan's DICOM files are not there: the objects get a study of their own");
  }
}

} // namespace

clinic::StudyIdentity studyIdentityOf(const std::filesystem::path& fileOrFolder, const std::string& series,
                                      Progress& progress) {
  const std::vector<medical_io::ScanSeries> all = medical_io::listScans(fileOrFolder, progress);
  const std::string id = series.substr(0, series.find('@'));
  const auto found = std::find_if(all.begin(), all.end(), [&](const medical_io::ScanSeries& one) {
    return id.empty() || one.id.substr(0, one.id.find('@')) == id;
  });
  if (found == all.end())
    throw UsageError("there is no such series", id);
  return clinic::readStudyIdentity(found->files, progress);
}

DicomExport dicomExportOf(Workbench& bench, const std::vector<std::string>& organs, int phases,
                          std::vector<Text>& warnings, Progress& progress) {
  if (phases < 0 || phases > kMostPhases)
    throw UsageError("The number of phases is 0 to 200", std::to_string(phases));
  DicomExport what;
  const auto chosen = chosenOrgans(bench, organs, warnings);
  for (const auto& organ : chosen)
    what.organs.push_back({organ->name, organ->look.color, organ->mesh});
  const auto keepPose = [&](double seconds) {
    ExportedPhase phase;
    phase.seconds = seconds;
    for (const auto& organ : chosen)
      phase.points.push_back(bench.organs().points(organ->id));
    what.phases.push_back(std::move(phase));
  };
  appendFindings(bench, what.findings);
  if (phases == 0)
    keepPose(0);
  else {
    bench.motion().requireMovable();
    const Points shown = bench.organs().shownPose();
    const double seconds = kSecondsOfMinute / bench.motion().ratePerMinute();
    for (int i = 0; i < phases; ++i) {
      progress.throwIfCancelled();
      bench.show(seconds * i / phases);
      keepPose(seconds * i / phases);
    }
    bench.showPose(shown);
  }
  takeIdentity(bench, what, warnings, progress);
  what.dateTime = timeNow();
  return what;
}

} // namespace viscera::workbench

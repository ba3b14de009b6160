#include "window/slices/warp_export.h"

#include <QFileDialog>
#include <QFileInfo>

#include <filesystem>
#include <optional>

#include "viscera/document/rig.h"
#include "viscera/document/scan_item.h"
#include "viscera/live/movable_binding.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/warped_image.h"
#include "window/work/actions.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

/// Parts of the whole job: until the space is bound, and until the scan is written.
constexpr double kBound = 0.1, kScanWritten = 0.7;

/// All that a worker needs.
struct Work {
  std::shared_ptr<const document::ScanItem> scan;
  std::shared_ptr<const coordinates::CoordinateSystem> system;
  coordinates::BindOptions options;
  coordinates::HandleSet handles;
  Points pose;
  std::vector<std::shared_ptr<const document::Organ>> stiff; ///< Organs that do not bend,
  std::vector<Points> stiffPosed;                            ///< and their vertices in the pose.
  std::filesystem::path file;
  std::optional<std::filesystem::path> labels; ///< The label map to warp as well.
};

struct Written {
  QString labels; ///< Empty when there were none.
  std::size_t folded = 0;
};

/// The label map that the organs, or at least the first of them that came from one, were made of.
std::optional<std::filesystem::path> labelsOf(const document::DocumentState& state) {
  for (const auto& organ : *state.organs)
    if (!organ->file.empty() && medical_io::isLabelMap(organ->file))
      return organ->file;
  return std::nullopt;
}

std::filesystem::path labelFileBeside(const std::filesystem::path& scan) {
  std::string name = scan.filename().string();
  for (const auto& [ending, labels] : {std::pair{".nii.gz", ".labels.nii.gz"},
                                       std::pair{".nii", ".labels.nii"}, std::pair{".nrrd", ".seg.nrrd"}})
    if (name.ends_with(ending)) {
      name.replace(name.size() - std::string_view(ending).size(), std::string::npos, labels);
      return scan.parent_path() / name;
    }
  return scan.parent_path() / (name + ".seg.nrrd"); // Writing the scan has refused such a name before.
}

Written write(const Work& work, Progress& progress) {
  const medical_io::Scan& scan = *work.scan->scan;
  std::optional<deformation::InverseMap> map;
  std::shared_ptr<deformation::StiffBodies> stiff;
  runPart(progress, 0, kBound, [&](Progress& part) {
    map.emplace(*work.system, work.handles, work.pose, work.options, medical_io::warpOptions(scan.spacing()),
                part);
    stiff = live::stiffBodies(work.stiff, {}, part);
    std::vector<const Points*> posed;
    for (const Points& points : work.stiffPosed)
      posed.push_back(&points);
    stiff->setPose(posed, *map);
  });
  const medical_io::Warp warp{*map, *work.system, stiff->empty() ? nullptr : stiff.get()};
  Written written;
  runPart(progress, kBound, work.labels ? kScanWritten : 1, [&](Progress& part) {
    medical_io::WarpReport report;
    const medical_io::Scan warped = medical_io::warpedScan(scan, warp, report, part);
    part.report(1, "Writing the scan");
    medical_io::writeScan(work.file, warped);
    written.folded = report.folded;
  });
  if (!work.labels)
    return written;
  runPart(progress, kScanWritten, 1, [&](Progress& part) {
    medical_io::WarpReport report;
    const medical_io::LabelMap labels = medical_io::readLabelMap(
        *work.labels, part, document::phaseOfLabels(*work.labels, work.scan.get(), part));
    const std::filesystem::path file = labelFileBeside(work.file);
    medical_io::writeLabelMap(file, medical_io::warpedLabelMap(labels, warp, report, part));
    written.labels = text(file.filename().string());
  });
  return written;
}

} // namespace

WarpExport::WarpExport(Workspace& workspace, Settings& settings, QWidget* window)
    : QObject(window), workspace_(workspace), settings_(settings), window_(window) {}

void WarpExport::addTo(Actions& actions) {
  actions.add("export.scan",
              {tr("Export the &warped scan..."),
               "patient",
               {},
               tr("Write the scan as the pose warps it, with a label map of the posed organs")},
              [this] { chooseAndExport(); });
  actions.enableWhile({"export.scan"}, [this] { return workspace_.state().scan != nullptr; });
}

void WarpExport::chooseAndExport() {
  const QString folder = settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString file =
      QFileDialog::getSaveFileName(window_, tr("Export the warped scan"), folder + tr("/warped.nii.gz"),
                                   tr("NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)"));
  if (!file.isEmpty())
    exportScan(file);
}

void WarpExport::exportScan(const QString& file) {
  const document::DocumentState& state = workspace_.state();
  Work work;
  const bool can = workspace_.guarded([&] {
    if (!state.scan)
      throw UsageError("There is no scan to export", {}, "open one first");
    if (state.rig->handles.empty())
      throw UsageError("There are no handles that could warp the scan", {}, "place some first");
    work = {state.scan,
            workspace_.registry().find(state.system->id),
            {state.system->parameters, {}},
            document::handleSet(*state.rig),
            workspace_.live().shownPose(),
            live::stiffOrgans(*state.organs),
            {},
            file.toStdString(),
            labelsOf(state)};
    for (const auto& organ : work.stiff)
      work.stiffPosed.push_back(workspace_.live().points(organ->id));
  });
  if (!can)
    return;
  workspace_.inBackground<Written>(
      tr("Exporting the warped scan"), Workspace::slotOf(file),
      [work](Progress& progress) { return write(work, progress); },
      [this, file](const Written& written) {
        settings_.setValue(kFolderKey, QFileInfo(file).absolutePath());
        QString said = tr("The warped scan was written to %1.").arg(file);
        if (!written.labels.isEmpty())
          said += QLatin1Char(' ') + tr("Its labels are beside it: %1.").arg(written.labels);
        if (written.folded > 0)
          said += QLatin1Char(' ') + tr("The pose folds the tissue at %n voxels: their values are estimates.",
                                        nullptr, static_cast<int>(written.folded));
        workspace_.noteWritten(said, file);
      });
}

} // namespace viscera::app

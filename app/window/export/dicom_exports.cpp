#include "window/export/dicom_exports.h"

#include <QFileInfo>
#include <QStringList>
#include <QTemporaryDir>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "viscera/document/scan_item.h"
#include "window/archive/archive_client.h"
#include "window/work/actions.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr const char* kIdentitySlot = "dicomIdentity";
constexpr double kBoundAgain = 0.3; ///< Part of the work until the organs are in their poses.
constexpr int kMostFolders = 1000;  ///< Of folders that are tried.

} // namespace

/// All that a worker needs.
struct DicomExports::Material {
  DicomDialog::Choice choice;
  document::DocumentState state;
  coordinates::Registry systems;
  Points shownPose;
  std::shared_ptr<const sequences::Sequence> sequence; ///< Null: no motion moves the organs.
  double ratePerMinute = 0;
  std::optional<live::PrescribedVolume> prescribed;
};

struct DicomExports::Made {
  std::vector<workbench::DicomFile> files;
  std::vector<Text> warnings;
};

DicomExports::DicomExports(Window window, QWidget* parent)
    : QObject(parent), window_(window), parent_(parent) {}

void DicomExports::addTo(Actions& actions) {
  actions.add("export.dicom",
              {tr("Export as &DICOM..."),
               "export",
               {},
               tr("Write organs and measurements as DICOM files, or send them to an archive (PACS)")},
              [this] { show(); });
  actions.enableWhile({"export.dicom"}, [this] { return !window_.workspace.document().organs().empty(); });
}

/// A folder that is not there yet, so that nothing in it stands in the way.
QString DicomExports::newFolder() const {
  const QString stem =
      window_.settings.folder(kFolderKey, QStandardPaths::DocumentsLocation) + QStringLiteral("/dicom");
  QString folder = stem;
  for (int number = 2; number < kMostFolders && QFileInfo::exists(folder); ++number)
    folder = stem + QLatin1Char('_') + QString::number(number);
  return folder;
}

void DicomExports::show() {
  if (dialog_ && dialog_->isVisible())
    return dialog_->raise();
  DicomDialog::Offer offer;
  offer.organs = window_.workspace.document().organs();
  offer.moves = window_.playback.player().movable();
  offer.hasScan = window_.workspace.state().scan != nullptr;
  offer.folder = newFolder();
  window_.workspace.guarded([&] { offer.archives = window_.archives.connections(); });
  dialog_ = new DicomDialog(offer, parent_);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_.data(), &QDialog::accepted, this, [this] { write(dialog_->choice()); });
  if (offer.hasScan)
    readIdentity();
  dialog_->open();
}

void DicomExports::readIdentity() {
  const auto scan = window_.workspace.state().scan;
  window_.workspace.jobs().submit<clinic::StudyIdentity>(
      tr("Reading whose the scan is").toStdString(), kIdentitySlot,
      [scan](Progress& progress) { return workbench::studyIdentityOf(scan->file, scan->series, progress); },
      [dialog = dialog_](JobResult<clinic::StudyIdentity> result) {
        if (!dialog)
          return;
        if (result.value)
          dialog->showIdentity(clinic::identifyingElements(*result.value));
        else
          dialog->showNoIdentity();
      });
}

std::shared_ptr<DicomExports::Material> DicomExports::material(const DicomDialog::Choice& choice) const {
  const Workspace& workspace = window_.workspace;
  auto made = std::make_shared<Material>(Material{
      choice, workspace.state(), workspace.registry(), window_.workspace.live().shownPose(), {}, 0, {}});
  const live::Player& player = window_.playback.player();
  if (player.movable()) {
    made->sequence = window_.playback.sharedSequence();
    made->ratePerMinute = player.ratePerMinute();
    made->prescribed = player.runner().prescribed();
  }
  return made;
}

DicomExports::Made DicomExports::make(const Material& material, const std::string& folder,
                                      Progress& progress) {
  Made made;
  workbench::DicomExport what;
  runPart(progress, 0, kBoundAgain, [&](Progress& part) {
    workbench::Setup setup;
    setup.systems = material.systems;
    workbench::Workbench bench(std::move(setup), &part);
    document::SessionContents contents;
    contents.state = material.state;
    bench.restore(std::move(contents));
    bench.setSequence(material.sequence, material.ratePerMinute);
    if (material.sequence)
      bench.motion().prescribe(material.prescribed);
    if (material.shownPose.rows() > 0 && material.shownPose.rows() == material.state.pose->rows())
      bench.showPose(material.shownPose);
    what =
        workbench::dicomExportOf(bench, material.choice.organs, material.choice.phases, made.warnings, part);
  });
  what.kinds = material.choice.kinds;
  what.withoutIdentity = material.choice.withoutIdentity;
  runPart(progress, kBoundAgain, 1,
          [&](Progress& part) { made.files = workbench::writeDicomExport(folder, what, part); });
  return made;
}

/// "segmentations (2), surfaces (1)", and what was left out.
QString DicomExports::summary(const Made& made) {
  const std::pair<const char*, QString> kinds[] = {{"segmentation", tr("segmentations")},
                                                   {"measurements", tr("structured reports")},
                                                   {"surface", tr("surfaces")},
                                                   {"contours", tr("structure sets")}};
  QStringList counted;
  for (const auto& [kind, title] : kinds) {
    const auto count = std::count_if(made.files.begin(), made.files.end(),
                                     [&](const workbench::DicomFile& file) { return file.kind == kind; });
    if (count > 0)
      counted << QStringLiteral("%1 (%2)").arg(title).arg(count);
  }
  QString said = counted.join(QStringLiteral(", ")) + QLatin1Char('.');
  for (const Text& warning : made.warnings)
    said += QLatin1Char(' ') + asSentence(warning);
  return said;
}

void DicomExports::write(const DicomDialog::Choice& choice) {
  std::shared_ptr<Material> material;
  if (!window_.workspace.guarded([&] { material = this->material(choice); }))
    return;
  if (choice.archive)
    return send(*choice.archive, material);
  window_.workspace.inBackground<Made>(
      tr("Exporting as DICOM"), Workspace::slotOf(choice.folder),
      [material, folder = choice.folder.toStdString()](Progress& progress) {
        return make(*material, folder, progress);
      },
      [this, folder = choice.folder](const Made& made) {
        window_.settings.setValue(kFolderKey, QFileInfo(folder).absolutePath());
        window_.workspace.noteWritten(tr("Written to %1: %2").arg(folder, summary(made)),
                                      text(made.files.front().file.string()));
      });
}

void DicomExports::send(const clinic::ArchiveConnection& archive, std::shared_ptr<Material> material) {
  const auto room = std::make_shared<QTemporaryDir>(); // Only the user may read it.
  const auto made = std::make_shared<Made>();
  const QString name = text(archive.name);
  window_.archives.send(
      archive, {&window_.workspace.jobs(), Workspace::slotOf(name)},
      [room, made, material](Progress& progress) {
        if (!room->isValid())
          throw CannotCreateError("the folder cannot be made", room->path().toStdString());
        *made = make(*material, (room->path() + QStringLiteral("/dicom")).toStdString(), progress);
        std::vector<std::filesystem::path> files;
        for (const workbench::DicomFile& one : made->files)
          files.push_back(one.file);
        return files;
      },
      [this, made, name] { window_.workspace.note(tr("Sent to %1: %2").arg(name, summary(*made))); });
}

} // namespace viscera::app

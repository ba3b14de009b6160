#include "window/export/report_export.h"

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

#include "viscera/presentation/opened_heart.h"
#include "viscera/report/report_file.h"
#include "viscera/report/session_script.h"
#include "window/session/session_files.h"
#include "window/work/actions.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

/// The data that a worker needs, kept as long as it works.
struct Material {
  explicit Material(Workspace& workspace) : organs(workspace.live().copy()), systems(workspace.registry()) {}

  report::ReportSource source;
  live::PosedCopy organs;
  live::StressCopy stress;
  coordinates::Registry systems;
};

} // namespace

ReportExport::ReportExport(Window window, QWidget* parent)
    : QObject(parent), window_(window), parent_(parent) {}

void ReportExport::addTo(Actions& actions) {
  actions.add("file.report",
              {tr("&Report..."),
               "export",
               {},
               tr("Write pictures, volumes, measurements, stress and motion as PDF or as one HTML page")},
              [this] { choose(); });
  actions.add("edit.copyCommands",
              {tr("&Copy as commands"),
               nullptr,
               {},
               tr("Copy the session as a script of viscera commands that gives the same result")},
              [this] { copyCommands(); });
  actions.enableWhile({"file.report", "edit.copyCommands"},
                      [this] { return !window_.workspace.document().organs().empty(); });
}

presentation::ViewState ReportExport::view() const {
  presentation::ViewState view = window_.view.state(true);
  view.shown.rest = false; // The report shows the pose, even in the mode Handles.
  return view;
}

void ReportExport::choose() {
  const QString folder = window_.settings.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString file =
      QFileDialog::getSaveFileName(parent_, tr("Report"), folder + QLatin1Char('/') + tr("report.pdf"),
                                   tr("PDF documents (*.pdf);;Web pages (*.html)"));
  if (!file.isEmpty())
    write(file);
}

void ReportExport::write(const QString& file) {
  Workspace& workspace = window_.workspace;
  auto material = std::make_shared<Material>(workspace);
  report::ReportSource& source = material->source;
  if (!workspace.guarded([&] {
        source.view = view();
        source.state = workspace.state();
        source.tissue = live::measuredTissueOf(workspace.warp(), *source.state.measurements);
        if (source.view.shownPose.rows() != source.state.pose->rows())
          material->organs.showPose(*source.state.pose);
        if (source.view.shown.stress) {
          material->stress = workspace.stress().copy();
          source.stress = &material->stress;
          source.stressStatus = workspace.stress().status();
        }
      }))
    return;
  source.organs = &material->organs;
  source.systems = &material->systems;
  source.file = window_.files.file().toStdString();
  const live::Player& player = window_.playback.player();
  if (player.movable()) {
    source.sequence = window_.playback.sharedSequence();
    source.ratePerMinute = player.ratePerMinute();
    source.prescribed = player.runner().prescribed();
  }
  workspace.inBackground<int>(
      tr("Writing the report"), Workspace::slotOf(file),
      [material, path = file.toStdString()](Progress& progress) {
        if (!report::isReportFile(path))
          throw UsageError("A report cannot be written to this kind of file", path,
                           "let it end in .pdf or .html");
        report::ReportSource& whole = material->source;
        whole.heartTissue =
            presentation::heartTissueFor(whole.state, whole.view, sample_organs::standardLibrary(), progress);
        return report::writeReport(path, report::makeReport(whole, {}, progress));
      },
      [this, file](int pages) {
        window_.settings.setValue(kFolderKey, QFileInfo(file).absolutePath());
        window_.workspace.noteWritten(tr("%1: %n pages.", nullptr, pages).arg(QFileInfo(file).fileName()),
                                      file);
      });
}

void ReportExport::copyCommands() {
  report::ScriptSource source;
  if (!window_.workspace.guarded([&] { source.view = view(); }))
    return;
  source.state = window_.workspace.state();
  if (!window_.files.modified())
    source.session = window_.files.file().toStdString();
  window_.workspace.inBackground<report::SessionScript>(
      tr("Copying as commands"), "commands", [source](Progress&) { return report::sessionScript(source); },
      [this](const report::SessionScript& script) {
        QGuiApplication::clipboard()->setText(QString::fromStdString(script.text));
        window_.workspace.note(
            tr("%n commands are in the clipboard.", nullptr, static_cast<int>(script.commands.size())));
      });
}

} // namespace viscera::app

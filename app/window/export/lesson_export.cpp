#include "window/export/lesson_export.h"

#include <QFileDialog>
#include <QFileInfo>

#include "viscera/lesson/animated_gltf.h"
#include "viscera/lesson/lesson.h"
#include "viscera/presentation/opened_heart.h"
#include "viscera/presentation/presenter.h"
#include "window/export/lesson_dialog.h"
#include "window/style/language.h"
#include "window/work/actions.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

namespace viscera::app {

LessonExport::LessonExport(Window window, QWidget* parent)
    : QObject(parent), window_(window), parent_(parent) {}

void LessonExport::addTo(Actions& actions) {
  actions.add("export.lesson",
              {tr("Export &lesson..."),
               "export",
               {},
               tr("Write the organs and their motion as one page that opens in any browser")},
              [this] { choose(); });
  actions.enableWhile({"export.lesson"}, [this] { return !window_.workspace.document().organs().empty(); });
}

lesson::LessonSource LessonExport::source() const {
  lesson::LessonSource source;
  source.state = window_.workspace.state();
  source.camera = presentation::cameraOf(window_.picture.view());
  source.slides = window_.view.state().slides;
  source.person = window_.view.state().person;
  source.conduction = source.conductionShown = window_.view.state().conduction;
  if (const auto opened = presentation::openedHeart(source.state, window_.view.state());
      opened && window_.picture.heartTissue() && window_.picture.heartTissue()->isOf(opened->heart)) {
    source.tissue = window_.picture.heartTissue();
    source.cut = window_.view.state().cut;
  }
  const live::Player& player = window_.playback.player();
  if (!player.movable())
    return source;
  source.sequence = window_.playback.sharedSequence();
  source.ratePerMinute = player.ratePerMinute();
  source.prescribed = player.runner().prescribed();
  return source;
}

lesson::LessonPlan LessonExport::plan() const {
  const lesson::LessonSource from = source();
  return lesson::planLesson(from, lesson::readySpecFor(from));
}

void LessonExport::choose() {
  lesson::LessonPlan planned;
  if (!window_.workspace.guarded([&] { planned = plan(); }))
    return;
  LessonDialog dialog(planned, parent_);
  if (dialog.exec() != QDialog::Accepted)
    return;
  const QString folder = window_.settings.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString file = QFileDialog::getSaveFileName(
      parent_, tr("Export lesson"),
      folder + QLatin1Char('/') + (dialog.wantsPage() ? tr("lesson.html") : tr("lesson.glb")),
      dialog.wantsPage() ? tr("Web pages (*.html)") : tr("glTF scenes (*.glb)"));
  if (!file.isEmpty())
    write(dialog.plan(), file);
}

void LessonExport::write(const lesson::LessonPlan& plan, const QString& file) {
  auto organs = std::make_shared<live::PosedCopy>(window_.workspace.live().copy());
  window_.workspace.jobs().submit<double>(
      tr("Exporting the lesson").toStdString(), Workspace::slotOf(file),
      [plan, organs, from = source(), path = file.toStdString()](Progress& progress) {
        if (QFileInfo(QString::fromStdString(path)).suffix() == QLatin1String("glb"))
          return lesson::writeAnimatedGltf(path, plan, from, *organs, progress).largestErrorMm;
        const lesson::Lesson made = lesson::makeLesson(plan, from, *organs, progress);
        lesson::writePage(path, made);
        return made.largestErrorMm;
      },
      [this, file](JobResult<double> result) {
        if (result.error)
          window_.workspace.report(*result.error);
        if (!result.value)
          return;
        window_.settings.setValue(kFolderKey, QFileInfo(file).absolutePath());
        window_.workspace.say({Message::Severity::info,
                               tr("Written to %1 (%2 MB). The motion in the file differs by at most %3 mm.")
                                   .arg(file)
                                   .arg(formatNumber(static_cast<double>(QFileInfo(file).size()) / 1e6, 1))
                                   .arg(formatNumber(*result.value, 2)),
                               {},
                               8});
      });
}

} // namespace viscera::app

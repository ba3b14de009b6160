// The session in the window: its actions, its name in the title, and what happens to unsaved work.
#include <QAction>
#include <QCloseEvent>
#include <QMenu>

#include <algorithm>
#include <memory>

#include "window/import/import_desk.h"
#include "window/main_window.h"
#include "window/play_parts.h"
#include "window/session/session_files.h"
#include "window/session/view_state.h"
#include "window/stress/stress_mode.h"

namespace viscera::app {
namespace {
/// The steps on each side of the present one that the list of steps shows.
constexpr std::size_t kShownSteps = 20;
} // namespace

void MainWindow::makeSession() {
  viewState_ = std::make_unique<ViewState>(ViewState::Window{workspace_, playback_, actions_, *viewArea_,
                                                             stress_->model(), [this] { return mode_; },
                                                             [this](Mode mode) { setMode(mode); }});
  sessions_ = new SessionFiles(workspace_, playback_, *viewState_, settings_, this);
  files_->setSessionOpener([this](const QString& file) { sessions_->open(file); });
  connect(sessions_, &SessionFiles::changed, this, &MainWindow::syncTitle);
  connect(sessions_, &SessionFiles::recentFilesChanged, this, &MainWindow::fillRecentMenu);
  connect(sessions_, &SessionFiles::opened, this, [this] {
    showWelcome(false);
    play_->comparison().end();
  });
  connect(samples_, &SampleLoader::loaded, sessions_, &SessionFiles::sampleLoaded);
  syncTitle();
}

void MainWindow::makeSessionActions() {
  actions_.add("file.new", {tr("&New session"), nullptr, {QKeySequence::New}, tr("Begin with nothing")},
               [this] { sessions_->begin(); });
  actions_.add("file.save", {tr("&Save"), "save", {QKeySequence::Save}, tr("Save the session")},
               [this] { sessions_->save(); });
  actions_.add("file.saveAs",
               {tr("Save &as..."), nullptr, {tr("Ctrl+Shift+S")}, tr("Save the session in another file")},
               [this] { sessions_->chooseAndSave(); });
  actions_.add("file.recover",
               {tr("&Bring back unsaved work"),
                nullptr,
                {},
                tr("Open what Viscera kept when it ended without saving")},
               [this] { sessions_->recover(); });
}

void MainWindow::syncTitle() {
  const bool modified = sessions_->modified();
  const bool nameless = sessions_->file().isEmpty() && !modified;
  setWindowTitle((nameless ? tr("Viscera") : sessions_->name()) + QStringLiteral("[*]"));
  setWindowModified(modified);
  setWindowFilePath(sessions_->file());
  actions_["file.recover"]->setEnabled(sessions_->recoverable());
}

/// The steps around the present one, the youngest first; those that were undone are grey.
void MainWindow::fillHistoryMenu() {
  historyMenu_->clear();
  const document::UndoStack& undo = workspace_.undo();
  const std::vector<std::string> names = undo.names();
  const std::size_t present = undo.position();
  const std::size_t first = present > kShownSteps ? present - kShownSteps : 0;
  const std::size_t last = std::min(names.size(), present + kShownSteps);
  const auto add = [&](const QString& label, std::size_t steps) {
    QAction* action = historyMenu_->addAction(
        label, this, [this, steps] { workspace_.guarded([this, steps] { workspace_.undo().goTo(steps); }); });
    action->setCheckable(true);
    action->setChecked(steps == present);
    QFont font = action->font();
    font.setItalic(steps > present);
    action->setFont(font);
  };
  for (std::size_t step = last; step > first; --step)
    add(text(names[step - 1]), step);
  if (first > 0)
    historyMenu_->addAction(tr("%n earlier {step|steps}", nullptr, static_cast<int>(first)))
        ->setEnabled(false);
  else
    add(tr("As opened"), 0);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  // Saving goes on behind this, and closes the window when it is done.
  const auto atOnce = std::make_shared<bool>(true);
  const bool leaves = sessions_->whenSaved([this, atOnce] {
    if (!*atOnce)
      close();
  });
  *atOnce = false;
  if (!leaves)
    return event->ignore();
  imports_->cancel();
  settings_.setValue("window/geometry", saveGeometry());
  settings_.setValue("window/layout", saveState());
  workspace_.jobs().cancelAll();
  sessions_->endCleanly();
  QMainWindow::closeEvent(event);
}

} // namespace viscera::app

// What stands in which menu, and the tour.
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>

#include "window/main_window.h"
#include "window/play_parts.h"
#include "window/stress/stress_mode.h"
#include "window/style/icon.h"
#include "window/view/view_area.h"
#include "window/widgets/panel_dock.h"
#include "window/widgets/tour_card.h"

namespace viscera::app {

void MainWindow::makeMenus() {
  const auto fill = [this](QMenu* menu, std::initializer_list<const char*> ids) {
    for (const char* id : ids) {
      if (*id)
        menu->addAction(actions_[id]);
      else
        menu->addSeparator();
    }
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  fill(file, {"file.new", "file.open", "file.openFolder", "file.check"});
  recentMenu_ = file->addMenu(tr("Open &recent"));
  sampleMenu_ = file->addMenu(icon("heart"), tr("Sample &organs"));
  fill(file, {"", "file.save", "file.saveAs", "file.recover", "", "handles.save", "file.export"});
  fill(file->addMenu(icon("export"), tr("Export &more")),
       {"export.organs", "export.displacements", "export.transform", "export.table", "export.measurements"});
  fill(file, {"file.screenshot", "", "file.quit"});
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  fill(edit, {"edit.undo", "edit.redo"});
  historyMenu_ = edit->addMenu(icon("undo"), tr("&Steps"));
  connect(historyMenu_, &QMenu::aboutToShow, this, &MainWindow::fillHistoryMenu);
  fill(edit, {"", "edit.selectAll", "handles.remove", "", "pose.reset", "pose.resetSelected"});
  QMenu* view = menuBar()->addMenu(tr("&View"));
  fill(view, {"mode.explore",      "mode.handles",
              "mode.deform",       "mode.stress",
              "mode.play",         "",
              "view.anterior",     "view.posterior",
              "view.left",         "view.right",
              "view.superior",     "view.inferior",
              "view.focus",        "",
              "view.handles",      "view.ghost",
              "view.cube",         "view.scale",
              "view.measurements", ""});
  stress_->fillMenu(view->addMenu(icon("stress"), tr("St&ress map")));
  QMenu* panels = view->addMenu(tr("&Panels"));
  for (PanelDock* dock : docks_)
    panels->addAction(dock->toggleViewAction());
  fill(panels, {"", "view.layout"});
  QMenu* theme = view->addMenu(icon("theme"), tr("&Theme"));
  fill(theme, {"theme.dark", "theme.light"});
  QMenu* organ = menuBar()->addMenu(tr("&Organ"));
  organ->addMenu(sampleMenu_);
  fill(organ, {"", "volume.lock", "volume.restore", "", "measure.distance", "measure.angle",
               "measure.removeAll", "", "organ.rename", "organ.remove", "", "file.export"});
  QMenu* handles = menuBar()->addMenu(tr("&Handles"));
  fill(handles,
       {"handles.place", "handles.addEnclosing", "handles.remove", "", "cage.load", "cage.hull", "",
        "handles.influence", "handles.regions", "handles.zones", "handles.superRegions", "", "handles.save"});
  fill(handles, {"", "handles.gizmo", "handles.compensate"});
  QMenu* mirror = handles->addMenu(icon("mirror"), tr("&Mirror drags"));
  fill(mirror, {"mirror.off", "mirror.sagittal", "mirror.coronal", "mirror.axial", "", "mirror.next"});
  QMenu* sequence = menuBar()->addMenu(tr("&Sequence"));
  fill(sequence, {"play.toggle", "play.start", "play.back", "play.forward", "", "play.loop"});
  for (const char* id : PlayParts::menu())
    fill(sequence, {id});
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  fill(help, {"help.welcome", "help.tour", "help.shortcuts", "", "help.about"});
  for (QMenu* menu : menuBar()->findChildren<QMenu*>())
    menu->setToolTipsVisible(true);
  fillRecentMenu();
  fillSampleMenu();
}

void MainWindow::fillRecentMenu() {
  recentMenu_->clear();
  for (const QString& recent : settings_.recentFiles()) {
    QAction* action = recentMenu_->addAction(QFileInfo(recent).fileName(), this,
                                             [this, recent] { files_->open({recent}); });
    action->setToolTip(recent);
  }
  if (recentMenu_->isEmpty())
    recentMenu_->addAction(tr("Nothing was opened yet"))->setEnabled(false);
}

void MainWindow::fillSampleMenu() {
  sampleMenu_->clear();
  QStringList names;
  workspace_.guarded([&] { names = samples_->names(); });
  for (const QString& name : names) {
    QString label = name;
    label.replace(QLatin1Char('_'), QLatin1Char(' '));
    label[0] = label[0].toUpper();
    sampleMenu_->addAction(label, this, [this, name] { samples_->load(name, true); });
  }
  if (sampleMenu_->isEmpty())
    sampleMenu_->addAction(tr("No sample organs are installed"))->setEnabled(false);
}

void MainWindow::startTour() {
  if (!tour_) {
    std::vector<TourStep> steps = {
        {tr("Look around"),
         tr("Drag with the left button to rotate, with Shift to pan; the wheel zooms. Click an organ to "
            "select it, press F "
            "to bring it into the picture. The eye in the list on the left hides it, the square changes its "
            "colour."),
         [this] { setMode(Mode::explore); }},
        {tr("See it move"),
         tr("Space plays and pauses. The timeline shows the phases of the cycle: drag along it to look at "
            "one instant. "
            "Below, the volumes are drawn as they change."),
         [this] {
           setMode(Mode::play);
           playback_.play();
         }},
        {tr("Handles"),
         tr("Organs follow handles around them. Here you edit them at rest: click the organ to add one, drag "
            "to move it, "
            "Delete to remove it. Everything is bound anew at once. I shows how far a handle reaches."),
         [this] { setMode(Mode::handles); }},
        {tr("Deform"),
         tr("Drag a handle and the organ follows; its volume is in the status bar. The padlock in the list "
            "on "
            "the left (K) keeps the volume whatever you do. T turns and scales selected handles, M mirrors "
            "drags. "
            "Ctrl+Z takes any change back, G shows the rest shape as an outline."),
         [this] { setMode(Mode::deform); }},
        {tr("Your own organs"),
         tr("Open surfaces (STL, OBJ, PLY, OFF, VTK, VTP, GLB) with Ctrl+O or drop them here; they get "
            "handles at once. "
            "Ctrl+S saves all of it as a session. ? lists all keys."),
         [this] { setMode(Mode::explore); }}};
    tour_ = new TourCard(std::move(steps), viewArea_);
    viewArea_->addCard(tour_, Qt::AlignBottom | Qt::AlignHCenter);
  }
  showWelcome(false);
  tour_->start();
}

} // namespace viscera::app

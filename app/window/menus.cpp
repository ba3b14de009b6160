#include "window/menus.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>

#include "window/style/icon.h"
#include "window/widgets/panel_dock.h"

namespace viscera::app {

Menus::Menus(QMenuBar& bar, const Parts& parts) : QObject(&bar), bar_(bar), parts_(parts) {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeOrganMenus();
  makeLastMenus();
  for (QMenu* menu : bar.findChildren<QMenu*>())
    menu->setToolTipsVisible(true);
  fillRecent();
  fillSamples();
}

void Menus::fill(QMenu* menu, const std::vector<const char*>& ids) const {
  for (const char* id : ids) {
    if (*id)
      menu->addAction(parts_.actions[id]);
    else
      menu->addSeparator();
  }
}

void Menus::makeFileMenu() {
  QMenu* file = bar_.addMenu(tr("&File"));
  fill(file, {"file.new", "file.open", "file.openFolder", "file.check"});
  recent_ = file->addMenu(tr("Open &recent"));
  samples_ = file->addMenu(icon("heart"), tr("Sample &organs"));
  fill(file,
       {"", "file.save", "file.saveAs", "file.recover", "", "handles.save", "file.export", "export.lesson"});
  fill(file->addMenu(icon("export"), tr("Export &more")),
       {"export.organs", "export.displacements", "export.transform", "export.table", "export.measurements"});
  fill(file, {"file.screenshot", "", "file.quit"});
}

void Menus::makeEditMenu() {
  QMenu* edit = bar_.addMenu(tr("&Edit"));
  fill(edit, {"edit.undo", "edit.redo"});
  parts_.edit.listStepsIn(edit->addMenu(icon("undo"), tr("&Steps")));
  fill(edit, {"", "edit.selectAll", "handles.remove", "", "pose.reset", "pose.resetSelected"});
}

void Menus::makeViewMenu() {
  QMenu* view = bar_.addMenu(tr("&View"));
  for (const auto& mode : parts_.modes.all())
    fill(view, {(QByteArray("mode.") + mode->description().id).constData()});
  fill(view,
       {"", "view.anterior", "view.posterior", "view.left", "view.right", "view.superior", "view.inferior",
        "view.focus", "", "view.handles", "view.ghost", "view.cube", "view.scale", "view.measurements", ""});
  fill(view->addMenu(icon("stress"), tr("St&ress map")), parts_.modes.find("stress").actions());
  QMenu* panels = view->addMenu(tr("&Panels"));
  for (PanelDock* dock : parts_.docks)
    panels->addAction(dock->toggleViewAction());
  fill(panels, {"", "view.layout"});
  fill(view->addMenu(icon("theme"), tr("&Theme")), {"theme.dark", "theme.light"});
}

void Menus::makeOrganMenus() {
  QMenu* organ = bar_.addMenu(tr("&Organ"));
  organ->addMenu(samples_);
  fill(organ, {"", "volume.lock", "volume.restore", ""});
  fill(organ, parts_.modes.find("explore").actions());
  fill(organ, {"", "organ.rename", "organ.remove", "", "file.export"});
  QMenu* handles = bar_.addMenu(tr("&Handles"));
  fill(handles, parts_.modes.find("handles").actions());
  fill(handles, {""});
  fill(handles, parts_.modes.find("deform").actions());
  fill(handles->addMenu(icon("mirror"), tr("&Mirror drags")),
       {"mirror.off", "mirror.sagittal", "mirror.coronal", "mirror.axial", "", "mirror.next"});
}

void Menus::makeLastMenus() {
  QMenu* sequence = bar_.addMenu(tr("&Sequence"));
  fill(sequence, {"play.toggle", "play.start", "play.back", "play.forward", "", "play.loop"});
  fill(sequence, parts_.modes.find("play").actions());
  fill(bar_.addMenu(tr("&Help")), {"help.welcome", "help.tour", "help.shortcuts", "", "help.about"});
}

void Menus::fillRecent() {
  recent_->clear();
  for (const QString& recent : parts_.settings.recentFiles()) {
    QAction* action = recent_->addAction(QFileInfo(recent).fileName(), this,
                                         [this, recent] { parts_.files.open({recent}); });
    action->setToolTip(recent);
  }
  if (recent_->isEmpty())
    recent_->addAction(tr("Nothing was opened yet"))->setEnabled(false);
}

void Menus::fillSamples() {
  QStringList names;
  parts_.workspace.guarded([&] { names = parts_.samples.names(); });
  for (const QString& name : names) {
    QString label = name;
    label.replace(QLatin1Char('_'), QLatin1Char(' '));
    label[0] = label[0].toUpper();
    samples_->addAction(label, this, [this, name] { parts_.samples.load(name, true); });
  }
  if (samples_->isEmpty())
    samples_->addAction(tr("No sample organs are installed"))->setEnabled(false);
}

} // namespace viscera::app

// The window's actions; what stands in which menu is in main_window_menus.cpp.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDateTime>
#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

#include "viscera/document/cage_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/pose_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/scene/picture.h"
#include "window/export_actions.h"
#include "window/import/import_desk.h"
#include "window/main_window.h"
#include "window/panels/organ_panel.h"
#include "window/play_parts.h"
#include "window/style/icon.h"
#include "window/view/handle_scene.h"
#include "window/view/organ_scene.h"
#include "window/view/region_scene.h"
#include "window/view/view_area.h"
#include "window/widgets/shortcut_card.h"

namespace viscera::app {

void MainWindow::makeFileActions() {
  actions_.add(
      "file.open",
      {tr("&Open..."), "open", {QKeySequence::Open}, tr("Open a session, organs, label maps or handles")},
      [this] { files_->chooseAndOpen(); });
  actions_.add("file.openFolder",
               {tr("Open a &folder of masks..."),
                "organs",
                {},
                tr("Open one patient: a folder with one mask for each organ, as TotalSegmentator writes it")},
               [this] { files_->chooseAndOpenFolder(); });
  actions_.add("file.check",
               {tr("&Import with check..."),
                "patient",
                {tr("Ctrl+Shift+O")},
                tr("Look at what files hold, and repair it, before it comes in")},
               [this] { files_->chooseAndOpen(true); });
  actions_.add("handles.save",
               {tr("Save &handles..."), "save", {}, tr("Save the handles at rest as Slicer markups")},
               [this] { files_->chooseAndSaveHandles(); });
  actions_.add("file.export",
               {tr("&Export organ..."), "export", {tr("Ctrl+E")}, tr("Export the organ as it is posed now")},
               [this] { files_->chooseAndExportOrgan(); });
  exports_->addTo(actions_);
  actions_.add("file.screenshot",
               {tr("Save s&creenshot"), "camera", {Qt::Key_F12}, tr("Save a picture of the 3D view")},
               [this] { saveScreenshot(); });
  actions_.add("file.quit", {tr("&Quit"), nullptr, {QKeySequence::Quit}, {}}, [this] { close(); });
}

void MainWindow::makeEditActions() {
  actions_.add("edit.undo", {tr("&Undo"), "undo", {tr("Ctrl+Z")}, {}},
               [this] { workspace_.guarded([this] { workspace_.undo().undo(); }); });
  actions_.add("edit.redo", {tr("&Redo"), "redo", {tr("Ctrl+Shift+Z")}, {}},
               [this] { workspace_.guarded([this] { workspace_.undo().redo(); }); });
  actions_.add("pose.reset",
               {tr("Reset &pose"), "reset", {tr("Ctrl+R")}, tr("Put every handle back to rest")},
               [this] { workspace_.perform(document::resetPose()); });
  actions_.add("pose.resetSelected",
               {tr("Reset selected handles"),
                "reset",
                {tr("Ctrl+Shift+R")},
                tr("Put the selected handles back to rest")},
               [this] { poses_.reset(workspace_.selection().handles()); });
  actions_.add("edit.selectAll", {tr("Select &all handles"), nullptr, {QKeySequence::SelectAll}, {}}, [this] {
    std::vector<document::HandleId> all;
    for (const document::Handle& handle : workspace_.document().rig().handles)
      all.push_back(handle.id);
    workspace_.selection().setHandles(all);
  });
  actions_.add("organ.rename", {tr("Re&name organ"), "rename", {}, {}}, [this] { organPanel_->editName(); });
  actions_.add("organ.remove", {tr("&Remove organ"), "remove", {}, {}}, [this] {
    if (const auto organ = workspace_.currentOrgan())
      workspace_.perform(document::removeOrgans({organ->id}));
  });
}

void MainWindow::makeModeActions() {
  for (const ModeDescription& description : modeDescriptions()) {
    const QByteArray id = QByteArray("mode.") + description.id;
    actions_.add(
        id.constData(),
        {description.name, description.icon, {QKeySequence(Qt::Key_0 + description.key)}, description.hint},
        [this, mode = description.mode] { setMode(mode); });
  }
}

void MainWindow::makeViewActions() {
  struct View {
    const char* id;
    QString name;
    QKeySequence key;
    scene::StandardView view;
  };
  // The digits of the keypad; those of the main row choose the mode.
  const auto keypad = [](int key, bool shift) {
    return QKeySequence(static_cast<int>(Qt::KeypadModifier) + (shift ? static_cast<int>(Qt::SHIFT) : 0) +
                        key);
  };
  using scene::StandardView;
  const View views[] = {
      {"view.anterior", tr("&Anterior"), keypad(Qt::Key_1, false), StandardView::anterior},
      {"view.posterior", tr("&Posterior"), keypad(Qt::Key_1, true), StandardView::posterior},
      {"view.left", tr("&Left"), keypad(Qt::Key_3, false), StandardView::left},
      {"view.right", tr("&Right"), keypad(Qt::Key_3, true), StandardView::right},
      {"view.superior", tr("&Superior"), keypad(Qt::Key_7, false), StandardView::superior},
      {"view.inferior", tr("&Inferior"), keypad(Qt::Key_7, true), StandardView::inferior}};
  for (const View& view : views)
    actions_.add(view.id, {view.name, "view", {view.key}, {}}, [this, from = view.view] {
      viewArea_->view()->view().lookFrom(from);
      viewArea_->view()->scheduleRender();
    });
  actions_.add("view.focus",
               {tr("&Focus"), "focus", {Qt::Key_F}, tr("Bring the selected organ, or all, into the picture")},
               [this] { focusSelection(); });
  actions_.addToggle("view.handles", {tr("Show &handles in every mode"), "handles", {Qt::Key_H}, {}}, false,
                     [this](bool on) { handleScene_->setAlwaysShown(on); });
  actions_.addToggle("view.ghost", {tr("&Ghost of the rest shape"), "ghost", {Qt::Key_G}, {}}, false,
                     [this](bool on) { organScene_->setGhostShown(on); });
  actions_.addToggle("view.cube", {tr("Orientation &cube"), "view", {}, {}}, true, [this](bool on) {
    viewArea_->view()->view().setOrientationCubeShown(on);
    viewArea_->view()->scheduleRender();
  });
  actions_.addToggle("view.scale", {tr("Scale &bar"), nullptr, {}, {}}, true, [this](bool on) {
    viewArea_->view()->view().setScaleBarShown(on);
    viewArea_->view()->scheduleRender();
  });
  auto* themes = new QActionGroup(this);
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const bool dark = kind == ThemeKind::dark;
    themes->addAction(actions_.addToggle(dark ? "theme.dark" : "theme.light",
                                         {dark ? tr("&Dark") : tr("&Light"), "theme", {}, {}}, false,
                                         [this, kind](bool on) {
                                           if (on && theme_ != kind)
                                             setTheme(kind);
                                         }));
  }
  actions_.add("view.layout",
               {tr("&Standard layout"), "reset", {}, tr("Put every panel back where it was at first")},
               [this] {
                 restoreState(standardLayout_);
                 if (imports_->isOpen())
                   showImports();
               });
}

void MainWindow::makeHandleActions() {
  actions_.add(
      "handles.place",
      {tr("&Place automatically"), "place", {tr("Ctrl+P")}, tr("Spread handles evenly around the organ")},
      [this] { placer_.place(); });
  actions_.add(
      "handles.addEnclosing",
      {tr("Add &enclosing handles"), "enclosing", {}, tr("Add the eight corners of a box around everything")},
      [this] { workspace_.perform(document::addEnclosingHandles()); });
  actions_.add("handles.remove",
               {tr("&Remove handles"), "remove", {QKeySequence::Delete}, tr("Remove the selected handles")},
               [this] { workspace_.perform(document::removeHandles(workspace_.selection().handles())); });
  actions_.add(
      "cage.load",
      {tr("Load a &cage..."),
       "open",
       {},
       tr("For coordinates with a cage: take a closed surface around the organ; its vertices are the "
          "handles")},
      [this] { files_->chooseAndLoadCage(); });
  actions_.add("cage.hull",
               {tr("Take the &hull as the cage"),
                "enclosing",
                {},
                tr("Give the loaded cage up: the convex hull of the handles is the cage again")},
               [this] { workspace_.perform(document::dropCage()); });
  actions_.addToggle("handles.influence",
                     {tr("&Influence map"),
                      "influence",
                      {Qt::Key_I},
                      tr("Colour the organ by the influence of the selected handle")},
                     false, [this](bool on) { organScene_->setInfluenceShown(on); });
}

void MainWindow::makeRegionActions() {
  const auto toggle = [this](const char* id, const Actions::Description& description,
                             bool scene::LayoutParts::*part) {
    actions_.addToggle(id, description, regionScene_->shown().*part, [this, part](bool on) {
      scene::LayoutParts shown = regionScene_->shown();
      shown.*part = on;
      regionScene_->setShown(shown);
    });
  };
  toggle("handles.regions",
         {tr("Show &regions"),
          "enclosing",
          {Qt::Key_R},
          tr("Show where each group of handles acts, and the cage of coordinates that need one")},
         &scene::LayoutParts::regions);
  toggle("handles.zones", {tr("Show &zones"), nullptr, {Qt::Key_Z}, tr("Show where regions meet, in red")},
         &scene::LayoutParts::zones);
  toggle("handles.superRegions",
         {tr("Show &super-regions"), nullptr, {}, tr("Show what counts in a zone, in yellow")},
         &scene::LayoutParts::superRegions);
}

void MainWindow::makeSequenceActions() {
  actions_.add("play.toggle", {tr("&Play or pause"), "play", {Qt::Key_Space}, {}},
               [this] { playback_.toggle(); });
  actions_.add("play.start", {tr("To the &start"), "to_start", {Qt::Key_Home}, {}},
               [this] { playback_.toStart(); });
  actions_.add("play.back", {tr("One frame &back"), "step_back", {Qt::Key_Comma}, {}},
               [this] { playback_.step(-1); });
  actions_.add("play.forward", {tr("One frame &forward"), "step_forward", {Qt::Key_Period}, {}},
               [this] { playback_.step(1); });
  actions_.addToggle("play.loop", {tr("&Repeat"), "loop", {Qt::Key_L}, tr("Repeat the cycle")}, true,
                     [this](bool on) { playback_.setLooping(on); });
  play_->makeActions(actions_);
}

void MainWindow::makeHelpActions() {
  actions_.add("help.shortcuts",
               {tr("&Mouse and keys"), "help", {Qt::Key_Question, tr("Shift+?"), Qt::Key_F1}, {}}, [this] {
                 shortcuts_->setVisible(!shortcuts_->isVisible());
                 shortcuts_->raise();
               });
  actions_.add("help.tour", {tr("Two-minute &tour"), "tour", {}, {}}, [this] { startTour(); });
  actions_.add("help.welcome", {tr("&Welcome"), "heart", {}, {}}, [this] { showWelcome(true); });
  actions_.add("help.about", {tr("&About Viscera"), "info", {}, {}}, [this] {
    Message message;
    message.text =
        tr("Viscera %1: organs deformed by handles, without a cage. BSD-3-Clause; a program for research and "
           "teaching, not a medical device.")
            .arg(QStringLiteral(VISCERA_VERSION));
    workspace_.say(message);
  });
}

QString MainWindow::saveScreenshot() {
  const QString folder = settings_.folder("files/pictures", QStandardPaths::PicturesLocation);
  const QString file =
      QStringLiteral("%1/viscera_%2.png")
          .arg(folder, QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd_hhmmss_zzz")));
  const bool done =
      workspace_.guarded([&] { scene::savePicture(viewArea_->view()->renderWindow(), file.toStdString()); });
  if (!done)
    return {};
  Message message;
  message.text = tr("Picture saved as %1").arg(file);
  message.seconds = 8;
  message.offers.push_back(
      {tr("Open folder"), [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); }});
  workspace_.say(message);
  return file;
}

void MainWindow::syncActions() {
  document::UndoStack& undo = workspace_.undo();
  const bool selected = !workspace_.selection().handles().empty();
  const bool organs = !workspace_.document().organs().empty();
  actions_["edit.undo"]->setEnabled(undo.canUndo());
  actions_["edit.redo"]->setEnabled(undo.canRedo());
  actions_["edit.undo"]->setText(undo.canUndo() ? tr("&Undo: %1").arg(text(undo.undoName())) : tr("&Undo"));
  actions_["edit.redo"]->setText(undo.canRedo() ? tr("&Redo: %1").arg(text(undo.redoName())) : tr("&Redo"));
  actions_["handles.remove"]->setEnabled(selected);
  actions_["pose.resetSelected"]->setEnabled(selected);
  actions_["pose.reset"]->setEnabled(!document::atRest(workspace_.state()));
  for (const char* id :
       {"handles.place", "handles.addEnclosing", "organ.rename", "organ.remove", "file.export", "view.focus"})
    actions_[id]->setEnabled(organs);
  const bool handles = !workspace_.document().rig().handles.empty();
  actions_["handles.save"]->setEnabled(handles);
  actions_["edit.selectAll"]->setEnabled(handles);
  const bool needsCage = workspace_.systemTraits().needsCage;
  actions_["cage.load"]->setEnabled(needsCage);
  actions_["cage.hull"]->setEnabled(needsCage && !workspace_.document().rig().cage.empty());
  syncDeformActions();
}

} // namespace viscera::app

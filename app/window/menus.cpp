#include "window/menus.h"

#include <QAction>
#include <QActionGroup>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QSet>

#include <algorithm>

#include "window/handles/coordinate_menu.h"
#include "window/slices/scan_actions.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/panel_dock.h"

namespace viscera::app {

namespace {
/// The steps on each side of the present one that the list of steps shows.
constexpr std::size_t kShownSteps = 20;
constexpr const char* kSeen = "seenInMenu";

/// A text that comes from a file or a user, for a menu: there a single & underlines the letter behind it.
QString withItsAmpersands(QString text) {
  return text.replace(QLatin1Char('&'), QLatin1String("&&"));
}

/// Gives an entry whose mnemonic is already used in the menu (or bar) another letter (none, if it is in
/// several menus): the first of a word, else any, else none. With two entries of one letter a key only marks
/// the first of them.
void giveLetters(const QWidget& menu) {
  QSet<QChar> taken;
  for (QAction* action : menu.actions()) {
    QString label = action->text();
    const int mark = label.indexOf(QLatin1Char('&'));
    if (mark < 0 || mark + 1 >= label.size() || label[mark + 1] == QLatin1Char('&'))
      continue;
    if (!taken.contains(label[mark + 1].toLower())) {
      taken.insert(label[mark + 1].toLower());
      continue;
    }
    label.remove(mark, 1);
    int place = -1;
    const auto widgets = action->associatedWidgets();
    const bool elsewhere = std::count_if(widgets.begin(), widgets.end(), [](const QWidget* widget) {
                             return qobject_cast<const QMenu*>(widget) != nullptr;
                           }) > 1; // There the new letter might be in use.
    for (const bool starts : {true, false})
      for (int i = 0; !elsewhere && place < 0 && i < label.size(); ++i)
        if (label[i].isLetter() && !taken.contains(label[i].toLower()) &&
            (!starts || i == 0 || label[i - 1] == QLatin1Char(' ')))
          place = i;
    if (place >= 0) {
      taken.insert(label[place].toLower());
      label.insert(place, QLatin1Char('&'));
    }
    action->setText(label);
  }
}
/// An icon stands for one command in menus, and a tick for what is on: a second command with the same icon
/// has none there, and neither has what can be on or off, since Qt draws an icon in place of the tick.
void giveIcons(const QList<QAction*>& entries, QSet<QString>& taken) {
  for (QAction* action : entries) {
    const QString name = action->property(kIconName).toString();
    const bool free = !name.isEmpty() && !action->isCheckable() && !taken.contains(name);
    const bool seen = action->property(kSeen).toBool(); // In another menu.
    if (!seen)
      action->setIconVisibleInMenu(free);
    action->setProperty(kSeen, true);
    if (free && !seen)
      taken.insert(name);
    if (action->menu())
      giveIcons(action->menu()->actions(), taken);
  }
}
} // namespace

Menus::Menus(QMenuBar& bar, const Parts& parts) : QObject(&bar), bar_(bar), parts_(parts) {
  addEditActions();
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeOrganMenus();
  makeLastMenus();
  giveLetters(bar);
  for (QMenu* menu : bar.findChildren<QMenu*>()) {
    menu->setToolTipsVisible(true);
    giveLetters(*menu);
  }
  QSet<QString> taken;
  giveIcons(bar.actions(), taken);
  fillRecent();
  fillSamples();
}

void Menus::addEditActions() {
  Actions& actions = parts_.actions;
  Workspace& workspace = parts_.workspace;
  document::UndoStack& steps = workspace.undo();
  QAction* undo = actions.add("edit.undo", {tr("&Undo"), "undo", {tr("Ctrl+Z")}, {}},
                              [&workspace, &steps] { workspace.guarded([&steps] { steps.undo(); }); });
  QAction* redo = actions.add("edit.redo", {tr("&Redo"), "redo", {tr("Ctrl+Shift+Z")}, {}},
                              [&workspace, &steps] { workspace.guarded([&steps] { steps.redo(); }); });
  actions.onSync([&steps, undo, redo] {
    undo->setEnabled(steps.canUndo());
    redo->setEnabled(steps.canRedo());
    undo->setText(steps.canUndo() ? tr("&Undo: %1").arg(withItsAmpersands(inWords(steps.undoName())))
                                  : tr("&Undo"));
    redo->setText(steps.canRedo() ? tr("&Redo: %1").arg(withItsAmpersands(inWords(steps.redoName())))
                                  : tr("&Redo"));
  });
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
  fill(file, {"file.new", "file.open", "file.openFolder", "file.openScan", "file.openSeries",
              "file.fromArchive", "file.check"});
  recent_ = file->addMenu(tr("Open &recent"));
  samples_ = file->addMenu(icon("heart"), tr("Sample &organs"));
  fill(file, {"", "file.save", "file.saveAs", "file.recover", "", "handles.save", "file.export",
              "export.lesson", "file.report", "export.dicom"});
  fill(file->addMenu(icon("export"), tr("Export &more")),
       {"export.scan", "export.organs", "export.displacements", "export.transform", "export.table",
        "export.measurements", "", "stress.exportMap", "stress.exportPoints", "stress.exportHistogram",
        "stress.exportCurve", "stress.exportProbes", "stress.exportProfiles"});
  fill(file, {"file.screenshot", "", "file.quit"});
}

void Menus::makeEditMenu() {
  QMenu* edit = bar_.addMenu(tr("&Edit"));
  fill(edit, {"edit.undo", "edit.redo"});
  QMenu* steps = edit->addMenu(icon("undo"), tr("&Steps"));
  connect(steps, &QMenu::aboutToShow, this, [this, steps] { fillSteps(steps); });
  fill(edit, {"", "edit.selectAll", "handles.remove", "", "pose.reset", "pose.resetSelected", "",
              "edit.copyCommands", "", "edit.settings"});
}

void Menus::makeViewMenu() {
  QMenu* view = bar_.addMenu(tr("&View"));
  for (const auto& mode : parts_.modes.all())
    fill(view, {(QByteArray("mode.") + mode->description().id).constData()});
  view->addSeparator();
  fill(view->addMenu(icon("camera"), tr("&Look from")),
       {"view.anterior", "view.posterior", "view.left", "view.right", "view.superior", "view.inferior"});
  fill(view,
       {"view.focus", "", "view.handles", "view.ghost", "view.cut", "view.cube", "view.scale", "view.shading",
        "view.edges", "view.flat", "view.measurements", "view.parts", "view.conduction", ""});
  fill(view->addMenu(icon("stress"), tr("St&ress map")), parts_.modes.find("stress").actions());
  fill(view->addMenu(icon("compare"), tr("&Compare")),
       {"play.compare", "play.compareSystems", "play.comparePose", "play.compareFiles",
        "play.compareTextbook", "play.single"});
  QMenu* slices = view->addMenu(icon("patient"), tr("&Scan"));
  fill(slices, parts_.scans.layouts());
  slices->addSeparator();
  slices->addActions(parts_.scans.sliceMenu().actions());
  fill(slices, {"", "scan.close"});
  fill(view->addMenu(icon("camera"), tr("&Slides")),
       {"slides.add", "slides.remove", "", "slides.next", "slides.previous", "slides.leave"});
  fill(view->addMenu(icon("chart"), tr("S&hown in lectures and movies")),
       {"signs.pressures", "signs.loops", "signs.ecg", "signs.valves", "signs.sounds"});
  fill(view, {"view.lecture", "lecture.dark", "view.fullScreen", ""});
  QMenu* panels = view->addMenu(tr("&Panels"));
  for (PanelDock* dock : parts_.docks)
    panels->addAction(dock->toggleViewAction());
  fill(panels, {"", "view.layout"});
  fill(view->addMenu(icon("theme"), tr("&Theme")), {"theme.dark", "theme.light"});
  makeLanguageMenu(*view->addMenu(tr("Lan&guage")));
}

void Menus::makeLanguageMenu(QMenu& menu) {
  constexpr const char* kKey = "window/language";
  auto* choices = new QActionGroup(&menu);
  connect(&menu, &QMenu::aboutToShow, this, [this, choices] { // The dialog of settings may have changed it.
    for (QAction* action : choices->actions())
      action->setChecked(action->data() == parts_.settings.value(kKey).toString());
  });
  const auto add = [&](const QString& name, const QString& code) {
    QAction* action = menu.addAction(name, this, [this, name, code] {
      parts_.settings.setValue(kKey, code);
      parts_.workspace.note(tr("The next start uses this language: %1.").arg(name));
    });
    action->setCheckable(true);
    action->setData(code);
    action->setChecked(parts_.settings.value(kKey).toString() == code);
    choices->addAction(action);
  };
  add(tr("As the &system"), {});
  menu.addSeparator();
  for (const Language& language : languages())
    add(language.name, language.code);
}

void Menus::makeOrganMenus() {
  QMenu* organ = bar_.addMenu(tr("&Organ"));
  organ->addMenu(samples_);
  fill(organ, {"", "volume.lock", "volume.restore", "", "organ.bends", "organ.rigid", "organ.fixed", "",
               "measure.gap"});
  fill(organ, parts_.modes.find("explore").actions());
  fill(organ, {"", "organ.showOnly", "organ.hide", "organ.showAll", "organ.find", "", "organ.rename"});
  organ->addMenu(new CoordinateMenu(parts_.workspace, parts_.actions, organ));
  fill(organ, {"organ.remove", "", "file.export"});
  QMenu* handles = bar_.addMenu(tr("Ha&ndles"));
  fill(handles, parts_.modes.find("handles").actions());
  fill(handles, {""});
  fill(handles, parts_.modes.find("deform").actions());
  fill(handles, {"", "handles.table"});
  fill(handles->addMenu(icon("mirror"), tr("&Mirror drags")),
       {"mirror.off", "mirror.sagittal", "mirror.coronal", "mirror.axial", "", "mirror.next"});
}

void Menus::makeLastMenus() {
  QMenu* sequence = bar_.addMenu(tr("&Sequence"));
  fill(sequence, {"play.toggle", "play.start", "play.back", "play.forward", "", "play.loop"});
  fill(sequence, parts_.modes.find("play").actions());
  fill(bar_.addMenu(tr("&Help")),
       {"help.guide", "", "help.welcome", "help.task", "help.tour", "help.shortcuts", "", "help.about"});
}

void Menus::fillRecent() {
  recent_->clear();
  for (const QString& recent : parts_.settings.recentFiles()) {
    QAction* action = recent_->addAction(withItsAmpersands(QFileInfo(recent).fileName()), this,
                                         [this, recent] { parts_.files.open({recent}); });
    action->setToolTip(recent);
  }
  if (recent_->isEmpty())
    recent_->addAction(tr("Nothing was opened yet"))->setEnabled(false);
}

void Menus::fillSteps(QMenu* menu) {
  menu->clear();
  const document::UndoStack& undo = parts_.workspace.undo();
  const std::vector<Text> names = undo.names();
  const std::size_t present = undo.position();
  const std::size_t first = present > kShownSteps ? present - kShownSteps : 0;
  const std::size_t last = std::min(names.size(), present + kShownSteps);
  const auto add = [&](const QString& label, std::size_t steps) {
    QAction* action = menu->addAction(label, this, [this, steps] {
      parts_.workspace.guarded([this, steps] { parts_.workspace.undo().goTo(steps); });
    });
    action->setCheckable(true);
    action->setChecked(steps == present);
    QFont font = action->font();
    font.setItalic(steps > present);
    action->setFont(font);
  };
  for (std::size_t step = last; step > first; --step)
    add(withItsAmpersands(inWords(names[step - 1])), step);
  if (first > 0)
    menu->addAction(tr("%n earlier steps", nullptr, static_cast<int>(first)))->setEnabled(false);
  else
    add(tr("As opened"), 0);
}

void Menus::fillSamples() {
  QStringList names;
  parts_.workspace.guarded([&] { names = parts_.samples.names(); });
  for (const QString& name : names)
    samples_->addAction(SampleLoader::title(name), this, [this, name] { parts_.samples.load(name, true); });
  if (samples_->isEmpty())
    samples_->addAction(tr("No sample organs are installed"))->setEnabled(false);
}

} // namespace viscera::app

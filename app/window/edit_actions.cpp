#include "window/edit_actions.h"

#include <QAction>
#include <QMenu>

#include <algorithm>

namespace viscera::app {
namespace {
/// The steps on each side of the present one that the list of steps shows.
constexpr std::size_t kShownSteps = 20;
} // namespace

EditActions::EditActions(Workspace& workspace, Actions& actions, QObject* parent)
    : QObject(parent), workspace_(workspace) {
  document::UndoStack& steps = workspace.undo();
  QAction* undo = actions.add("edit.undo", {tr("&Undo"), "undo", {tr("Ctrl+Z")}, {}},
                              [&workspace, &steps] { workspace.guarded([&steps] { steps.undo(); }); });
  QAction* redo = actions.add("edit.redo", {tr("&Redo"), "redo", {tr("Ctrl+Shift+Z")}, {}},
                              [&workspace, &steps] { workspace.guarded([&steps] { steps.redo(); }); });
  actions.add("edit.selectAll", {tr("Select &all handles"), nullptr, {QKeySequence::SelectAll}, {}},
              [this] { selectAll(); });
  actions.enableWhile({"edit.selectAll"},
                      [&workspace] { return !workspace.document().rig().handles.empty(); });
  actions.whenSynced([&steps, undo, redo] {
    undo->setEnabled(steps.canUndo());
    redo->setEnabled(steps.canRedo());
    undo->setText(steps.canUndo() ? tr("&Undo: %1").arg(text(steps.undoName())) : tr("&Undo"));
    redo->setText(steps.canRedo() ? tr("&Redo: %1").arg(text(steps.redoName())) : tr("&Redo"));
  });
}

void EditActions::selectAll() {
  std::vector<document::HandleId> all;
  for (const document::Handle& handle : workspace_.document().rig().handles)
    all.push_back(handle.id);
  workspace_.selection().setHandles(all);
}

void EditActions::listStepsIn(QMenu* menu) {
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillSteps(menu); });
}

void EditActions::fillSteps(QMenu* menu) {
  menu->clear();
  const document::UndoStack& undo = workspace_.undo();
  const std::vector<std::string> names = undo.names();
  const std::size_t present = undo.position();
  const std::size_t first = present > kShownSteps ? present - kShownSteps : 0;
  const std::size_t last = std::min(names.size(), present + kShownSteps);
  const auto add = [&](const QString& label, std::size_t steps) {
    QAction* action = menu->addAction(
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
    menu->addAction(tr("%n earlier {step|steps}", nullptr, static_cast<int>(first)))->setEnabled(false);
  else
    add(tr("As opened"), 0);
}

} // namespace viscera::app

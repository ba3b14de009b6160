#include "window/handles/handles_mode.h"

#include <QAbstractItemView>
#include <QApplication>

#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "window/handles/handles_page.h"
#include "window/style/language.h"
#include "window/view/view_area.h"
#include "window/view/view_model.h"
#include "window/work/binding_messages.h"

namespace viscera::app {

HandlesMode::HandlesMode(const ModeParts& parts, Actions& actions)
    : Mode(parts, {"handles", "handles", 2, tr("Handles"),
                   tr("Click the organ to add a handle, drag to move it, Delete removes it; the rest shape "
                      "stays")}) {
  makeRigActions(actions);
  makeViewActions(actions);
}

void HandlesMode::makeRigActions(Actions& actions) {
  actions.add(
      "handles.place",
      {tr("&Place automatically"), "place", {tr("Ctrl+P")}, tr("Spread handles evenly around the organ")},
      [this] { parts_.placer.place(); });
  actions.add(
      "handles.addEnclosing",
      {tr("Add &enclosing handles"), "enclosing", {}, tr("Add the eight corners of a box around everything")},
      [this] { workspace_.perform(document::addEnclosingHandles()); });
  actions.add("handles.remove",
              {tr("&Remove handles"), "remove", {QKeySequence::Delete}, tr("Remove the selected handles")},
              [this] { removeSelected(); });
  actions.add("edit.selectAll", {tr("Select &all handles"), nullptr, {QKeySequence::SelectAll}, {}},
              [this] { selectAll(); });
  actions.add("cage.hull",
              {tr("Use the &hull as the cage"),
               "enclosing",
               {},
               tr("Discard the loaded cage and use the convex hull of the handles again")},
              [this] { workspace_.perform(document::dropCage()); });
  actions.enableWhile({"handles.place", "handles.addEnclosing"},
                      [this] { return !workspace_.document().organs().empty(); });
  // Handles can be removed and selected by keys only while they are visible.
  const auto seen = [this] { return parts_.view.state().shown.handles || parts_.view.state().handles; };
  actions.enableWhile({"handles.remove"},
                      [this, seen] { return seen() && !workspace_.selection().handles().empty(); });
  actions.enableWhile({"edit.selectAll"},
                      [this, seen] { return seen() && !workspace_.document().rig().handles.empty(); });
  actions.enableWhile({"cage.hull"}, [this] {
    return workspace_.systemTraits().needsCage && !workspace_.document().rig().cage.empty();
  });
}

void HandlesMode::removeSelected() {
  const std::vector<document::HandleId> handles = workspace_.selection().handles();
  workspace_.performTelling(document::removeHandles(handles),
                            tr("%n handles removed", nullptr, static_cast<int>(handles.size())));
}

/// The key is meant for the list that has the focus, else for the handles.
void HandlesMode::selectAll() {
  if (auto* list = qobject_cast<QAbstractItemView*>(QApplication::focusWidget()))
    return list->selectAll();
  std::vector<document::HandleId> all;
  for (const document::Handle& handle : workspace_.document().rig().handles)
    all.push_back(handle.id);
  workspace_.selection().setHandles(all);
}

void HandlesMode::makeViewActions(Actions& actions) {
  using presentation::ViewState;
  parts_.view.addToggle(actions, "handles.influence",
                        {tr("&Influence map"),
                         "influence",
                         {Qt::Key_I},
                         tr("Colour the organ by the influence of the selected handle")},
                        &ViewState::influence);
  parts_.view.addToggle(
      actions, "handles.regions",
      {tr("Show &regions"),
       "enclosing",
       {Qt::Key_R},
       tr("Show where each group of handles acts, and the cage of coordinates that need one")},
      [](ViewState& view) -> bool& { return view.layout.regions; });
  parts_.view.addToggle(actions, "handles.zones",
                        {tr("Show &zones"), nullptr, {Qt::Key_Z}, tr("Show where regions meet, in red")},
                        [](ViewState& view) -> bool& { return view.layout.zones; });
  parts_.view.addToggle(actions, "handles.superRegions",
                        {tr("Show &super-regions"),
                         nullptr,
                         {},
                         tr("Show the super-region that counts in each zone, in yellow")},
                        [](ViewState& view) -> bool& { return view.layout.superRegions; });
}

std::vector<const char*> HandlesMode::actions() const {
  return {"handles.place",
          "handles.addEnclosing",
          "handles.remove",
          "",
          "cage.load",
          "cage.hull",
          "",
          "handles.influence",
          "handles.regions",
          "handles.zones",
          "handles.superRegions",
          "",
          "handles.save"};
}

QWidget* HandlesMode::makePage(const Actions& actions) {
  return new HandlesPage(workspace_, actions);
}

void HandlesMode::enter() {
  bound_ = connect(&parts_.binding, &BindingMessages::bound, this, [this](double seconds) {
    parts_.area.showBadge(tr("Bound in %1 ms").arg(formatNumber(1000 * seconds, 1)));
  });
}

void HandlesMode::click(const ClickedPlace* place) {
  if (!place)
    return Mode::click(place);
  const auto organ = workspace_.document().organ(place->organ);
  if (!organ)
    return;
  const double offset = deformation::Placement().offsetFraction * boundsOf(organ->mesh->points).diagonal();
  document::NewHandle handle;
  handle.rest = place->position + offset * place->normal;
  if (workspace_.perform(document::addHandles({handle}, workspace_.selection().group())))
    workspace_.selection().setHandles({workspace_.document().rig().handles.back().id});
}

} // namespace viscera::app

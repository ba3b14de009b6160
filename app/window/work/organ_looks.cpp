#include "window/work/organ_looks.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

#include "viscera/anatomy/part.h"
#include "viscera/document/organ_commands.h"

namespace viscera::app {

void changeLooks(Workspace& workspace, const QString& name, const std::vector<document::OrganId>& organs,
                 const std::function<void(document::OrganLook&)>& change) {
  std::vector<document::Command> commands;
  std::string key = name.toStdString();
  for (const document::OrganId id : organs)
    if (const auto organ = workspace.document().organ(id)) {
      document::OrganLook look = organ->look;
      change(look);
      commands.push_back(document::setOrganLook(id, look));
      key += "/" + std::to_string(id.value);
    }
  if (commands.empty())
    return;
  document::Command all = document::combined(name.toStdString(), std::move(commands));
  all.mergeKey = key;
  workspace.perform(all);
}

namespace {

/// The colour of textbooks that an organ has not; none where its name tells none.
std::optional<Vec3> otherTextbookColor(const document::Organ& organ) {
  const std::optional<Vec3> usual = anatomy::colorNamed(organ.name);
  const bool has = usual && *usual == organ.look.color && !organ.look.vertexColors;
  return has ? std::nullopt : usual;
}

} // namespace

std::vector<document::OrganId> withoutTextbookColors(const Workspace& workspace,
                                                     const std::vector<document::OrganId>& organs) {
  std::vector<document::OrganId> others;
  for (const document::OrganId id : organs)
    if (const auto organ = workspace.document().organ(id); organ && otherTextbookColor(*organ))
      others.push_back(id);
  return others;
}

void giveTextbookColors(Workspace& workspace, const QString& name,
                        const std::vector<document::OrganId>& organs) {
  std::vector<document::Command> commands;
  for (const document::OrganId id : withoutTextbookColors(workspace, organs)) {
    const auto organ = workspace.document().organ(id);
    document::OrganLook look = organ->look;
    look.color = *otherTextbookColor(*organ);
    look.vertexColors = false;
    commands.push_back(document::setOrganLook(id, look));
  }
  if (!commands.empty())
    workspace.perform(document::combined(name.toStdString(), std::move(commands)));
}

void showWhere(Workspace& workspace, const QString& name,
               const std::function<bool(const document::Organ&)>& visible) {
  std::vector<document::OrganId> others;
  for (const auto& organ : workspace.document().organs())
    if (visible(*organ) != organ->look.visible)
      others.push_back(organ->id);
  changeLooks(workspace, name, others, [](document::OrganLook& look) { look.visible = !look.visible; });
  workspace.undo().seal();
}

void showOnly(Workspace& workspace, const std::vector<document::OrganId>& organs) {
  const auto isWanted = [&organs](document::OrganId id) {
    return id && std::find(organs.begin(), organs.end(), id) != organs.end();
  };
  showWhere(workspace, QCoreApplication::translate("OrganLooks", "Show only this"),
            [&isWanted](const document::Organ& organ) {
              return isWanted(organ.id) || isWanted(organ.parent); // What is inside of it belongs to it.
            });
}

} // namespace viscera::app

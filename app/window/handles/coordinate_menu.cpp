#include "window/handles/coordinate_menu.h"

#include <QAction>

#include <string>

#include "viscera/document/axes_commands.h"
#include "window/import/organ_check.h"
#include "window/work/actions.h"

namespace viscera::app {

CoordinateMenu::CoordinateMenu(Workspace& workspace, Actions& actions, QWidget* parent)
    : QMenu(tr("Convert the axes"), parent), workspace_(workspace) {
  setObjectName(QStringLiteral("coordinateMenu"));
  setToolTipsVisible(true);
  bool units = false;
  for (const std::string& id : document::coordinateRepairs()) {
    if (!units && id.starts_with("unit-")) {
      addSeparator();
      units = true;
    }
    QAction* entry = addAction(repairName(id));
    entry->setObjectName(QLatin1String("organ.convert.") + QString::fromStdString(id));
    entry->setToolTip(repairTip(id));
    connect(entry, &QAction::triggered, this, [this, id, &actions] { convert(id, actions); });
  }
  actions.onSync([this] { menuAction()->setEnabled(!workspace_.document().organs().empty()); });
}

void CoordinateMenu::convert(const std::string& id, Actions& actions) {
  if (!workspace_.perform(document::convertCoordinates(id)))
    return;
  actions.sync();
  actions["view.focus"]->trigger(); // In another unit the organs would lie outside the picture.
}

} // namespace viscera::app

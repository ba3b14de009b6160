#include "window/organs/organ_menu.h"

#include <algorithm>

#include "viscera/document/measurement_commands.h"
#include "viscera/document/organ_commands.h"
#include "window/style/icon.h"
#include "window/widgets/color_palette.h"
#include "window/work/actions.h"
#include "window/work/organ_looks.h"

namespace viscera::app {

OrganMenu::OrganMenu(Workspace& workspace, PoseEditor& poses, Chosen chosen, QWidget* parent)
    : QMenu(parent), workspace_(workspace), poses_(poses), chosen_(std::move(chosen)) {
  setObjectName(QStringLiteral("organMenu"));
}

void OrganMenu::addTo(Actions& actions) {
  QAction* lock = actions.add("volume.lock",
                              {tr("&Lock volume"),
                               "lock",
                               {Qt::Key_K},
                               tr("Keep the organ's volume constant in Deform mode; for an organ with "
                                  "cavities, the volume within its outer surface")},
                              [this, &actions] {
                                poses_.setLocked(chosen_(), !allLocked());
                                actions.sync(); // Where it was refused, the mark goes again.
                              });
  lock->setCheckable(true);
  actions.enableWhile({"volume.lock"}, [this] { return workspace_.currentOrgan() != nullptr; });
  actions.onSync([this, lock] { lock->setChecked(allLocked()); });
  addMobility(actions);
  actions
      .add("measure.gap",
           {tr("&Shortest distance of two organs"),
            "distance",
            {},
            tr("Choose two organs in the list: the distance follows them, wherever they are nearest")},
           [this] {
             if (const auto organs = chosen_(); organs.size() == 2)
               workspace_.perform(document::addGap(organs[0], organs[1]));
             else
               workspace_.note(tr("Choose two organs in the list first, the second one with Ctrl."));
           })
      ->setIconText(tr("Two organs"));
  actions.enableWhile({"measure.gap"}, [this] { return workspace_.document().organs().size() > 1; });
  fill(actions);
}

/// How the chosen organs follow the handles: one of three.
void OrganMenu::addMobility(Actions& actions) {
  using document::Mobility;
  struct Choice {
    const char* id;
    QString name;
    QString tip;
    Mobility mobility;
  };
  const Choice choices[] = {
      {"organ.bends", tr("&Bends as soft tissue"), tr("Every place of the organ follows the handles"),
       Mobility::bends},
      {"organ.rigid", tr("Moves as a r&igid body"),
       tr("The organ keeps its shape and moves as the tissue around it does on the whole; so do bones"),
       Mobility::rigid},
      {"organ.fixed", tr("Stays in &place"), tr("No handle moves the organ"), Mobility::fixed}};
  for (const Choice& choice : choices) {
    QAction* action = actions.add(choice.id, {choice.name, nullptr, {}, choice.tip},
                                  [this, mobility = choice.mobility, &actions] {
                                    workspace_.perform(document::setMobility(chosen_(), mobility));
                                    actions.sync(); // The mark is that of the document.
                                  });
    action->setCheckable(true);
    actions.enableWhile({choice.id}, [this] { return !chosen_().empty(); });
    actions.onSync([this, action, mobility = choice.mobility] {
      const auto organs = chosen_();
      action->setChecked(!organs.empty() &&
                         std::all_of(organs.begin(), organs.end(), [&](document::OrganId id) {
                           const auto organ = workspace_.document().organ(id);
                           return organ && organ->mobility == mobility;
                         }));
    });
  }
}

void OrganMenu::fill(Actions& actions) {
  for (const char* id : {"organ.showOnly", "organ.hide", "organ.showAll", "view.focus", "organ.rename"})
    addAction(actions[id]);
  addSeparator();
  QAction* color = addAction(app::icon("influence"), tr("Colour..."));
  color->setObjectName(QStringLiteral("organColor"));
  connect(color, &QAction::triggered, this, [this] { chooseColorOf(chosen_(), pos()); });
  QAction* own = addAction(tr("The organ's own colours"));
  own->setObjectName(QStringLiteral("organOwnColors"));
  connect(own, &QAction::triggered, this, [this] {
    changeLooks(workspace_, tr("Change colour"), withHiddenColors(),
                [](document::OrganLook& look) { look.vertexColors = true; });
    workspace_.undo().seal();
  });
  QAction* usual = addAction(tr("Textbook colours"));
  usual->setObjectName(QStringLiteral("organTextbookColors"));
  connect(usual, &QAction::triggered, this,
          [this] { giveTextbookColors(workspace_, tr("Textbook colours"), chosen_()); });
  addAction(actions["volume.lock"]);
  for (const char* id : {"organ.bends", "organ.rigid", "organ.fixed"})
    addAction(actions[id]);
  addAction(actions["measure.gap"]);
  addSeparator();
  addAction(actions["organ.remove"]);
  connect(this, &QMenu::aboutToShow, this, [this, color, own, usual, &actions] {
    actions.sync();
    color->setEnabled(!chosen_().empty());
    usual->setEnabled(!withoutTextbookColors(workspace_, chosen_()).empty());
    own->setVisible(!withHiddenColors().empty());
  });
}

void OrganMenu::chooseColorOf(const std::vector<document::OrganId>& organs, const QPoint& globalPlace) {
  const auto first = organs.empty() ? nullptr : workspace_.document().organ(organs.front());
  if (!first)
    return;
  chooseColor(
      parentWidget(), globalPlace, asColor(first->look.color),
      [this, organs](const QColor& color) {
        changeLooks(workspace_, tr("Change colour"), organs, [&color](document::OrganLook& look) {
          look.color = asVec3(color);
          look.vertexColors = false;
        });
      },
      [this] { workspace_.undo().seal(); });
}

/// The chosen ones whose file gives each vertex a colour, which is not shown.
std::vector<document::OrganId> OrganMenu::withHiddenColors() const {
  std::vector<document::OrganId> organs = chosen_();
  std::erase_if(organs, [this](document::OrganId id) {
    const auto organ = workspace_.document().organ(id);
    return !organ || organ->mesh->colors.rows() == 0 || organ->look.vertexColors;
  });
  return organs;
}

/// Asks the chosen ones that have a volume.
bool OrganMenu::allLocked() const {
  bool any = false;
  for (const document::OrganId id : chosen_()) {
    const auto organ = workspace_.document().organ(id);
    if (!organ || !organ->closed())
      continue;
    any = true;
    if (!organ->volumeLocked)
      return false;
  }
  return any;
}

} // namespace viscera::app

#include "window/help.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "window/guide/guide_window.h"
#include "window/guide/help_cards.h"
#include "window/guide/task_card.h"

namespace viscera::app {

Help::Help(const Parts& parts, Actions& actions, QObject* parent) : QObject(parent), parts_(parts) {
  actions.add("help.guide",
              {tr("User &guide"), "help", {Qt::Key_F1}, tr("The guide, at what the present mode does")},
              [this] { openGuide(); });
  actions.add("help.task", {tr("&First task: drag a dot"), "handles", {}, {}}, [this] { startTask(); });
  actions.enableWhile({"help.task"}, [this] { return !parts_.workspace.document().rig().handles.empty(); });
  actions.add("help.shortcuts", {tr("&Mouse and keys"), nullptr, {Qt::Key_Question, tr("Shift+?")}, {}},
              [this] {
                shortcuts_->setVisible(!shortcuts_->isVisible());
                shortcuts_->raise();
              });
  actions.add("help.tour", {tr("Two-minute &tour"), "tour", {}, {}}, [this] { startTour(); });
  actions.add("help.welcome", {tr("&Welcome"), "heart", {}, {}}, [this] { showWelcome(true); });
  actions.add("help.about", {tr("&About Viscera"), "info", {}, {}}, [this] { tellAbout(); });
}

void Help::makeCards(const QMenuBar& menus, QMenu* samples) {
  welcome_ = new WelcomeCard(samples, &parts_.area);
  parts_.area.addCard(welcome_, Qt::AlignTop | Qt::AlignHCenter);
  connect(welcome_, &WelcomeCard::heightTaken, &parts_.area, &ViewArea::reserveAbove);
  welcome_->hide();
  shortcuts_ = new ShortcutCard(menus, &parts_.area);
  parts_.area.addCard(shortcuts_, Qt::AlignCenter);
  connect(welcome_, &WelcomeCard::openRequested, &parts_.files, [this] { parts_.files.chooseAndOpen(); });
  connect(welcome_, &WelcomeCard::tourRequested, this, &Help::startTour);
  connect(welcome_, &WelcomeCard::taskRequested, this, &Help::startTask);
  // After a change of the mode, the welcome card is not needed any more.
  connect(&parts_.modes, &ModeController::changed, this, [this] { showWelcome(false); });
  connect(welcome_, &WelcomeCard::closed, this,
          [this] { parts_.settings.setValue("window/welcome", false); });
}

void Help::showWelcome(bool shown) {
  welcome_->setVisible(shown);
  if (shown)
    welcome_->raise();
}

bool Help::close() {
  for (QWidget* card :
       {static_cast<QWidget*>(shortcuts_), static_cast<QWidget*>(tour_), static_cast<QWidget*>(task_)})
    if (card && card->isVisible()) {
      card->hide();
      return true;
    }
  return false;
}

void Help::openGuide() {
  // The headings of docs/user_guide.md.
  static const std::map<std::string, const char*> kSections = {{"explore", "user-guide"},
                                                               {"handles", "groups-of-handles"},
                                                               {"deform", "deform-mode"},
                                                               {"stress", "stress-mode"},
                                                               {"play", "play-organs-in-motion"}};
  if (!guide_)
    guide_ = new GuideWindow(parts_.area.window());
  const auto section = kSections.find(parts_.modes.present().description().id);
  guide_->open(QStringLiteral("user_guide.md"),
               section == kSections.end() ? QString() : QLatin1String(section->second));
}

/// The one in front of the handles that can be moved is bright.
void Help::startTask() {
  const auto& handles = parts_.workspace.document().rig().handles;
  Vec3 middle = Vec3::Zero();
  for (const document::Handle& handle : handles)
    middle += handle.rest / static_cast<double>(handles.size());
  // The first view looks at the middle of the front; corners around the organ may lie outside the picture.
  const auto aside = [&middle](const document::Handle& handle) {
    return std::hypot(handle.rest.x() - middle.x(), handle.rest.z() - middle.z());
  };
  const document::Handle* front = nullptr;
  for (const document::Handle& handle : handles)
    if (!handle.locked && handle.visible && handle.rest.y() <= middle.y() &&
        (!front || aside(handle) < aside(*front)))
      front = &handle;
  if (!front)
    return;
  if (!task_) {
    task_ = new TaskCard(parts_.workspace, &parts_.area);
    parts_.area.addCard(task_, Qt::AlignBottom | Qt::AlignHCenter);
  }
  showWelcome(false);
  parts_.modes.choose("deform");
  parts_.workspace.selection().setHandles({front->id});
  task_->start();
}

void Help::tellAbout() {
  parts_.workspace.note(
      tr("Viscera %1: organs deformed by handles, without a cage. BSD-3-Clause; a program for research and "
         "teaching, not a medical device.")
          .arg(QStringLiteral(VISCERA_VERSION)),
      0);
}

void Help::startTour() {
  if (!tour_) {
    std::vector<TourStep> steps = {
        {tr("Look around"),
         tr("Drag with the left button to rotate, with Shift to pan; the wheel zooms. Click an organ to "
            "select it, press F "
            "to bring it into the picture; D measures distances, A angles. The eye in the list on the left "
            "hides it, the square changes its "
            "colour."),
         {"view3d", "organs"},
         [this] { parts_.modes.choose("explore"); }},
        {tr("Play a motion"),
         tr("Space plays and pauses. The timeline shows the phases of the cycle: drag along it to look at "
            "one instant. "
            "Below, the volumes are drawn as they change."),
         {"timeline", "volumes"},
         [this] {
           parts_.modes.choose("play");
           parts_.playback.play();
         }},
        {tr("Handles"),
         tr("Organs follow handles around them. Here you edit them at rest: click the organ to add one, drag "
            "to move it, "
            "Delete to remove it. The organ is bound again at once. I shows how far a handle reaches."),
         {"handles"},
         [this] { parts_.modes.choose("handles"); }},
        {tr("Deform"),
         tr("Drag a handle and the organ follows; its volume is in the status bar. The padlock in the list "
            "on "
            "the left (K) keeps the volume whatever you do. T turns and scales selected handles, M mirrors "
            "drags. "
            "Ctrl+Z undoes any change, G shows the rest shape as an outline."),
         {"organs", "statusVolume"},
         [this] { parts_.modes.choose("deform"); }},
        {tr("Stress"),
         tr("The colours say how much the pose distorts the tissue inside. Click the organ to read the "
            "values "
            "of a "
            "point, C cuts it open, M shows the next map. Space plays the sequence, and the map follows."),
         {"properties"},
         [this] { parts_.modes.choose("stress"); }},
        {tr("Your own organs"),
         tr("Open surfaces (STL, OBJ, PLY, OFF, VTK, VTP, GLB) or label maps (NIfTI, NRRD, DICOM-SEG) with "
            "Ctrl+O or drop them here; they get "
            "handles at once. "
            "Ctrl+S saves all of it as a session. ? lists all keys."),
         {"menus"},
         [this] { parts_.modes.choose("explore"); }}};
    tour_ = new TourCard(std::move(steps), &parts_.area);
    parts_.area.addCard(tour_, Qt::AlignBottom | Qt::AlignHCenter);
  }
  showWelcome(false);
  tour_->start();
}

} // namespace viscera::app

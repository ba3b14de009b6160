#pragma once

#include <QObject>

#include "window/import/file_actions.h"
#include "window/modes/mode_controller.h"
#include "window/view/view_area.h"
#include "window/work/actions.h"

class QMenu;
class QMenuBar;

namespace viscera::app {

class GuideWindow;
class ShortcutCard;
class TaskCard;
class TourCard;
class WelcomeCard;

/// The help of the window: the guide, the welcome card, a first task, the tour and the list of shortcuts.
class Help final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window that the help explains and over which it is shown; all have to live longer.
  struct Parts {
    Workspace& workspace;
    Playback& playback;
    ModeController& modes;
    FileActions& files;
    Settings& settings;
    ViewArea& area;
  };

  /// Adds "help.guide", "help.shortcuts", "help.task", "help.tour", "help.welcome" and "help.about".
  Help(const Parts& parts, Actions& actions, QObject* parent = nullptr);

  /// Makes the cards over the view, once the menus are there; `samples` is the one of sample organs.
  void makeCards(const QMenuBar& menus, QMenu* samples);
  void showWelcome(bool shown);
  /// Closes the list of shortcuts, or else ends the tour; false when neither is open.
  bool close();

private:
  /// The guide, at the section of the present mode.
  void openGuide();
  void startTask();
  void startTour();
  void tellAbout();

  Parts parts_;
  WelcomeCard* welcome_ = nullptr;
  ShortcutCard* shortcuts_ = nullptr;
  TourCard* tour_ = nullptr;
  TaskCard* task_ = nullptr;
  GuideWindow* guide_ = nullptr;
};

} // namespace viscera::app

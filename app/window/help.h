#pragma once

#include <QObject>

#include "window/actions.h"
#include "window/file_actions.h"
#include "window/modes/mode_controller.h"
#include "window/view/view_area.h"

class QMenu;
class QMenuBar;

namespace viscera::app {

class ShortcutCard;
class TourCard;
class WelcomeCard;

/// The help of the window: the welcome card, the tour and the list of shortcuts.
class Help final : public QObject {
  Q_OBJECT

public:
  /// What help speaks of and where it stands; all have to live longer.
  struct Parts {
    Workspace& workspace;
    Playback& playback;
    ModeController& modes;
    FileActions& files;
    Settings& settings;
    ViewArea& area;
  };

  /// Adds "help.shortcuts", "help.tour", "help.welcome" and "help.about".
  Help(const Parts& parts, Actions& actions, QObject* parent = nullptr);

  /// Makes the cards over the view, once the menus are there; `samples` is the one of sample organs.
  void makeCards(const QMenuBar& menus, QMenu* samples);
  void showWelcome(bool shown);
  /// Puts the list of keys away, or else ends the tour; false when neither was there.
  bool close();

private:
  void startTour();
  void tellAbout();

  Parts parts_;
  WelcomeCard* welcome_ = nullptr;
  ShortcutCard* shortcuts_ = nullptr;
  TourCard* tour_ = nullptr;
};

} // namespace viscera::app

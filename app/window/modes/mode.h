#pragma once

#include <QObject>

#include <vector>

#include "viscera/presentation/view_state.h"
#include "window/style/theme.h"
#include "window/timeline/playback.h"
#include "window/workspace.h"

class QWidget;

namespace viscera::app {

class Actions;
class BindingMessages;
class HandleController;
class HandlePlacer;
class Picture;
class PoseEditor;
class SampleLoader;
class Settings;
class ViewArea;
class ViewModel;
class VolumeMonitor;

/// The parts of the window with which modes work; all live longer than the modes.
struct ModeParts {
  Workspace& workspace;
  Playback& playback;
  PoseEditor& poses;
  VolumeMonitor& volumes;
  HandlePlacer& placer;
  SampleLoader& samples;
  BindingMessages& binding;
  Settings& settings;
  ViewArea& area;
  ViewModel& view;
  Picture& picture;
  HandleController& handles;
};

/// The organ that was clicked and the place on its displayed surface, mm.
struct ClickedPlace {
  document::OrganId organ;
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
};

/// The panels that a mode needs beside the organs and the properties, which every mode shows.
struct UsefulPanels {
  bool handles = false;
  bool timeline = false;
  bool charts = false;

  bool operator==(const UsefulPanels&) const = default;
};

/// The base of the window's modes (Explore, Handles, Deform, Stress, Play): what the view shows, what a click
/// on it does, and the mode's actions and property page. It adds its actions when it is made; which mode is
/// on, only the `ModeController` knows.
class Mode : public QObject {
  Q_OBJECT

public:
  /// The mode as the user meets it.
  struct Description {
    const char* id = "";   ///< "explore"; as in sessions and options.
    const char* icon = ""; ///< Of the icon set.
    int key = 0;           ///< The digit that chooses it; stays the same whatever other modes there are.
    QString name;          ///< Under the icon.
    QString hint;          ///< For the status bar: what the mouse does.
  };

  Mode(const ModeParts& parts, Description description)
      : parts_(parts), workspace_(parts.workspace), description_(std::move(description)) {}

  const Description& description() const { return description_; }
  /// The ids of its actions as in a menu, "" for a line between them.
  virtual std::vector<const char*> actions() const { return {}; }
  /// The property page; the actions of all parts are there. The caller owns it.
  virtual QWidget* makePage(const Actions& actions) = 0;
  /// The chart below the timeline, the caller's; null: the volumes.
  virtual QWidget* makeChart() { return nullptr; }
  /// Whether its own chart is to be seen now, else the volumes; `chartWantedChanged` tells that it is
  /// otherwise.
  virtual bool chartWanted() const { return true; }

  /// What it wants to be seen, while it is on; `shownChanged` tells that it is something else.
  virtual presentation::Shown shown() const = 0;
  virtual motion::WantedPose pose() const = 0;
  /// Asked when the mode begins, and when another sequence is there or none; `panelsChanged` tells that it is
  /// otherwise.
  virtual UsefulPanels panels() const = 0;
  /// What the mouse does; `hintChanged` tells that it is something else.
  virtual QString hint() const { return description_.hint; }

  virtual void setTheme(const Theme&) {}
  virtual void enter() {}
  virtual void leave() {}
  /// Takes back what the user is at; false when there is nothing.
  virtual bool escape() { return false; }
  /// Whether each click on the view counts on its own now, so that two quick ones are no double click.
  virtual bool takesClicks() const { return false; }
  /// A click at a place of the view: true when the mode has used it, because it looks deeper than to the
  /// organs' surfaces. Else `click` follows.
  virtual bool press(const QPointF&) { return false; }
  /// A click, not on a handle; null: beside all organs. Selects the organ, where a mode has no other use.
  virtual void click(const ClickedPlace* place) {
    if (place)
      workspace_.selection().setOrgan(place->organ);
    else
      workspace_.selection().clear();
  }

Q_SIGNALS:
  /// It asks to be the present mode.
  void wanted();
  void shownChanged();
  void hintChanged();
  void chartWantedChanged();
  void panelsChanged();

protected:
  const ModeParts parts_;
  Workspace& workspace_; ///< Of `parts_`: what all modes use.

private:
  Description description_;
};

} // namespace viscera::app

#pragma once

#include <QObject>

#include <vector>

#include "viscera/presentation/view_state.h"
#include "window/style/theme.h"
#include "window/timeline/playback.h"
#include "window/work/workspace.h"

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
  /// Name, icon and texts of the mode.
  struct Description {
    const char* id = "";   ///< "explore"; as in sessions and options.
    const char* icon = ""; ///< Of the icon set.
    int key = 0;           ///< The digit that chooses it; does not depend on the other modes.
    QString name;          ///< Shown under the icon.
    QString hint;          ///< For the status bar: what the mouse does.
  };

  Mode(const ModeParts& parts, Description description)
      : parts_(parts), workspace_(parts.workspace), description_(std::move(description)) {}

  const Description& description() const { return description_; }
  /// The ids of its actions as in a menu, "" for a line between them.
  virtual std::vector<const char*> actions() const { return {}; }
  /// Creates the property page, after the actions of all parts were added. The caller owns it.
  virtual QWidget* makePage(const Actions& actions) = 0;
  /// The chart below the timeline, the caller's; null: the volumes.
  virtual QWidget* makeChart() { return nullptr; }
  /// Whether to show the mode's own chart instead of the volumes; `chartWantedChanged` is emitted when that
  /// changes.
  virtual bool chartWanted() const { return true; }

  /// What the view shows while the mode is on; `shownChanged` is emitted when that changes.
  virtual presentation::Shown shown() const = 0;
  virtual live::WantedPose pose() const = 0;
  /// Asked when the mode begins, and when another sequence is there or none; `panelsChanged` tells that it is
  /// otherwise. What a drag changes must not change it: the layout stays under the mouse.
  virtual UsefulPanels panels() const = 0;
  /// A text for the status bar about what the mouse does; `hintChanged` is emitted when it changes.
  virtual QString hint() const { return description_.hint; }

  virtual void setTheme(const Theme&) {}
  virtual void enter() {}
  virtual void leave() {}
  /// Cancels what the user is doing; false when there is nothing to cancel.
  virtual bool escape() { return false; }
  /// Whether each click on the view counts on its own now, so that two quick ones are no double click.
  virtual bool takesClicks() const { return false; }
  /// Called for a click at a place in the view before `click`. Returns true when the mode has handled it, for
  /// modes that pick something behind the organs' surfaces; else `click` is called.
  virtual bool press(const QPointF&) { return false; }
  /// Called for a click that is not on a handle; null: on no organ. The base class selects the organ.
  virtual void click(const ClickedPlace* place) {
    if (place)
      workspace_.selection().setOrgan(place->organ);
    else
      workspace_.selection().clear();
  }

Q_SIGNALS:
  /// The mode asks to become the present one.
  void wanted();
  void shownChanged();
  void hintChanged();
  void chartWantedChanged();
  void panelsChanged();

protected:
  const ModeParts parts_;
  Workspace& workspace_; ///< Taken from `parts_`, since all modes use it.

private:
  Description description_;
};

} // namespace viscera::app

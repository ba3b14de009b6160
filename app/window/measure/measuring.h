#pragma once

#include <QObject>

#include "window/actions.h"
#include "window/measure/measure_scene.h"
#include "window/view/view_area.h"

namespace viscera::app {

class MeasureBox;

/// Measuring as the window has it: tool, what is drawn, list and actions.
class Measuring final : public QObject {
  Q_OBJECT

public:
  /// `explore` brings the window into Explore mode. All have to live longer.
  Measuring(Workspace& workspace, ViewArea& area, OrganScene& organs, HandleScene& handles,
            std::function<void()> explore, QObject* parent = nullptr);

  /// Adds "measure.distance", "measure.angle", "measure.removeAll" and "view.measurements".
  void addTo(Actions& actions);
  /// The list, for the window to put somewhere. The actions have to be there, also "export.measurements".
  MeasureBox* makeBox();
  void setMode(Mode mode) { tool_.setMode(mode); }
  void setTheme();
  /// See MeasureTool.
  bool escape() { return tool_.escape(); }
  bool active() const { return tool_.active(); }
  /// What the status bar says while it is active.
  QString hint() const;

  const scene::MeasurementGlyphs& glyphs() const { return glyphs_; }

Q_SIGNALS:
  /// It began or ended.
  void stateChanged();

private:
  void toggle(MeasureTool::Kind kind, bool on);
  void syncActions();

  Workspace& workspace_;
  ViewArea& area_;
  std::function<void()> explore_;
  scene::MeasurementGlyphs glyphs_;
  MeasureTool tool_;
  MeasureScene scene_;
  Actions* actions_ = nullptr;
  Subscription subscription_;
};

} // namespace viscera::app

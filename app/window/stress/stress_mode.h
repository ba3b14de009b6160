#pragma once

#include <QObject>

#include <memory>

#include "window/actions.h"
#include "window/stress/stress_model.h"
#include "window/stress/stress_scene.h"
#include "window/view/view_area.h"

class QMenu;

namespace viscera::app {

class ProbeCard;
class StressChart;
class StressPage;

/// Stress mode as the window has it: model, view, page, chart, probe card and actions.
class StressMode final : public QObject {
  Q_OBJECT

public:
  StressMode(Workspace& workspace, Playback& playback, Settings& settings, Actions& actions, ViewArea& area,
             OrganScene& organs, HandleScene& handles, QObject* parent = nullptr);
  ~StressMode() override;

  /// The property page and the chart, for the window to put somewhere.
  StressPage* makePage();
  StressChart* makeChart();
  void fillMenu(QMenu* menu) const;

  void setActive(bool active);
  void setTheme(const Theme& theme);
  /// Closes the probe or puts a dragged plane back; false when there was nothing to do.
  bool escape();

  StressModel& model() { return model_; }
  StressScene& scene() { return scene_; }

private:
  void makeActions();
  void syncActions();
  void changeLook(const std::function<void(StressLook&)>& change);

  Workspace& workspace_;
  Playback& playback_;
  Actions& actions_;
  ViewArea& area_;
  StressModel model_;
  StressScene scene_;
  ProbeCard* card_;
  StressChart* chart_ = nullptr;
};

} // namespace viscera::app

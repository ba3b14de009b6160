#pragma once

#include <QObject>

#include <vector>

#include <vtkNew.h>

#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"
#include "viscera/scene/vtkVisceraCutPlaneWidget.h"
#include "window/stress/stress_model.h"
#include "window/view/handle_controller.h"
#include "window/view/view_widget.h"

namespace viscera::app {

/// Handles the mouse for a stress map: it moves the plane that cuts the organ open, and shows the values at a
/// clicked place.
class CutController final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  CutController(Workspace& workspace, StressModel& model, ViewWidget& view, Picture& picture,
                const HandleController& handles, QObject* parent = nullptr);
  ~CutController() override;

  vtkVisceraCutPlaneWidget* planeWidget() const { return widget_; }
  /// Places the cut through the organ's middle, facing the camera.
  void faceReader();
  /// Cuts through the middle, across `normal`, and looks at the cut from where it can be seen.
  void cutAcross(const Vec3& normal);
  /// Shows the values at the nearest visible point there.
  void probeAt(const QPointF& place);

private:
  void listen();
  void enable();
  void onPlaneMoved();

  Workspace& workspace_;
  StressModel& model_;
  ViewWidget& view_;
  Picture& picture_;
  const HandleController& handles_;
  vtkNew<vtkVisceraCutPlaneWidget> widget_;
  std::vector<unsigned long> observers_;
};

} // namespace viscera::app

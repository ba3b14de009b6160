#pragma once

#include <QObject>

#include <memory>
#include <vector>

#include <vtkNew.h>

#include "viscera/deformation/witness_interpolation.h"
#include "viscera/scene/probe_marker.h"
#include "viscera/scene/stretch_glyphs.h"
#include "viscera/scene/tissue_actor.h"
#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"
#include "viscera/scene/vtkVisceraCutPlaneWidget.h"
#include "window/stress/stress_model.h"
#include "window/view/handle_scene.h"
#include "window/view/organ_scene.h"
#include "window/view/view_widget.h"

namespace viscera::app {

/// The stress map in the 3D view: the organ's surface and its inside in the map's colours, the plane that
/// cuts it open, glyphs, the legend and the probe. While the mode is on it decides what is seen of the
/// organs; afterwards everything is as before.
class StressScene final : public QObject {
  Q_OBJECT

public:
  StressScene(Workspace& workspace, StressModel& model, ViewWidget& view, OrganScene& organs,
              HandleScene& handles, QObject* parent = nullptr);
  ~StressScene() override;

  void setTheme(const scene::Theme& theme);
  /// The cut as it is; meaningful while the mode is on.
  scene::CutPlane cutPlane() const;
  vtkVisceraCutPlaneWidget* planeWidget() const { return planeWidget_; }
  /// Null while there is no map.
  const scene::TissueActor* tissue() const { return tissue_.get(); }
  const scene::StretchGlyphs& glyphs() const { return *glyphs_; }
  const scene::ProbeMarker& marker() const { return marker_; }
  /// Lets the cut face the reader, through the organ's middle.
  void faceReader();

Q_SIGNALS:
  void changed();

private:
  void onActive();
  void onSampled();
  void interpolateLater();
  void sync();
  void syncValues();
  void syncTissue();
  void syncOrgans();
  void syncCut();
  void syncHandles();
  void syncGlyphs();
  void syncLegend();
  void syncProbe();
  void onPlaneMoved();
  void onClick(const QPointF& place);
  bool kept(const Vec3& point) const;
  bool inRange(double value) const;
  bool organShown() const;
  scene::OrganActor* organActor() const;

  Workspace& workspace_;
  StressModel& model_;
  ViewWidget& view_;
  OrganScene& organs_;
  HandleScene& handles_;
  std::unique_ptr<scene::TissueActor> tissue_;
  std::unique_ptr<scene::StretchGlyphs> glyphs_;
  scene::ProbeMarker marker_;
  vtkNew<vtkVisceraCutPlaneRepresentation> plane_;
  vtkNew<vtkVisceraCutPlaneWidget> planeWidget_;
  std::vector<unsigned long> observers_;
  std::shared_ptr<const deformation::WitnessInterpolation> onSurface_;
  std::shared_ptr<Values> surfaceValues_ = std::make_shared<Values>();
  std::vector<int> glyphPoints_;
  Vec3 middle_ = Vec3::Zero(); ///< Of the organ at rest, and the radius of the ball around it.
  double radius_ = 1;
  bool planeFromWidget_ = false;
  std::string legendTitle_;
  scene::ValueRange legendRange_{0, 0};
  bool legendFolded_ = false;
};

} // namespace viscera::app

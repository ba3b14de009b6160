#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <vtkNew.h>

#include "handle_picture.h"
#include "organ_picture.h"
#include "viscera/live/stress_marks_reader.h"
#include "viscera/presentation/stress_values.h"
#include "viscera/scene/measurement_glyphs.h"
#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"

namespace viscera::presentation {

/// Draws the stress map of one organ: its surface and its inside in the map's colours, the plane that cuts it
/// open, glyphs, and the probes. It also returns how other organs and handles are drawn meanwhile.
class StressPicture {
public:
  explicit StressPicture(scene::OrganView& view);
  ~StressPicture();

  /// Draws the map where the scene shows one, else nothing.
  void update(const Scene& scene);

  /// Whether a map is drawn.
  bool drawn() const { return tissue_ && values_.ready(); }
  /// The appearances of organs while a map is on; else empty.
  std::map<document::OrganId, Appearance> appearances(const Scene& scene) const;
  /// Returns which handles are shown; null: all.
  ShownWhere shownWhere(const Scene& scene) const;
  MapColors colors() const { return {values_.colors(), values_.range(), revision_}; }

  const StressValues& values() const { return values_; }
  scene::TissueActor* tissue() const { return tissue_.get(); }
  const scene::StretchGlyphs& glyphs() const { return glyphs_; }
  const scene::ProbeMarker& probe() const { return probe_; }
  const scene::MeasurementGlyphs& marks() const { return markGlyphs_; }
  const live::ReadMarks& readMarks() const { return readMarks_; }
  vtkVisceraCutPlaneRepresentation* plane() const { return plane_; }
  Vec3 middle() const { return middle_; }
  double radius() const { return radius_; }

private:
  /// The inputs of the last picture; while they are equal, nothing is rebuilt.
  struct Made {
    std::uint64_t revision = 0;
    std::shared_ptr<const deformation::WitnessMesh> mesh;
    std::shared_ptr<const live::CycleStress> cycle;
    StressLook look;
    std::shared_ptr<const document::StressMarks> marks;
    std::optional<scene::ValueRange> shared;
    bool operator==(const Made&) const = default;
  };

  bool onSurface(const Scene& scene) const;
  void takeMesh(const live::StressFrame& frame);
  void dropTissue();
  void updateCut(const StressLook& look);
  void updateTissue(const Scene& scene);
  void updateGlyphs(const live::StressFrame& frame, const StressLook& look);
  void updateProbe(const live::StressFrame& frame, const StressLook& look);
  void updateMarks(const Scene& scene);
  void hideAll();
  bool kept(const Vec3& point, const StressLook& look) const;

  scene::OrganView& view_;
  StressValues values_;
  std::shared_ptr<const deformation::WitnessMesh> mesh_;
  std::unique_ptr<scene::TissueActor> tissue_;
  scene::StretchGlyphs glyphs_;
  scene::ProbeMarker probe_;
  live::StressMarksReader marksReader_;
  live::ReadMarks readMarks_;
  scene::MeasurementGlyphs markGlyphs_;
  vtkNew<vtkVisceraCutPlaneRepresentation> plane_;
  std::shared_ptr<Values> surfaceValues_ = std::make_shared<Values>();
  std::vector<int> glyphPoints_;
  Vec3 middle_ = Vec3::Zero();
  double radius_ = 1;
  std::optional<Made> made_;
  std::uint64_t revision_ = 0; ///< Of the values.
};

} // namespace viscera::presentation

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/document/document.h"
#include "viscera/document/measured_values.h"
#include "viscera/live/posed_organs.h"
#include "viscera/live/stress_frame.h"
#include "viscera/live/stress_marks_reader.h"
#include "viscera/plugin/registry.h"
#include "viscera/presentation/part_names.h"
#include "viscera/presentation/stress_values.h"
#include "viscera/presentation/view_state.h"
#include "viscera/scene/color_map.h"
#include "viscera/scene/helper_glyphs.h"
#include "viscera/scene/measurement_glyphs.h"
#include "viscera/scene/organ_labels.h"
#include "viscera/scene/organ_view.h"
#include "viscera/scene/stretch_glyphs.h"
#include "viscera/scene/tissue_actor.h"
#include "viscera/sequences/heart_valves.h"

class vtkVisceraCutPlaneRepresentation;

namespace viscera::presentation {

struct Bending;

/// Numbers that are shown as colours on the surfaces of organs, such as an influence.
struct SurfaceMap {
  std::map<document::OrganId, std::shared_ptr<const Values>> values; ///< One a vertex.
  scene::ColorMap colors;
  scene::ValueRange range;
  std::string title; ///< Of the legend.
  std::string unit;  ///< Or empty.
  std::string mark;  ///< What has the map's `missing` colour ("folded"); empty: nothing has.
};

/// A measurement that the user has begun and that is not part of the document yet.
struct PendingMeasurement {
  std::vector<document::MeasurementId> highlighted; ///< Chosen, or under the mouse.
  /// What its one to three points become, complete or not: no measurement yet. None while there are no
  /// points.
  document::Measurement pending;
};

/// A surface that is shown although no document has it, such as an organ that is being imported.
struct TransientSurface {
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< Never null.
  Vec3 color = Vec3::Ones();
  double opacity = 1;
  bool vertexColors = true; ///< The mesh's own colours, when it has some, go before `color`.
};

/// Everything that is drawn: document, organs, view state and further input. Only read while it is drawn.
struct Scene {
  const document::DocumentState& state;
  live::PosedOrgans& organs;
  const ViewState& view;
  const plugin::Registry& systems;
  const live::StressFrame* stress = nullptr; ///< Null: there is no stress map.
  const SurfaceMap* map = nullptr;           ///< Null: only what `view` asks for.
  const PendingMeasurement* measuring = nullptr;
  const std::vector<TransientSurface>* transient = nullptr; ///< Shown beside the organs; null: none.
  /// The parts whose names are written instead of those that `view` asks for; null: as it says.
  const std::vector<Part>* parts = nullptr;
  const Bending* bending = nullptr; ///< For slices in the view that are bent; null: they cannot be.
  /// The valves of a heart that is shown beating, at this instant; nothing: none are known.
  std::optional<sequences::ValveInstants> valves = std::nullopt;
  /// Of the stress map's colours, that another picture has, too; nothing: its own.
  std::optional<scene::ValueRange> stressRange = std::nullopt;
  bool stressLegend = true;            ///< False: the other picture says it for both.
  document::OrganId pointedOrgan = {}; ///< Under the mouse: its handles stand out; none: all are alike.
};

/// Draws a document in a 3D view: the one place where organs, handles, ghosts, regions, cages, influence and
/// stress maps, labels, measurements and the legend become actors. The window, its second view, movies
/// and the command line each have one on a view of their own. It owns its actors and the memory that they
/// show, has no user interface and changes nothing: what handles the mouse is given the presenter.
///
/// `update` compares with what it drew last and touches only what is different, so that it may be called
/// after any change, in any order, and as often as anybody likes. For the thread that renders the view.
///
///     scene::OrganView view;
///     presentation::Presenter presenter(view);
///     presenter.update({document.state(), live, viewState, systems});
///     window->Render();
class Presenter {
public:
  /// Says what stands in a picture in the language of its reader.
  using Translate = std::function<std::string(const char* text)>;

  /// The view has to live longer.
  explicit Presenter(scene::OrganView& view, Threads threads = {}, Translate translate = {});
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  /// Brings the view to what the scene says, but for the camera. O(organs), and what has changed. Throws
  /// what the organs throw; the picture is then partly the one before.
  void update(const Scene& scene);

  scene::OrganView& view() const { return view_; }
  /// The organ that an actor of the view shows, or none; the actor that shows an organ, or null.
  document::OrganId organOf(const scene::OrganActor* actor) const;
  std::shared_ptr<scene::OrganActor> actorOf(document::OrganId organ) const;

  const scene::OrganLabels& labels() const;
  const scene::MeasurementGlyphs& measurements() const;
  /// What the stress map shows; not ready while there is none.
  const StressValues& stressValues() const;
  /// The inside of the organ under stress, null while it is not drawn; and what belongs to it.
  scene::TissueActor* tissue() const;
  const scene::StretchGlyphs& glyphs() const;
  const scene::ProbeMarker& probe() const;
  /// The pinned probes and lines of the organ under stress as they are drawn, and what they say in the map
  /// that is shown.
  const scene::MeasurementGlyphs& stressMarks() const;
  const live::ReadMarks& readMarks() const;
  /// The plane that cuts it open, for a widget to take hold of.
  vtkVisceraCutPlaneRepresentation* cutPlane() const;
  /// The middle of the organ under stress at rest, and the radius of the ball around it, mm.
  Vec3 stressMiddle() const;
  double stressRadius() const;

private:
  struct Parts;
  scene::OrganView& view_;
  std::unique_ptr<Parts> parts_;
};

/// Returns the camera of a view.
Camera cameraOf(const scene::OrganView& view);

/// Sets the camera of a view. A camera that looks nowhere (position and focus are one place) changes nothing.
void lookFrom(const Camera& camera, scene::OrganView& view);
/// The same where the camera was kept together with this state of the view: a legend that comes with it later
/// does not move it.
void lookFrom(const Camera& camera, const ViewState& state, scene::OrganView& view);

/// The text of an organ's label: "LV cavity" for the sample heart's organ LV, else its name; either as the
/// reader's language says it.
std::string labelOf(const document::Organ& organ, const Presenter::Translate& translate = {});

/// The colour in which an organ of this colour is drawn, in pictures, lists and charts alike: tables of label
/// maps have pure red and green, on which light and shade cannot be told apart. A colour is brought towards
/// the grey of its own lightness where it is more vivid than blood; all others stay as they are. The document
/// and what is exported keep the file's own. `color` and the result are red green blue, 0 to 1.
Vec3 shownColor(const Vec3& color);

/// A measured value for a reader: "83.4 mm", degrees with the sign for them, "41.3 HU"; "-" where there is
/// none. `decimalMark` stands before the decimals. UTF-8.
std::string formatMeasured(document::MeasurementKind kind, double value, const std::string& unit = {},
                           char decimalMark = '.');

/// How the values of a rectangle or a sphere spread: deviation, least and largest value, size and number of
/// voxels; empty for the other kinds, and where there are no values. UTF-8.
std::string describeSpread(const document::Measurement& measurement, const document::MeasuredValues& values,
                           const std::string& unit, const Presenter::Translate& translate = {},
                           char decimalMark = '.');

} // namespace viscera::presentation

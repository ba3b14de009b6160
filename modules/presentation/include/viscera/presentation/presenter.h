#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/parallel.h"
#include "viscera/document/document.h"
#include "viscera/document/measured_values.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/heart/heart_valves.h"
#include "viscera/live/heart_tissue.h"
#include "viscera/live/posed_organs.h"
#include "viscera/live/stress_frame.h"
#include "viscera/live/stress_marks_reader.h"
#include "viscera/presentation/part_names.h"
#include "viscera/presentation/stress_values.h"
#include "viscera/presentation/view_state.h"
#include "viscera/scene/color_map.h"
#include "viscera/scene/conduction_glyphs.h"
#include "viscera/scene/helper_glyphs.h"
#include "viscera/scene/measurement_glyphs.h"
#include "viscera/scene/organ_labels.h"
#include "viscera/scene/organ_view.h"
#include "viscera/scene/stretch_glyphs.h"
#include "viscera/scene/tissue_actor.h"
#include "viscera/scene/valve_glyphs.h"

class vtkVisceraCutPlaneRepresentation;

namespace viscera::presentation {

struct Warping;

/// Numbers that are shown as colours on the surfaces of organs, such as an influence.
struct SurfaceMap {
  std::map<document::OrganId, std::shared_ptr<const Values>> values; ///< One for each vertex.
  scene::ColorMap colors;
  scene::ValueRange range;
  std::string title; ///< Of the legend.
  std::string unit;  ///< Or empty.
  std::string mark;  ///< Label of the map's `missing` colour ("folded"); empty: that colour is not used.
  bool glassAround = false; ///< Organs without values are drawn as glass: they would hide those with.
};

/// A measurement that the user has begun and that is not part of the document yet.
struct PendingMeasurement {
  std::vector<document::MeasurementId> highlighted; ///< Chosen, or under the mouse.
  /// The measurement with its one to three points so far, possibly incomplete. Without points: none has
  /// begun.
  document::Measurement pending;
};

/// A surface that is shown without being part of the document, such as an organ that is being imported.
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
  const coordinates::Registry& systems;
  const live::StressFrame* stress = nullptr; ///< Null: there is no stress map.
  const SurfaceMap* map = nullptr;           ///< Null: only maps chosen in `view`.
  const PendingMeasurement* measuring = nullptr;
  const std::vector<TransientSurface>* transient = nullptr; ///< Shown beside the organs; null: none.
  /// The parts whose names are shown instead of those chosen in `view`; null: those of `view`.
  const std::vector<Part>* parts = nullptr;
  const Warping* warping = nullptr; ///< For slices and measured places of the scan that follow the pose, if
                                    ///< the view warps the scan; null: they cannot.
  /// The valves of the beating heart at this instant; empty: none are known.
  std::optional<heart::ValveInstants> valves = std::nullopt;
  /// Range of the stress map's colours, shared with another picture; empty: a range of its own.
  std::optional<scene::ValueRange> stressRange = std::nullopt;
  bool stressLegend = true;            ///< False: the other picture shows the legend for both.
  document::OrganId pointedOrgan = {}; ///< The organ under the mouse, whose handles are highlighted; none:
                                       ///< all handles look alike.
  /// The instant of the beat that is shown; empty: none is known.
  std::optional<heart::BeatClock> clock = std::nullopt;
  /// The tissue of the sample heart, which the cut shows (`openedHeart`); null: not there, or not yet.
  std::shared_ptr<const live::HeartTissue> heartTissue = nullptr;
};

/// Draws a document in a 3D view: creates the actors of organs, handles, ghosts, regions, cages, influence
/// and stress maps, labels, measurements and the legend. The window, its second view, movies and the command
/// line each have a presenter with a view of its own. It owns its actors and the memory that they show. It
/// has no user interface and does not change the document; classes that handle the mouse hold a reference to
/// the presenter.
///
/// `update` compares the scene with the last one and updates only what differs, so that it may be called
/// after any change, in any order and at any rate. For the thread that renders the view.
///
///     scene::OrganView view;
///     presentation::Presenter presenter(view);
///     presenter.update({document.state(), live, viewState, systems});
///     window->Render();
class Presenter {
public:
  /// Translates a text of the picture into the language of the user.
  using Translate = std::function<std::string(const char* text)>;

  /// The view has to live longer.
  explicit Presenter(scene::OrganView& view, Threads threads = {}, Translate translate = {});
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  /// Updates everything in the view but the camera to the scene. O(organs), and what has changed. Throws what
  /// the organs throw; the picture is then only partly updated.
  void update(const Scene& scene);

  scene::OrganView& view() const { return view_; }
  /// The organ that an actor of the view shows, or none; the actor that shows an organ, or null.
  document::OrganId organOf(const scene::OrganActor* actor) const;
  std::shared_ptr<scene::OrganActor> actorOf(document::OrganId organ) const;

  /// The actor of the tissue of a sample heart that is cut open; null while the heart's surfaces are drawn.
  const scene::OrganActor* heartTissue() const;

  /// Whether blood fills that heart's chambers and vessels.
  bool heartBlood() const;

  const scene::OrganLabels& labels() const;
  const scene::MeasurementGlyphs& measurements() const;
  /// The numbers of the stress map; not `ready` while there is none.
  const StressValues& stressValues() const;
  /// The actor of the inside of the organ with the stress map, null while it is not drawn; the functions
  /// below return other parts of that map.
  scene::TissueActor* tissue() const;
  const scene::StretchGlyphs& glyphs() const;
  const scene::ProbeMarker& probe() const;
  /// The glyphs of the organ's pinned probes and lines, and their values in the displayed map.
  const scene::MeasurementGlyphs& stressMarks() const;
  const live::ReadMarks& readMarks() const;
  /// The heart's valves that are drawn, with their chords.
  const scene::ValveGlyphs& valves() const;
  /// The lines of the heart's conduction system that are drawn.
  const scene::ConductionGlyphs& conduction() const;
  /// The plane that cuts the organ open, for the widget that moves it.
  vtkVisceraCutPlaneRepresentation* cutPlane() const;
  /// The middle of the organ with the stress map at rest, and the radius of the ball around it, mm.
  Vec3 stressMiddle() const;
  double stressRadius() const;

private:
  struct Parts;
  scene::OrganView& view_;
  std::unique_ptr<Parts> parts_;
};

/// Returns the camera of a view.
Camera cameraOf(const scene::OrganView& view);

/// Sets the camera of a view. Nothing happens if position and focus of the camera coincide.
void lookFrom(const Camera& camera, scene::OrganView& view);
/// The same where the camera was kept together with this state of the view: a legend that comes with it later
/// does not move it.
void lookFrom(const Camera& camera, const ViewState& state, scene::OrganView& view);

/// The name of an organ where people read: "LV cavity" for the sample heart's organ LV, for others
/// `anatomy::readableName`. Each translated where a translation is known. Files keep the organ's own name.
std::string labelOf(const document::Organ& organ, const Presenter::Translate& translate = {});

/// The colour in which an organ of this colour is drawn, in pictures, lists and charts alike: tables of label
/// maps have pure red and green, on which light and shade cannot be told apart. A colour more vivid than that
/// of blood is moved towards the grey of its own lightness; all others stay as they are. The document and
/// exported files keep the original colour. `color` and the result are red green blue, 0 to 1.
Vec3 shownColor(const Vec3& color);

/// A measured value for a reader: "83.4 mm", degrees with the sign for them, "41.3 HU"; "-" where there is
/// none. `decimalMark` stands before the decimals. UTF-8.
std::string formatMeasured(document::MeasurementKind kind, double value, const std::string& unit = {},
                           char decimalMark = '.');

/// The statistics of the values in a rectangle or a sphere as text: deviation, least and largest value, size
/// and number of voxels; empty for the other kinds, and where there are no values. UTF-8.
std::string describeSpread(const document::Measurement& measurement, const document::MeasuredValues& values,
                           const std::string& unit, const Presenter::Translate& translate = {},
                           char decimalMark = '.');

} // namespace viscera::presentation

#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "viscera/anatomy/norms.h"
#include "viscera/core/arrays.h"
#include "viscera/document/circulation_choice.h"
#include "viscera/document/ids.h"
#include "viscera/heart/heart_numbers.h"
#include "viscera/live/session_motion.h"
#include "viscera/live/strain_reading.h"
#include "viscera/presentation/heart_signs.h"
#include "viscera/presentation/scan_look.h"
#include "viscera/presentation/stress_look.h"
#include "viscera/scene/region_hulls.h"

/// The view of a document as one value (camera, colours, cuts, playing sequence): a session saves it beside
/// the document, and a `Presenter` draws the same picture again from both. The theme is not part of it,
/// because it is a setting of the user.
namespace viscera::presentation {

/// Positions of handles, `n x 3` mm. Those of different numbers of handles can be compared, too.
struct HandlePositions : Points {
  using Points::Points;
  using Points::operator=;

  bool operator==(const HandlePositions& other) const {
    return rows() == other.rows() && Points::operator==(other);
  }
};

/// Position, focus and opening angle of a camera.
struct Camera {
  Vec3 position = Vec3::Zero(); ///< mm, LPS.
  Vec3 focus = Vec3::Zero();
  Vec3 up = Vec3::UnitZ();
  double angleDegrees = 30;
  bool parallel = false;
  double parallelScaleMm = 1;

  bool operator==(const Camera&) const = default;
};

/// The items that a mode shows, such as handles or regions. Drawing depends on this and not on the mode, so
/// that a new mode needs no change of the drawing code.
struct Shown {
  bool rest = false;         ///< Organs and handles at rest instead of in their pose.
  bool handles = false;      ///< The handles, even if the user has not switched them on.
  bool movable = false;      ///< They can be grabbed.
  bool compensating = false; ///< Handles that compensate for a locked volume are tinted.
  bool tools = false;        ///< The gizmo and the mirror plane, if they are on.
  bool regions = false;      ///< The regions into which the coordinates divide the space, and the cage.
  bool stress = false;       ///< The stress map in place of the organ's own colours.

  bool operator==(const Shown&) const = default;
};

/// The planes that drags can be mirrored at, through the middle of the organ at rest.
enum class Mirror { off, sagittal, coronal, axial };

using live::MotionChoice;
using live::Playing;
using live::Prescribed;

/// The contents of a second view for comparison. A session does not save a comparison with files.
struct Compared {
  enum class What {
    rate,        ///< The same organs at a rate of their own.
    coordinates, ///< The same organs and handles with another coordinate system.
    pose,        ///< The same organs in a pose that was kept.
    sample,      ///< A sample organ.
  };
  What what = What::rate;
  std::string name;         ///< The id of the coordinates, or the sample's; empty for the others.
  double ratePerMinute = 0; ///< Of the sequence in the second view; 0: none is played there.
  HandlePositions pose;     ///< The kept one; empty for the others.

  bool operator==(const Compared&) const = default;
};

/// A plane that cuts organs open in all modes but Stress, which has a cut of its own.
struct OrganCut {
  bool on = false;
  Vec3 normal = Vec3::UnitY(); ///< Unit, towards the part that stays; by default the anterior part is cut
                               ///< away.
  double offset = 0;           ///< -1 to 1, of the radius of the ball around the visible organs at rest.
  bool blood = false;          ///< The sample heart's chambers are full of blood, else empty.

  bool operator==(const OrganCut&) const = default;
};

/// Visibility and opacity of an organ that replace those of its look in the document.
struct OrganSeen {
  bool visible = true;
  double opacity = 1; ///< 0 to 1.

  bool operator==(const OrganSeen&) const = default;
};

/// The organs whose visibility or opacity differs from the document. Ids that are not in the document are
/// ignored.
using OrgansSeen = std::map<document::OrganId, OrganSeen>;

/// The look of the organs on a slide: which of them, cut or whole, with or without names.
struct SlideLook {
  OrganCut cut;
  bool labels = false;
  bool partNames = false;
  OrgansSeen organs; ///< All organs of that time; others are shown with their look in the document.

  bool operator==(const SlideLook&) const = default;
};

/// A slide of a lecture: a kept view with a caption.
struct Slide {
  std::string caption; ///< Under the picture; UTF-8.
  Camera camera;
  std::optional<double>
      fraction; ///< Fraction of the cycle at which the sequence stands, [0, 1]; none: the sequence goes on.
  /// None, as in older sessions: organs, cut and names stay as they are.
  std::optional<SlideLook> look = std::nullopt;

  bool operator==(const Slide&) const = default;
};

/// The selected organ and handles; the last handle is the current one.
struct SelectionState {
  document::OrganId organ;
  document::GroupId group;
  std::vector<document::HandleId> handles;

  bool operator==(const SelectionState&) const = default;
};

/// How the strain of a heart is shown: below the view, and as colours on the organ.
struct StrainLook {
  bool chart = false;   ///< Its curves and bull's eye in the place of the volumes.
  bool onOrgan = false; ///< The segments as colours on the organ.
  live::StrainDirection direction = live::StrainDirection::longitudinal;
  live::StrainMoment moment = live::StrainMoment::peak;
  int segment = 0; ///< The chosen one, 1 to 17; 0: none.
  /// The phase that strain is measured from, counted from 1; 0: the end of diastole is found. A cycle with
  /// less phases is measured from the one that is found.
  int reference = 0;
  /// The left ventricle whose axes have been clicked, and the points, mm at rest; those that are missing are
  /// found.
  document::OrganId axesOf = {};
  std::optional<Vec3> base = std::nullopt, apex = std::nullopt, insertion = std::nullopt;

  bool operator==(const StrainLook&) const = default;
};

/// The whole view of a document, as a session saves it.
struct ViewState {
  std::string mode = "explore"; ///< The id of a mode of the window.
  Shown shown;                  ///< The items that this mode shows.
  std::optional<Camera> camera; ///< None: from the front, everything in the picture.

  bool handles = false; ///< The handles are shown in every mode.
  bool influence = false;
  bool ghost = false;
  bool labels = false;
  bool partNames = false; ///< Names of the organs' parts.
  bool measurements = true;
  bool orientationCube = true;
  bool scaleBar = true;
  bool gizmo = false;
  bool exactly =
      false; ///< Under a locked volume, moved handles go where they are sent, and others compensate.
  bool freeHandlesFollow = false; ///< Handles that are not dragged go where the tissue would take them.
  bool besideElasticity = false;  ///< In Deform: the elastic organ under the same handles, as a ghost.
  Mirror mirror = Mirror::off;
  scene::LayoutParts layout{.regions = true}; ///< Regions, zones, super-regions of the groups.
  bool chartOfCycle = true;                   ///< The chart shows one cycle, else the last seconds.
  bool circulationChart = true; ///< While a circulation moves the heart: shows its curves instead of the
                                ///< volumes.
  bool valves = true;           ///< Valves of a beating heart, and the flow through them.
  bool conduction = false;      ///< The conduction system of a heart, lit by the excitation of its beat.
  bool beatSigns = false;       ///< Electrocardiogram, sounds and valves under the heart's phases.
  HeartSigns heartSigns;        ///< Below the view in lectures, and in movies.
  StressLook stress;
  StrainLook strain;
  ScanLook scan;
  OrganCut cut;
  OrgansSeen organsSeen; ///< Set while a slide is shown; the document does not change.
  /// The person whose normal ranges are shown: one sex, since those of both shade nearly all of a chart.
  anatomy::Person person{anatomy::Sex::women, 0};
  heart::ChosenEnds cycleEnds; ///< Of a measured motion, where the user has chosen them.

  SelectionState selection;
  std::vector<MotionChoice> motions;
  std::optional<Playing> playing;
  std::optional<Compared> compared; ///< None: there is no second view.
  std::vector<Slide> slides;        ///< In the order in which they are shown.
  /// The displayed positions of the handles if they differ from the document's pose; else empty.
  HandlePositions shownPose;

  bool operator==(const ViewState&) const = default;
};

/// The part of a view that says how organs move. O(motions).
live::SessionMotion motionOf(const ViewState& view);

/// The view as JSON, for a session (docs/session_format.md, "view").
nlohmann::ordered_json toJson(const ViewState& view);

/// Reads what `toJson` made, and the views of sessions of formats 1 and 2. Values that are missing or out of
/// range get their defaults. `circulation` is the session's: a heartbeat of those formats began at another
/// instant, which depends on what moved the heart, and its fractions are read as those of today's beat.
/// Throws `DataError` for what is no view.
ViewState viewFromJson(const nlohmann::ordered_json& item,
                       const document::CirculationChoice& circulation = {});

} // namespace viscera::presentation

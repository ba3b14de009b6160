#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/document/ids.h"
#include "viscera/norms/norms.h"
#include "viscera/presentation/scan_look.h"
#include "viscera/presentation/stress_look.h"
#include "viscera/scene/region_hulls.h"

/// The view of a document as one value (camera, colours, cuts, playing sequence): what a session keeps beside
/// the document, and all that a `Presenter` has to know to draw the same picture again. The theme is not in
/// it: it is the user's, not the document's.
namespace viscera::presentation {

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

/// The items that a mode shows, such as handles or regions. A picture depends on this and not on the mode, so
/// that a new mode needs no line in what draws.
struct Shown {
  bool rest = false;         ///< Organs and handles at rest instead of in their pose.
  bool handles = false;      ///< The handles, also where the user has not asked for them.
  bool movable = false;      ///< They can be grabbed.
  bool compensating = false; ///< Those that make up for a locked volume are tinted.
  bool tools = false;        ///< The gizmo and the mirror plane, where they are wanted.
  bool regions = false;      ///< What the coordinates divide the space into, and the cage.
  bool stress = false;       ///< The stress map in place of the organ's own colours.

  bool operator==(const Shown&) const = default;
};

/// The planes that drags can be mirrored at, through the middle of the organ at rest.
enum class Mirror { off, sagittal, coronal, axial };

/// A sequence that can be played, by the recipe that makes it again.
struct MotionChoice {
  document::OrganId organ;
  std::string recipe; ///< motion/motion_recipe.h; JSON.

  bool operator==(const MotionChoice&) const = default;
};

/// The volume that an organ is to have while the sequence moves it.
struct Prescribed {
  document::OrganId organ;
  std::string file; ///< The name of the file that it came from, for texts; UTF-8.
  /// Fraction of the cycle and volume, ml. As they were read: who plays them judges them.
  std::vector<std::array<double, 2>> curve;

  bool operator==(const Prescribed&) const = default;
};

/// The playing sequence, its rate and its present instant.
struct Playing {
  int motion = -1;     ///< Among the motions; -1: the sequence that the document holds.
  double fraction = 0; ///< Of the cycle, 0 to 1.
  double ratePerMinute = 0;
  double speed = 1;
  bool loop = true;
  bool shown = false; ///< The organs are in the sequence's pose.
  std::optional<Prescribed> prescribed = std::nullopt;

  bool operator==(const Playing&) const = default;
};

/// What a second view shows beside the organs. Files that it shows are in no session.
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
  Points pose;              ///< The kept one, `n x 3` mm; empty for the others.

  bool operator==(const Compared& other) const;
};

/// A plane that cuts organs open in all modes but Stress, which has a cut of its own.
struct OrganCut {
  bool on = false;
  Vec3 normal = Vec3::UnitY(); ///< Unit, to what stays; at first what is in front of it goes.
  double offset = 0;           ///< -1 to 1, of the radius of the ball around the visible organs at rest.

  bool operator==(const OrganCut&) const = default;
};

/// How an organ is seen in place of what its look in the document says.
struct OrganSeen {
  bool visible = true;
  double opacity = 1; ///< 0 to 1.

  bool operator==(const OrganSeen&) const = default;
};

/// Organs that are seen otherwise than the document says. Those that a document does not have mean nothing.
using OrgansSeen = std::map<document::OrganId, OrganSeen>;

/// What a slide shows of the organs: which of them, cut or whole, with or without names.
struct SlideLook {
  OrganCut cut;
  bool labels = false;
  bool partNames = false;
  OrgansSeen organs; ///< All that there were; others are seen as the document says.

  bool operator==(const SlideLook&) const = default;
};

/// A slide of a lecture: a kept view with a caption.
struct Slide {
  std::string caption; ///< Under the picture; UTF-8.
  Camera camera;
  std::optional<double>
      fraction; ///< Where in its cycle the sequence stands, [0, 1]; none: it goes on as it is.
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

/// The whole view of a document, as a session saves it.
struct ViewState {
  std::string mode = "explore"; ///< The id of a mode of the window.
  Shown shown;                  ///< As that mode asks for.
  std::optional<Camera> camera; ///< None: from the front, everything in the picture.

  bool handles = false; ///< The handles are shown in every mode.
  bool influence = false;
  bool ghost = false;
  bool labels = false;
  bool partNames = false; ///< Of the parts of organs that have named places.
  bool measurements = true;
  bool orientationCube = true;
  bool scaleBar = true;
  bool gizmo = false;
  Mirror mirror = Mirror::off;
  scene::LayoutParts layout{.regions = true}; ///< Regions, zones, super-regions of the groups.
  bool chartOfCycle = true;                   ///< The chart shows one cycle, else the last seconds.
  bool circulationChart = true; ///< Where a circulation moves the heart: its curves in place of the volumes.
  bool valves = true;           ///< Of a heart that beats: its valves, and what flows through them.
  bool beatSigns = false;       ///< Electrocardiogram, sounds and valves under the heart's phases.
  StressLook stress;
  ScanLook scan;
  OrganCut cut;
  OrgansSeen organsSeen; ///< While a slide is shown: the document does not change for it.
  norms::Person person;  ///< Whose normal ranges are shown.

  SelectionState selection;
  std::vector<MotionChoice> motions;
  std::optional<Playing> playing;
  std::optional<Compared> compared; ///< None: one view.
  std::vector<Slide> slides;        ///< In the order in which they are shown.
  /// Where the handles were seen when it is not the document's pose, `n x 3` mm; empty otherwise.
  Points shownPose;

  bool operator==(const ViewState& other) const;
};

/// The view as JSON text, for a session (docs/session_format.md, "view").
std::string toJson(const ViewState& view);

/// Reads what `toJson` wrote, and the views of sessions of format 1. What is missing or out of range is as at
/// first. Throws `DataError` for text that is no view.
ViewState viewFromJson(const std::string& text);

} // namespace viscera::presentation

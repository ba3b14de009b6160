#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/document/document.h"
#include "viscera/lesson/lesson_spec.h"
#include "viscera/live/heart_tissue.h"
#include "viscera/live/motion_runner.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sequences/sequence.h"

/// Plans a lesson, a page for any browser, from a document, a motion and a view.
namespace viscera::lesson {

/// The most rates that `offeredRates` proposes for a lesson, so that the lesson stays short.
inline constexpr std::size_t kMostRates = 10;
/// The most handles of a rig that a reader can drag; for a larger rig other handles are placed.
inline constexpr std::size_t kMostOwnHandles = 40;

/// The document, motion and view that a lesson is made from.
struct LessonSource {
  document::DocumentState state = {};
  std::shared_ptr<const sequences::Sequence> sequence = {};  ///< Null: the organs are still.
  double ratePerMinute = 0;                                  ///< To begin with; 0: the sequence's own.
  std::optional<live::PrescribedVolume> prescribed = {};     ///< As the window plays it.
  std::optional<presentation::Camera> camera = {};           ///< The camera at the beginning.
  std::vector<presentation::Slide> slides = {};              ///< Views that the session keeps, in order.
  anatomy::Person person = presentation::ViewState().person; ///< Whose normal ranges are shown.
  /// Tissue of the sample heart that the lesson can cut open; null: it has no cut.
  std::shared_ptr<const live::HeartTissue> tissue = {};
  /// The cut at the beginning; off, or without one: closed, and through four chambers when it is opened.
  presentation::OrganCut cut = {};
  bool conduction = false;      ///< Whether the lesson has the heart's conduction system,
  bool conductionShown = false; ///< and shows it at the beginning.
};

/// A label of a lesson: a name at a place of a surface.
struct PlannedLabel {
  std::string text;
  Vec3 at = Vec3::Zero(); ///< mm, LPS, at rest; it moves with the nearest vertex.
  double ringMm = 0;      ///< Of a valve: the radius of the ring that is drawn there.
};

/// An organ that a lesson will show, with its name and look.
struct PlannedSurface {
  document::OrganId organ;
  std::string title;
  Vec3 color = Vec3::Ones(); ///< Red green blue, 0 to 1: of its tile and its curve.
  bool vertexColors = false; ///< It is drawn in the mesh's own colours.
  double opacity = 1;
  bool wall = false;    ///< Others lie in it: it can be made transparent.
  bool charted = false; ///< It is closed and tracked, so its volume is a line of the chart.
  bool ejects = false;  ///< It is a ventricle, with stroke volume and ejection fraction.
  bool output = false;  ///< The left one: its stroke volume times the rate is the cardiac output.
  std::vector<PlannedLabel> labels;
};

/// The conduction system of the heart in a lesson.
struct PlannedConduction {
  bool on = false; ///< At the beginning.
};

/// A normal range that the chart of a lesson shows as a band.
struct PlannedRange {
  std::size_t surface = 0;
  std::string kind; ///< "ml", drawn in the chart, or "percent", written beside the ejection fraction.
  double low = 0;
  double high = 0;
  std::string text;
};

/// A measurement of the document with the name that the lesson gives it.
struct PlannedMeasurement {
  document::Measurement measurement;
  std::string title;
};

/// A phase's name in the sequence, and in the lesson.
struct PlannedPhase {
  std::string name;
  std::string title;
};

/// The plan of a lesson: its organs, labels, texts and slides without the motion's data. It is small and made
/// at once, so that it can be checked and edited before the lesson itself is made. A lesson contains only
/// those parts of the document that are listed here.
struct LessonPlan {
  std::string language; ///< Of the page's own texts, a code of `pageLanguages`; empty: the program's.
  std::string title;
  std::string notes; ///< Sources and disclaimers.
  std::vector<PlannedSurface> surfaces;
  std::vector<PlannedRange> ranges;
  std::vector<PlannedMeasurement> measurements;
  std::vector<PlannedPhase> phases;
  std::vector<PlannedSlide> slides;
  std::optional<Eye> eye;           ///< None: from the front.
  std::vector<std::string> handles; ///< Labels of the rig's own; empty: others are placed, or none.
  bool ownHandles = false;
  int placedHandles = 22;        ///< When they are not the rig's own; 0: none.
  std::vector<double> rates;     ///< Ascending; empty when the organs are still.
  double rate = 0;               ///< To begin with, one of them.
  std::optional<PlannedCut> cut; ///< At the beginning; none where the lesson cannot be cut open.
  std::optional<PlannedConduction> conduction; ///< None where it has no conduction system.
  bool strain = false;                         ///< Whether the page has a bull's eye that follows the beat.
};

/// Plans a lesson of the organs that are shown: titles from their names, ("LV" becomes "Left ventricle"),
/// bands of healthy people, the document's measurements, the session's slides before those of `spec`, and the
/// overrides of `spec`. Throws `UsageError` when no organ is shown, and for an unknown language, name or
/// phase in `spec`.
///
///     LessonSource source{document.state()};
///     LessonPlan plan = planLesson(source, {});
///     plan.title = "The liver in a breath";
LessonPlan planLesson(const LessonSource& source, const LessonSpec& spec);

/// The texts and slides that the program has for the sample organ that a document shows: names of its parts,
/// and for the sequence of that organ title, notes, rates and slides, too; the session's own slides replace
/// these. Empty for other organs.
LessonSpec readySpecFor(const LessonSource& source);

/// Offers at most `kMostRates` rates between a sequence's lowest and highest, its own among them, ascending.
std::vector<double> offeredRates(const sequences::Sequence& sequence);

/// One text of a lesson.
struct LessonText {
  std::string kind; ///< What it is: "Title", "Organ", "Label".
  std::string* text = nullptr;
};
/// All texts of a plan, in the order in which a reader meets them, to be looked at and changed in place.
std::vector<LessonText> textsOf(LessonPlan& plan);

} // namespace viscera::lesson

#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/parameters.h"
#include "viscera/core/signal.h"
#include "viscera/document/circulation_choice.h"
#include "viscera/document/ids.h"
#include "viscera/document/key_sequence.h"
#include "viscera/document/measurement.h"
#include "viscera/document/organ.h"
#include "viscera/document/rig.h"
#include "viscera/document/stress_marks.h"

namespace viscera::document {

struct ScanItem;
struct StudyItem;

using OrganList = std::vector<std::shared_ptr<const Organ>>;

/// The chosen coordinate system, by its id, with the values of its parameters.
struct SystemChoice {
  std::string id = "s-celestial"; ///< As in the registry.
  coordinates::ParameterValues parameters;
};

/// The state of a document, which is everything that is saved and undone, in ten immutable parts that
/// states share with one another: a copy costs ten pointers, and a state that is kept (by the undo stack,
/// by a worker that saves) never changes.
///
/// It does not contain the view: the selection (`Selection`), the camera, the mode, the time of a sequence.
struct DocumentState {
  std::shared_ptr<const OrganList> organs; ///< Never null, nor is any of its items.
  std::shared_ptr<const Rig> rig;          ///< Never null.
  std::shared_ptr<const Points> pose; ///< `handles x 3` mm, row i belongs to `rig->handles[i]`. Never null.
  std::shared_ptr<const SystemChoice> system;           ///< Never null.
  std::shared_ptr<const KeySequence> keySequence;       ///< The keys that a user has recorded. Never null.
  std::shared_ptr<const MeasurementList> measurements;  ///< In the order in which they were made. Never null.
  std::shared_ptr<const StressMarks> stressMarks;       ///< Probes and lines in stress maps. Never null.
  std::shared_ptr<const CirculationChoice> circulation; ///< How the heart is moved. Never null.
  std::shared_ptr<const ScanItem> scan;   ///< The image beside the organs (scan_item.h); null: there is none.
  std::shared_ptr<const StudyItem> study; ///< Images over the cycle (study_item.h); null: there are none.

  /// An empty document.
  DocumentState();

  /// The organ with that id, or null. O(organs).
  std::shared_ptr<const Organ> organ(OrganId id) const;

  /// Compares the parts by address, as `isClean` of the undo stack does. O(1).
  friend bool operator==(const DocumentState&, const DocumentState&) = default;
};

/// Whether two states have the same contents to the last bit, wherever they are stored. Linear in the size of
/// the contents.
bool identical(const DocumentState& a, const DocumentState& b);

/// Whether the pose is the rest pose, exactly.
bool atRest(const DocumentState& state);

/// Describes a change of the document to its observers: the states before and after.
struct Change {
  DocumentState before;
  DocumentState after;
  /// The step is not complete (a drag, a slider): another change or its end follows.
  bool interactive = false;

  bool organs() const { return before.organs != after.organs; }
  bool rig() const { return before.rig != after.rig; }
  bool pose() const { return before.pose != after.pose; }
  bool system() const { return before.system != after.system; }
  bool keySequence() const { return before.keySequence != after.keySequence; }
  bool measurements() const { return before.measurements != after.measurements; }
  bool stressMarks() const { return before.stressMarks != after.stressMarks; }
  bool circulation() const { return before.circulation != after.circulation; }
  bool scan() const { return before.scan != after.scan; }
  bool study() const { return before.study != after.study; }
};

/// The open document: its state, and a signal for changes of it. Any holder may read it; only an `UndoStack`
/// changes it, by commands. For one thread; other threads are given a `DocumentState`.
///
/// A change is notified in two rounds. First the objects derived from the document (selection, bindings,
/// maps) update themselves without notifying anyone. Then all observers are called: those of the document, of
/// the derived objects, and of the undo stack. At that time everything is up to date, so observers do not
/// depend on the order. If one throws, the others are still called; then the function that made the change
/// rethrows the first exception. The change is not undone.
class Document {
public:
  Document() = default;
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const DocumentState& state() const { return state_; }
  const OrganList& organs() const { return *state_.organs; }
  std::shared_ptr<const Organ> organ(OrganId id) const { return state_.organ(id); }
  const Rig& rig() const { return *state_.rig; }
  const Points& pose() const { return *state_.pose; }
  const SystemChoice& system() const { return *state_.system; }
  const KeySequence& keySequence() const { return *state_.keySequence; }
  const MeasurementList& measurements() const { return *state_.measurements; }
  const StressMarks& stressMarks() const { return *state_.stressMarks; }
  const CirculationChoice& circulation() const { return *state_.circulation; }

  /// Calls `observer` after every change. An observer may read the document; changing it throws
  /// `std::logic_error`.
  [[nodiscard]] Subscription onChange(std::function<void(const Change&)> observer) {
    return changed_.connect(std::move(observer));
  }

  /// Serves objects derived from the document: called before the observers of a change, in the order of
  /// connection (so an object is connected after those that it is derived from).
  [[nodiscard]] Subscription onDerive(std::function<void(const Change&)> bringUpToDate) {
    return derived_.connect(std::move(bringUpToDate));
  }
  /// Calls `news`, by which a derived object notifies its own observers: at once, or after the change under
  /// way is complete.
  void announce(std::function<void()> news);

private:
  friend class UndoStack;

  /// Throws `std::logic_error` while observers of a change are being called.
  void requireNoChangeUnderWay() const;
  /// Calls the observers even if only `interactive` has changed, because the end of a step is a change for
  /// them.
  void replace(DocumentState state, bool interactive, std::function<void()> news);

  DocumentState state_;
  IdSource ids_;
  Signal<const Change&> derived_;
  Signal<const Change&> changed_;
  std::deque<std::function<void()>> news_; ///< Notifications of derived objects for the change under way.
  bool changing_ = false;
};

} // namespace viscera::document

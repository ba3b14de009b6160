#include "viscera/document/undo_stack.h"

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>

#include "viscera/document/scan_item.h"
#include "viscera/document/study_item.h"
#include "viscera/document/validate.h"

namespace viscera::document {
namespace {

/// Lets `after` use the parts of `before` that it only copied, so that equal states are equal by address.
void shareEqualParts(const DocumentState& before, DocumentState& after) {
  // Each part is compared within an otherwise equal state, so that the one definition of "identical" decides.
  const auto share = [&](auto part) {
    DocumentState mixed = before;
    mixed.*part = after.*part;
    if (identical(before, mixed))
      after.*part = before.*part;
  };
  share(&DocumentState::organs);
  share(&DocumentState::rig);
  share(&DocumentState::pose);
  share(&DocumentState::system);
  share(&DocumentState::keySequence);
  share(&DocumentState::measurements);
  share(&DocumentState::stressMarks);
  share(&DocumentState::circulation);
}

template <class Array>
std::size_t bytesOf(const Array& array) {
  return static_cast<std::size_t>(array.size()) * sizeof(typename Array::Scalar);
}

std::size_t bytesOf(const geometry::TriangleMesh& mesh) {
  return bytesOf(mesh.points) + bytesOf(mesh.triangles) + bytesOf(mesh.colors);
}

std::size_t bytesOf(const medical_io::Scan& scan) {
  return std::visit(
      [](const auto& samples) {
        return samples.size() * sizeof(typename std::decay_t<decltype(samples)>::value_type);
      },
      scan.samples);
}

/// The most that its decoded pictures take.
std::size_t bytesOf(const medical_io::CineStudy& study) {
  std::size_t bytes = 0;
  for (const medical_io::CineSlice& slice : study.slices)
    bytes += slice.fractions.size() * sizeof(float) * static_cast<std::size_t>(slice.geometry.rows) *
             static_cast<std::size_t>(slice.geometry.columns);
  return std::min(bytes, medical_io::CineOptions().keptBytes);
}

/// Roughly what `after` holds in memory that `before` does not; of scans, which may be larger than all the
/// rest, what `before` held, as the present one would be in memory without a step, too.
std::size_t newBytes(const DocumentState& before, const DocumentState& after) {
  std::size_t bytes = sizeof(DocumentState);
  if (after.organs != before.organs) {
    for (const auto& organ : *after.organs) {
      const bool known = std::any_of(before.organs->begin(), before.organs->end(),
                                     [&](const auto& other) { return other->mesh == organ->mesh; });
      bytes += sizeof(Organ) + (known ? 0 : bytesOf(*organ->mesh));
    }
  }
  if (after.rig != before.rig) {
    bytes += after.rig->handles.size() * sizeof(Handle) + after.rig->cage.size() * sizeof(CageTriangle);
    for (const Group& group : after.rig->groups)
      bytes += sizeof(Group) + group.handles.size() * sizeof(HandleId);
  }
  if (after.pose != before.pose)
    bytes += bytesOf(*after.pose);
  if (after.keySequence != before.keySequence)
    for (const SequenceKey& key : after.keySequence->keys)
      bytes += sizeof(key) + key.displacements.size() * sizeof(*key.displacements.begin());
  if (after.measurements != before.measurements)
    for (const Measurement& measurement : *after.measurements)
      bytes += sizeof(measurement) + measurement.points.size() * sizeof(MeasuredPoint);
  if (after.stressMarks != before.stressMarks)
    bytes += sizeof(StressMarks) + after.stressMarks->probes.size() * sizeof(StressProbe) +
             after.stressMarks->lines.size() * sizeof(StressLine);
  if (after.circulation != before.circulation)
    bytes += sizeof(CirculationChoice);
  if (before.scan && !(after.scan && after.scan->scan == before.scan->scan))
    bytes += before.scan->time ? std::min(before.scan->time->bytes, before.scan->time->keptBytes)
                               : bytesOf(*before.scan->scan);
  if (before.study && !(after.study && after.study->study == before.study->study))
    bytes += bytesOf(*before.study->study);
  return bytes;
}

} // namespace

UndoStack::UndoStack(Document& document, std::size_t memory)
    : document_(document), memory_(memory), clean_{document.state()} {}

void UndoStack::change(DocumentState state) {
  document_.replace(std::move(state), stepOpen_, changed_.emission());
}

void UndoStack::perform(const Command& command) {
  document_.requireNoChangeUnderWay();
  const DocumentState before = document_.state();
  DocumentState after = command.apply(before, document_.ids_);
  shareEqualParts(before, after);
  if (after == before)
    return;
  validate(after, before);
  Entry entry{command.name, command.mergeKey, before, after};
  if (!stepOpen_ && merges(command)) {
    entry.before = entries_.back().before;
    shareEqualParts(entry.before, after);
    entry.after = after;
    entries_.pop_back();
    position_ = entries_.size();
  }
  if (entry.before == after)
    seal(); // A slider that is back where it began has done nothing.
  else if (!stepOpen_)
    push(std::move(entry));
  change(std::move(after));
}

bool UndoStack::merges(const Command& command) const {
  // A saved state has to stay reachable by undo, so no command is merged into the step that ended there.
  return !sealed_ && !command.mergeKey.empty() && position_ > 0 && position_ == entries_.size() &&
         entries_.back().mergeKey == command.mergeKey && !isClean(entries_.back().after);
}

void UndoStack::push(Entry entry) {
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(position_), entries_.end());
  entry.bytes = newBytes(entry.before, entry.after);
  entries_.push_back(std::move(entry));
  position_ = entries_.size();
  forgetOldest();
  sealed_ = false;
}

/// The last step stays, however large it is.
void UndoStack::forgetOldest() {
  std::size_t kept = 0;
  auto oldest = entries_.end();
  while (oldest != entries_.begin() &&
         (oldest == entries_.end() || kept + std::prev(oldest)->bytes <= memory_))
    kept += (--oldest)->bytes;
  position_ -= static_cast<std::size_t>(oldest - entries_.begin());
  entries_.erase(entries_.begin(), oldest);
}

UndoStack::Step::Step(UndoStack& undo, const Text& name) : undo_(&undo) {
  undo.beginStep(name);
  number_ = undo.stepNumber_;
}

UndoStack::Step::~Step() {
  try {
    cancel();
  } catch (...) { // Thrown by an observer, after all were called; a destructor cannot report it.
  }
}

/// The stack while this step is the one that is open; the step is over then.
UndoStack* UndoStack::Step::take() {
  UndoStack* undo = std::exchange(undo_, nullptr);
  return undo && undo->stepOpen_ && undo->stepNumber_ == number_ ? undo : nullptr;
}

void UndoStack::Step::finish() {
  if (UndoStack* undo = take())
    undo->endStep();
}

void UndoStack::Step::cancel() {
  if (UndoStack* undo = take())
    undo->cancelStep();
}

void UndoStack::beginStep(const Text& name) {
  document_.requireNoChangeUnderWay();
  endStep();
  stepBefore_ = document_.state();
  stepName_ = name;
  stepOpen_ = true;
  ++stepNumber_;
  changed_.emit();
}

void UndoStack::endStep() {
  if (!stepOpen_)
    return;
  document_.requireNoChangeUnderWay();
  stepOpen_ = false;
  DocumentState after = document_.state();
  shareEqualParts(stepBefore_, after);
  if (!(after == stepBefore_))
    push({stepName_, {}, stepBefore_, after});
  stepBefore_ = {};
  seal();
  change(std::move(after));
}

void UndoStack::cancelStep() {
  if (!stepOpen_)
    return;
  document_.requireNoChangeUnderWay();
  stepOpen_ = false;
  change(std::exchange(stepBefore_, {}));
}

void UndoStack::undo() {
  if (canUndo())
    goTo(position_ - 1);
}

void UndoStack::redo() {
  if (canRedo())
    goTo(position_ + 1);
}

void UndoStack::goTo(std::size_t steps) {
  if (stepOpen_ || steps > entries_.size() || steps == position_)
    return;
  DocumentState state = steps < position_ ? entries_[steps].before : entries_[steps - 1].after;
  document_.requireNoChangeUnderWay();
  position_ = steps;
  seal();
  change(std::move(state));
}

Text UndoStack::undoName() const {
  return canUndo() ? entries_[position_ - 1].name : Text();
}

Text UndoStack::redoName() const {
  return canRedo() ? entries_[position_].name : Text();
}

std::vector<Text> UndoStack::names() const {
  std::vector<Text> list;
  for (const Entry& entry : entries_)
    list.push_back(entry.name);
  return list;
}

void UndoStack::markSaved() {
  endStep();
  markSaved(document_.state());
}

void UndoStack::markSaved(DocumentState state) {
  clean_ = {std::move(state)};
  changed_.emit();
}

void UndoStack::markUntouched() {
  endStep();
  std::erase_if(clean_, [this](const DocumentState& clean) { // Those that no step leads to any more.
    return std::none_of(entries_.begin(), entries_.end(), [&clean](const Entry& entry) {
      return entry.before == clean || entry.after == clean;
    });
  });
  clean_.push_back(document_.state());
  changed_.emit();
}

void UndoStack::markUnsaved() {
  markSaved(DocumentState()); // Equal to none: states are compared by address.
}

bool UndoStack::isClean(const DocumentState& state) const {
  return std::find(clean_.begin(), clean_.end(), state) != clean_.end();
}

void UndoStack::reset(DocumentState state) {
  document_.requireNoChangeUnderWay();
  stepOpen_ = false;
  stepBefore_ = {};
  entries_.clear();
  position_ = 0;
  for (const auto& organ : *state.organs)
    document_.ids_.reserve(organ->id);
  for (const Handle& handle : state.rig->handles)
    document_.ids_.reserve(handle.id);
  for (const Group& group : state.rig->groups)
    document_.ids_.reserve(group.id);
  for (const SequenceKey& key : state.keySequence->keys) {
    document_.ids_.reserve(key.id);
    for (const auto& [handle, moved] : key.displacements) // Handles that were removed are still meant.
      document_.ids_.reserve(handle);
  }
  for (const Measurement& measurement : *state.measurements) {
    document_.ids_.reserve(measurement.id);
    for (const MeasuredPoint& point : measurement.points) // An organ whose file is missing is still meant.
      document_.ids_.reserve(point.organ);
  }
  for (const StressProbe& probe : state.stressMarks->probes) {
    document_.ids_.reserve(probe.id);
    document_.ids_.reserve(probe.organ); // Also of one whose file is missing.
  }
  for (const StressLine& line : state.stressMarks->lines)
    document_.ids_.reserve(line.id);
  seal();
  clean_ = {state};
  change(std::move(state));
}

} // namespace viscera::document

#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/document/command.h"
#include "viscera/document/document.h"

namespace viscera::document {

/// Performs, undoes and redoes commands, which is the only way to change a document. Only memory limits the
/// number of steps (a step of a drag keeps one pose). For the document's thread.
///
///     Document document;
///     UndoStack undo(document);
///     undo.perform(addOrgans({{makeOrgan("Ball", mesh), -1}}));
///     undo.undo();
class UndoStack {
public:
  /// The memory that steps may use, bytes; beyond it the oldest ones are dropped.
  static constexpr std::size_t kMemory = std::size_t{1} << 30;

  explicit UndoStack(Document& document, std::size_t memory = kMemory);

  /// Performs a command as one undo step (or as part of the open step). A command that changes nothing adds
  /// no step. Throws what the command throws, and `DataError` for a state that no session file could hold
  /// (validate.h); document and stack are then unchanged.
  void perform(const Command& command);

  /// An open step: all commands until `finish` become one undo step, and observers see the changes as
  /// interactive. Steps do not nest: a new one finishes the one before, whose object then has no effect. The
  /// stack must live longer.
  class [[nodiscard]] Step {
  public:
    Step(UndoStack& undo, const Text& name);
    Step(Step&& other) noexcept : undo_(std::exchange(other.undo_, nullptr)), number_(other.number_) {}
    Step& operator=(Step&&) = delete;
    /// Cancels the step if it is still open, as after an error or Esc during a drag.
    ~Step();

    /// Closes the step. One that changed nothing in the end leaves no entry.
    void finish();
    /// Goes back to the state at the beginning and leaves no entry.
    void cancel();

  private:
    UndoStack* take();

    UndoStack* undo_; ///< Null when it is over.
    int number_;
  };
  bool stepOpen() const { return stepOpen_; }
  /// Cancels the open step, if there is one; its object then has no effect.
  void cancelStep();

  /// Makes the next command begin a new step even if its merge key is that of the last one, as after a slider
  /// was released.
  void seal() { sealed_ = true; }

  /// False while a step is open: it has to be finished or cancelled first.
  bool canUndo() const { return !stepOpen_ && position_ > 0; }
  bool canRedo() const { return !stepOpen_ && position_ < entries_.size(); }
  /// Goes one step back or forth; nothing happens when `canUndo` or `canRedo` is false.
  void undo();
  void redo();
  /// Goes to the state after `steps` of all steps, like repeated `undo` or `redo`; observers are called once.
  void goTo(std::size_t steps);
  /// The name of the step that `undo` or `redo` would affect; empty when there is none.
  Text undoName() const;
  Text redoName() const;
  /// The names of all steps, oldest first, and how many of them are done now.
  std::vector<Text> names() const;
  std::size_t position() const { return position_; }

  /// Remembers the present state as the saved one.
  void markSaved();
  /// Remembers the state that was saved while work went on.
  void markSaved(DocumentState state);
  /// Remembers the present state as one with nothing to save, beside the others of this kind, as after one
  /// untouched sample replaced another.
  void markUntouched();
  /// Marks all states as unsaved, for a document from a recovery file.
  void markUnsaved();
  /// Whether the document is in the saved (or loaded, or an untouched) state, also after undoing back to it.
  bool isClean() const { return isClean(document_.state()); }

  /// Another document: forgets all steps and takes `state` as saved.
  void reset(DocumentState state);

  /// Calls `observer` when the names, `canUndo`, `canRedo`, `isClean` or the open step may have changed.
  [[nodiscard]] Subscription onChange(std::function<void()> observer) {
    return changed_.connect(std::move(observer));
  }

private:
  struct Entry {
    Text name;
    std::string mergeKey;
    DocumentState before;
    DocumentState after;
    std::size_t bytes = 0; ///< Memory of the parts that are in `after` and not in `before`.
  };

  void beginStep(const Text& name);
  void endStep();
  void change(DocumentState state);
  void push(Entry entry);
  void forgetOldest();
  bool merges(const Command& command) const;
  bool isClean(const DocumentState& state) const;

  Document& document_;
  std::size_t memory_;
  std::vector<Entry> entries_;
  std::size_t position_ = 0;
  std::vector<DocumentState> clean_; ///< Those with nothing to save.
  DocumentState stepBefore_;
  Text stepName_;
  bool stepOpen_ = false;
  int stepNumber_ = 0; ///< Of the last step that was opened.
  bool sealed_ = true;
  Signal<> changed_;
};

} // namespace viscera::document

#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "viscera/document/command.h"
#include "viscera/document/document.h"

namespace viscera::document {

/// Performs commands on a document, and undoes and redoes them, which is the only way to change it, without a
/// limit but memory (a step of a drag keeps one pose). For the document's thread.
///
///     Document document;
///     UndoStack undo(document);
///     undo.perform(addOrgans({{makeOrgan("Ball", mesh), -1}}));
///     undo.undo();
class UndoStack {
public:
  /// What the steps may keep in memory, bytes; beyond it the oldest ones are forgotten.
  static constexpr std::size_t kMemory = std::size_t{1} << 30;

  explicit UndoStack(Document& document, std::size_t memory = kMemory);

  /// Does a command as one undo step (or as part of the step that is open). A command that changes nothing
  /// leaves no step. Passes on what the command throws, and throws `DataError` for a state that no session
  /// file could hold (validate.h), with the document and the stack as they were.
  void perform(const Command& command);

  /// An open step: all commands until `finish` become one undo step, and observers see the changes as
  /// interactive. Steps do not nest: a new one finishes the one before, whose holder then holds nothing. The
  /// stack must live longer.
  class [[nodiscard]] Step {
  public:
    Step(UndoStack& undo, const std::string& name);
    Step(Step&& other) noexcept : undo_(std::exchange(other.undo_, nullptr)), number_(other.number_) {}
    Step& operator=(Step&&) = delete;
    /// Cancels what is still open: an error on the way, Esc during a drag.
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

  /// The next command begins a step of its own even when its merge key is that of the last one: a slider was
  /// let go.
  void seal() { sealed_ = true; }

  /// False while a step is open: whoever drags finishes or cancels first.
  bool canUndo() const { return !stepOpen_ && position_ > 0; }
  bool canRedo() const { return !stepOpen_ && position_ < entries_.size(); }
  /// Goes one step back or forth; nothing happens when `canUndo` or `canRedo` says no.
  void undo();
  void redo();
  /// Goes to where `steps` of all steps are done, as so many `undo` or `redo` would; observers are told once.
  void goTo(std::size_t steps);
  /// The name of the step that `undo` would take back, or `redo` do again; empty when there is none.
  std::string undoName() const;
  std::string redoName() const;
  /// The names of all steps, oldest first, and how many of them are done now.
  std::vector<std::string> names() const;
  std::size_t position() const { return position_; }

  /// Remembers the present state as the saved one.
  void markSaved();
  /// Remembers the state that was saved while work went on.
  void markSaved(DocumentState state);
  /// No state there has been is a saved one: the document came out of a recovery file.
  void markUnsaved();
  /// Whether the document is what was saved (or loaded): undoing back to it is clean again.
  bool isClean() const;

  /// Another document: forgets all steps and takes `state` as saved.
  void reset(DocumentState state);

  /// Tells when the names, `canUndo`, `canRedo`, `isClean` or the open step may be new.
  [[nodiscard]] Subscription onChange(std::function<void()> observer) {
    return changed_.connect(std::move(observer));
  }

private:
  struct Entry {
    std::string name;
    std::string mergeKey;
    DocumentState before;
    DocumentState after;
    std::size_t bytes = 0; ///< What is in `after` and not in `before`.
  };

  void beginStep(const std::string& name);
  void endStep();
  void cancelStep();
  void change(DocumentState state);
  void push(Entry entry);
  void forgetOldest();
  bool merges(const Command& command) const;

  Document& document_;
  std::size_t memory_;
  std::vector<Entry> entries_;
  std::size_t position_ = 0;
  DocumentState saved_;
  DocumentState stepBefore_;
  std::string stepName_;
  bool stepOpen_ = false;
  int stepNumber_ = 0; ///< Of the last step that was opened.
  bool sealed_ = true;
  Signal<> changed_;
};

} // namespace viscera::document

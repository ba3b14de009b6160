#pragma once

#include <QObject>

#include "viscera/coordinates/registry.h"
#include "viscera/core/error.h"
#include "viscera/core/job_queue.h"
#include "viscera/core/phrase.h"
#include "viscera/document/document.h"
#include "viscera/document/selection.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/live_stress.h"
#include "viscera/live/live_warp.h"
#include "window/widgets/message_bar.h"

namespace viscera::app {

/// The open document with its binding, workers and messages, shared by all parts of the window. The parts
/// read the document and change it by `perform` only; errors are shown as a message over the view.
class Workspace final : public QObject {
  Q_OBJECT

public:
  /// `registry` holds the coordinate systems to choose from.
  explicit Workspace(coordinates::Registry registry, QObject* parent = nullptr);

  const document::Document& document() const { return document_; }
  const document::DocumentState& state() const { return document_.state(); }
  document::UndoStack& undo() { return undo_; }
  document::Selection& selection() { return selection_; }
  JobQueue& jobs() { return jobs_; }
  live::LiveBinding& live() { return live_; }
  live::LiveStress& stress() { return stress_; }
  /// Deforms the scan by the present pose; shared by the slices, the 3D view and the status line.
  live::LiveWarp& warp() { return warp_; }
  const coordinates::Registry& registry() const { return registry_; }

  [[nodiscard]] Subscription onChange(std::function<void(const document::Change&)> observer) {
    return document_.onChange(std::move(observer));
  }

  /// Calls `what` after all observers were notified of the present change of the document; at once if there
  /// is no change under way.
  void afterChange(std::function<void()> what) { document_.announce(std::move(what)); }

  /// Performs the command as one undo step; if that fails, shows the error and returns false.
  bool perform(const document::Command& command) {
    return guarded([&] { undo_.perform(command); });
  }
  /// Does the command as `perform` does, and says what it did, with an offer to undo it that ends with the
  /// next step: for what a key may do unseen.
  bool performTelling(const document::Command& command, const QString& said);
  /// Calls `work`; an error becomes a message and false. The barrier that no exception passes on its way into
  /// Qt.
  bool guarded(const std::function<void()>& work);

  /// Runs `work` on a worker, and cancels the previous job in the same slot; `then` is called with the
  /// result. If `work` fails, shows the error as a message and does not call `then`.
  template <typename Result>
  void inBackground(const QString& name, const std::string& slot, std::function<Result(Progress&)> work,
                    std::function<void(Result)> then) {
    jobs_.submit<Result>(name.toStdString(), slot, std::move(work),
                         [this, then = std::move(then)](JobResult<Result> result) {
                           if (result.error)
                             report(*result.error);
                           if (result.value)
                             then(std::move(*result.value));
                         });
  }

  /// The slot of a job that writes this file: jobs that write other files wait for it, a job that writes the
  /// same file replaces it.
  static std::string slotOf(const QString& file) { return kWriting + file.toStdString(); }
  /// The names of the jobs that write files.
  QStringList writing() const;

  /// The traits of the chosen coordinate system; those of the standard system if it does not exist.
  coordinates::Traits systemTraits() const;

  void say(const Message& message) { Q_EMIT messageRaised(message); }
  /// Shows a message for as long as it takes to read it.
  void note(const QString& text, int seconds = 8) { say({Message::Severity::info, text, {}, seconds}); }
  /// Shows a message about a file that was written, and offers to open its folder.
  void noteWritten(const QString& text, const QString& file);
  void report(const Error& error);
  /// Removes a message that no longer applies.
  void retract(const QString& said) { Q_EMIT messageRetracted(said); }

  /// The organ that commands act on: the selected one, else the first that is not a cavity of another organ;
  /// null without organs.
  std::shared_ptr<const document::Organ> currentOrgan() const;
  /// The organ that Properties describe: the selected one, else the only one there is beside its cavities;
  /// null where several could be meant.
  std::shared_ptr<const document::Organ> describedOrgan() const;

Q_SIGNALS:
  void messageRaised(const viscera::app::Message& message);
  void messageRetracted(const QString& text);

private:
  static constexpr const char* kWriting = "write:";

  document::Document document_;
  document::UndoStack undo_;
  coordinates::Registry registry_;
  JobQueue jobs_;
  live::LiveBinding live_;
  live::LiveStress stress_;
  live::LiveWarp warp_;
  document::Selection selection_;
  QString told_;               ///< What was said of the last step; empty when another one is the last.
  std::size_t toldAt_ = 0;     ///< The steps that were done with it.
  Subscription stepsFollowed_; ///< Ends before what it observes.
};

/// "83.4 ml", "938 ml": three or four significant digits.
QString formatMilliliters(double milliliters);

/// The text of an error for the user: what went wrong, where, and what to try.
QString sentenceOf(const Error& error);
/// A text in the language of the window as a sentence: with a capital and a full stop.
QString asSentence(const Text& text);
/// Formats the change of a volume: "+12.3 ml" and "+1.3 %". One too small for the digits is "+0.0".
QString formatChange(const live::OrganVolume& volume);
QString formatRelativeChange(const live::OrganVolume& volume);

/// Converts from UTF-8 and back.
inline QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

} // namespace viscera::app

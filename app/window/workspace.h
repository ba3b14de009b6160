#pragma once

#include <QObject>

#include "viscera/core/error.h"
#include "viscera/plugin/registry.h"
#include "viscera/session/document.h"
#include "viscera/session/job_queue.h"
#include "viscera/session/live_binding.h"
#include "viscera/session/live_stress.h"
#include "viscera/session/selection.h"
#include "viscera/session/undo_stack.h"
#include "window/widgets/message_bar.h"

namespace viscera::app {

/// What the coordinates of a document are like; nothing special for some that are not there.
coordinates::Traits traitsOf(const session::DocumentState& state, const plugin::Registry& systems);

/// The open document and everything that works on it, for all parts of the window. Parts read the document
/// and change it by `perform` only; what goes wrong becomes a message over the view.
class Workspace final : public QObject {
  Q_OBJECT

public:
  /// `registry` holds the coordinate systems to choose from.
  explicit Workspace(plugin::Registry registry, QObject* parent = nullptr);
  ~Workspace() override;

  const session::Document& document() const { return document_; }
  const session::DocumentState& state() const { return document_.state(); }
  session::UndoStack& undo() { return undo_; }
  session::Selection& selection() { return selection_; }
  session::JobQueue& jobs() { return jobs_; }
  session::LiveBinding& live() { return live_; }
  session::LiveStress& stress() { return stress_; }
  const plugin::Registry& registry() const { return registry_; }

  [[nodiscard]] session::Subscription onChange(std::function<void(const session::Change&)> observer) {
    return document_.onChange(std::move(observer));
  }

  /// Does the command as one undo step; when it is not possible, says why and returns false.
  bool perform(const session::Command& command);
  /// Calls `work`; an error becomes a message and false. The barrier that no exception passes on its way into
  /// Qt.
  bool guarded(const std::function<void()>& work);

  /// What the chosen coordinates promise; the standard ones' where there are none of that name.
  coordinates::Traits systemTraits() const;

  void say(const Message& message) { Q_EMIT messageRaised(message); }
  void report(const Error& error);

  /// The organ that commands act on: the selected one, else the first that is nobody's cavity; null without
  /// organs.
  std::shared_ptr<const session::Organ> currentOrgan() const;

Q_SIGNALS:
  void messageRaised(const viscera::app::Message& message);

private:
  // The live binding hears of every change before the selection does: whoever is told that the selection
  // changed may ask it about any organ of the document.
  session::Document document_;
  session::UndoStack undo_;
  plugin::Registry registry_;
  session::JobQueue jobs_;
  session::LiveBinding live_;
  session::LiveStress stress_;
  session::Selection selection_;
};

/// "83.4 ml", "938 ml": three or four significant digits.
QString formatMilliliters(double milliliters);

/// What a module says, as a sentence: with a capital and a full stop.
QString asSentence(const std::string& utf8);
/// The change of a volume: "+12.3 ml" and "+1.3 %". One too small for the digits is "+0.0".
QString formatChange(const session::OrganVolume& volume);
QString formatRelativeChange(const session::OrganVolume& volume);

/// From UTF-8 and back.
inline QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

} // namespace viscera::app

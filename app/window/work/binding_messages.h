#pragma once

#include <QObject>
#include <QPointer>

#include <functional>
#include <utility>
#include <vector>

#include "window/widgets/message_bar.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Shows a message when an organ cannot be bound to its handles, with a remedy, and removes it when the organ
/// is bound. A message also lists once what a binding had to cut or leave out.
class BindingMessages final : public QObject {
  Q_OBJECT

public:
  /// The remedies that a message offers change the document of `repaired`, of which the document of
  /// `workspace` may be a copy; null: they change the document of `workspace`.
  BindingMessages(Workspace& workspace, MessageBar* bar, QObject* parent = nullptr,
                  Workspace* repaired = nullptr);
  ~BindingMessages() override;

  /// Says whether a motion moves the handles: to add others would stop it, so that no message offers that.
  void setMoved(std::function<bool()> moved) { moved_ = std::move(moved); }
  /// Call it where that may have changed.
  void followMotion();

Q_SIGNALS:
  /// All organs were bound anew, in so many seconds.
  void bound(double seconds);

private:
  void sync();
  void retractOfGone();
  Message messageFor(const document::Organ& organ, const live::BindingStatus& status) const;

  void showNotes(const QStringList& notes);

  Workspace& workspace_;
  Workspace& repaired_;
  QPointer<MessageBar> bar_;
  std::function<bool()> moved_ = [] { return false; };
  bool moving_ = false; ///< As the message says.
  QString shown_;
  QStringList notes_; ///< Of the bindings in use.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app

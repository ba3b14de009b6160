#pragma once

#include <QObject>
#include <QPointer>

#include <vector>

#include "window/widgets/message_bar.h"
#include "window/workspace.h"

namespace viscera::app {

/// Shows a message when an organ cannot be bound to its handles, with a remedy, and removes it when the organ
/// is bound. What a binding had to cut or leave out is told once.
class BindingMessages final : public QObject {
  Q_OBJECT

public:
  /// Offers change the document of `mended`, of which that of `workspace` may be a mirror image; null: its
  /// own.
  BindingMessages(Workspace& workspace, MessageBar* bar, QObject* parent = nullptr,
                  Workspace* mended = nullptr);
  ~BindingMessages() override;

Q_SIGNALS:
  /// Everything is bound anew; how long that took.
  void bound(double seconds);

private:
  void sync();
  void retractOfGone();
  Message messageFor(const document::Organ& organ, const live::BindingStatus& status) const;

  void tellNotes(const QStringList& notes);

  Workspace& workspace_;
  Workspace& mended_;
  QPointer<MessageBar> bar_;
  QString shown_;
  QStringList notes_; ///< Of the bindings in use.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app

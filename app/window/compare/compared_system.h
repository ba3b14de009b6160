#pragma once

#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

#include "window/widgets/system_combo.h"
#include "window/work/binding_messages.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Shows the first view's organs and handles with another coordinate system in the second view. It offers the
/// list of systems and copies pose and selection, so that both are seen under the same motion.
class ComparedSystem final : public QObject {
  Q_OBJECT

public:
  /// Both have to live longer. Begins with T-Celestial coordinates, which take any handles as the program's
  /// own do; with those when the first document has T-Celestial.
  ComparedSystem(Workspace& first, Workspace& second, MessageBar* messages, QObject* parent = nullptr);

  /// The list of systems, for the second view's header, which owns it from then on.
  SystemCombo* makeChooser();
  void choose(const std::string& id);
  const std::string& system() const { return choice_->id; }
  /// The first document's state with the other coordinates.
  document::DocumentState applied(document::DocumentState state) const;

  /// The second document has become the first one's mirror image, with all of its organs and handles.
  void mirrored() { followSelection(); }

Q_SIGNALS:
  void chosen();

private:
  void followSelection();

  Workspace& first_;
  Workspace& second_;
  BindingMessages messages_;
  std::shared_ptr<const document::SystemChoice> choice_;
  QPointer<SystemCombo> chooser_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app

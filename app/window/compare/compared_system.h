#pragma once

#include <QComboBox>
#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

#include "window/binding_messages.h"
#include "window/pose_editor.h"
#include "window/view/handle_scene.h"
#include "window/view/organ_scene.h"
#include "window/view/view_widget.h"
#include "window/workspace.h"

namespace viscera::app {

/// Other coordinates for the first view's organs and handles in the second view: the list to choose them
/// from, and the handles, the selection, the ghost and the influence map as the first view has them, so that
/// the two systems are seen under the same motion.
class ComparedSystem final : public QObject {
  Q_OBJECT

public:
  /// One of the two views; its parts have to live longer.
  struct Side {
    Workspace& workspace;
    OrganScene& organs;
    ViewWidget& view;
  };

  /// `handles` are those of the first view. Begins with T-Celestial coordinates, which take any handles as
  /// the program's own do; with those when the first view has T-Celestial.
  ComparedSystem(const Side& first, const HandleScene& handles, const Side& second, MessageBar* messages,
                 QObject* parent = nullptr);
  ~ComparedSystem() override;

  /// The list of systems, for the second view's header, which owns it from then on.
  QComboBox* makeChooser();
  void choose(const std::string& id);
  const std::string& system() const { return choice_->id; }
  /// The first document's state with the other coordinates.
  document::DocumentState applied(document::DocumentState state) const;

  /// The second document has become the first one's mirror image, with all of its organs and handles.
  void mirrored();

Q_SIGNALS:
  void chosen();

private:
  void followLook();
  void followSelection();

  Side first_;
  Side second_;
  ViewModel view_;   ///< Says only whether handles are shown.
  PoseEditor poses_; ///< Moves nothing: handles are moved in the first view.
  const HandleScene& firstHandles_;
  std::unique_ptr<HandleScene> handles_;
  BindingMessages messages_;
  std::shared_ptr<const document::SystemChoice> choice_;
  QPointer<QComboBox> chooser_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app

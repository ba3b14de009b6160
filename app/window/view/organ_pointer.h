#pragma once

#include <QLabel>
#include <QTimer>

#include <optional>

#include "window/view/picture.h"
#include "window/view/view_widget.h"
#include "window/workspace.h"

class QMenu;

namespace viscera::app {

/// Handles the mouse for organs in a view: shows the name of the organ under the cursor and highlights its
/// handles; a double click shows that organ alone, and another one all organs; the right button opens the
/// organ's context menu. In a second view for comparison it shows names only.
class OrganPointer final : public QObject {
  Q_OBJECT

public:
  /// All must live longer. `menu` acts on the current organ; null: only names are shown.
  OrganPointer(Workspace& workspace, Picture& picture, ViewWidget& view, QMenu* menu,
               QObject* parent = nullptr);

  /// The name that is shown; empty when there is none.
  QString shownName() const { return name_->isVisible() ? name_->text() : QString(); }

Q_SIGNALS:
  /// The user wants to see the current organ alone, or all organs.
  void aloneWanted();
  void allWanted();

private:
  std::shared_ptr<const document::Organ> organAt(const QPointF& place) const;
  void hover(const std::optional<QPointF>& place);
  void showName();
  void isolate(const QPointF& place);
  void openMenu(const QPointF& place);

  Workspace& workspace_;
  Picture& picture_;
  ViewWidget& view_;
  QMenu* menu_;
  QLabel* name_;
  QTimer rested_; ///< Ends when the mouse has rested: while it moves fast, no name is shown.
  QPointF place_;
};

} // namespace viscera::app

#pragma once

#include <QLabel>
#include <QTimer>

#include <optional>

#include "window/view/picture.h"
#include "window/view/view_widget.h"
#include "window/work/workspace.h"

class QMenu;

namespace viscera::app {

/// Handles the mouse for organs in a view: shows the name of the organ under the cursor and highlights its
/// handles; a double click shows that organ alone, and another one all organs; the right button opens the
/// organ's context menu. In a second view for comparison it shows names only.
class OrganPointer final : public QObject {
  Q_OBJECT

public:
  /// What the view shows by, and where; all must live longer.
  struct Parts {
    Workspace& workspace;
    const ViewModel& model;
    Picture& picture;
    ViewWidget& view;
  };

  /// `menu` acts on the current organ; null: names alone, nothing can be done.
  OrganPointer(const Parts& parts, QMenu* menu, QObject* parent = nullptr);

  /// The name that is shown; empty when there is none.
  QString shownName() const { return name_->isVisible() ? name_->text() : QString(); }

Q_SIGNALS:
  /// The user wants to see the current organ alone, or all organs.
  void aloneWanted();
  void allWanted();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::shared_ptr<const document::Organ> organAt(const QPointF& place) const;
  void hover(const std::optional<QPointF>& place);
  /// What was under the mouse may be elsewhere now, or hidden: the name leaves, and comes back where the
  /// mouse still rests on an organ.
  void lookAgain();
  void showName();
  void isolate(const QPointF& place);
  void openMenu(const QPointF& place);

  Workspace& workspace_;
  Picture& picture_;
  ViewWidget& view_;
  QMenu* menu_;
  QLabel* name_;
  QTimer rested_;                ///< Ends when the mouse has rested: a name does not follow a fast one.
  std::optional<QPointF> place_; ///< Of the mouse, while it is over the view with no button down.
  Subscription subscription_;
};

} // namespace viscera::app

#pragma once

#include <QWidget>

#include "window/view/view_widget.h"
#include "window/widgets/message_bar.h"

class QGridLayout;
class QLabel;
class QTimer;

namespace viscera::app {

/// The 3D view with what lies over it: the message bar at the top, a badge, cards; and beside it, while two
/// organs are compared, a second view.
class ViewArea final : public QWidget {
  Q_OBJECT

public:
  explicit ViewArea(QWidget* parent = nullptr);

  ViewWidget* view() const { return view_; }
  MessageBar* messages() const { return messages_; }

  /// Puts `second` beside the view, both equally wide, with `header` above the view. Both widgets become
  /// this one's, until `joinViews` deletes them.
  void splitView(QWidget* header, QWidget* second);
  /// The view is alone again.
  void joinViews();

  /// A short remark at the top left that fades by itself ("bound in 15 ms").
  void showBadge(const QString& text);
  /// Puts a card over the view; it keeps its own size and is clipped by nothing.
  void addCard(QWidget* card, Qt::Alignment alignment);

private:
  QGridLayout* grid_;
  QWidget* views_; ///< The view, and the second one beside it.
  ViewWidget* view_;
  MessageBar* messages_;
  QLabel* badge_;
  QTimer* badgeTimer_;
  QWidget* header_ = nullptr;
  QWidget* second_ = nullptr;
};

} // namespace viscera::app

#pragma once

#include <QWidget>

#include <array>

#include "window/view/view_widget.h"
#include "window/widgets/message_bar.h"

class QGridLayout;
class QLabel;
class QTimer;

namespace viscera::app {

/// The central widget of the window: the 3D view with the message bar at the top, a badge, cards; around it
/// up to three slices; and beside all that, while two organs are compared, a second view.
class ViewArea final : public QWidget {
  Q_OBJECT

public:
  explicit ViewArea(QWidget* parent = nullptr);

  ViewWidget* view() const { return view_; }
  MessageBar* messages() const { return messages_; }

  /// Gives the slices their places around the view, which is at the upper right: upper left, lower left,
  /// lower right. This widget takes ownership; the slices are hidden until `arrange` shows them.
  void addSlices(const std::array<QWidget*, 3>& slices);
  /// Sets which of the view and the slices are visible; they share the room.
  void arrange(bool view, const std::array<bool, 3>& slices);

  /// Moves the camera so that everything is in the view, once the layout has placed the view.
  void frameSoon();

  /// Puts `second` beside the view, both equally wide, with `header` above the view. Takes ownership of both
  /// widgets; `joinViews` deletes them.
  void splitView(QWidget* header, QWidget* second);
  /// Sets the height of the header over a split view; without one nothing happens.
  void setHeaderHeight(int height);
  /// The view is alone again.
  void joinViews();

  /// A short remark at the top left that fades by itself ("bound in 15 ms").
  void showBadge(const QString& text);
  /// Hides that remark early; another one stays.
  void retractBadge(const QString& text);
  /// Leaves so many pixels below the views and slices free of them; 0: none.
  void reserveBelow(int pixels);
  /// The same above, for a card that is so high: what the view shows is not behind it.
  void reserveAbove(int cardHeight);
  /// Puts a card over the view; it keeps its own size and is clipped by nothing.
  void addCard(QWidget* card, Qt::Alignment alignment);

private:
  void syncTop();

  QGridLayout* grid_;
  QWidget* views_; ///< The view, and the second one beside it.
  ViewWidget* view_;
  QGridLayout* four_; ///< The view and the slices.
  std::array<QWidget*, 3> slices_{};
  MessageBar* messages_;
  QLabel* badge_;
  QTimer* badgeTimer_;
  QWidget* header_ = nullptr;
  QWidget* second_ = nullptr;
  int cardHeight_ = 0; ///< Above the views.
};

} // namespace viscera::app

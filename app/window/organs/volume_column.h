#pragma once

#include <QStyledItemDelegate>

namespace viscera::app {

/// Draws a volume and, small and coloured below it, by how much it has changed.
class VolumeColumn final : public QStyledItemDelegate {
  Q_OBJECT

public:
  /// What an item has beside the text of its volume: the change as text, empty while there is none, and its
  /// colour.
  enum Role { kChangeRole = Qt::UserRole, kChangeColorRole };

  using QStyledItemDelegate::QStyledItemDelegate;

  /// How high a row has to be for both, in that font.
  static int rowHeight(const QFont& font);
  /// How wide both are, without what is left free around them.
  static int textWidth(const QFont& font, const QString& volume, const QString& change);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace viscera::app

#pragma once

#include <QComboBox>

#include <string>

#include "viscera/coordinates/registry.h"

namespace viscera::app {

/// A combo box with the coordinate systems under headings: those recommended for organs, those with a cage,
/// those that need tetrahedra, and the attempts of the thesis, for comparison. The heading of a system
/// follows from its traits, so that systems of plugins are sorted too.
class SystemCombo final : public QComboBox {
  Q_OBJECT

public:
  explicit SystemCombo(const coordinates::Registry& registry, QWidget* parent = nullptr);

  /// The id at a place; empty for a heading.
  std::string systemAt(int index) const;
  void setSystem(const std::string& id);
  /// The text of the closed list: the name, shortened with an ellipsis if it does not fit. The tooltip then
  /// has the whole name.
  QString shownText() const;

Q_SIGNALS:
  /// The user has chosen the system with this id.
  void systemChosen(const std::string& id);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

} // namespace viscera::app

#pragma once

#include <QComboBox>

#include <string>

#include "viscera/plugin/registry.h"

namespace viscera::app {

/// A combo box with the coordinate systems under headings: those recommended for organs, those with a cage,
/// those that need tetrahedra, and the attempts of the thesis, which are there to be compared. Where a system
/// stands follows from what it says of itself, so that a plugin's finds its place.
class SystemCombo final : public QComboBox {
  Q_OBJECT

public:
  explicit SystemCombo(const plugin::Registry& registry, QWidget* parent = nullptr);

  /// The id at a place; empty for a heading.
  std::string systemAt(int index) const;
  void setSystem(const std::string& id);
  /// What the closed list shows: the name, shortened with an ellipsis where it does not fit. Its whole is in
  /// the tooltip then.
  QString shownText() const;

Q_SIGNALS:
  /// The user has chosen a system, by its id.
  void systemChosen(const std::string& id);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

} // namespace viscera::app

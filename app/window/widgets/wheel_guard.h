#pragma once

#include <QObject>

class QWidget;

namespace viscera::app {

/// The wheel over a panel scrolls the panel, also where the pointer happens to be over a list of choices, a
/// number or a slider: those keep their values. Guards all that is in `contents`, now and later; lives as
/// long as `contents`.
class WheelGuard final : public QObject {
  Q_OBJECT

public:
  explicit WheelGuard(QWidget* contents);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void watch(QObject* object);
};

} // namespace viscera::app

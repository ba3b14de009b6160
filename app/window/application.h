#pragma once

#include <QApplication>

#include <functional>

namespace viscera::app {

/// A QApplication that turns an exception in an event handler into a message, after which the window goes on.
/// Without this an exception that leaves an event's handler ends the program.
class Application final : public QApplication {
public:
  using QApplication::QApplication;

  /// Calls a function and returns true if it did not throw; such as `Workspace::guarded`.
  using Guard = std::function<bool(const std::function<void()>&)>;
  /// Empty: exceptions pass through, as tests want them.
  void setGuard(Guard guard) { guard_ = std::move(guard); }

  bool notify(QObject* receiver, QEvent* event) override {
    if (!guard_)
      return QApplication::notify(receiver, event);
    bool handled = false;
    guard_([&] { handled = QApplication::notify(receiver, event); });
    return handled;
  }

private:
  Guard guard_;
};

} // namespace viscera::app

#pragma once

#include <QApplication>
#include <QEvent>
#include <QLabel>

#include <functional>

namespace viscera::app {

/// A QApplication that turns an exception in an event handler into a message, after which the window goes on.
/// Without this an exception that leaves an event's handler ends the program.
///
/// It also lets labels show their texts as they are: names of files, organs and regions come from files of
/// other people, and Qt would take tags in them for formatting, and show pictures that they name. This holds
/// for every label, also of message boxes and tooltips; one with tags of its own has the format
/// `Qt::RichText` and escapes what it inserts.
class Application final : public QApplication {
public:
  using QApplication::QApplication;

  /// Calls a function and returns true if it did not throw; such as `Workspace::guarded`.
  using Guard = std::function<bool(const std::function<void()>&)>;
  /// Empty: exceptions pass through, as tests want them.
  void setGuard(Guard guard) { guard_ = std::move(guard); }

  bool notify(QObject* receiver, QEvent* event) override {
    if (event->type() == QEvent::Polish) // Before it is measured or drawn for the first time.
      keepTagsAsText(qobject_cast<QLabel*>(receiver));
    if (!guard_)
      return QApplication::notify(receiver, event);
    bool handled = false;
    guard_([&] { handled = QApplication::notify(receiver, event); });
    return handled;
  }

private:
  static void keepTagsAsText(QLabel* label) {
    if (label && label->textFormat() == Qt::AutoText)
      label->setTextFormat(Qt::PlainText);
  }

  Guard guard_;
};

} // namespace viscera::app

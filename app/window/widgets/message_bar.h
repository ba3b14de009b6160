#pragma once

#include <QFrame>
#include <QString>

#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QTimer;

namespace viscera::app {

/// A message for the user, with actions to choose from, that does not interrupt the work.
struct Message {
  enum class Severity { info, warning, error };
  struct Offer {
    QString label;
    std::function<void()> accept; ///< Called when the user clicks the button; the bar closes itself.
  };

  Severity severity = Severity::info;
  QString text;              ///< What happened and what to do next.
  std::vector<Offer> offers; ///< Buttons.
  int seconds = 0;           ///< Closes by itself after so long; 0: stays until closed.
};

/// A line over the view that shows a message with buttons for what can be done about it. A new message
/// replaces the old one.
class MessageBar final : public QFrame {
  Q_OBJECT

public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(const Message& message);
  /// The text on show, or held back; empty when the bar is closed.
  QString text() const;
  /// Keeps what it shows, and whatever comes, to itself until that ends: a lecture is for others.
  void setHeldBack(bool held);

public Q_SLOTS:
  void dismiss();
  /// Closes the bar when it shows this text.
  void retract(const QString& text);

private:
  void showOrHide();
  void rebuildOffers(const std::vector<Message::Offer>& offers);

  QLabel* icon_;
  QLabel* text_;
  QWidget* offersBox_;
  QHBoxLayout* offers_;
  QTimer* timer_;
  bool open_ = false;
  bool held_ = false;
};

} // namespace viscera::app

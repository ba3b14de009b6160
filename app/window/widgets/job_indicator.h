#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;

namespace viscera::app {

/// The long task that runs now, in the status bar: its step, how far it is, and a cross to cancel it.
class JobIndicator final : public QWidget {
  Q_OBJECT

public:
  explicit JobIndicator(QWidget* parent = nullptr);

  /// Shows the task; a negative fraction: it cannot say how far it is.
  void showJob(const QString& step, double fraction);
  void clear();

Q_SIGNALS:
  void cancelRequested();

private:
  QLabel* step_;
  QProgressBar* bar_;
};

} // namespace viscera::app

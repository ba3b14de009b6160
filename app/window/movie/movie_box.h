#pragma once

#include <QWidget>

#include <functional>

#include "window/movie/movie_plan.h"
#include "window/work/settings.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace viscera::app {

/// The controls that choose how a movie is recorded, and start it: kind, file, size, frames a second, cycles.
/// Kinds that this computer cannot write are disabled, with the reason.
class MovieBox final : public QWidget {
  Q_OBJECT

public:
  explicit MovieBox(Settings& settings, QWidget* parent = nullptr);

  /// Sets the name of new files: "heartbeat_75".
  void setName(const QString& name);
  void setRunning(bool running);
  MoviePlan plan() const;
  /// Checks again which encoders are installed and which file name is free.
  void refresh();

Q_SIGNALS:
  void recordRequested(const viscera::app::MoviePlan& plan);
  void cancelRequested();

protected:
  void showEvent(QShowEvent* event) override;

private:
  MovieFormat format() const;
  void makeControls();
  void addRow(const QString& name, QWidget* control);
  void chooseFile();
  void syncFormat();
  void proposeFile();

  Settings& settings_;
  QString name_;
  QComboBox* format_ = nullptr;
  QLabel* missing_ = nullptr;
  QLineEdit* file_ = nullptr;
  QComboBox* size_ = nullptr;
  QSpinBox* rate_ = nullptr;
  QSpinBox* cycles_ = nullptr;
  QCheckBox* caption_ = nullptr;
  QCheckBox* table_ = nullptr;
  QPushButton* record_ = nullptr;
  bool running_ = false;
  bool chosen_ = false; ///< The user has named the file.
};

} // namespace viscera::app

#pragma once

#include <QDialog>

#include "viscera/live/series_contents.h"
#include "window/timeline/measured_motion.h"
#include "window/work/settings.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;
class QVBoxLayout;

namespace viscera::app {

/// The dialog that finds a patient's motion in a series (Sequence > Motion from a series). The user chooses
/// the files, which parts are cavities and which are tissue, the duration of a cycle, and the options of the
/// search. The dialog shows errors, so that the user can correct the input. It is not modal.
class MotionDialog final : public QDialog {
  Q_OBJECT

public:
  MotionDialog(Workspace& workspace, MeasuredMotion& measured, Settings& settings, QWidget* parent);

  /// Reads the contents of a folder or of files on a worker.
  void look(const QStringList& files);
  /// Starts the search with the input of the dialog.
  void start();
  /// The text at the bottom: an error, or the input that is missing.
  QString said() const;

protected:
  bool event(QEvent* event) override;

private:
  void makeFiles(QVBoxLayout& column);
  void makeItems(QVBoxLayout& column);
  void makeTimes(QVBoxLayout& column);
  QWidget* makeMore();
  void chooseFolder();
  void chooseFiles();
  void take(const live::SeriesContents& contents);
  void fillItems();
  void onEnded(const QString& refusal);
  void say(const QString& what, bool refused);
  void sync();
  QString missing() const;
  /// The request from the input of the dialog. Throws `UsageError`.
  live::SeriesRequest request() const;
  live::TrackOptions options() const;

  Workspace& workspace_;
  MeasuredMotion& measured_;
  Settings& settings_;
  QStringList files_;
  live::SeriesContents contents_;
  bool looking_ = false;
  bool finding_ = false;
  QLabel* what_ = nullptr;
  QTableWidget* items_ = nullptr;
  QDoubleSpinBox* period_ = nullptr;
  QLabel* rate_ = nullptr;
  QCheckBox* loop_ = nullptr;
  QSpinBox* handles_ = nullptr;
  QDoubleSpinBox* robust_ = nullptr;
  QCheckBox* keepVolumes_ = nullptr;
  QLineEdit* leaveOut_ = nullptr;
  QLabel* said_ = nullptr;
  QLabel* missing_ = nullptr;
  QPushButton* start_ = nullptr;
};

} // namespace viscera::app

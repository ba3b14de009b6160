#pragma once

#include <QDialog>

#include <filesystem>
#include <functional>
#include <vector>

#include "viscera/live/series_contents.h"
#include "window/timeline/measured_motion.h"
#include "window/work/settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;
class QVBoxLayout;

namespace viscera::app {

class CinePage;

/// The dialog that finds a patient's motion in a series (Sequence > Motion from a series): in labels of every
/// phase, or in cine images and labels of a few phases. The user chooses the files, which parts are cavities
/// and which are tissue, the duration of a cycle, and the options of the search. The dialog shows errors, so
/// that the user can correct the input. It is not modal.
class MotionDialog final : public QDialog {
  Q_OBJECT

public:
  MotionDialog(Workspace& workspace, MeasuredMotion& measured, Settings& settings, QWidget* parent);

  /// Reads the contents of a folder or of files on a worker.
  void look(const QStringList& files);
  /// Asks for images and labels of a few phases, or else for labels of every phase.
  void setFromImages(bool images);
  /// Asks for images, and takes those of the study that is open, where nothing has been chosen yet.
  void offerStudy();
  CinePage& images() { return *cine_; }
  /// Starts the search with the input of the dialog.
  void start();
  /// The text at the bottom: an error, or the input that is missing.
  QString said() const;

protected:
  bool event(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void makeSource(QVBoxLayout& column);
  void makeFiles(QVBoxLayout& column);
  void makeButtons(QVBoxLayout& column);
  void makeItems(QVBoxLayout& column);
  void makeTimes(QVBoxLayout& column);
  QWidget* makeMore();
  void chooseFolder();
  void chooseFiles();
  void lookIntoLabels(std::function<live::SeriesContents(Progress&)> read);
  void lookAtCineLabels();
  void forgetLook();
  void takeImages();
  bool fromImages() const;
  void take(const live::SeriesContents& contents);
  void fillItems();
  void onEnded(const QString& refusal);
  void say(const QString& what, bool refused);
  void sync();
  QString missing() const;
  /// The request from the input of the dialog. Throws `UsageError`.
  live::SeriesRequest request() const;
  /// The same from images and labels of a few phases.
  live::CineRequest cineRequest() const;
  std::vector<live::LabelledSurface> surfaces() const;
  std::vector<std::size_t> leftOut() const;
  live::TrackOptions options() const;

  Workspace& workspace_;
  MeasuredMotion& measured_;
  Settings& settings_;
  QStringList files_;
  live::SeriesContents contents_;
  bool looking_ = false;
  int looks_ = 0; ///< The latest look into labels; answers to earlier ones are dropped.
  bool finding_ = false;
  QComboBox* source_ = nullptr;
  QLabel* about_ = nullptr;
  QWidget* seriesBox_ = nullptr;
  CinePage* cine_ = nullptr;
  std::filesystem::path cyclePlace_; ///< Of the images that the period was taken from.
  QLabel* what_ = nullptr;
  QTableWidget* items_ = nullptr;
  QDoubleSpinBox* period_ = nullptr;
  QLabel* rate_ = nullptr;
  QCheckBox* loop_ = nullptr;
  QSpinBox* handles_ = nullptr;
  QDoubleSpinBox* robust_ = nullptr;
  QCheckBox* keepVolumes_ = nullptr;
  QLabel* robustName_ = nullptr;
  QLabel* leaveOutName_ = nullptr;
  QLineEdit* leaveOut_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QLabel* said_ = nullptr;
  QLabel* missing_ = nullptr;
  QPushButton* start_ = nullptr;
};

} // namespace viscera::app

#pragma once

#include <QStringList>
#include <QWidget>

#include <functional>
#include <memory>

#include "viscera/document/study_item.h"
#include "viscera/live/cine_draft.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace viscera::app {

/// The part of the dialog for a motion from images: which images, and which files are the labels of which
/// phases. What it asks for is a `live::CineDraft`; this class shows it and changes it.
class CinePage final : public QWidget {
  Q_OBJECT

public:
  CinePage(Workspace& workspace, Settings& settings, QWidget* parent);

  /// Takes the images of a study that is there, and looks through them on a worker.
  void useStudy(std::shared_ptr<const document::StudyItem> study);
  /// Reads images from a folder or file on a worker.
  void openImages(const QString& place);
  void addLabels(const QStringList& files);
  /// What was dropped on the dialog: images where there are none yet, and a folder alone is dropped; else
  /// labels.
  void takeDropped(const QStringList& files);

  const live::CineDraft& draft() const { return draft_; }
  /// The study whose images were chosen; null without.
  std::shared_ptr<const document::StudyItem> study() const { return study_; }
  /// The labels of the first phase that has some, from which their roles are read; none without.
  std::optional<live::PhaseLabels> firstLabels() const;

Q_SIGNALS:
  /// Images, labels or their phases have changed.
  void changed();
  /// The files with labels have changed.
  void labelsChanged();
  /// The images cannot be read.
  void refused(const QString& why);

private:
  struct Looked {
    std::shared_ptr<const document::StudyItem> study;
    live::CineCycle cycle;
  };

  void makeImages(QVBoxLayout& column);
  void makeLabels(QVBoxLayout& column);
  void look(const QString& name, std::function<Looked(Progress&)> work);
  void chooseImages(bool folder);
  void chooseLabels(bool folder);
  void fill();
  void sync();

  Workspace& workspace_;
  Settings& settings_;
  live::CineDraft draft_;
  std::shared_ptr<const document::StudyItem> study_;
  QString looking_; ///< The name of the images that are being read; empty: none.
  QLabel* images_ = nullptr;
  QPushButton* openStudy_ = nullptr;
  QTableWidget* labels_ = nullptr;
  QLabel* remark_ = nullptr;
  Subscription subscription_;
};

} // namespace viscera::app

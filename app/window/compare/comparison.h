#pragma once

#include <QObject>
#include <QPointer>

#include <map>
#include <memory>
#include <optional>

#include "viscera/presentation/view_state.h"
#include "window/settings.h"
#include "window/style/theme.h"
#include "window/timeline/playback.h"
#include "window/timeline/volume_monitor.h"
#include "window/view/view_model.h"
#include "window/workspace.h"

class QSpinBox;
class QToolButton;

namespace viscera::app {

class ComparedSystem;
class DifferenceMap;
class Picture;
class SideHeader;
class ViewArea;
class ViewWidget;

/// Compares two organs side by side: manages a second document with its own binding, playback and view beside
/// the first, under one timeline and linked cameras. The second one shows the first's organs at another rate
/// or by other coordinates, another sample organ, or files; nothing of it is in the first document.
class Comparison final : public QObject {
  Q_OBJECT

public:
  /// What is compared with, and where; all have to live longer.
  struct First {
    Workspace& workspace;
    Playback& playback;
    VolumeMonitor& volumes;
    ViewArea& area;
    Settings& settings;
    ViewModel& view;
    Picture& picture;
  };

  explicit Comparison(const First& first, QObject* parent = nullptr);
  ~Comparison() override;

  bool on() const { return second_ != nullptr; }
  /// The organs of the first view at another rate; they follow what happens to the first's document.
  void showSameOrgan();
  /// Another motion of the same organs for `showSameOrgan` to show, at its own rate; null: the first view's.
  void setBeside(std::shared_ptr<const sequences::Sequence> sequence);
  /// The organs of the first view as they are posed at this moment; they stay so.
  void showKeptPose();
  /// The organs of the first view under the same motion, tied to the same handles by other coordinates.
  void showOtherCoordinates();
  void showSample(const QString& name);
  void showFiles(const QStringList& files);
  /// Asks for files and shows them.
  void chooseFiles();
  /// One view again.
  void end();

  /// What is compared with, for a session. None of files, of what has not come yet, and of a kept pose whose
  /// organs, handles or coordinates are no longer the document's.
  std::optional<presentation::Compared> compared() const;
  /// Compares with that again, with the first view as it is: its organs, its motion and its camera. Says so
  /// when what is asked for is not there.
  void restore(const presentation::Compared& compared);

  void setTheme(const Theme& theme);

  /// Of the second view; only while `on`.
  Workspace& workspace();
  Playback& playback();
  ViewWidget& view();
  const Picture& picture() const;
  /// The other coordinates of the second view, or null.
  ComparedSystem* comparedSystem() const;
  /// How far the two lie apart, while other coordinates are compared, or null.
  DifferenceMap* differences() const;

Q_SIGNALS:
  /// It began or ended.
  void toggled(bool on);

private:
  struct Second;

  void open();
  void showPose(const Points& pose);
  void setSecondRate(double perMinute);
  bool hasWhatIsIn(const presentation::Compared& compared) const;
  QWidget* makeSecondPane();
  void fillHeader(SideHeader& header);
  void mirror();
  QToolButton* makeDifferenceButton();
  QToolButton* makeErrorsButton();
  void dropSystem();
  void takeRate();
  void linkCameras();
  void syncHeaders();
  void syncMotion();
  QString volumesOf(int side) const;
  static QStringList phasesOf(const Playback& playback);
  QString titleOf(const Workspace& workspace, const Playback& playback) const;

  First first_;
  std::unique_ptr<Second> second_;
  QPointer<SideHeader> firstHeader_;
  QPointer<SideHeader> secondHeader_;
  QPointer<QSpinBox> rate_;
  Theme theme_;
  std::shared_ptr<const sequences::Sequence> beside_;
  bool same_ = false;
  std::optional<presentation::Compared::What> what_; ///< None: files, or nothing yet.
  QString sample_;                                   ///< The one that was asked for.
  /// That were wanted of the second view's sequences, a minute: an undo brings these back.
  std::map<std::shared_ptr<const sequences::Sequence>, double> rates_;
  double wantedRate_ = 0; ///< Of the sample that is being loaded, a minute; 0: as fast as the first view's.
};

} // namespace viscera::app

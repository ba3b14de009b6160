#pragma once

#include <QObject>
#include <QPointer>

#include <map>
#include <memory>
#include <optional>

#include "viscera/presentation/view_state.h"
#include "window/style/theme.h"
#include "window/timeline/playback.h"
#include "window/timeline/volume_monitor.h"
#include "window/view/view_model.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

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
  /// Ends the comparison; the window shows one view again.
  void end();

  /// What the first view is compared with, for saving in a session; also a sample that is still loading.
  /// Empty for a comparison with files, and for a kept pose whose organs, handles or coordinates are no
  /// longer the document's.
  std::optional<presentation::Compared> compared() const;
  /// Restores a saved comparison; organs, motion and camera of the first view stay as they are. Shows a
  /// message when what was compared with is missing.
  void restore(const presentation::Compared& compared);

  void setTheme(const Theme& theme);

  /// The parts of the second view; only while `on`.
  Workspace& workspace();
  Playback& playback();
  ViewWidget& view();
  Picture& picture() const;
  /// The other coordinates of the second view, or null.
  ComparedSystem* comparedSystem() const;
  /// The colours of the differences of both views, while other coordinates or poses are compared, else null.
  DifferenceMap* differences() const;

Q_SIGNALS:
  /// The comparison began or ended.
  void toggled(bool on);

private:
  struct Second;

  void open();
  void show(const presentation::Compared& sample);
  void takeSample(const QString& name);
  void showPose(const Points& pose);
  void setSecondRate(double perMinute);
  bool hasWhatIsIn(const presentation::Compared& compared) const;
  QWidget* makeSecondPane();
  void fillHeader(SideHeader& header);
  void mirror();
  QToolButton* makeDifferenceButton();
  QToolButton* makeErrorsButton();
  void dropSystem();
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
  QString sample_;                                   ///< The one that is shown.
  QString offered_; ///< The second view's last message, if it offers something, which ends with the view.
  /// The rates that the user chose for the second view's sequences, per minute; restored on undo.
  std::map<std::shared_ptr<const sequences::Sequence>, double> rates_;
  /// The sample that is being loaded, also after that was cancelled. Its rate is 0 where it is to have the
  /// first view's.
  std::optional<presentation::Compared> wanted_;
};

} // namespace viscera::app

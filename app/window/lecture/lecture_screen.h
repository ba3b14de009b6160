#pragma once

#include <QObject>

#include "window/lecture/lecture_signs.h"
#include "window/lecture/slides.h"
#include "window/modes/window_layout.h"
#include "window/timeline/volume_monitor.h"
#include "window/view/view_area.h"

class QFontMetrics;
class QFrame;
class QLabel;

namespace viscera::app {

/// The full-screen presentation for a lecture: the view alone on the whole screen, with the slide's caption,
/// the phase and the volumes below it in large letters, white on black or black on white, and the signs of a
/// beating heart below those; the view leaves them a strip of the screen, so that they cover no part of an
/// organ. Messages wait until it ends. While it is `on`, the window gives the views the theme of a lecture.
/// The keys of a presentation remote go through the slides (Page Down, Page Up), darken the screen (B or the
/// full stop, which shows the next frame otherwise) and end it (Escape).
class LectureScreen final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  struct Parts {
    WindowLayout& layout;
    ViewArea& area;
    Slides& slides;
    Playback& playback;
    VolumeMonitor& volumes;
    CirculationModel& circulation;
    ViewModel& view;
  };

  /// Adds "view.lecture", "lecture.dark" and the switches of `HeartSigns` ("signs.ecg" and others).
  LectureScreen(const Parts& parts, Actions& actions, QObject* parent = nullptr);

  bool on() const { return parts_.layout.bare(); }
  void begin();
  /// Ends the presentation and restores the window. False when it was not on.
  bool end();
  void setTheme(const Theme& theme) { signs_->setTheme(theme); }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void sync();
  /// Whether the full stop darkens the screen instead of showing the next frame.
  void takeFullStop(bool taken);
  void makeCard();
  void addSwitches();
  void placeCard();
  void fitNumbers();
  const Playback* playbackOf(int side) const;
  QString numbers() const;
  QString numbersOf(int side) const;
  QString rowOf(int side, const QString& phase) const;
  int widestRow(int side, const QFontMetrics& type) const;

  Parts parts_;
  Actions& actions_;
  QAction* shown_;
  QAction* darken_;
  QWidget* strip_;              ///< Below the view, with the card in it.
  int height_ = 0;              ///< Of the strip: as much as the slide has needed so far.
  double numbersPart_ = 1;      ///< Of the largest type of the numbers: as little as they have needed so far.
  double numbersPointSize_ = 0; ///< The largest type.
  QFrame* card_;
  QLabel* caption_;
  QLabel* numbers_;
  LectureSigns* signs_;
  QWidget* dark_;
};

} // namespace viscera::app

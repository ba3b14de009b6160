#pragma once

#include <QStringList>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

#include "viscera/anatomy/norms.h"
#include "viscera/scene/volume_chart.h"
#include "window/style/theme.h"
#include "window/timeline/volume_monitor.h"

class QLabel;
class QTabBar;
class QStackedLayout;
class QVBoxLayout;

namespace viscera::app {

class ChartCursor;
class ElidedLabel;
class MeasuredMotion;
class ViewModel;

/// A panel with the tracked volumes as numbers and as a live chart, ejection fraction, stroke volume and
/// normal ranges.
class VolumePanel final : public QWidget {
  Q_OBJECT

public:
  VolumePanel(VolumeMonitor& monitor, Playback& playback, ViewModel& view, QWidget* parent = nullptr);
  ~VolumePanel() override;

  /// Draws the measured volumes of a tracked motion as dots, and shows `table`, of which it becomes the
  /// parent, in a tab beside the chart while there is such a motion.
  void setMeasured(MeasuredMotion& measured, QWidget* table);
  /// The height that the table needs with its tab; none without it.
  std::optional<int> wantedHeight() const;

  void setTheme(const Theme& theme);
  /// Sets whether to draw one cycle with a cursor at the present instant, or the last seconds.
  void setCycleShown(bool shown);
  /// Shows the normal ranges of that line.
  void setNormalsOf(std::size_t line);
  /// A text about the stripes in the chart and their source; empty when there are none.
  QString normalsText() const;

Q_SIGNALS:
  /// `wantedHeight` has changed.
  void wantedHeightChanged();

protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  struct Tile {
    QLabel* value = nullptr;
    QLabel* detail = nullptr;
  };

  QWidget* makeTiles();
  /// The width of the longest detail in the language of the window.
  int tileWidth() const;
  void makeChart();
  void rebuild();
  /// Whether `rebuild` has followed the monitor's lines; another observer of these may show the panel before.
  bool followsLines() const { return tiles_.size() == monitor_.lines().size(); }
  void refresh();
  /// Refreshes without drawing the same cycle again.
  void refreshIfNew();
  /// Updates what follows every frame: the numbers and the cursor.
  void followFrame();
  void placeCursor();
  double cycleLength() const;
  /// Whether the document's own pose is looked at: the numbers of a beat say nothing about it.
  bool posed() const { return playback_.wantedPose() != live::WantedPose::sequence; }
  bool cycleDrawn() const { return cycleShown_ && !posed() && !dragsShown(); }
  /// Whether the chart shows the last drags, because no sequence is shown.
  bool dragsShown() const { return !playback_.showing() && monitor_.drags().rows() >= 2; }
  void take(const sequences::VolumeRecord* record);
  void draw();
  void drawCycle();
  void drawRecord();
  void syncNormals();
  void showNormalsOfChosen();
  QStringList normalsForms() const;
  std::size_t prescribedLine() const;
  void syncPrescribed();
  void drawPrescribed(double length);
  void syncMeasured();
  void showTab(int tab);
  void drawMeasured(double length);
  Tile addTile(const VolumeMonitor::Line& line);
  QString detailOf(std::size_t line) const;

  VolumeMonitor& monitor_;
  Playback& playback_;
  ViewModel& view_;
  std::unique_ptr<scene::VolumeChart> chart_;
  QVTKOpenGLNativeWidget* chartWidget_;
  ChartCursor* cursor_;
  QVBoxLayout* column_ = nullptr; ///< Tabs, and the chart or the table.
  QTabBar* tabs_;                 ///< Shown where there is a table.
  QWidget* chartTab_;
  QStackedLayout* stack_;         ///< A hint, or the chart.
  ElidedLabel* source_ = nullptr; ///< Explains the stripes.
  QWidget* normals_ = nullptr;    ///< Contains `source_` and the choice of the person.
  anatomy::Person person_;
  QWidget* tileBox_ = nullptr;
  QWidget* tileArea_;
  std::vector<Tile> tiles_;
  const sequences::VolumeRecord* shown_ = nullptr; ///< The record in the chart; null: one cycle.
  int drawnCycles_ = -1;       ///< Value of the monitor's `cycles` when the chart was drawn.
  std::size_t normalsOf_ = 0;  ///< The line whose normal ranges are drawn.
  bool normalsBeat_ = false;   ///< Whether that line had a beat when they were drawn.
  std::size_t prescribed_ = 0; ///< The line whose prescribed volume is drawn; behind the last one: none.
  /// A line of measured volumes in the chart.
  struct Dots {
    std::size_t line = 0;    ///< Of the organ.
    std::size_t surface = 0; ///< Of the measured motion, or of the one before it.
    bool before = false;     ///< A dashed line.
  };
  MeasuredMotion* measured_ = nullptr;
  QWidget* table_ = nullptr;
  std::vector<Dots> dots_; ///< Behind the organs' lines.
  bool cycleShown_ = true;
  std::size_t charted_ = 0; ///< Rows of the record that the chart has.
  double chartedUntil_ = 0;
  QTimer drawing_; ///< Ends when the chart is to be drawn.
};

} // namespace viscera::app

#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <memory>
#include <vector>

#include "viscera/scene/volume_chart.h"
#include "window/style/theme.h"
#include "window/timeline/volume_monitor.h"

class QHBoxLayout;
class QLabel;
class QStackedLayout;

namespace viscera::app {

/// The volumes as numbers and as a live chart, with ejection fraction and stroke volume.
class VolumePanel final : public QWidget {
  Q_OBJECT

public:
  explicit VolumePanel(VolumeMonitor& monitor, Playback& playback, QWidget* parent = nullptr);
  ~VolumePanel() override;

  void setTheme(const Theme& theme);

protected:
  void showEvent(QShowEvent* event) override;

private:
  struct Tile {
    QLabel* value = nullptr;
    QLabel* detail = nullptr;
  };

  void rebuild();
  void refresh();
  /// What the chart shows: the sequence, or the drags when none is on show.
  const session::VolumeRecord& shownRecord();
  Tile addTile(const VolumeMonitor::Line& line);
  QString detailOf(std::size_t line) const;

  VolumeMonitor& monitor_;
  Playback& playback_;
  std::unique_ptr<scene::VolumeChart> chart_;
  QVTKOpenGLNativeWidget* chartWidget_;
  QStackedLayout* stack_; ///< A hint, or the chart.
  QWidget* tileBox_ = nullptr;
  QWidget* tileArea_;
  std::vector<Tile> tiles_;
  const session::VolumeRecord* shown_ = nullptr;
  std::size_t charted_ = 0; ///< Rows of the record that the chart has.
  double chartedUntil_ = 0;
};

} // namespace viscera::app

#pragma once

#include <QWidget>

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/scene/color_map.h"

namespace viscera::app {

/// A widget that draws the histogram of a stress map: bars in the colours of a map over its range, with a
/// line at the mean and one at the 95th percentile, and values outside of the limit dimmed.
class Histogram final : public QWidget {
  Q_OBJECT

public:
  explicit Histogram(QWidget* parent = nullptr);

  struct Contents {
    scene::ColorMap colors;
    scene::ValueRange range;
    double mean = 0;
    double percentile95 = 0;
    scene::ValueRange shown{-1e300, 1e300}; ///< Values within the limit.
  };

  /// Counts the first `count` of `values`: numbers beyond the range in the bars at its ends, NaN nowhere.
  void show(const Values& values, Eigen::Index count, const Contents& contents);
  void clear();
  /// Numbers in each bar.
  const std::vector<int>& bars() const { return bars_; }

  QSize sizeHint() const override { return {200, minimumHeight()}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  double xOf(double value) const;

  Contents contents_;
  std::vector<int> bars_;
};

} // namespace viscera::app

#pragma once

#include <QTableWidget>

#include <cstddef>

#include "window/slices/slice_widget.h"
#include "window/style/theme.h"
#include "window/timeline/measured_motion.h"

namespace viscera::app {

/// A table of the planes of a motion that was found from images: what each says of the phase that is shown,
/// its weight there and over the beat, and why it says little, with its light. Empty for other motions.
class PlaneTable final : public QTableWidget {
  Q_OBJECT

public:
  explicit PlaneTable(MeasuredMotion& measured, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  /// Fills the table for a motion, and for the present phase.
  void fill();

private:
  void fillRow(int row, const live::CinePlaneUse& plane, std::size_t phase);

  MeasuredMotion& measured_;
  Theme theme_;
};

/// What a slice of the document's study said of the phase that is shown, for its pane: weight and quality in
/// words with their light. Empty while the organs are not posed by a motion from these images.
SliceVerdict planeVerdict(const MeasuredMotion& measured, const Playback& playback, std::size_t slice);

} // namespace viscera::app

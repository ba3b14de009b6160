#pragma once

#include <QFont>
#include <QImage>
#include <QSize>

#include <memory>
#include <optional>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "viscera/presentation/circulation_figure.h"
#include "viscera/scene/theme.h"
#include "window/circulation/circulation_model.h"
#include "window/timeline/beat_drawing.h"
#include "window/timeline/playback.h"

namespace viscera::app {

/// The physiology of the beating heart below the picture of a movie, drawn as below the view of a lecture:
/// the charts of its circulation, or the strip of the textbook's beat. A copy of what is shown when the
/// recording begins. Created on the main thread, used on one other.
class MovieSigns {
public:
  /// Only read while the signs are made.
  struct Source {
    const Playback& playback;
    const CirculationModel& circulation;
    presentation::HeartSigns signs; ///< What is drawn of it.
    scene::Theme theme;
  };

  /// Null where the motion has none of what is chosen. `movie` is the size of the whole picture.
  static std::unique_ptr<MovieSigns> of(const Source& source, const QSize& movie);

  /// The height of the picture below the view's, pixels; an even number.
  int height() const { return size_.height(); }
  /// Draws the signs at a fraction of the cycle in [0, 1]. Throws `Error` when nothing can be drawn.
  vtkSmartPointer<vtkImageData> picture(double fraction);

private:
  /// A circulation, and the one kept to compare with.
  struct Curves {
    presentation::ShownCirculation shown;
    std::optional<presentation::ShownCirculation> before;
    bool marked = false; ///< The heart beats with it, so that the curves have its instant.
  };

  MovieSigns(const Source& source, const QSize& movie);

  void drawCurves();

  presentation::HeartSigns signs_;
  scene::Theme theme_;
  QFont type_;
  QSize size_;
  double scale_ = 1; ///< Of the strip.
  BeatDrawing drawing_;
  std::optional<Curves> curves_;          ///< None: the strip is drawn.
  QImage ground_;                         ///< What does not change from frame to frame.
  int legendHeight_ = 0;                  ///< Above the charts.
  std::vector<scene::CurvePanel> places_; ///< The panels that are drawn.
};

/// One picture above another of the same width.
vtkSmartPointer<vtkImageData> aboveEachOther(vtkImageData* upper, vtkImageData* lower);

} // namespace viscera::app

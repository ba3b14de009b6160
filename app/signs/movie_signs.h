#pragma once

#include <QFont>
#include <QImage>
#include <QSize>

#include <memory>
#include <optional>
#include <vector>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "signs/beat_drawing.h"
#include "viscera/core/phrase.h"
#include "viscera/presentation/circulation_figure.h"
#include "viscera/scene/theme.h"

namespace viscera::app {

/// The physiology of the beating heart below a picture, drawn as below the view of a lecture: the charts of
/// its circulation, or the strip of the textbook's beat. Movies of the window, and movies and pictures of the
/// command line have it. Created on the main thread, used there or on one other.
class MovieSigns {
public:
  /// A circulation, and the one kept to compare with.
  struct Curves {
    presentation::ShownCirculation shown;
    std::optional<presentation::ShownCirculation> before;
    bool marked = false; ///< The heart beats with it, so that the curves have its instant.
  };
  /// What is drawn, and how.
  struct Source {
    std::optional<Curves> curves;           ///< None: the strip of `beat` is drawn.
    std::optional<heart::CardiacBeat> beat; ///< The textbook's.
    presentation::HeartSigns signs;         ///< What is drawn of it.
    scene::Theme theme;
    QFont type; ///< The type of a movie of usual height.
    Wording language;
  };

  /// Null where there is none of what is chosen. `picture` is the size of the whole picture.
  static std::unique_ptr<MovieSigns> of(Source source, const QSize& picture);

  /// The height of the picture below the view's, pixels; an even number.
  int height() const { return size_.height(); }
  /// Draws the signs at a fraction of the cycle in [0, 1]. Throws `Error` when nothing can be drawn.
  vtkSmartPointer<vtkImageData> picture(double fraction);

private:
  MovieSigns(Source source, const QSize& picture);

  void drawCurves();

  Source source_;
  QSize size_;
  double scale_ = 1; ///< Of the strip.
  BeatDrawing drawing_;
  QImage ground_;                         ///< What does not change from frame to frame.
  int legendHeight_ = 0;                  ///< Above the charts.
  std::vector<scene::CurvePanel> places_; ///< The panels that are drawn.
};

/// One picture above another of the same width.
vtkSmartPointer<vtkImageData> aboveEachOther(vtkImageData* upper, vtkImageData* lower);

} // namespace viscera::app

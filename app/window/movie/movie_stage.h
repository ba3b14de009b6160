#pragma once

#include <QSize>
#include <QString>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include "viscera/live/motion_runner.h"
#include "viscera/live/posed_organs.h"
#include "viscera/presentation/presenter.h"
#include "viscera/presentation/stage.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// A copy of a view and its organs, made when the recording of a movie begins: changes that the user makes in
/// the meantime do not affect the movie. Created on the main thread, used on one other.
class MovieStage {
public:
  /// The view to record; only read by the constructor.
  struct Source {
    Workspace& workspace;
    Playback& playback;
    const Picture& picture;
    /// The segments of a heart's wall as colours at an instant of the sequence, for any thread; empty: none.
    std::function<presentation::SurfaceMap(double seconds)> segments;
  };

  /// Sets the stage for pictures of this size.
  MovieStage(const Source& source, const QSize& size, bool caption);

  /// Poses the organs at `seconds` of the sequence, as the window would show them; organs without one stay as
  /// they are. Returns the volumes of what is tracked, ml.
  const std::vector<double>& show(double seconds);
  const std::vector<std::string>& names() const { return names_; } ///< Names of the tracked organs.
  /// Draws the pose that is shown, as the window would. Throws `Error` when nothing can be drawn.
  vtkSmartPointer<vtkImageData> picture();

  double periodSeconds() const { return runner_.periodSeconds(); }

private:
  void openStage();
  void addCaption();
  void writeCaption();

  coordinates::Registry systems_;
  document::DocumentState state_;
  live::PosedCopy organs_;
  live::StressCopy stress_;
  live::MotionRunner runner_;
  presentation::ViewState view_;
  std::optional<scene::ValueRange> stressRange_; ///< Range of both views at the start.
  bool stressLegend_;
  std::shared_ptr<const live::HeartTissue> heartTissue_;
  std::function<presentation::SurfaceMap(double)> segments_;
  scene::Theme theme_;
  QSize size_;
  bool captionWanted_;
  double seconds_ = 0;
  std::vector<std::string> names_;
  std::vector<double> milliliters_; ///< One for each name, in the pose that is shown.
  vtkNew<vtkTextActor> caption_;
  std::unique_ptr<presentation::Stage> stage_; ///< Belongs to the thread that draws.
};

/// Two pictures of the same height beside one another.
vtkSmartPointer<vtkImageData> besideEachOther(vtkImageData* left, vtkImageData* right);

} // namespace viscera::app

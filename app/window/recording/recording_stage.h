#pragma once

#include <QSize>
#include <QString>

#include <memory>
#include <string>
#include <vector>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include "viscera/live/posed_copy.h"
#include "viscera/motion/motion_runner.h"
#include "viscera/scene/measurement_glyphs.h"
#include "viscera/scene/organ_labels.h"
#include "viscera/scene/organ_view.h"
#include "viscera/scene/surfaceless_window.h"
#include "window/timeline/playback.h"
#include "window/workspace.h"

namespace viscera::app {

/// The organs of one view as they were when a recording began, with poses of their own: whatever the user
/// does in the meantime, the recording goes on as it was. For the main thread.
class RecordingStage {
public:
  /// What is recorded.
  struct Source {
    Workspace& workspace;
    Playback& playback;
    scene::OrganView& view; ///< Its camera and colours are taken over.
    bool labels = false;
    bool measurements = false;
  };

  explicit RecordingStage(const Source& source);
  ~RecordingStage();

  /// Takes over the look of the view, for pictures of this size. On the main thread.
  void prepareView(const Source& source, const QSize& size, bool caption);

  /// Poses the organs at `seconds` of the sequence, as the window would show them; organs without one stay as
  /// they are. Returns the volumes of what is tracked, ml.
  const std::vector<double>& show(double seconds);
  const std::vector<std::string>& names() const { return names_; } ///< Of what is tracked.
  /// Draws the pose that is shown, after `prepareView`. Throws `Error` when nothing can be drawn.
  vtkSmartPointer<vtkImageData> picture();

  double periodSeconds() const;

private:
  struct Surface {
    std::shared_ptr<const document::Organ> organ;
    std::shared_ptr<scene::OrganActor> actor;
  };

  void addActors();
  void addLabels(const document::Document& document);
  void addCaption(const Vec3& color);
  void openWindow();
  void measure();
  void writeCaption();

  document::DocumentState state_;
  live::PosedCopy organs_;
  motion::MotionRunner runner_;
  double seconds_ = 0;
  std::vector<Surface> surfaces_;
  std::vector<std::string> names_;
  std::vector<double> milliliters_; ///< One a name, of the pose that is shown.
  QSize size_;
  std::unique_ptr<scene::SurfacelessWindow> window_; ///< Of the thread that draws.
  std::unique_ptr<scene::OrganView> view_;
  std::unique_ptr<scene::OrganLabels> labels_;
  std::unique_ptr<scene::MeasurementGlyphs> measurements_;
  vtkNew<vtkTextActor> caption_;
  bool captionShown_ = false;
};

/// Two pictures of the same height beside one another.
vtkSmartPointer<vtkImageData> besideEachOther(vtkImageData* left, vtkImageData* right);

} // namespace viscera::app

#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "viscera/presentation/cine_presenter.h"
#include "window/view/view_model.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// What the panes beside the 3D view show of a cine study, and what wheel and mouse do there. `SlicePanes`
/// has the widgets, and asks this while the document has a study.
class CinePanes {
public:
  /// Both have to live longer.
  CinePanes(Workspace& workspace, ViewModel& model);

  /// Whether the document has a study.
  bool shown() const { return workspace_.state().study != nullptr; }
  void update(const presentation::SliceScene& scene, const std::vector<presentation::SlicePane>& panes) {
    presenter_.update(scene, panes);
  }
  /// The same as of `presentation::CinePresenter`, of the last update.
  const scene::SlicePicture& picture(int pane) const { return presenter_.picture(pane); }
  const medical_io::SliceFrame& frame(int pane) const { return presenter_.frame(pane); }
  presentation::SliceReading read(int pane, const Eigen::Vector2d& pixel) const {
    return presenter_.read(pane, pixel);
  }
  const presentation::CinePresenter& presenter() const { return presenter_; }
  void setBent(std::optional<presentation::BentContour> bent) { presenter_.setBent(std::move(bent)); }

  /// Shows the slice so many turns of the wheel further in its stack, or the next long axis.
  void scroll(int pane, double steps);
  /// The level and width that are shown.
  medical_io::ValueWindow window() const;

private:
  Workspace& workspace_;
  ViewModel& model_;
  presentation::CinePresenter presenter_;
};

} // namespace viscera::app

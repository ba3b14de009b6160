#pragma once

#include <QMenu>
#include <QObject>

#include <memory>
#include <optional>

#include "viscera/presentation/contour_bend.h"
#include "window/slices/slice_grip.h"
#include "window/slices/slice_panes.h"
#include "window/timeline/playback.h"
#include "window/track/contour_corrector.h"
#include "window/work/actions.h"

namespace viscera::app {

/// Drags the contour of a tracked organ in a pane of the study, while "Correct contours" is on or with Ctrl.
/// The contour bends under the mouse; at the release the motion is fitted to it. Escape cancels the drag.
class ContourGrip final : public QObject, public SliceGrip {
  Q_OBJECT

public:
  /// All have to live longer.
  ContourGrip(Workspace& workspace, SlicePanes& panes, ContourCorrector& corrector, Playback& playback,
              QObject* parent = nullptr);
  ~ContourGrip() override;

  /// Adds "study.correctContours" and a menu of the document's corrections to remove to the menu of slices.
  void addTo(Actions& actions, QMenu& menu);

  bool press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) override;
  void drag(int direction, const Eigen::Vector2d& pixel) override;
  void release(int direction, const Eigen::Vector2d& pixel, bool moved) override;
  std::optional<Qt::CursorShape> hover(int direction, const std::optional<Eigen::Vector2d>& pixel) override;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  /// A contour that is dragged.
  struct Held {
    presentation::ContourBend bend;
    document::OrganId organ;
    std::size_t phase = 0, slice = 0;
    Vec3 offset = Vec3::Zero(); ///< From the mouse to the grabbed place, mm.
  };

  std::optional<presentation::ContourPlace> placeAt(int direction, const Eigen::Vector2d& pixel) const;
  void show(int direction);
  void drop();
  void fillMenu();

  Workspace& workspace_;
  SlicePanes& panes_;
  ContourCorrector& corrector_;
  Playback& playback_;
  QMenu corrections_;
  bool on_ = false;
  std::optional<Held> held_;
};

} // namespace viscera::app

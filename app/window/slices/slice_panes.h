#pragma once

#include <QObject>

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "viscera/presentation/presenter.h"
#include "viscera/presentation/slice_presenter.h"
#include "window/slices/cine_panes.h"
#include "window/slices/slice_grip.h"
#include "window/slices/slice_widget.h"
#include "window/view/view_area.h"
#include "window/view/view_model.h"
#include "window/work/workspace.h"

class QMenu;

namespace viscera::app {

class Picture;

/// Manages the three slices beside the 3D view, of the scan or of a cine study, and handles the mouse on them
/// by changing the view's state. As with `Picture`, every change of the document, of its organs and of that
/// state only marks the slices as out of date; they are brought up to date once, before the next frame or
/// when something reads them.
class SlicePanes final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer. `picture` is the 3D view's, with the same handles; `menu` opens at the right
  /// button.
  SlicePanes(Workspace& workspace, ViewModel& model, Picture& picture, ViewArea& area, QMenu& menu,
             QObject* parent = nullptr);
  ~SlicePanes() override;

  void setTheme(const Theme& theme);
  SliceWidget& widget(int direction) { return *widgets_[static_cast<std::size_t>(direction)]; }
  /// The presenter, up to date.
  const presentation::SlicePresenter& presenter() {
    bringUpToDate();
    return presenter_;
  }

  /// Adds a tool, which has to live longer, that gets the left button before the slices do; tools are asked
  /// in the order in which they were added.
  void addGrip(SliceGrip& grip) { grips_.push_back(&grip); }
  /// The same, before the others, for the slices of a cine study alone.
  void addCineGrip(SliceGrip& grip) { cineGrips_.push_back(&grip); }
  /// What tools ask of a pane, of the scan's slice or of the study's: its frame, up to date, the normal of
  /// its plane, the row of the handle there or -1, and the measured point there.
  const medical_io::SliceFrame& frameNow(int direction);
  Vec3 normalOf(int direction);
  int handleAt(int direction, const Eigen::Vector2d& pixel);
  std::optional<scene::MeasurementGlyphs::Mark> measuredAt(int direction, const Eigen::Vector2d& pixel);
  /// The largest distance from the mouse at which something can be grabbed, in pixels of a slice's picture.
  double reach(int direction) const;
  /// Where the tissue drawn at a place of a slice is at rest, mm, and the reverse: other places in a warped
  /// scan only.
  Vec3 restOf(const Vec3& place) const;
  Vec3 drawnAt(const Vec3& rest) const;
  /// Sets the measurement under way, which the slices draw.
  void setMeasuring(presentation::PendingMeasurement measuring);

  /// Sets what is said of a slice of the document's cine study in its pane; null: nothing.
  void setVerdicts(std::function<SliceVerdict(std::size_t slice)> verdicts) {
    verdicts_ = std::move(verdicts);
    markOutdated();
  }

  /// Marks the slices as out of date and schedules the rendering of those that are visible.
  void markOutdated();
  /// The slices of a cine study; the panes show them while the document has one.
  const CinePanes& cine() const { return cine_; }
  /// The same, up to date.
  const CinePanes& cineNow() {
    bringUpToDate();
    return cine_;
  }
  /// Sets the contour that a user bends in a slice of a study; none: no contour.
  void setBent(std::optional<presentation::BentContour> bent);
  /// Moves a slice by so many of the scan's voxels, towards head, front and right.
  void scroll(int direction, double steps);

Q_SIGNALS:
  /// The visible slices were brought up to date after changes: once for each frame, before it is rendered,
  /// unless something has read them in between.
  void changed();

private:
  void bringUpToDate();
  void updateScan(presentation::SliceScene scene, const std::vector<presentation::SlicePane>& shown,
                  const presentation::Warping* warping);
  void connectWidget(int direction);
  void connectGrips(int direction);
  void hover(int direction, const std::optional<Eigen::Vector2d>& pixel);
  void arrange();
  void followWarp();
  void moveCross(int direction, const Eigen::Vector2d& pixel);
  void dragWindow(const QPointF& by);
  void pan(int direction, const QPointF& by);
  void zoom(int direction, double factor, const Eigen::Vector2d& around);
  void isolate(int direction);
  void read(int direction, const std::optional<Eigen::Vector2d>& pixel);
  std::vector<presentation::SlicePane> panes() const;
  const medical_io::SliceFrame& frame(int direction) const;

  Workspace& workspace_;
  ViewModel& model_;
  Picture& picture_;
  ViewArea& area_;
  std::array<SliceWidget*, 3> widgets_{};
  presentation::SlicePresenter presenter_;
  CinePanes cine_;
  std::function<SliceVerdict(std::size_t slice)> verdicts_;
  bool outdated_ = true;
  std::array<std::optional<Eigen::Vector2d>, 3> cursor_;
  /// The tools that are asked for the slices that are shown, the first ones first.
  std::vector<SliceGrip*> gripsNow() const;
  std::vector<SliceGrip*> grips_, cineGrips_;
  SliceGrip* holding_ = nullptr; ///< The tool that handles the present drag.
  presentation::PendingMeasurement measuring_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app

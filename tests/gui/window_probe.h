#pragma once

#include <QTest>

#include <sstream>
#include <string>
#include <vector>

#include <vtkImageData.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "viscera/scene/picture.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/compare/comparison.h"
#include "window/main_window.h"
#include "window/play/play_mode.h"
#include "window/stress/stress_mode.h"
#include "window/view/view_area.h"

/// Reads what a window shows from its parts, so that tests of the whole window do not depend on its structure
/// elsewhere.
namespace viscera::tests {

/// Drivers and instruments differ in the last bits of colours and at edges.
inline constexpr int kSameColor = 8;
inline constexpr double kMostDiffering = 0.005;

/// Where an organ is drawn, or why it is not.
struct ShownOrgan {
  bool drawn = false;
  bool visible = false;
  bool colouredByNumbers = false;
  Points points; ///< `n x 3`, mm: what the actor's memory holds.
};

inline scene::OrganView& viewOf(app::MainWindow& window) {
  return window.viewArea().view()->view();
}

inline int shownHandleCount(app::MainWindow& window) {
  return viewOf(window).handles()->GetNumberOfHandles();
}

inline Points shownHandlePositions(app::MainWindow& window) {
  return viewOf(window).handles()->GetPositions();
}

inline int actorCount(app::MainWindow& window) {
  return static_cast<int>(viewOf(window).organs().size());
}

/// All visible props of the 3D view's renderer.
inline std::vector<vtkProp*> visibleProps(app::MainWindow& window) {
  std::vector<vtkProp*> seen;
  vtkPropCollection* props = viewOf(window).renderer()->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* prop = props->GetNextProp(place))
    if (prop->GetVisibility())
      seen.push_back(prop);
  return seen;
}

/// The actors that show an organ's surface; there should be one.
inline std::vector<scene::OrganActor*> actorsOf(app::MainWindow& window, const document::Organ& organ) {
  std::vector<scene::OrganActor*> found;
  for (const auto& actor : viewOf(window).organs())
    if (&actor->mesh() == organ.mesh.get())
      found.push_back(actor.get());
  return found;
}

inline ShownOrgan shownOrgan(app::MainWindow& window, const document::Organ& organ) {
  const auto actors = actorsOf(window, organ);
  ShownOrgan shown;
  if (actors.size() != 1)
    return shown;
  shown.drawn = true;
  shown.visible = actors.front()->visible();
  shown.colouredByNumbers = actors.front()->scalarsShown();
  shown.points = actors.front()->points();
  return shown;
}

/// Whether an organ is to be seen outside of Stress: as the slide that is shown has it, else the document.
inline bool wantedVisible(app::MainWindow& window, const document::Organ& organ) {
  const presentation::OrgansSeen& slide = window.viewModel().state().organsSeen;
  const auto found = slide.find(organ.id);
  return found == slide.end() ? organ.look.visible : found->second.visible;
}

/// The differences between the 3D view and the document with its live binding; empty for none.
inline std::string disagreement(app::MainWindow& window) {
  std::ostringstream wrong;
  const document::DocumentState& state = window.workspace().state();
  const auto handles = static_cast<Eigen::Index>(state.rig->handles.size());
  const Points& shown = window.workspace().live().shownPose();
  if (state.pose->rows() != handles || shown.rows() != handles)
    wrong << "poses have " << state.pose->rows() << " and " << shown.rows() << " rows for " << handles
          << " handles; ";
  else if (shownHandleCount(window) != handles)
    wrong << shownHandleCount(window) << " handles are drawn, " << handles << " there are; ";
  else if (handles > 0 && shownHandlePositions(window) != shown)
    wrong << "handles are drawn " << (shownHandlePositions(window) - shown).rowwise().norm().maxCoeff()
          << " mm from where they are; ";
  if (actorCount(window) != static_cast<int>(state.organs->size()))
    wrong << actorCount(window) << " organs are drawn, " << state.organs->size() << " there are; ";
  for (const auto& organ : *state.organs) {
    const ShownOrgan drawn = shownOrgan(window, *organ);
    if (!drawn.drawn)
      wrong << organ->name << " is not drawn once; ";
    else if (drawn.points != window.workspace().live().points(organ->id))
      wrong << organ->name << " is drawn with other points than it has; ";
    else if (window.mode() != "stress" && drawn.visible != wantedVisible(window, *organ))
      wrong << organ->name << (drawn.visible ? " is seen though hidden; " : " is not seen; ");
  }
  return wrong.str();
}

/// The difference between the displayed pose and that at the timeline's instant, with the volumes that are
/// locked or prescribed; empty when they agree, and where those volumes cannot be kept. A timeline that is
/// not followed stands at the beginning.
inline std::string offTheTimeline(app::Workspace& workspace, app::Playback& playback) {
  if (!playback.sequence())
    return {};
  const double fraction = playback.player().fraction();
  if (!playback.showing())
    return fraction == 0 ? std::string()
                         : "the timeline stands at " + std::to_string(fraction) + ", nothing follows it; ";
  live::MotionRunner runner(workspace.state(), workspace.live());
  runner.setSequence(playback.sharedSequence());
  runner.setRatePerMinute(playback.player().ratePerMinute());
  runner.prescribe(playback.player().runner().prescribed());
  const std::optional<Points> pose = runner.poseAt(playback.player().secondsInCycle());
  if (!pose)
    return {}; // The last pose in which they could be kept stays.
  const Points& shown = workspace.live().shownPose();
  if (shown.rows() != pose->rows())
    return "the timeline moves other handles than there are; ";
  const double off = (shown - *pose).cwiseAbs().maxCoeff();
  return off <= 1e-9 ? std::string()
                     : "the pose is " + std::to_string(off) + " mm from the timeline's at " +
                           std::to_string(fraction) + "; ";
}

/// Whether no job runs and every organ is bound.
inline bool atPeace(app::Workspace& workspace) {
  return workspace.jobs().idle() && !workspace.live().busy();
}

/// The same in both views, and whether the stress map is computed in its mode.
inline bool atPeace(app::MainWindow& window) {
  app::Workspace& workspace = window.workspace();
  app::Comparison& comparison = window.play().comparison();
  if (!atPeace(workspace) || (comparison.on() && !atPeace(comparison.workspace())))
    return false;
  if (window.mode() != "stress" || workspace.document().organs().empty())
    return true;
  using State = live::StressStatus::State;
  const State state = workspace.stress().status().state;
  return state == State::ready || state == State::failed || state == State::cancelled;
}

/// The 3D view's own pixels, without the widgets over it, with the mouse away from everything.
inline vtkSmartPointer<vtkImageData> grab(app::MainWindow& window) {
  QTest::mouseMove(&window, QPoint(2, 2));
  QTest::qWait(60);
  viewOf(window).setMoving(false);
  return scene::grabPicture(viewOf(window).window());
}

/// Makes the 3D view that large, in pixels.
inline void setViewSize(app::MainWindow& window, int width, int height) {
  window.viewArea().view()->setFixedSize(width, height);
  QTest::qWait(20);
}

} // namespace viscera::tests

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/scene/helper_glyphs.h"
#include "viscera/scene/legend.h"
#include "viscera/scene/organ_actor.h"
#include "viscera/scene/region_hulls.h"
#include "viscera/scene/surface_pick.h"
#include "viscera/scene/theme.h"

class vtkRenderer;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkVisceraGizmoRepresentation;
class vtkVisceraGizmoWidget;
class vtkVisceraHandleSetRepresentation;
class vtkVisceraHandleSetWidget;

namespace viscera::scene {

/// The standard directions from which the camera looks at the patient. In the anterior view the reader faces
/// the patient: the patient's left is on the right.
enum class StandardView { anterior, posterior, left, right, superior, inferior };

/// "anterior" and so on. Throws `UsageError` that lists them for anything else.
StandardView standardViewFromName(const std::string& name);
std::string nameOf(StandardView view);

/// What lets a software renderer draw sooner while something moves (`OrganView::setMoving`). Each is there to
/// be switched off by a benchmark, which tells then within one run what it saves.
struct Shortcuts {
  bool fewerTriangles = true; ///< Of organs that have more than 30,000 vertices together.
  bool blending = true;       ///< Of translucent organs, in place of peeling them.
};

/// The 3D view: renderer, lights, background, camera, orientation cube, scale bar, legend, handles. It draws
/// into any vtkRenderWindow (Qt's, a plain one, a surfaceless one) and reads the density of the screen from
/// the window's DPI (72 DPI is one device pixel a logical pixel). Belongs to the thread that renders it;
/// views with organs and windows of their own may be rendered by several threads at once.
class OrganView {
public:
  OrganView();
  ~OrganView();
  OrganView(const OrganView&) = delete;
  OrganView& operator=(const OrganView&) = delete;

  /// Draws in `window` and adds the renderers to it. Edges are smoothed by four samples a pixel; see
  /// `setMoving` for software renderers. Null detaches from the present window; the window has to outlive the
  /// view or be detached first.
  void setWindow(vtkRenderWindow* window);
  vtkRenderWindow* window() const;
  /// Gives the interactor our mouse (left rotates, middle or Shift+left pans, right drag or wheel zooms; no
  /// single-letter keys) and enables the handle widget on it. Null: none.
  void setInteractor(vtkRenderWindowInteractor* interactor);
  vtkRenderer* renderer() const;

  void setTheme(const Theme& theme);
  const Theme& theme() const;

  /// Organs in the view; they hide handles while opaque. Adding one twice or removing an unknown one does
  /// nothing.
  void add(std::shared_ptr<OrganActor> organ);
  void remove(const std::shared_ptr<OrganActor>& organ);
  void clear();
  const std::vector<std::shared_ptr<OrganActor>>& organs() const;

  /// Box of the visible organs, and of what else is framed; of all handles when there is none. O(vertices).
  Bounds bounds() const;
  /// Sets a function that returns the box of something else to frame, which is drawn in place of organs, if
  /// it exists. Null: nothing.
  void setAlsoFramed(std::function<std::optional<Bounds>()> box);

  /// Moves the camera to a standard view of everything that is shown, and frames it.
  void lookFrom(StandardView view);
  void lookFrom(StandardView view, const Bounds& bounds);
  /// Frames the box with a small margin, and keeps the direction of sight.
  void frame(const Bounds& bounds);
  void frame();
  /// Tells the view that the present camera was stored for a picture with a legend: a legend that appears
  /// later, because its numbers are still being computed, does not move the camera.
  void expectLegend();

  vtkVisceraHandleSetRepresentation* handles() const;
  vtkVisceraHandleSetWidget* handleWidget() const;
  /// The gizmo that rotates and scales; hidden at first.
  vtkVisceraGizmoRepresentation* gizmo() const;
  vtkVisceraGizmoWidget* gizmoWidget() const;
  ConstraintGlyph& constraint();
  RegionHulls& regions();
  MirrorPlaneGlyph& mirrorPlane();
  Legend& legend();

  void setOrientationCubeShown(bool shown);
  /// The side of the body whose face or letter of the orientation cube is at a display position (device
  /// pixels from the lower left corner) in the last frame; none beside the cube, and while it is hidden.
  std::optional<StandardView> orientationSideAt(double x, double y) const;
  /// Highlights a side of the cube from the next frame on, or none; returns whether that changes the picture.
  bool highlightOrientationSide(std::optional<StandardView> side);
  void setScaleBarShown(bool shown);
  /// Sets the decimal mark of numbers in the view, a point by default: ',' in German. Call it before the
  /// legend and measurements are shown.
  void setDecimalMark(char mark);
  char decimalMark() const;

  /// Sets whether something moves. Meanwhile a software renderer does not smooth edges, which takes as long
  /// as all the rest, blends translucent organs in order of their distance instead of peeling them, which
  /// takes four times as long, and draws one in two, four, ... vertices of the organs if they have more than
  /// 30,000 together. The view detects motion by the mouse itself; code that plays a sequence calls this, and
  /// renders once more at the end.
  void setMoving(bool moving);
  bool moving() const;
  /// Draws the following frames as quickly as those of a motion. If `isSlow`, code that responds to an event
  /// calls it with true, renders, calls it with false, and renders once more when no other event follows.
  /// Labels are still laid out anew.
  void setFastDrawing(bool quick);
  /// Sets the shortcuts that are taken then; all of them to begin with. Counts from the next frame on.
  void setShortcuts(const Shortcuts& shortcuts);
  /// Whether a whole, smooth frame takes so long that a quick one is drawn first: a software renderer draws
  /// more than 30,000 vertices, or peels translucent organs. Never before the first frame. O(organs).
  bool isSlow() const;

  /// How the triangles of all organs are seen. A quick frame that leaves some of them out has no edges.
  void setMeshLook(const MeshLook& look);
  const MeshLook& meshLook() const;

  /// What is under a display position (device pixels from the lower left corner).
  std::optional<SurfacePick> pick(double x, double y) const;
  /// The opaque organ that hides one of the view's organs from the present camera; null if a part of it is
  /// visible, or if it is not shown. Tests two dozen of its vertices, each of which costs as much as a pick.
  const OrganActor* coverOf(const OrganActor& organ) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Device pixels in a logical pixel: the window's DPI over 72, at least 1.
double pixelRatioOf(vtkRenderWindow* window);

/// Whether a window renders on the processor (llvmpipe, softpipe, swrast, SWR). The window's context has to
/// exist: call it after the first render or `Start()`.
bool rendersInSoftware(vtkRenderWindow* window);

} // namespace viscera::scene

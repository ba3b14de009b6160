#pragma once

#include <QObject>

#include <memory>

#include "viscera/scene/depth_shading.h"
#include "window/view/picture.h"
#include "window/view/view_area.h"
#include "window/view/view_model.h"
#include "window/work/actions.h"
#include "window/work/settings.h"

namespace viscera::app {

/// The actions for the camera, for what every mode can show or hide, and for saving pictures.
class ViewActions final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window that the actions change; all have to live longer.
  struct Parts {
    Workspace& workspace;
    const Picture& picture;
    ViewArea& area;
    ViewModel& view;
    Settings& settings;
  };

  /// Adds the standard views, "view.focus", the switches of the view and "file.screenshot".
  ViewActions(const Parts& parts, Actions& actions, QObject* parent = nullptr);

  void lookFrom(scene::StandardView from);
  /// Frames the selected organ, or all. If another organ hides it, shows a message that offers to show it
  /// alone.
  void focus();

private:
  void makeViews(Actions& actions);
  void makeSwitches(Actions& actions);
  void makeShading(Actions& actions);
  void makeMeshLook(Actions& actions);
  void saveScreenshot();
  void offerIsolate(const document::Organ& organ);

  Parts parts_;
  std::unique_ptr<scene::DepthShading> shading_; ///< The first view's.
};

} // namespace viscera::app

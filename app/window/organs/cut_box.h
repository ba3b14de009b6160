#pragma once

#include <QWidget>

#include "window/view/view_model.h"
#include "window/view/view_widget.h"
#include "window/work/workspace.h"

class QCheckBox;

namespace viscera::app {

class ValueSlider;

/// The controls of the plane that cuts organs open in the 3D view: the switch "view.cut", the direction of
/// the plane and its place, and whether blood is in a heart that it opens.
class CutBox final : public QWidget {
  Q_OBJECT

public:
  /// All have to live longer.
  CutBox(Workspace& workspace, ViewModel& view, ViewWidget& widget, const Actions& actions,
         QWidget* parent = nullptr);

private:
  QWidget* makeSwitches(const Actions& actions);
  QWidget* makeDirections();
  void cutFrom(const Vec3& normal);
  void sync();

  Workspace& workspace_;
  ViewModel& view_;
  ViewWidget& widget_;
  QWidget* directions_;
  ValueSlider* offset_;
  QCheckBox* blood_; ///< There while a heart is cut open.
  Subscription subscription_;
};

} // namespace viscera::app

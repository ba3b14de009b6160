#include "interactor_style.h"

#include <cmath>

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace viscera::scene {
namespace {

/// Factor of one turn of the wheel.
constexpr double kZoomPerStep = 1.15;

class SlicerLikeStyle : public vtkInteractorStyleTrackballCamera {
public:
  static SlicerLikeStyle* New();
  vtkTypeMacro(SlicerLikeStyle, vtkInteractorStyleTrackballCamera)

      void OnChar() override {}

  // The base class renders each turn of the wheel twice.
  void OnMouseWheelForward() override { turnWheel(MouseWheelMotionFactor); }
  void OnMouseWheelBackward() override { turnWheel(-MouseWheelMotionFactor); }

private:
  void turnWheel(double steps) {
    const int* at = Interactor->GetEventPosition();
    FindPokedRenderer(at[0], at[1]);
    if (CurrentRenderer)
      Dolly(std::pow(kZoomPerStep, steps));
  }
};
vtkStandardNewMacro(SlicerLikeStyle);

} // namespace

vtkSmartPointer<vtkInteractorStyle> newInteractorStyle() {
  return vtkSmartPointer<SlicerLikeStyle>::New();
}

} // namespace viscera::scene

#include "interactor_style.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>

namespace viscera::scene {
namespace {

class SlicerLikeStyle : public vtkInteractorStyleTrackballCamera {
public:
  static SlicerLikeStyle* New();
  vtkTypeMacro(SlicerLikeStyle, vtkInteractorStyleTrackballCamera)

      void OnChar() override {}
};
vtkStandardNewMacro(SlicerLikeStyle);

} // namespace

vtkSmartPointer<vtkInteractorStyle> newInteractorStyle() {
  return vtkSmartPointer<SlicerLikeStyle>::New();
}

} // namespace viscera::scene

// A sphere, handles around it, one of them dragged: the volume is kept, and the stress measured.
#include <cmath>
#include <cstdio>

#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkVisceraDeformFilter.h>
#include <vtkVisceraHandleSource.h>
#include <vtkVisceraStressFilter.h>

int main() {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(40);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkCleanPolyData> organ;
  organ->SetInputConnection(sphere->GetOutputPort());

  vtkNew<vtkVisceraHandleSource> rest, posed;
  for (vtkVisceraHandleSource* handles : {rest.Get(), posed.Get()}) {
    handles->SetInputConnection(organ->GetOutputPort());
    handles->SetCount(24);
  }
  posed->SetMovedHandle(10);
  posed->SetDisplacement(0, 12, 4);

  vtkNew<vtkVisceraDeformFilter> deform;
  deform->SetInputConnection(organ->GetOutputPort());
  deform->SetRestHandlesConnection(rest->GetOutputPort());
  deform->SetPosedHandlesConnection(posed->GetOutputPort());
  deform->LockVolumeOn();
  deform->Update();

  vtkNew<vtkVisceraStressFilter> stress;
  stress->SetInputConnection(organ->GetOutputPort());
  stress->SetRestHandlesConnection(rest->GetOutputPort());
  stress->SetPosedHandlesConnection(deform->GetOutputPort(1)); // the handles that the lock has moved
  stress->Update();

  const bool measured =
      vtkPolyData::SafeDownCast(stress->GetOutput())->GetPointData()->HasArray("RotationalStress");
  std::printf("volume %.4f ml, at rest %.4f ml; rotational stress up to %.3f rad\n",
              deform->GetVolume() / 1000, deform->GetRestVolume() / 1000, stress->GetMaxRotationalStress());
  return std::abs(deform->GetVolumeRatio() - 1) < 1e-12 && measured && stress->GetMaxRotationalStress() > 0
             ? 0
             : 1;
}

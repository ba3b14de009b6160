"""The filters in a pipeline of VTK: handles are placed, one moves step by step, volume and stress follow."""

from _example import needs

needs("vtkmodules")
filters = needs("viscera_vtk.vtkVisceraFilters")
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

sphere = vtkSphereSource()
sphere.SetRadius(40)
sphere.SetThetaResolution(60)
sphere.SetPhiResolution(60)
clean = vtkCleanPolyData()
clean.SetInputConnection(sphere.GetOutputPort())
organ = vtkTriangleFilter()
organ.SetInputConnection(clean.GetOutputPort())

rest, posed = filters.vtkVisceraHandleSource(), filters.vtkVisceraHandleSource()
for source in (rest, posed):
    source.SetInputConnection(organ.GetOutputPort())
    source.SetCount(26)
posed.SetMovedHandle(12)


def follow(kind):
    made = kind()
    made.SetInputConnection(organ.GetOutputPort())
    made.SetRestHandlesConnection(rest.GetOutputPort())
    made.SetPosedHandlesConnection(posed.GetOutputPort())
    return made


deform, stress = follow(filters.vtkVisceraDeformFilter), follow(filters.vtkVisceraStressFilter)
deform.LockVolumeOn()
for distance in (0, 5, 10, 15):
    posed.SetDisplacement(0, distance, 0)
    deform.Update()
    stress.Update()
    print(f"moved by {distance:2} mm: volume {deform.GetVolume() / 1000:.4f} ml, rotational stress up to "
          f"{np.degrees(stress.GetMaxRotationalStress()):.1f} degrees")
    assert abs(deform.GetVolumeRatio() - 1) < 1e-12
print(vtk_to_numpy(deform.GetOutput().GetPoints().GetData()).shape, "points")

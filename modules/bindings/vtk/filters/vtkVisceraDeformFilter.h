#pragma once

#include "vtkVisceraFiltersModule.h" // for the export macro
#include "vtkVisceraHandleFilter.h"

/**
 * @class vtkVisceraDeformFilter
 * @brief Deforms an organ by handles, without a cage.
 *
 * Output 0 has the posed points in double precision, and as field data Volume, RestVolume (mm^3; of the
 * tetrahedra, else of the closed surface), VolumeRatio, VectorArea (mm^2: zero to rounding for a closed
 * surface whose cells all count once) and UnboundPoints (outside the hull of the handles, they do not move).
 * They refer to the whole organ on every rank, not to a piece. Output 1: the handles of the pose, changed
 * by the volume lock where that is on; they lie on the first rank. Cost: O(points x handles) once, then a
 * fifth of it or less for another pose.
 *
 *     vtkNew<vtkVisceraDeformFilter> filter;
 *     filter->SetInputData(organ);
 *     filter->SetRestHandlesData(rest);
 *     filter->SetPosedHandlesData(posed);
 *     filter->Update();
 */
class VTKVISCERAFILTERS_EXPORT vtkVisceraDeformFilter : public vtkVisceraHandleFilter {
public:
  static vtkVisceraDeformFilter* New();
  vtkTypeMacro(vtkVisceraDeformFilter, vtkVisceraHandleFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Keep the coordinates (points x handles x 8 bytes), so that another pose takes one product.
  vtkSetMacro(KeepWeights, vtkTypeBool);
  vtkGetMacro(KeepWeights, vtkTypeBool);
  vtkBooleanMacro(KeepWeights, vtkTypeBool);
  ///@}

  ///@{ Move the handles that the pose leaves at rest, each along its own derivative of the volume, so that
  /// the
  /// whole organ has TargetVolume (mm^3; 0: that at rest) exactly. Keeps the coordinates while it executes.
  vtkSetMacro(LockVolume, vtkTypeBool);
  vtkGetMacro(LockVolume, vtkTypeBool);
  vtkBooleanMacro(LockVolume, vtkTypeBool);
  vtkSetClampMacro(TargetVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TargetVolume, double);
  ///@}

  ///@{ Of the last execution; global.
  vtkGetMacro(Volume, double);
  vtkGetMacro(RestVolume, double);
  vtkGetMacro(VolumeRatio, double);
  vtkGetMacro(VectorArea, double);
  vtkGetMacro(UnboundPoints, vtkIdType);
  ///@}

protected:
  vtkVisceraDeformFilter();
  ~vtkVisceraDeformFilter() override;
  void Work(Job& job) override;

  vtkTypeBool KeepWeights = 1;
  vtkTypeBool LockVolume = 0;
  double TargetVolume = 0;
  double Volume = 0;
  double RestVolume = 0;
  double VolumeRatio = 1;
  double VectorArea = 0;
  vtkIdType UnboundPoints = 0;

private:
  struct Kept;
  std::unique_ptr<Kept> Weights;

  vtkVisceraDeformFilter(const vtkVisceraDeformFilter&) = delete;
  void operator=(const vtkVisceraDeformFilter&) = delete;
};

#pragma once

#include "vtkVisceraFiltersModule.h" // for the export macro
#include "vtkVisceraHandleFilter.h"

/**
 * @class vtkVisceraStressFilter
 * @brief Computes how a pose of the handles distorts an organ, at each of its points.
 *
 * The output has the posed points (at rest with PosePoints off) and as point data RotationalStress (rad: the
 * largest angle by which the local stretch turns a direction; 0 for rigid motions), VolumeRatio (at most 0
 * where tissue is folded), StretchMax and StretchMin. Field data of the whole organ: MaxRotationalStress and
 * MeanRotationalStress (rad; over the rest cells, by volume or area). Points without coordinates are not
 * distorted. Cost: O(points x handles), about ten times a first pose for systems with derivatives in closed
 * form.
 */
class VTKVISCERAFILTERS_EXPORT vtkVisceraStressFilter : public vtkVisceraHandleFilter {
public:
  static vtkVisceraStressFilter* New();
  vtkTypeMacro(vtkVisceraStressFilter, vtkVisceraHandleFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Whether the output's points are posed.
  vtkSetMacro(PosePoints, vtkTypeBool);
  vtkGetMacro(PosePoints, vtkTypeBool);
  vtkBooleanMacro(PosePoints, vtkTypeBool);
  ///@}

  ///@{ Of the last execution, rad; global.
  vtkGetMacro(MaxRotationalStress, double);
  vtkGetMacro(MeanRotationalStress, double);
  ///@}

protected:
  vtkVisceraStressFilter() = default;
  ~vtkVisceraStressFilter() override = default;
  void Work(Job& job) override;

  vtkTypeBool PosePoints = 1;
  double MaxRotationalStress = 0;
  double MeanRotationalStress = 0;

private:
  vtkVisceraStressFilter(const vtkVisceraStressFilter&) = delete;
  void operator=(const vtkVisceraStressFilter&) = delete;
};

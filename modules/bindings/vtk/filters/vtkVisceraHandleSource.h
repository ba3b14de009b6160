#pragma once

#include "vtkPolyDataAlgorithm.h"
#include "vtkVisceraFiltersModule.h" // for the export macro

#include <memory> // for std::unique_ptr

/**
 * @class vtkVisceraHandleSource
 * @brief Creates the handles of an organ: given one by one, or placed around it.
 *
 * Where points were set, they are the handles. Else, with the organ's closed surface (polygons) as input,
 * Count handles are placed just off it, spread evenly; with Enclosing the first eight are the corners of a
 * box around it, so that every point can be bound. Two sources, one at rest and one moved, make a pose. Every
 * rank gets all handles when a filter asks for the whole; as pieces they lie in piece 0.
 */
class VTKVISCERAFILTERS_EXPORT vtkVisceraHandleSource : public vtkPolyDataAlgorithm {
public:
  static vtkVisceraHandleSource* New();
  vtkTypeMacro(vtkVisceraHandleSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ The handles, mm, LPS. None: they are placed around the input.
  void SetNumberOfPoints(int count);
  int GetNumberOfPoints() const;
  void SetPoint(int handle, double x, double y, double z);
  ///@}

  ///@{ How many are placed around an organ; at least 8 with Enclosing, else 4.
  vtkSetClampMacro(Count, int, 4, 1000);
  vtkGetMacro(Count, int);
  ///@}

  ///@{ Whether the first eight are the corners of a box around the organ.
  vtkSetMacro(Enclosing, vtkTypeBool);
  vtkGetMacro(Enclosing, vtkTypeBool);
  vtkBooleanMacro(Enclosing, vtkTypeBool);
  ///@}

  ///@{ One handle moved by Displacement (mm); -1: none.
  vtkSetMacro(MovedHandle, int);
  vtkGetMacro(MovedHandle, int);
  vtkSetVector3Macro(Displacement, double);
  vtkGetVector3Macro(Displacement, double);
  ///@}

protected:
  vtkVisceraHandleSource();
  ~vtkVisceraHandleSource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Count = 30;
  vtkTypeBool Enclosing = 1;
  int MovedHandle = -1;
  double Displacement[3] = {0, 0, 0};

private:
  struct Given;
  std::unique_ptr<Given> Handles;

  vtkVisceraHandleSource(const vtkVisceraHandleSource&) = delete;
  void operator=(const vtkVisceraHandleSource&) = delete;
};

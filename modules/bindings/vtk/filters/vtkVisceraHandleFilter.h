#pragma once

#include "vtkPointSetAlgorithm.h"
#include "vtkVisceraFiltersModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkMultiProcessController;

/**
 * @class vtkVisceraHandleFilter
 * @brief Base class of VTK filters that take handles at rest and posed.
 *
 * Input 0: the organ at rest, polygons or tetrahedra in mm (vtkPolyData, vtkUnstructuredGrid, or a composite
 * of them); in parallel any part of it. Input 1: the handles at rest (any vtkPointSet; triangles among them
 * are a cage). Input 2: the same handles posed, in the same order. Handles may lie on one rank, on all, or in
 * parts: every rank gets all.
 *
 * Values of the whole organ are the same to the last bit for any number of ranks and threads: ghost cells do
 * not count, and sums are exact. An error on one rank ends the filter on all of them, with that rank's
 * message.
 */
class VTKVISCERAFILTERS_EXPORT vtkVisceraHandleFilter : public vtkPointSetAlgorithm {
public:
  vtkTypeMacro(vtkVisceraHandleFilter, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ The handles, as inputs 1 and 2.
  void SetRestHandlesConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetPosedHandlesConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetRestHandlesData(vtkDataObject* handles) { this->SetInputData(1, handles); }
  void SetPosedHandlesData(vtkDataObject* handles) { this->SetInputData(2, handles); }
  ///@}

  ///@{ The coordinates, by the id of a built-in system; standard "s-celestial".
  void SetSystem(const char* id);
  const char* GetSystem() const { return this->System.c_str(); }
  ///@}

  ///@{ A parameter of the system by name; the filter fails for one that the system does not offer.
  void SetParameter(const char* name, double value);
  void RemoveAllParameters();
  ///@}

  /// @{ Two parameters of the celestial systems: how much nearer handles count more, and how far a handle is
  /// blurred (mm).
  vtkSetClampMacro(Locality, double, 0.0, 6.0);
  vtkGetMacro(Locality, double);
  vtkSetClampMacro(Softness, double, 0.0, 1000.0);
  vtkGetMacro(Softness, double);
  ///@}

  /// @{ 0: all threads of the machine for one process, one thread for each of several.
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /// The controller of the ranks; the global one when none was set.
  virtual void SetController(vtkMultiProcessController*);

protected:
  vtkVisceraHandleFilter();
  ~vtkVisceraHandleFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int ComputeInputUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Calls `Work`; an exception becomes an error of the filter.
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  struct Job;
  /// Does the work of the filter. Between collective calls, code may throw only within `Ranks::together`.
  virtual void Work(Job& job) = 0;

  std::string System = "s-celestial";
  double Locality = 0;
  double Softness = 0;
  int NumberOfThreads = 0;
  vtkMultiProcessController* Controller = nullptr;

private:
  struct Named;
  std::unique_ptr<Named> Parameters;

  vtkVisceraHandleFilter(const vtkVisceraHandleFilter&) = delete;
  void operator=(const vtkVisceraHandleFilter&) = delete;
};

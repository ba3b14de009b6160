#pragma once

#include "organ_parts.h"
#include "vtkVisceraHandleFilter.h"

class vtkDataObject;
class vtkInformationVector;

/// The state of one execution of a filter: ranks, handles, input and output.
struct vtkVisceraHandleFilter::Job {
  viscera::vtk_filters::Ranks ranks;
  viscera::vtk_filters::Rig rig;
  std::vector<viscera::vtk_filters::Leaf> leaves;
  vtkDataObject* output = nullptr; ///< Of port 0.
  vtkInformationVector* outputs = nullptr;
};

namespace viscera::vtk_filters {

/// Adds one number to the field data.
void tell(vtkDataObject* output, const char* name, double value);

} // namespace viscera::vtk_filters

#include "vtkVisceraHandleFilter.h"

#include <exception>
#include <map>

#include "src/filter_job.h"
#include "viscera/core/error.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace vf = viscera::vtk_filters;

void vf::tell(vtkDataObject* output, const char* name, double value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

struct vtkVisceraHandleFilter::Named {
  std::map<std::string, double> values;
};

vtkCxxSetObjectMacro(vtkVisceraHandleFilter, Controller, vtkMultiProcessController);

vtkVisceraHandleFilter::vtkVisceraHandleFilter() : Parameters(new Named) {
  this->SetNumberOfInputPorts(3);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVisceraHandleFilter::~vtkVisceraHandleFilter() {
  this->SetController(nullptr);
}

void vtkVisceraHandleFilter::SetSystem(const char* id) {
  const std::string wanted = id ? id : "s-celestial";
  if (wanted == this->System)
    return;
  this->System = wanted;
  this->Modified();
}

void vtkVisceraHandleFilter::SetParameter(const char* name, double value) {
  const auto found = this->Parameters->values.find(name ? name : "");
  if (found != this->Parameters->values.end() && found->second == value)
    return;
  this->Parameters->values[name ? name : ""] = value;
  this->Modified();
}

void vtkVisceraHandleFilter::RemoveAllParameters() {
  if (this->Parameters->values.empty())
    return;
  this->Parameters->values.clear();
  this->Modified();
}

int vtkVisceraHandleFilter::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  // Composites come whole: executed block by block, ranks with different numbers of blocks would wait for
  // ever.
  if (port == 0)
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkVisceraHandleFilter::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkPolyData");
  return 1;
}

int vtkVisceraHandleFilter::RequestDataObject(vtkInformation*, vtkInformationVector** inputs,
                                              vtkInformationVector* outputs) {
  auto* input = vtkDataObject::GetData(inputs[0]);
  auto* output = vtkDataObject::GetData(outputs);
  if (input && (!output || !output->IsA(input->GetClassName()))) {
    auto made = vtk::TakeSmartPointer(input->NewInstance());
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  if (this->GetNumberOfOutputPorts() > 1 && !vtkDataObject::GetData(outputs, 1)) {
    vtkNew<vtkPolyData> handles;
    outputs->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), handles);
  }
  return 1;
}

int vtkVisceraHandleFilter::ComputeInputUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                     vtkInformationVector*) {
  for (const int port : {1, 2}) {
    auto* info = inputs[port]->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

int vtkVisceraHandleFilter::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                        vtkInformationVector* outputs) {
  const vf::Ranks ranks(this->Controller);
  try {
    Job job{ranks, {}, {}, vtkDataObject::GetData(outputs), outputs};
    job.rig = vf::gatherRig(
        ranks, vtkPointSet::GetData(inputs[1]), vtkPointSet::GetData(inputs[2]),
        {this->System, this->Parameters->values, this->Locality, this->Softness, this->NumberOfThreads});
    ranks.together([&] { job.leaves = vf::copyLeaves(vtkDataObject::GetData(inputs[0]), job.output); });
    this->Work(job);
  } catch (const std::exception& error) {
    // The same on every rank; one is enough to say it, but a log of any of them is to show it.
    vtkErrorMacro(<< viscera::explanationOf(error));
    return 0;
  }
  return 1;
}

void vtkVisceraHandleFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "System: " << this->System << "\n"
     << indent << "Locality: " << this->Locality << "\n"
     << indent << "Softness: " << this->Softness << "\n"
     << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  for (const auto& [name, value] : this->Parameters->values)
    os << indent << name << ": " << value << "\n";
}

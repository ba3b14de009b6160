#include "vtkVisceraHandleSource.h"

#include <exception>

#include "src/leaves.h"
#include "src/rig.h"
#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"
#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace vf = viscera::vtk_filters;

vtkStandardNewMacro(vtkVisceraHandleSource);

struct vtkVisceraHandleSource::Given {
  viscera::Points points = viscera::Points(0, 3);
};

vtkVisceraHandleSource::vtkVisceraHandleSource() : Handles(new Given) {}

vtkVisceraHandleSource::~vtkVisceraHandleSource() = default;

void vtkVisceraHandleSource::SetNumberOfPoints(int count) {
  const Eigen::Index before = this->Handles->points.rows();
  if (count == before || count < 0)
    return;
  this->Handles->points.conservativeResize(count, 3);
  if (count > before)
    this->Handles->points.bottomRows(count - before).setZero();
  this->Modified();
}

int vtkVisceraHandleSource::GetNumberOfPoints() const {
  return static_cast<int>(this->Handles->points.rows());
}

void vtkVisceraHandleSource::SetPoint(int handle, double x, double y, double z) {
  if (handle < 0)
    return;
  if (handle >= this->Handles->points.rows())
    this->SetNumberOfPoints(handle + 1);
  const Eigen::RowVector3d place(x, y, z);
  if (this->Handles->points.row(handle) == place)
    return;
  this->Handles->points.row(handle) = place;
  this->Modified();
}

int vtkVisceraHandleSource::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkVisceraHandleSource::RequestInformation(vtkInformation*, vtkInformationVector**,
                                               vtkInformationVector* outputs) {
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkVisceraHandleSource::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                vtkInformationVector*) {
  // Handles are placed around the whole organ, on every rank.
  if (inputs[0]->GetNumberOfInformationObjects() > 0) {
    auto* info = inputs[0]->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

int vtkVisceraHandleSource::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                        vtkInformationVector* outputs) {
  auto* output = vtkPolyData::GetData(outputs);
  auto* info = outputs->GetInformationObject(0);
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
    return 1;
  viscera::Points handles = this->Handles->points;
  auto* organ = vtkPolyData::GetData(inputs[0]);
  try {
    if (handles.rows() == 0 && organ && organ->GetNumberOfPoints() > 0) {
      viscera::geometry::TriangleMesh mesh;
      mesh.points = vf::pointsOf(organ, 0, organ->GetNumberOfPoints());
      std::vector<std::int32_t> corners;
      vf::forEachCell(
          organ,
          [&](vtkIdType a, vtkIdType b, vtkIdType c) {
            for (const vtkIdType id : {a, b, c})
              corners.push_back(static_cast<std::int32_t>(id));
          },
          [](vtkIdType, vtkIdType, vtkIdType, vtkIdType) {});
      mesh.triangles = Eigen::Map<const viscera::Triangles>(corners.data(),
                                                            static_cast<Eigen::Index>(corners.size() / 3), 3);
      handles = viscera::deformation::placeHandles(mesh, {this->Count, this->Enclosing != 0});
    }
  } catch (const std::exception& error) {
    vtkErrorMacro(<< viscera::explanationOf(error));
    return 0;
  }
  if (this->MovedHandle >= 0 && this->MovedHandle < handles.rows())
    handles.row(this->MovedHandle) += Eigen::Map<const Eigen::RowVector3d>(this->Displacement);
  vf::fillHandles(output, handles);
  return 1;
}

void vtkVisceraHandleSource::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->GetNumberOfPoints() << "\n"
     << indent << "Count: " << this->Count << "\n"
     << indent << "Enclosing: " << this->Enclosing << "\n"
     << indent << "MovedHandle: " << this->MovedHandle << "\n";
}

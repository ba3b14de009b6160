#include "vtkVisceraDeformFilter.h"

#include "src/filter_job.h"
#include "src/rig.h"
#include "viscera/core/error.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

namespace vf = viscera::vtk_filters;

struct vtkVisceraDeformFilter::Kept {
  vf::KeptWeights weights;
};

vtkStandardNewMacro(vtkVisceraDeformFilter);

vtkVisceraDeformFilter::vtkVisceraDeformFilter() : Weights(new Kept) {
  this->SetNumberOfOutputPorts(2);
}

vtkVisceraDeformFilter::~vtkVisceraDeformFilter() = default;

void vtkVisceraDeformFilter::Work(Job& job) {
  vf::KeptWeights& kept = this->Weights->weights;
  vf::OrganParts parts(job.ranks, job.rig, job.leaves);
  const bool keep = this->KeepWeights || this->LockVolume;
  job.ranks.together([&] {
    parts.pose(kept, keep, [this](double fraction) {
      this->UpdateProgress(fraction);
      if (this->GetAbortExecute())
        throw viscera::Cancelled();
    });
  });
  const vf::RestVolume rest = parts.restVolume(kept);
  viscera::Points pose = job.rig.pose;
  if (this->LockVolume)
    pose = parts.restoreVolume(kept, this->TargetVolume > 0 ? this->TargetVolume : rest.volume.mm3);
  const vf::GlobalVolume volume = parts.volume();
  if (!this->KeepWeights)
    kept.portions.clear();
  this->RestVolume = rest.volume.mm3;
  this->Volume = volume.mm3;
  this->VolumeRatio = rest.volume.mm3 != 0 ? volume.mm3 / rest.volume.mm3 : 1;
  this->VectorArea = rest.vectorAreaMm2;
  this->UnboundPoints = parts.unboundPoints();
  if (this->UnboundPoints > 0 && job.ranks.first())
    vtkWarningMacro(<< this->UnboundPoints << " points lie outside the hull of the handles and do not move.");
  vf::tell(job.output, "Volume", this->Volume);
  vf::tell(job.output, "RestVolume", this->RestVolume);
  vf::tell(job.output, "VolumeRatio", this->VolumeRatio);
  vf::tell(job.output, "VectorArea", this->VectorArea);
  vf::tell(job.output, "UnboundPoints", static_cast<double>(this->UnboundPoints));
  // Once in all, so that what is drawn or written together has no copies; filters gather them from there.
  vf::fillHandles(vtkPolyData::GetData(job.outputs, 1), job.ranks.first() ? pose : viscera::Points(0, 3));
}

void vtkVisceraDeformFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "KeepWeights: " << this->KeepWeights << "\n"
     << indent << "LockVolume: " << this->LockVolume << "\n"
     << indent << "TargetVolume: " << this->TargetVolume << "\n"
     << indent << "Volume: " << this->Volume << "\n"
     << indent << "RestVolume: " << this->RestVolume << "\n";
}

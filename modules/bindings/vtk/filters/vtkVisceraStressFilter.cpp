#include "vtkVisceraStressFilter.h"

#include <algorithm>
#include <cmath>

#include "src/filter_job.h"
#include "viscera/core/error.h"
#include "viscera/deformation/witness_gradients.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

namespace vf = viscera::vtk_filters;

vtkStandardNewMacro(vtkVisceraStressFilter);

namespace {

constexpr vtkIdType kStressPortion = 8192; // their derivatives fit into the processor's caches

/// The four arrays of one leaf.
struct StressArrays {
  vtkNew<vtkDoubleArray> stress, ratio, most, least;

  StressArrays(vtkIdType count) {
    stress->SetName("RotationalStress");
    ratio->SetName("VolumeRatio");
    most->SetName("StretchMax");
    least->SetName("StretchMin");
    for (auto* array : {stress.Get(), ratio.Get(), most.Get(), least.Get()})
      array->SetNumberOfValues(count);
  }

  void put(vtkIdType begin, const viscera::deformation::StressMap& map) {
    const auto copy = [begin](const viscera::Values& from, vtkDoubleArray* to) {
      std::copy_n(from.data(), from.size(), to->GetPointer(begin));
    };
    copy(map.rotationalStress, stress);
    copy(map.volumeRatio, ratio);
    copy(map.stretchMax, most);
    copy(map.stretchMin, least);
  }

  void addTo(vtkPointSet* set) const {
    for (auto* array : {stress.Get(), ratio.Get(), most.Get(), least.Get()})
      set->GetPointData()->AddArray(array);
    set->GetPointData()->SetActiveScalars("RotationalStress");
  }
};

void measurePortion(const vf::Rig& rig, const viscera::Points& points, vtkIdType begin,
                    StressArrays& arrays) {
  viscera::Progress unheard;
  const auto gradients = rig.system->gradients(rig.handles, points, rig.options, unheard);
  viscera::deformation::WitnessGradients witnesses(points.rows(), rig.handles.positions.rows(),
                                                   gradients.lift);
  witnesses.put(0, gradients, points.rows());
  viscera::deformation::StressMap map;
  witnesses.evaluate(rig.pose, map, rig.options.threads);
  arrays.put(begin, map);
}

/// The mean over cells, by their size at rest, of the mean over their corners.
struct WeightedMean {
  viscera::ExactSum surface, surfaceSize, solid, solidSize;

  void add(vtkPointSet* at, const viscera::Points& rest, const double* stress) {
    vf::forEachCell(
        at,
        [&](vtkIdType a, vtkIdType b, vtkIdType c) {
          const viscera::Vec3 p = rest.row(a).transpose(), q = rest.row(b).transpose(),
                              r = rest.row(c).transpose();
          const double size = (q - p).cross(r - p).norm() / 2;
          surfaceSize.add(size);
          surface.add(size * (stress[a] + stress[b] + stress[c]) / 3);
        },
        [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
          const viscera::Vec3 o = rest.row(a).transpose(), p = rest.row(b).transpose(),
                              q = rest.row(c).transpose(), r = rest.row(d).transpose();
          const double size = std::abs((p - o).cross(q - o).dot(r - o)) / 6;
          solidSize.add(size);
          solid.add(size * (stress[a] + stress[b] + stress[c] + stress[d]) / 4);
        });
  }

  /// Collective.
  double over(const vf::Ranks& ranks) {
    ranks.add({&surface, &surfaceSize, &solid, &solidSize});
    const double volume = solidSize.value(), area = surfaceSize.value();
    return volume > 0 ? solid.value() / volume : area > 0 ? surface.value() / area : 0;
  }
};

} // namespace

void vtkVisceraStressFilter::Work(Job& job) {
  double most = 0;
  WeightedMean mean;
  job.ranks.together([&] {
    vtkIdType done = 0, all = 0;
    for (const vf::Leaf& leaf : job.leaves)
      all += leaf.from->GetNumberOfPoints();
    for (const vf::Leaf& leaf : job.leaves) {
      const vtkIdType count = leaf.from->GetNumberOfPoints();
      if (count == 0)
        continue;
      const viscera::Points rest = vf::pointsOf(leaf.from, 0, count);
      StressArrays arrays(count);
      const vtkIdType portion = job.rig.system->traits().needsTetrahedra ? count : kStressPortion;
      for (vtkIdType begin = 0; begin < count; begin += portion) {
        const vtkIdType size = std::min(portion, count - begin);
        measurePortion(job.rig, rest.middleRows(begin, size), begin, arrays);
        done += size;
        this->UpdateProgress(static_cast<double>(done) / static_cast<double>(all));
        if (this->GetAbortExecute())
          throw viscera::Cancelled();
      }
      const double* stress = arrays.stress->GetPointer(0);
      most = std::max(most, *std::max_element(stress, stress + count));
      mean.add(leaf.from, rest, stress);
      arrays.addTo(leaf.to);
    }
  });
  this->MaxRotationalStress = job.ranks.largest(most);
  this->MeanRotationalStress = mean.over(job.ranks);
  if (this->PosePoints) {
    vf::KeptWeights none;
    vf::OrganParts parts(job.ranks, job.rig, job.leaves);
    job.ranks.together([&] { parts.pose(none, false, [](double) {}); });
  }
  vf::tell(job.output, "MaxRotationalStress", this->MaxRotationalStress);
  vf::tell(job.output, "MeanRotationalStress", this->MeanRotationalStress);
}

void vtkVisceraStressFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PosePoints: " << this->PosePoints << "\n"
     << indent << "MaxRotationalStress: " << this->MaxRotationalStress << "\n"
     << indent << "MeanRotationalStress: " << this->MeanRotationalStress << "\n";
}

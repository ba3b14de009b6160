#include "rig.h"

#include <algorithm>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataSetAttributes.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "leaves.h"
#include "viscera/coordinates/systems.h"
#include "viscera/coordinates/vector_bits.h"
#include "viscera/core/error.h"
#include "viscera/deformation/tetrahedralise.h"

namespace viscera::vtk_filters {
namespace {

/// Positions and the triangles among them as numbers: how many, then all of them.
std::vector<double> packed(vtkPointSet* handles) {
  std::vector<double> positions;
  std::vector<double> triangles;
  if (!handles)
    return {};
  auto* ghosts = handles->GetPointGhostArray();
  std::vector<std::int64_t> place(static_cast<std::size_t>(handles->GetNumberOfPoints()), -1);
  std::int64_t next = 0;
  for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i) {
    if (ghosts && (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT))
      continue;
    place[static_cast<std::size_t>(i)] = next++;
    const double* p = handles->GetPoint(i);
    positions.insert(positions.end(), p, p + 3);
  }
  auto* surface = vtkPolyData::SafeDownCast(handles);
  if (surface && surface->GetPolys()) {
    auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(count, ids);
      for (vtkIdType corner = 2; corner < count; ++corner)
        for (const vtkIdType id : {ids[0], ids[corner - 1], ids[corner]})
          triangles.push_back(static_cast<double>(place[static_cast<std::size_t>(id)]));
    }
  }
  if (next == 0)
    return {};
  std::vector<double> all = {static_cast<double>(next)};
  all.insert(all.end(), positions.begin(), positions.end());
  all.insert(all.end(), triangles.begin(), triangles.end());
  return all;
}

/// Adds what `packed` made of one rank's handles.
void unpack(const std::vector<double>& part, std::vector<double>& positions,
            std::vector<std::int32_t>& cage) {
  if (part.empty())
    return;
  const auto count = static_cast<std::ptrdiff_t>(part[0]);
  const auto before = static_cast<std::int32_t>(positions.size() / 3);
  positions.insert(positions.end(), part.begin() + 1, part.begin() + 1 + 3 * count);
  for (auto index = part.begin() + 1 + 3 * count; index != part.end(); ++index)
    cage.push_back(before + static_cast<std::int32_t>(*index));
}

coordinates::HandleSet gatherHandles(const Ranks& ranks, vtkPointSet* handles) {
  const auto parts = ranks.gather(packed(handles));
  std::vector<double> positions;
  std::vector<std::int32_t> cage;
  for (auto part = parts.begin(); part != parts.end(); ++part)
    if (std::find(parts.begin(), part, *part) == part)
      unpack(*part, positions, cage);
  coordinates::HandleSet set;
  set.positions =
      Eigen::Map<const Points>(positions.data(), static_cast<Eigen::Index>(positions.size() / 3), 3);
  set.cage = Eigen::Map<const Triangles>(cage.data(), static_cast<Eigen::Index>(cage.size() / 3), 3);
  return set;
}

std::shared_ptr<const coordinates::CoordinateSystem> systemNamed(const std::string& id) {
  std::string known;
  for (const auto& system : coordinates::builtInSystems()) {
    if (system->id() == id)
      return system;
    known += (known.empty() ? "" : ", ") + system->id();
  }
  throw UsageError("there is no coordinate system '" + id + "'", {}, "use one of: " + known);
}

coordinates::BindOptions optionsOf(const coordinates::CoordinateSystem& system, const Choices& choices,
                                   bool alone) {
  coordinates::BindOptions options;
  for (const auto& [name, value] : choices.parameters)
    options.parameters.set(name, value);
  if (choices.locality != 0)
    options.parameters.set("locality", choices.locality);
  if (choices.softness != 0)
    options.parameters.set("softness", choices.softness);
  options.parameters.requireWithin(system.parameters());
  options.threads.count = choices.threads > 0 ? choices.threads : alone ? 0 : 1;
  return deformation::withTetgen(std::move(options));
}

} // namespace

bool Rig::bindsAs(const Rig& other) const {
  return other.system && system->id() == other.system->id() &&
         options.parameters.all() == other.options.parameters.all() &&
         handles.positions.rows() == other.handles.positions.rows() &&
         handles.positions == other.handles.positions && handles.cage.rows() == other.handles.cage.rows() &&
         handles.cage == other.handles.cage;
}

Rig gatherRig(const Ranks& ranks, vtkPointSet* rest, vtkPointSet* posed, const Choices& choices) {
  Rig rig;
  rig.handles = gatherHandles(ranks, rest);
  rig.pose = gatherHandles(ranks, posed).positions;
  const int most = static_cast<int>(ranks.largest(coordinates::vectorBits()));
  ranks.together([&] {
    if (coordinates::vectorBits() != most)
      throw DataError("the processor computes with vectors of " + std::to_string(coordinates::vectorBits()) +
                          " bits, those of other ranks of " + std::to_string(most),
                      "ranks", "set VISCERA_VECTOR_BITS to the smallest of them on all ranks");
    rig.system = systemNamed(choices.system);
    rig.options = optionsOf(*rig.system, choices, ranks.count() == 1);
    if (rig.handles.positions.rows() == 0)
      throw DataError("there are no handles", "rest handles");
    if (rig.handles.positions.rows() != rig.pose.rows())
      throw DataError("there are " + std::to_string(rig.handles.positions.rows()) + " handles at rest but " +
                          std::to_string(rig.pose.rows()) + " posed ones",
                      "handles", "give the same ones in the same order");
    if (!rig.pose.allFinite())
      throw DataError("a position is not a finite number", "posed handles");
  });
  return rig;
}

void fillHandles(vtkPolyData* data, const Points& positions) {
  auto points = newPoints(positions.rows());
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Handle");
  std::copy_n(positions.data(), positions.size(), memoryOf(points));
  for (vtkIdType i = 0; i < positions.rows(); ++i) {
    vertices->InsertNextCell(1, &i);
    numbers->InsertNextValue(static_cast<int>(i));
  }
  data->Initialize();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(numbers);
}

} // namespace viscera::vtk_filters

#include "viscera/document/sequence_rig.h"

#include <algorithm>

#include "viscera/core/error.h"

namespace viscera::document {
namespace {
constexpr double kSameRest = 1e-6; ///< Of the size of all handles.
}

void requireFits(const Rig& rig, const sequences::Sequence& sequence) {
  const Points& own = sequence.restHandles();
  const Points rest = rig.restPositions();
  const std::string advice = "take the sequence's own handles";
  if (own.rows() != rest.rows())
    throw DataError("The sequence moves " + std::to_string(own.rows()) + " handles, but there are " +
                        std::to_string(rest.rows()),
                    sequence.name(), advice);
  const double size = std::max(boundsOf(own).diagonal(), 1.0);
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    if (!((own.row(i) - rest.row(i)).norm() <= kSameRest * size))
      throw DataError("The sequence was made for another place of a handle",
                      sequence.name() + ", handle " + rig.handles[static_cast<std::size_t>(i)].label, advice);
}

NewRig rigOf(const sequences::Sequence& sequence) {
  NewRig rig;
  rig.handles = newHandles(sequence.restHandles());
  for (const sequences::HandleGroup& group : sequence.groups()) {
    rig.groups.push_back({group.name, group.color, group.handles});
    int number = 0;
    for (const int handle : group.handles)
      rig.handles[static_cast<std::size_t>(handle)].label = group.name + " " + std::to_string(++number);
  }
  if (rig.groups.empty()) {
    NewGroup all{sequence.name(), {1.0, 0.5, 0.2}, {}};
    for (std::size_t i = 0; i < rig.handles.size(); ++i)
      all.handles.push_back(static_cast<int>(i));
    rig.groups.push_back(std::move(all));
  }
  return rig;
}

} // namespace viscera::document

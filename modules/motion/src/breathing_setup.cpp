#include "viscera/motion/breathing_setup.h"

#include <memory>
#include <numeric>
#include <utility>

#include "sequence_binding.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/document/sequence_rig.h"
#include "viscera/sequences/breathing.h"

namespace viscera::motion {
namespace {

constexpr int kCorners = 8;
constexpr int kHandles = 38;

std::vector<int> rows(int begin, int end) {
  std::vector<int> list(static_cast<std::size_t>(end - begin));
  std::iota(list.begin(), list.end(), begin);
  return list;
}

} // namespace

SequenceSetup breathingSetup(const sample_organs::SampleLibrary& library,
                             sample_organs::Resolution resolution, Progress& progress, Threads threads) {
  SequenceSetup setup;
  runPart(progress, 0, 1, [&](Progress& part) {
    setup.organ = sample_organs::sampleOrgan(library, "liver", resolution, part, threads);
  });
  const auto mesh = surfaceOf(setup.organ, "outer");
  deformation::Placement placement;
  placement.count = kHandles;
  const Points handles = deformation::placeHandles(*mesh, placement);
  // The corners come first.
  std::vector<sequences::HandleGroup> groups{
      {"Far corners", {0.60, 0.60, 0.60}, rows(0, kCorners)},
      {"Liver", {0.90, 0.62, 0.00}, rows(kCorners, static_cast<int>(handles.rows()))}};
  setup.sequence =
      std::make_shared<sequences::LiverBreathing>(handles, boundsOf(mesh->points), std::move(groups));
  setup.rig = document::rigOf(*setup.sequence);
  return setup;
}

} // namespace viscera::motion

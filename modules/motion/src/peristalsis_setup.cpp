#include "viscera/motion/peristalsis_setup.h"

#include <memory>
#include <utility>

#include "sequence_binding.h"
#include "viscera/document/sequence_rig.h"
#include "viscera/sequences/peristalsis.h"

namespace viscera::motion {
namespace {

/// A little more than one handle spacing.
constexpr double kSoftnessMm = 25;
/// Where the time goes when nothing is cached.
constexpr double kOrganPart = 0.9;

} // namespace

SequenceSetup peristalsisSetup(const sample_organs::SampleLibrary& library,
                               sample_organs::Resolution resolution, Progress& progress, Threads threads) {
  SequenceSetup setup;
  runPart(progress, 0, kOrganPart, [&](Progress& part) {
    setup.organ = sample_organs::sampleOrgan(library, "stomach", resolution, part, threads);
  });
  setup.system = softCoordinates(kSoftnessMm);
  sequences::StomachRig rig = makeStomachRig(
      sequences::sampleStomachAnatomy(sample_organs::implicitSurface(library, "stomach", "stomach_smooth")));
  const Points rest = rig.restHandles();
  const auto volume =
      std::make_shared<const MovedVolume>(surfaceOf(setup.organ, "outer"), rest, setup.system, threads);
  setup.sequence = std::make_shared<sequences::Peristalsis>(
      std::move(rig), compensationFor(rest, setup.system, threads),
      [volume](const Points& pose, const Points& direction) { return volume->along(pose, direction); });
  setup.rig = document::rigOf(*setup.sequence);
  progress.report(1);
  return setup;
}

} // namespace viscera::motion

#include "viscera/workbench/loaded_sample.h"

#include <utility>

#include "viscera/anatomy/part.h"
#include "viscera/document/open_files.h"
#include "viscera/live/sequence_setup.h"

namespace viscera::workbench {
namespace {

void dress(std::vector<document::NewOrgan>& organs) {
  for (const document::NewOrgan& organ : organs)
    if (organ.parentInBatch >= 0)
      organs[static_cast<std::size_t>(organ.parentInBatch)].organ.look.opacity = kWallOpacity;
  for (document::NewOrgan& organ : organs) {
    document::OrganLook& look = organ.organ.look;
    const Colors& painted = organ.organ.mesh->colors;
    if (painted.rows() > 0)
      look.color = painted.cast<double>().colwise().mean().transpose() / 255.0;
    // Blood in its textbook colours: they stay apart also through the wall.
    if (const auto chamber = anatomy::chamberNamed(organ.organ.name))
      look.color = anatomy::colorOf(*chamber);
    look.vertexColors = organ.parentInBatch < 0;
  }
}

} // namespace

LoadedSample loadSample(const sample_organs::SampleLibrary& library, const std::string& name,
                        sample_organs::Resolution resolution, Progress& progress, Threads threads) {
  LoadedSample sample;
  for (const live::SampleSequence& motion : live::sampleSequences()) {
    if (motion.organ != name)
      continue;
    live::SequenceSetup setup = live::setUpSequence(library, motion.id, resolution, progress, threads);
    sample.organs = document::organsFrom(setup.organ);
    sample.motion = setup.sequence;
    sample.recipe = live::SampleMotion{motion.id, resolution};
    sample.rig = std::move(setup.rig);
    sample.system = std::move(setup.system);
    break;
  }
  if (!sample.motion)
    sample.organs =
        document::organsFrom(sample_organs::sampleOrgan(library, name, resolution, progress, threads));
  dress(sample.organs);
  return sample;
}

} // namespace viscera::workbench

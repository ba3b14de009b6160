#include "viscera/motion/sequence_setup.h"

#include "viscera/core/error.h"
#include "viscera/motion/breathing_setup.h"
#include "viscera/motion/heartbeat_setup.h"
#include "viscera/motion/peristalsis_setup.h"

namespace viscera::motion {
namespace {

using SetUp = SequenceSetup (*)(const sample_organs::SampleLibrary&, sample_organs::Resolution, Progress&,
                                Threads);

/// A sequence and the function that makes it.
struct Maker {
  SampleSequence about;
  SetUp setUp;
};

const std::vector<Maker>& makers() {
  static const std::vector<Maker> list{{{"heartbeat", "Heartbeat", "heart"}, heartbeatSetup},
                                       {{"peristalsis", "Gastric peristalsis", "stomach"}, peristalsisSetup},
                                       {{"breathing", "Breathing", "liver"}, breathingSetup}};
  return list;
}

} // namespace

const std::vector<SampleSequence>& sampleSequences() {
  static const std::vector<SampleSequence> list = [] {
    std::vector<SampleSequence> all;
    for (const Maker& maker : makers())
      all.push_back(maker.about);
    return all;
  }();
  return list;
}

SequenceSetup setUpSequence(const sample_organs::SampleLibrary& library, const std::string& id,
                            sample_organs::Resolution resolution, Progress& progress, Threads threads) {
  std::string known;
  for (const Maker& maker : makers()) {
    if (maker.about.id == id)
      return maker.setUp(library, resolution, progress, threads);
    known += (known.empty() ? "" : ", ") + maker.about.id;
  }
  throw UsageError("there is no sequence \"" + id + "\"", {}, "use one of: " + known);
}

} // namespace viscera::motion

#include "viscera/session/sequence_setup.h"

#include "viscera/core/error.h"
#include "viscera/session/breathing_setup.h"
#include "viscera/session/heartbeat_setup.h"
#include "viscera/session/open_files.h"
#include "viscera/session/peristalsis_setup.h"
#include "viscera/session/system_commands.h"

namespace viscera::session {
namespace {

using SetUp = SequenceSetup (*)(const organs::SampleLibrary&, organs::Resolution, Progress&, Threads);

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

SequenceSetup setUpSequence(const organs::SampleLibrary& library, const std::string& id,
                            organs::Resolution resolution, Progress& progress, Threads threads) {
  std::string known;
  for (const Maker& maker : makers()) {
    if (maker.about.id == id)
      return maker.setUp(library, resolution, progress, threads);
    known += (known.empty() ? "" : ", ") + maker.about.id;
  }
  throw UsageError("there is no sequence \"" + id + "\"", {}, "use one of: " + known);
}

Command showSequence(const SequenceSetup& setup) {
  const std::string name = "Show " + setup.sequence->name();
  return combined(name, {addOrgans(organsFrom(setup.organ)), replaceRig(setup.rig), setSystem(setup.system)});
}

} // namespace viscera::session

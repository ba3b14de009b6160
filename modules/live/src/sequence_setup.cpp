#include "viscera/live/sequence_setup.h"

#include <utility>

#include "measured_cavities.h"
#include "sample_heart.h"
#include "sequence_binding.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/rig_commands.h"
#include "viscera/heart/heartbeat.h"
#include "viscera/sequences/peristalsis.h"

namespace viscera::live {
namespace {

using sample_organs::SampleLibrary;

/// Part of the time of a heart with its beat that the organ takes when nothing is cached.
constexpr double kHeartPart = 0.8;

/// The cavities of its heart hold what the cycle says.
void makeHeartbeat(const SampleLibrary& library, SequenceSetup& setup, Progress& progress, Threads threads) {
  SampleHeart heart = sampleHeart(library, threads);
  progress.report(0.5, "heartbeat");
  progress.throwIfCancelled();
  setup.system = heart.system;
  const auto cavities = std::make_shared<const MeasuredCavities>(setup.organ, heart, threads);
  progress.throwIfCancelled();
  setup.sequence = std::make_shared<heart::CavityHeartbeat>(
      heart::CavityFit(std::move(heart.motion), std::move(heart.compensation),
                       [cavities](const Points& pose) { return cavities->at(pose); }),
      heart::CardiacCycle());
}

void makePeristalsis(const SampleLibrary& library, SequenceSetup& setup, Progress& /*progress*/,
                     Threads threads) {
  setup.system = softCoordinates(kSoftnessMm);
  sequences::StomachRig rig = makeStomachRig(
      sequences::sampleStomachAnatomy(sample_organs::implicitSurface(library, "stomach", "stomach_smooth")));
  const Points rest = rig.restHandles();
  const auto volume =
      std::make_shared<const MovedVolume>(surfaceOf(setup.organ, "outer"), rest, setup.system, threads);
  setup.sequence = std::make_shared<sequences::Peristalsis>(
      std::move(rig), compensationFor(rest, setup.system, threads), volumeAlong(volume));
}

void makeBreathing(const SampleLibrary& /*library*/, SequenceSetup& setup, Progress& /*progress*/,
                   Threads /*threads*/) {
  setup.sequence = liverBreathing(*surfaceOf(setup.organ, "outer"));
}

/// A sequence and the function that makes it, and its coordinates, for the organ that is there.
struct Maker {
  SampleSequence about;
  double organPart; ///< Of the time, when nothing is cached.
  void (*make)(const SampleLibrary&, SequenceSetup&, Progress&, Threads);
};

const std::vector<Maker>& makers() {
  static const std::vector<Maker> list{
      {{"heartbeat", "Heartbeat", "heart"}, kHeartPart, makeHeartbeat},
      {{"peristalsis", "Gastric peristalsis", "stomach"}, 0.9, makePeristalsis},
      {{"breathing", "Breathing", "liver"}, 1, makeBreathing}};
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

SequenceMatch matchesOrgan(const SampleSequence& sequence, const std::string& organName) {
  const auto part = anatomy::partNamed(organName);
  if (!part || part->extent != anatomy::Extent::whole)
    return SequenceMatch::unknown;
  if (part->chamber != anatomy::Chamber::none && sequence.organ == anatomy::kHeart.organ)
    return SequenceMatch::unknown;
  const bool muscle = part->organ == "myocardium" && sequence.organ == anatomy::kHeart.organ;
  return muscle || part->organ == sequence.organ ? SequenceMatch::yes : SequenceMatch::no;
}

SequenceSetup setUpSequence(const sample_organs::SampleLibrary& library, const std::string& id,
                            sample_organs::Resolution resolution, Progress& progress, Threads threads) {
  std::string known;
  for (const Maker& maker : makers()) {
    if (maker.about.id == id) {
      SequenceSetup setup;
      runPart(progress, 0, maker.organPart, [&](Progress& part) {
        setup.organ = sample_organs::sampleOrgan(library, maker.about.organ, resolution, part, threads);
      });
      runPart(progress, maker.organPart, 1,
              [&](Progress& part) { maker.make(library, setup, part, threads); });
      setup.rig = document::rigOf(*setup.sequence);
      progress.report(1);
      return setup;
    }
    known += (known.empty() ? "" : ", ") + maker.about.id;
  }
  throw UsageError(misuse("there is no sequence \"%1\"", id), {}, misuse("use one of: %1", known));
}

} // namespace viscera::live

#include "viscera/motion/sequence_setup.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "sample_heart.h"
#include "sequence_binding.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/content_hash.h"
#include "viscera/core/error.h"
#include "viscera/document/rig_commands.h"
#include "viscera/sequences/heartbeat.h"
#include "viscera/sequences/peristalsis.h"

namespace viscera::motion {
namespace {

using nlohmann::json;
using sample_organs::SampleLibrary;
using sequences::CardiacCycle;
using sequences::CavityVolumes;
using sequences::HeartbeatCalibration;

/// Of the time that a heart with its beat takes, what the organ takes when nothing is cached.
constexpr double kHeartPart = 0.8;

/// Lists of numbers by name.
using NumberTable = std::map<std::string, std::vector<double>>;

std::string hex(std::uint64_t key) {
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << key;
  return text.str();
}

bool allFinite(const NumberTable& table) {
  for (const auto& [name, numbers] : table)
    for (const double number : numbers)
      if (!std::isfinite(number))
        return false;
  return true;
}

/// Numbers that took long to find, one JSON file for each table, believed only under the key of all that they
/// depend on.
class NumberCache {
public:
  /// An empty path keeps nothing.
  explicit NumberCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The table, or nothing when it is not there, damaged, or of another key. The numbers are finite.
  std::optional<NumberTable> load(const std::string& name, std::uint64_t key) const {
    if (folder_.empty())
      return {};
    std::ifstream file(fileOf(name, key));
    try {
      const json contents = json::parse(file);
      if (contents.at("key") != hex(key))
        return {};
      NumberTable table = contents.at("numbers").get<NumberTable>();
      if (allFinite(table))
        return table;
    } catch (const json::exception&) {
      // Missing or damaged: whoever asked finds the numbers again.
    }
    return {};
  }

  /// Keeps a table for the next time, to the last bit; does nothing when the folder cannot be written.
  void store(const std::string& name, std::uint64_t key, const NumberTable& table) const {
    if (folder_.empty())
      return;
    std::error_code ignored;
    std::filesystem::create_directories(folder_, ignored);
    try {
      writeAtomically(fileOf(name, key), [&](std::ostream& out) {
        out << json{{"key", hex(key)}, {"numbers", table}}.dump(1) << '\n';
      });
    } catch (const CannotCreateError&) {
      // A cache that cannot be written costs time, nothing else.
    }
  }

private:
  std::filesystem::path fileOf(const std::string& name, std::uint64_t key) const {
    return folder_ / (name + '-' + hex(key) + ".json");
  }

  std::filesystem::path folder_;
};

/// The sample heart's beat, and how its corrections are found.
class HeartbeatMaker {
public:
  HeartbeatMaker(const SampleLibrary& library, const sample_organs::SampleOrgan& organ, Threads threads)
      : organ_(organ), threads_(threads), numbers_(library.cache), heart_(sampleHeart(library, threads)) {}

  const document::SystemChoice& system() const { return heart_.system; }

  std::shared_ptr<const sequences::Sequence> make(Progress& progress) const {
    return std::make_shared<sequences::CalibratedHeartbeat>(heart_.motion, cycle_, heart_.compensation,
                                                            calibration(progress));
  }

private:
  /// What the cache has, or what is found now and kept.
  HeartbeatCalibration calibration(Progress& progress) const {
    const std::uint64_t key = cacheKey();
    const std::string name = std::string("heartbeat-") + sample_organs::nameOf(organ_.resolution);
    if (const auto known = numbers_.load(name, key)) {
      const auto left = known->find("leftGain");
      const auto right = known->find("rightShift");
      if (left != known->end() && right != known->end())
        return {left->second, right->second};
    }
    const HeartbeatCalibration found =
        sequences::calibrateHeartbeat(heart_.motion, cycle_, heart_.compensation, measured(), progress);
    numbers_.store(name, key, {{"leftGain", found.leftGain}, {"rightShift", found.rightShift}});
    return found;
  }

  sequences::MeasureCavities measured() const {
    const auto moved = [&](const char* name) {
      return std::make_shared<MovedVolume>(surfaceOf(organ_, name), heart_.rest, heart_.system, threads_);
    };
    return [left = moved("lv"), right = moved("rv")](const Points& pose) {
      return CavityVolumes{left->at(pose), right->at(pose)};
    };
  }

  /// The cavities, the handles, and what the motion makes of them at a few instants: whoever changes a
  /// formula, a curve or the coordinates changes the key.
  std::uint64_t cacheKey() const {
    std::uint64_t key = 0;
    const auto add = [&key](const auto& array) {
      key = contentHash({reinterpret_cast<const char*>(array.data()),
                         static_cast<std::size_t>(array.size()) * sizeof(*array.data())},
                        key);
    };
    for (const char* name : {"lv", "rv"}) {
      add(surfaceOf(organ_, name)->points);
      add(surfaceOf(organ_, name)->triangles);
    }
    add(heart_.rest);
    Points pose;
    for (const double phase : {0.05, 0.2, 0.3, 0.5, 0.65}) {
      heart_.motion.pose(uncorrectedState(cycle_, phase), pose);
      heart_.compensation.apply(heart_.rest, pose);
      add(pose);
    }
    return key;
  }

  const sample_organs::SampleOrgan& organ_;
  Threads threads_;
  NumberCache numbers_;
  CardiacCycle cycle_;
  SampleHeart heart_;
};

/// Calibrated on the cavities of its heart. The corrections are kept in the library's cache under the hash of
/// all that they depend on; calibrating takes about a second otherwise.
void makeHeartbeat(const SampleLibrary& library, SequenceSetup& setup, Progress& progress, Threads threads) {
  const HeartbeatMaker maker(library, setup.organ, threads);
  setup.system = maker.system();
  setup.sequence = maker.make(progress);
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
  throw UsageError("there is no sequence \"" + id + "\"", {}, "use one of: " + known);
}

} // namespace viscera::motion

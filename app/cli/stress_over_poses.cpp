#include "cli/stress_over_poses.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "cli/played_sequence.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/live/sequence_file.h"
#include "viscera/live/stress_difference.h"
#include "viscera/live/stress_reading.h"
#include "viscera/sequences/keyframes.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

constexpr double kDegreesOfRadian = 180 / std::numbers::pi;
constexpr double kCourseMsPerSecond = 1000;
constexpr int kMostCurveInstants = 2000;
constexpr int kCurveDigits = 9;

/// The points of the mesh and the stress at them, in any pose.
class PosedTissue {
public:
  PosedTissue(const StressOverPosesOptions::Mapped& mapped, Progress& progress)
      : mapped_(mapped),
        positions_(mapped.input.system->bind(mapped.input.handles, mapped.interior.mesh().points,
                                             deformation::withTetgen(mapped.input.options), progress)) {}

  live::StressFrame at(const Points& pose) const {
    live::StressFrame frame;
    auto points = std::make_shared<Points>();
    auto map = std::make_shared<deformation::StressMap>();
    positions_->deform(pose, *points, mapped_.input.options.threads);
    mapped_.interior.gradients->evaluate(pose, *map, mapped_.input.options.threads);
    frame.mesh = mapped_.interior.sample.mesh;
    frame.points = std::move(points);
    frame.map = std::move(map);
    return frame;
  }

private:
  const StressOverPosesOptions::Mapped& mapped_;
  std::unique_ptr<coordinates::Binding> positions_;
};

/// A sequence with the labels of its handles.
struct LabelledSequence {
  std::shared_ptr<const sequences::Sequence> sequence;
  std::vector<std::string> labels;
};

LabelledSequence sequenceNamed(const std::string& name, CommandContext& context) {
  if (live::isSequenceFile(name)) {
    live::SequenceFile file = live::readSequence(name);
    return {std::make_shared<const sequences::KeyframedSequence>(std::move(file.track)),
            std::move(file.labels)};
  }
  PlayRequest request;
  request.sequence = name;
  const PlayedSequence played = playedSequence(request, context);
  LabelledSequence labelled{played.sequence, {}};
  for (const document::Handle& handle : played.rig.handles)
    labelled.labels.push_back(handle.label);
  return labelled;
}

/// The rig's handles at an instant: each is displaced as the sequence's handle of its label; others stay.
class RigPoses {
public:
  RigPoses(LabelledSequence of, const document::Rig& rig) : of_(std::move(of)), rest_(rig.restPositions()) {
    for (const std::string& label : of_.labels)
      rows_.push_back(rowOfHandle(rig, label));
  }

  double periodSeconds() const { return 60 / of_.sequence->standardRatePerMinute(); }
  Points at(double seconds) const {
    Points own;
    of_.sequence->poseAt(seconds, of_.sequence->standardRatePerMinute(), own);
    Points pose = rest_;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      pose.row(rows_[i]) += own.row(row) - of_.sequence->restHandles().row(row);
    }
    return pose;
  }

private:
  LabelledSequence of_;
  Points rest_;           ///< Of the rig.
  std::vector<int> rows_; ///< Of the rig, one for each handle of the sequence.
};

ordered_json summaryJson(const Values& values, Eigen::Index witnesses) {
  const live::QuantitySummary summary = live::summaryOf(values, witnesses);
  return {{"min", summary.min},
          {"mean", summary.mean},
          {"p95", summary.percentile95},
          {"max", summary.max},
          {"missing", summary.missing}};
}

/// What is measured at one instant.
struct CurveRow {
  double seconds = 0;
  deformation::StressStatistics statistics;
  std::vector<live::StressReading> probes;
};

/// Nothing where there is no tissue, or it is folded.
std::string cellOf(const live::StressReading& reading, const live::StressMeasure& measure) {
  const double value = live::valueOf(reading, measure);
  return std::isfinite(value) ? significant(value, kCurveDigits) : std::string();
}

constexpr std::size_t kWithoutMaterial = 4;
constexpr std::pair<const char*, live::StressQuantity> kCurveQuantities[] = {
    {"stress_degrees", live::StressQuantity::rotationalStress},
    {"volume_ratio", live::StressQuantity::volumeRatio},
    {"stretch_max", live::StressQuantity::stretchMax},
    {"stretch_min", live::StressQuantity::stretchMin},
    {"von_mises_kpa", live::StressQuantity::vonMises},
    {"strain_energy_kpa", live::StressQuantity::energy}};

/// The quantities of a curve: those of a material only of a stated one.
std::span<const std::pair<const char*, live::StressQuantity>>
curveQuantitiesOf(const elasticity::StatedMaterial& material) {
  return std::span(kCurveQuantities)
      .first(material.stated() ? std::size(kCurveQuantities) : kWithoutMaterial);
}

void writeCourse(const std::string& file, const std::vector<CurveRow>& rows,
                 const elasticity::StatedMaterial& material) {
  const std::string of = material.stated() ? ", " + live::nameOf(material).english() : std::string();
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "time_s,stress_degrees_min,stress_degrees_mean,stress_degrees_p95,stress_degrees_max,folded";
    for (std::size_t probe = 1; probe <= rows.front().probes.size(); ++probe)
      for (const auto& [name, quantity] : curveQuantitiesOf(material))
        stream << ','
               << csvField("probe" + std::to_string(probe) + '_' + name +
                           (live::describe(quantity).ofMaterial ? of : std::string()));
    stream << '\n';
    for (const CurveRow& row : rows) {
      stream << significant(row.seconds, kCurveDigits);
      const deformation::StressStatistics& s = row.statistics;
      for (const double angle : {s.min, s.mean, s.percentile95, s.max})
        stream << ',' << significant(kDegreesOfRadian * angle, kCurveDigits);
      stream << ',' << s.folded;
      for (const live::StressReading& probe : row.probes)
        for (const auto& [name, quantity] : curveQuantitiesOf(material))
          stream << ',' << cellOf(probe, {quantity, material});
      stream << '\n';
    }
  });
}

ordered_json courseJson(const std::vector<CurveRow>& rows, const elasticity::StatedMaterial& material) {
  ordered_json json = {{"timeMs", ordered_json::array()}, {"stressDegrees", ordered_json::object()}};
  for (const CurveRow& row : rows) {
    json["timeMs"].push_back(kCourseMsPerSecond * row.seconds);
    json["stressDegrees"]["mean"].push_back(kDegreesOfRadian * row.statistics.mean);
    json["stressDegrees"]["p95"].push_back(kDegreesOfRadian * row.statistics.percentile95);
    json["stressDegrees"]["max"].push_back(kDegreesOfRadian * row.statistics.max);
    json["folded"].push_back(row.statistics.folded);
  }
  json["probes"] = ordered_json::array();
  const char* const keys[] = {"stressDegrees", "volumeRatio", "stretchMax",
                              "stretchMin",    "vonMisesKpa", "strainEnergyKpa"};
  for (std::size_t probe = 0; probe < rows.front().probes.size(); ++probe) {
    ordered_json curve = {{"number", probe + 1}};
    for (const CurveRow& row : rows)
      for (std::size_t q = 0; q < curveQuantitiesOf(material).size(); ++q) {
        const double value = live::valueOf(row.probes[probe], {kCurveQuantities[q].second, material});
        curve[keys[q]].push_back(std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr));
      }
    json["probes"].push_back(std::move(curve));
  }
  return json;
}

} // namespace

std::vector<OutputOption> StressOverPosesOptions::outputs() {
  return {{.name = "--difference", .endings = {".vtu", ".csv", ".txt"}}, tableOutput("--curve-csv")};
}

void StressOverPosesOptions::addTo(CLI::App& options) {
  options
      .add_option("--before", before_,
                  "Another pose (.mrk.json): what the pose exceeds it by is computed as well")
      ->type_name("FILE");
  options
      .add_option("--difference", difference_,
                  "That difference as a map for ParaView (.vtu), or as a table (.csv)")
      ->type_name("FILE");
  options
      .add_option("--sequence", sequence_,
                  "A sequence (.sequence.json, heartbeat, ...) whose handles have the labels of REST: the "
                  "course of the stress over its cycle, also at every --probe")
      ->type_name("SEQUENCE");
  options.add_option("--instants", instants_, "Instants of the cycle")
      ->check(wholeBetween(2, kMostCurveInstants))
      ->capture_default_str();
  options.add_option("--curve-csv", curve_, "The course over the cycle as a table")->type_name("FILE");
}

void StressOverPosesOptions::check() const {
  if (before_.empty() && !difference_.empty())
    throw UsageError("A difference needs another pose", "--difference", "add --before POSE");
  if (sequence_.empty() && !curve_.empty())
    throw UsageError("A course needs a sequence", "--curve-csv", "add --sequence SEQUENCE");
}

void StressOverPosesOptions::compute(const Mapped& mapped, const std::vector<Vec3>& probes,
                                     CommandContext& context, Outcome& outcome) const {
  if (!before_.empty())
    compare(mapped, context, outcome);
  if (!sequence_.empty())
    follow(mapped, probes, context, outcome);
}

void StressOverPosesOptions::compare(const Mapped& mapped, CommandContext& context, Outcome& outcome) const {
  const PosedTissue tissue(mapped, context.progress);
  const live::StressFrame now = tissue.at(mapped.input.pose);
  const live::StressFrame before = tissue.at(poseInput(before_, mapped.input.rig, outcome.warnings));
  const auto difference = live::stressDifference(now, before, mapped.material);
  if (!difference)
    throw DataError("the two poses are not of the same points", before_);
  if (!difference_.empty())
    live::writeStressDifference(difference_, now, *difference);
  const Eigen::Index witnesses = now.mesh->witnesses;
  outcome.json["difference"] = {{"before", before_},
                                {"stressDegrees", summaryJson(difference->stressDegrees, witnesses)},
                                {"volumeRatio", summaryJson(difference->volumeRatio, witnesses)},
                                {"stretchMax", summaryJson(difference->stretchMax, witnesses)},
                                {"stretchMin", summaryJson(difference->stretchMin, witnesses)}};
  if (mapped.material.stated()) {
    outcome.json["difference"]["vonMisesKpa"] = summaryJson(difference->vonMisesKpa, witnesses);
    outcome.json["difference"]["strainEnergyKpa"] = summaryJson(difference->energyKpa, witnesses);
  }
  if (!difference_.empty())
    outcome.json["difference"]["file"] = difference_;
  const live::QuantitySummary degrees = live::summaryOf(difference->stressDegrees, witnesses);
  outcome.text += Listing()
                      .add("difference", fixed(degrees.min, 2) + " to " + fixed(degrees.max, 2) + " deg, " +
                                             fixed(degrees.mean, 2) + " on average")
                      .text();
}

void StressOverPosesOptions::follow(const Mapped& mapped, const std::vector<Vec3>& probes,
                                    CommandContext& context, Outcome& outcome) const {
  const RigPoses poses(sequenceNamed(sequence_, context), mapped.input.rig);
  const PosedTissue tissue(mapped, context.progress);
  const auto& mesh = mapped.interior.sample.mesh;
  std::optional<live::TissuePoints> points;
  if (!probes.empty())
    points.emplace(mesh, pointsOf(probes), live::probeReach(*mesh));
  std::vector<CurveRow> rows;
  for (int instant = 0; instant < instants_; ++instant) {
    context.progress.report(static_cast<double>(instant) / instants_, "stress over the cycle");
    context.progress.throwIfCancelled();
    const double seconds = poses.periodSeconds() * instant / instants_;
    const live::StressFrame frame = tissue.at(poses.at(seconds));
    rows.push_back({seconds, deformation::statisticsOf(*frame.map, mesh->witnesses),
                    points ? points->read(*frame.points, *frame.map) : std::vector<live::StressReading>()});
  }
  if (!curve_.empty())
    writeCourse(curve_, rows, mapped.material);
  ordered_json json = {{"sequence", sequence_}, {"periodMs", kCourseMsPerSecond * poses.periodSeconds()}};
  json.update(courseJson(rows, mapped.material));
  if (!curve_.empty())
    json["csv"] = curve_;
  outcome.json["overSequence"] = std::move(json);
  const CurveRow* worst = &rows.front();
  for (const CurveRow& row : rows)
    if (row.statistics.max > worst->statistics.max)
      worst = &row;
  outcome.text +=
      Listing()
          .add("over the cycle", "at most " + fixed(kDegreesOfRadian * worst->statistics.max, 2) + " deg, " +
                                     fixed(worst->seconds, 3) + " s after its beginning")
          .text();
}

} // namespace viscera::app::cli

#include "cli/commands/all_commands.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <vtkImageData.h>

#include "cli/cardiac_keys.h"
#include "cli/heart_signs.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "cli/played_sequence.h"
#include "cli/stage_options.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/document/open_files.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/heart/clinical_numbers.h"
#include "viscera/live/cycle_curves.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/scene/movie_writer.h"
#include "viscera/scene/picture.h"
#include "viscera/sequences/volume_curve.h"
#include "viscera/sequences/volume_record.h"

namespace viscera::app::cli {
namespace {

constexpr int kMostCycles = 1000;
constexpr int kMostColumns = 100;
constexpr int kMostOnASheet = 400;
constexpr double kLowestRate = 0.1;   ///< Frames a second that a sheet of a slow sequence needs.
constexpr double kHighestRate = 240;  ///< Frames a second that a movie is good for.
constexpr double kDrawingShare = 0.9; ///< Of the progress; the rest is closing the movie.

/// The surfaces on a stage, with or without signs below them, and the writers that take the pictures.
class FrameRenderer {
public:
  /// `signs` may be null; else it lives longer.
  FrameRenderer(const PlayedSequence& played, const StageOptions& options, double room, SignsBelow* signs,
                const CommandContext& context)
      : systems_(context.systems), played_(*played.bench), signs_(signs),
        stage_(stageFor(signs ? signs->above() : options, context.threads)) {
    show(std::nullopt);
    stage_.compose(scene::standardViewFromName(options.view), room);
  }

  void addWriter(const std::filesystem::path& target, double framesPerSecond) {
    writers_.push_back(std::make_unique<scene::MovieWriter>(
        target, scene::MovieOptions{.framesPerSecond = framesPerSecond}));
  }

  /// The pose that is shown, with these valves, at a fraction of the cycle in [0, 1].
  void addFrame(const std::optional<heart::ValveInstants>& valves, double fraction) {
    show(valves);
    vtkSmartPointer<vtkImageData> picture = stage_.picture();
    if (signs_)
      picture = signs_->below(picture, fraction);
    for (const auto& writer : writers_)
      writer->add(picture);
    if (keep_)
      kept_.push_back(picture);
  }

  /// Keeps all pictures from now on.
  void keep() { keep_ = true; }
  const std::vector<vtkSmartPointer<vtkImageData>>& kept() const { return kept_; }

  void finish(Progress& progress) {
    for (const auto& writer : writers_)
      writer->finish(progress);
  }

private:
  void show(const std::optional<heart::ValveInstants>& valves) {
    presentation::Scene scene{played_.state(), played_.organs(), view_, systems_};
    scene.valves = valves;
    stage_.presenter().update(scene);
  }

  const coordinates::Registry& systems_;
  workbench::Workbench& played_;
  SignsBelow* signs_;
  presentation::ViewState view_;
  presentation::Stage stage_;
  std::vector<std::unique_ptr<scene::MovieWriter>> writers_;
  std::vector<vtkSmartPointer<vtkImageData>> kept_;
  bool keep_ = false;
};

std::string sequenceNames() {
  std::string names;
  for (const live::SampleSequence& sequence : live::sampleSequences())
    names += (names.empty() ? "" : " or ") + sequence.id;
  return names;
}

/// A volume that a beat should leave as it is, ml.
struct KeptVolume {
  double restMl = 0;
  std::vector<double> ml;

  nlohmann::ordered_json json() const {
    const auto [low, high] = std::minmax_element(ml.begin(), ml.end());
    const double change = std::max(*high - restMl, restMl - *low) / restMl;
    return {{"minMl", *low}, {"maxMl", *high}, {"restMl", restMl}, {"maxRelativeChange", change}};
  }
  std::string text() const {
    const auto [low, high] = std::minmax_element(ml.begin(), ml.end());
    return fixed(*low, 1) + " to " + fixed(*high, 1) + " ml, at rest " + fixed(restMl, 1) + " ml";
  }
};

/// Measurements of the sample heart's walls.
struct Walls {
  KeptVolume chambers; ///< Chambers from outside less both cavities: muscle, and the atria with their blood.
  KeptVolume muscle;   ///< The left ventricle from outside less its cavity.
  std::optional<heart::WallMotion> motion;
};

void addWalls(const Walls& walls, nlohmann::ordered_json& json, Listing& listing) {
  constexpr double kGramsPerMl = 1.05;
  json["wallVolume"] = walls.chambers.json();
  json["leftVentricularMuscle"] = walls.muscle.json();
  json["leftVentricularMuscle"]["massG"] = kGramsPerMl * walls.muscle.restMl;
  listing.add("wall", walls.chambers.text())
      .add("LV muscle", walls.muscle.text() + ", " + fixed(kGramsPerMl * walls.muscle.restMl, 0) + " g");
  if (!walls.motion)
    return;
  const heart::WallMotion& motion = *walls.motion;
  json["wallMotion"] = {{"mapseMm", motion.mapseMm},
                        {"tapseMm", motion.tapseMm},
                        {"twistDegrees", motion.twistDegrees},
                        {"thickeningPercent", motion.thickeningPercent},
                        {"thinnestWallMm", motion.thinnestWallMm},
                        {"thickestWallMm", motion.thickestWallMm}};
  for (const heart::WallMotionRange& range : heart::wallMotionRanges())
    listing.add(range.name, fixed(motion.*range.value, 1) + ' ' + range.unit + " (" + fixed(range.low, 0) +
                                " to " + fixed(range.high, 0) + ")");
}

/// Measures at the keys of a key sequence: there the volumes are what was recorded.
void measureKeys(const PlayedSequence& played, live::MotionRunner& runner, double rate,
                 sequences::VolumeRecord& record) {
  const double stretch = played.sequence->standardRatePerMinute() / rate;
  for (const double key : played.sequence->keys()) {
    const double seconds = stretch * key;
    runner.show(seconds);
    record.add(seconds, runner.volumesMl());
  }
}

/// The surface whose ejection fraction is the heart's: the left ventricle, else the first cavity, else the
/// only surface of a key sequence. -1 for none.
int ventricleOf(const PlayedSequence& played) {
  const document::OrganList& organs = *played.bench->state().organs;
  for (std::size_t i = 0; i < played.surfaces.size(); ++i) // The sample's, whatever the session calls it.
    if (played.ofSession && organs[i]->origin.surface == "lv")
      return static_cast<int>(i);
  for (std::size_t i = 0; i < played.surfaces.size(); ++i)
    if (anatomy::chamberNamed(played.surfaces[i].name) == anatomy::kLeftVentricle)
      return static_cast<int>(i);
  if (played.sequence->keys().empty())
    return -1;
  if (played.surfaces.size() == 1)
    return 0;
  if (!played.ofSession)
    return 1;
  const auto cavity = std::find_if(organs.begin(), organs.end(),
                                   [](const auto& organ) { return static_cast<bool>(organ->parent); });
  return cavity == organs.end() ? -1 : static_cast<int>(cavity - organs.begin());
}

/// Adds the results of fitting the sequence to an organ.
void addFit(const live::RetargetedSequence& fitted, nlohmann::ordered_json& json, Listing& listing) {
  json["retargeted"] = {{"scale", fitted.scale},
                        {"handles", fitted.rig.handles.size()},
                        {"landmarks", nlohmann::ordered_json::array()}};
  std::string computed;
  for (const live::Landmark& landmark : fitted.landmarks.points) {
    const Vec3& p = landmark.position;
    json["retargeted"]["landmarks"].push_back(
        {{"name", landmark.role}, {"positionMm", {p.x(), p.y(), p.z()}}, {"computed", landmark.computed}});
    if (landmark.computed && computed.find(landmark.role) == std::string::npos)
      computed += (computed.empty() ? "" : ", ") + landmark.role;
  }
  listing.add("size", fixed(fitted.scale, 2) + " of the sample organ's")
      .add("computed", computed.empty() ? "nothing: all landmarks are given" : computed);
}

/// `viscera play`: plays a sequence, measures it, and records it.
class PlayCommand final : public Command {
public:
  std::string name() const override { return "play"; }
  std::string summary() const override { return "Play a sequence, measure it and record it"; }
  std::vector<OutputOption> outputs() const override {
    return {tableOutput("--csv"), pictureOutput("--sheet"),        {"--movie"},
            {"--frames"},         handleOutput("--write-handles"), handleOutput("--write-landmarks")};
  }

  void addOptions(CLI::App& options) override {
    options
        .add_option("SEQUENCE", request_.sequence,
                    sequenceNames() +
                        ", a .sequence.json file, or a session (.viscera), which is played as " +
                        "in the window: its organs, motion, locked volumes and circulation")
        ->required();
    options
        .add_option("--organ", request_.organ,
                    "What to move instead of the sequence's own organ: the sequence is fitted to it")
        ->type_name("ORGAN");
    options
        .add_option(
            "--landmarks", request_.landmarks,
            "Points on that organ (.mrk.json), labelled apex, base, right; or fundus, centreline-1, ..., "
            "body, pylorus. Those that are missing are computed")
        ->type_name("FILE");
    options.add_option("--landmark", request_.landmark, "One landmark in mm, LPS: apex=12.5,-40,7")
        ->type_name("NAME=X,Y,Z");
    options
        .add_option("--write-landmarks", landmarksOut_,
                    "Where to write the landmarks that were used (.mrk.json)")
        ->type_name("FILE");
    options.add_option("--handles", request_.handles, "Handle file; has to hold the sequence's own handles")
        ->type_name("FILE");
    options
        .add_option("--write-handles", handlesOut_,
                    "Where to write the sequence's handles in their groups, at rest (.mrk.json)")
        ->type_name("FILE");
    options
        .add_option(
            "--volume-curve", volumeCurve_,
            "Volume over the cycle that the outer surface is to have, as two columns (.csv): fraction of "
            "the cycle, or time_s, and ml; NAME=FILE for another surface, as in lv=F.csv")
        ->type_name("FILE");
    options
        .add_option("--scenario", request_.scenario,
                    "State of the circulation that the heart follows: rest, exercise, ..., "
                    "as 'viscera circulate --list' has them")
        ->type_name("NAME");
    options
        .add_option("--ejection-fraction", request_.ejectionFraction,
                    "Ejection fraction of the left ventricle of a heart with chambers that --organ names "
                    "(default 0.58)")
        ->type_name("PART")
        ->check(above(0));
    options.add_option("--rate", rate_, "Cycles a minute; the sequence's or session's own when not said")
        ->type_name("PER_MINUTE")
        ->check(above(0));
    options.add_option("--cycles", cycles_, "How many cycles")
        ->type_name("N")
        ->check(wholeBetween(1, kMostCycles))
        ->capture_default_str();
    options.add_option("--fps", framesPerSecond_, "Frames a second")
        ->type_name("F")
        ->check(between(kLowestRate, kHighestRate))
        ->capture_default_str();
    options.add_option("--frames", frames_, "Folder for numbered PNG pictures")->type_name("FOLDER");
    options.add_option("--movie", movie_, "Movie to write: .ogv, or .mp4 and .gif where ffmpeg is installed")
        ->type_name("FILE");
    options.add_option("--csv", csv_, "Table of the volumes over time")->type_name("FILE");
    options.add_option("--sheet", sheet_, "One picture (.png) of all frames, side by side")
        ->type_name("FILE");
    options.add_option("--columns", columns_, "Frames beside each other on the sheet")
        ->check(wholeBetween(1, kMostColumns))
        ->capture_default_str();
    signs_.addTo(options);
    addStageOptions(options, stage_, size_);
  }

  Outcome run(CommandContext& context) override {
    const auto begin = std::chrono::steady_clock::now();
    stage_.size = pictureSize(size_);
    if (signs_.given() && !draws())
      throw UsageError("There is no picture to draw them below", signs_.text(),
                       "ask for one with --movie, --frames or --sheet");
    if (!csv_.empty())
      const AtomicFile writable(csv_); // Fails before the work, not after it.
    request_.ratePerMinute = rate_;
    PlayedSequence played = playedSequence(request_, context);
    writeRig(played);
    const double rate = rateOf(played);
    const int frames = workbench::frameCount(rate, framesPerSecond_, cycles_);
    const Measured measured = play(played, rate, frames, context);
    if (!csv_.empty())
      sequences::writeVolumeTable(csv_, measured.volumes, anatomy::chamberKeys(measured.volumes.names()));
    Outcome outcome = report(played, measured, rate);
    outcome.warnings = std::move(played.warnings);
    if (!measured.obstacle.empty())
      outcome.warnings.push_back(measured.obstacle);
    outcome.json["warnings"] = outcome.warnings;
    outcome.json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return outcome;
  }

private:
  bool draws() const { return !frames_.empty() || !movie_.empty() || !sheet_.empty(); }

  /// The measurements of a played sequence.
  struct Measured {
    sequences::VolumeRecord volumes; ///< At the frames.
    sequences::VolumeRecord atKeys;  ///< Of a key sequence: at its keys, which frames may miss.
    live::CycleCurves cycle;         ///< The whole cycle, so that no extreme depends on the frames.
    std::optional<Walls> walls;      ///< Of the sample heart.
    /// Where a session's locked volumes could not be kept first, in words; else empty.
    std::string obstacle = {};
    std::vector<std::string> signs = {}; ///< That are drawn.

    /// All volumes of a surface, ml: at least one.
    std::vector<double> of(std::size_t surface) const {
      std::vector<double> values = volumes.column(surface);
      for (const std::vector<double>& more : {atKeys.column(surface), cycle.milliliters[surface]})
        values.insert(values.end(), more.begin(), more.end());
      return values;
    }
  };

  /// The rate to play at. Throws `UsageError` outside what the sequence allows.
  double rateOf(const PlayedSequence& played) const {
    const sequences::Sequence& sequence = *played.sequence;
    if (rate_ == 0 && played.ratePerMinute > 0)
      return played.ratePerMinute;
    if (rate_ == 0 || !request_.scenario.empty())
      return sequence.standardRatePerMinute();
    if (rate_ < sequence.lowestRatePerMinute() || rate_ > sequence.highestRatePerMinute())
      throw UsageError("It is not a rate at which " + sequence.id() + " can be played",
                       "--rate " + significant(rate_, 6),
                       "from " + significant(sequence.lowestRatePerMinute(), 6) + " to " +
                           significant(sequence.highestRatePerMinute(), 6) + " a minute");
    return rate_;
  }

  /// Writes the handles and landmarks that are asked for.
  void writeRig(const PlayedSequence& played) const {
    if (!handlesOut_.empty())
      medical_io::writeHandles(handlesOut_, played.ofSession
                                                ? document::handleFile(*played.bench->state().rig)
                                                : document::handleFile(document::completed(played.rig)));
    if (landmarksOut_.empty())
      return;
    if (!played.retargeted)
      throw UsageError("There are no landmarks of this motion", "--write-landmarks",
                       "name another organ without chambers with --organ");
    medical_io::writeHandles(landmarksOut_, live::landmarkFile(played.retargeted->landmarks, "Landmarks"));
  }

  /// A runner with the volume that is prescribed: "FILE" for the outer surface, "NAME=FILE" for another one.
  live::MotionRunner& runnerOf(PlayedSequence& played, double rate) const {
    played.bench->setSequence(played.sequence, rate);
    live::MotionRunner& runner = played.bench->motion();
    runner.prescribe(played.prescribed);
    if (volumeCurve_.empty())
      return runner;
    const std::size_t equal = volumeCurve_.find('=');
    const int named = equal == std::string::npos ? -1 : played.find(volumeCurve_.substr(0, equal));
    const std::string file = named < 0 ? volumeCurve_ : volumeCurve_.substr(equal + 1);
    runner.prescribe(live::PrescribedVolume{played.surfaces[std::max(named, 0)].organ,
                                            sequences::readVolumeCurve(file, 60 / rate)});
    runner.requireReachable();
    return runner;
  }

  /// The volumes of the walls out of those of a heart's surfaces.
  static double chambersMl(const PlayedSequence& played, const std::vector<double>& row) {
    double volume = row[played.surfaces.size()];
    for (const char* cavity : {"lv", "rv", "la", "ra"})
      if (const int found = played.find(cavity); found >= 0)
        volume -= row[static_cast<std::size_t>(found)];
    return volume;
  }
  static double muscleMl(const PlayedSequence& played, const std::vector<double>& row) {
    return row[played.surfaces.size() + 1] - row[static_cast<std::size_t>(played.find("lv"))];
  }
  static Walls wallsAtRest(const PlayedSequence& played) {
    std::vector<double> row;
    for (std::size_t i = 0; i < played.bench->state().organs->size(); ++i)
      row.push_back(played.restMl(i));
    Walls walls;
    walls.chambers.restMl = chambersMl(played, row);
    walls.muscle.restMl = muscleMl(played, row);
    return walls;
  }
  static void measureWalls(const PlayedSequence& played, const std::vector<double>& row, Walls& walls) {
    walls.chambers.ml.push_back(chambersMl(played, row));
    walls.muscle.ml.push_back(muscleMl(played, row));
  }

  /// A volume that cannot be met ends a play with a curve; locked ones leave the organs as they were.
  void noteObstacle(const live::MotionRunner& runner, double seconds, Measured& measured) const {
    if (runner.obstacle().empty())
      return;
    const std::string place = " at " + fixed(seconds, 3) + " s: " + runner.obstacle().english();
    if (!volumeCurve_.empty())
      throw DataError("the volume cannot be met" + place, volumeCurve_,
                      "ask for a volume nearer to that at rest");
    if (measured.obstacle.empty())
      measured.obstacle = "the locked volumes cannot be kept, and the organs stay as they were," + place;
  }

  /// Plays every frame, and records those that are asked for.
  Measured play(PlayedSequence& played, double rate, int frames, CommandContext& context) const {
    std::vector<std::string> names;
    for (const PlayedSurface& surface : played.surfaces)
      names.push_back(surface.name);
    Measured measured{sequences::VolumeRecord(names), sequences::VolumeRecord(names), {}, {}};
    std::optional<SignsBelow> signs;
    if (signs_.given()) {
      signs.emplace(signs_, toldBeat(*played.sequence, played.driving, rate), stage_);
      measured.signs = signs->drawn();
    }
    std::optional<FrameRenderer> recording;
    if (draws())
      recording.emplace(played, stage_, sheet_.empty() ? 0 : kRoomOnASheet, signs ? &*signs : nullptr,
                        context);
    if (!frames_.empty())
      recording->addWriter(std::filesystem::path(frames_) / "",
                           framesPerSecond_); // A folder, whatever its name.
    if (!movie_.empty())
      recording->addWriter(movie_, framesPerSecond_);
    if (!sheet_.empty()) {
      if (frames > kMostOnASheet)
        throw UsageError(std::to_string(frames) + " frames do not fit on a sheet", "--sheet " + sheet_,
                         "ask for fewer with --fps; " + std::to_string(kMostOnASheet) + " at most");
      recording->keep();
    }
    live::MotionRunner& runner = runnerOf(played, rate);
    if (played.hasWalls)
      measured.walls = wallsAtRest(played);
    for (int frame = 0; frame < frames; ++frame) {
      context.progress.throwIfCancelled();
      const double seconds = frame / framesPerSecond_;
      runner.show(seconds);
      std::vector<double> row = runner.volumesMl();
      noteObstacle(runner, seconds, measured);
      if (played.hasWalls)
        measureWalls(played, row, *measured.walls);
      row.resize(played.surfaces.size());
      measured.volumes.add(seconds, row);
      if (recording)
        recording->addFrame(heart::valvesAt(*played.sequence, seconds, rate),
                            std::fmod(seconds * rate / 60, 1));
      context.progress.report(kDrawingShare * (frame + 1) / frames, "playing");
    }
    measureKeys(played, runner, rate, measured.atKeys);
    Progress quiet;
    measured.cycle = live::measureCycle(runner, quiet);
    if (measured.walls)
      measured.walls->motion = measured.cycle.wall;
    if (recording)
      recording->finish(context.progress);
    if (!sheet_.empty())
      scene::writeSmallPng(sheet_, scene::contactSheet(recording->kept(), columns_));
    return measured;
  }

  /// Adds the ejection fraction and what belongs to it, as far as the surfaces are closed.
  void addIndices(const PlayedSequence& played, const Measured& measured, double rate, Outcome& outcome,
                  Listing& listing) const {
    outcome.json["ejectionFraction"] = nullptr;
    const int ventricle = ventricleOf(played);
    for (std::size_t i = 0; i < played.surfaces.size(); ++i) {
      // The keys of a key sequence are what was measured: the numbers are those of `viscera track`.
      const bool hasKeys = measured.atKeys.rows() > 0;
      const std::vector<double> values = hasKeys ? measured.atKeys.column(i) : measured.of(i);
      const bool isVentricle = static_cast<int>(i) == ventricle;
      if ((!isVentricle && !hasKeys) || !(*std::min_element(values.begin(), values.end()) > 0))
        continue;
      const heart::CardiacIndices indices = heart::cardiacIndices(values, rate);
      if (hasKeys)
        setUnderNames(outcome.json["indices"], played.surfaces[i].name, cardiacJson(indices));
      if (!isVentricle)
        continue;
      outcome.json["ejectionFraction"] = indices.ejectionFraction;
      outcome.json["strokeVolumeMl"] = indices.strokeVolumeMl;
      outcome.json["cardiacOutputLPerMinute"] = indices.cardiacOutputLPerMinute;
      outcome.json["endDiastolicVolumeMl"] = indices.endDiastolicMl;
      outcome.json["endSystolicVolumeMl"] = indices.endSystolicMl;
      listing.add("ejection fraction", fixed(indices.ejectionFraction, 3))
          .add("stroke volume", fixed(indices.strokeVolumeMl, 1) + " ml")
          .add("output", fixed(indices.cardiacOutputLPerMinute, 2) + " l a minute");
    }
  }

  Outcome report(const PlayedSequence& played, const Measured& measured, double rate) const {
    const sequences::VolumeRecord& volumes = measured.volumes;
    Outcome outcome;
    outcome.json = {{"sequence", played.sequence->id()},
                    {"ratePerMinute", rate},
                    {"frames", volumes.rows()},
                    {"cycles", cycles_},
                    {"framesPerSecond", framesPerSecond_},
                    {"warnings", played.warnings}};
    if (!request_.scenario.empty())
      outcome.json["scenario"] = request_.scenario;
    Listing listing;
    listing.add("sequence", played.sequence->name().english() + ", " + significant(rate, 6) + " a minute")
        .add("frames", std::to_string(volumes.rows()));
    double outerChange = 0;
    for (std::size_t i = 0; i < played.surfaces.size(); ++i) {
      const PlayedSurface& surface = played.surfaces[i];
      const std::vector<double> values = measured.of(i);
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      const double rest = played.restMl(i);
      setUnderNames(outcome.json["volumes"], surface.name,
                    {{"minMl", *low}, {"maxMl", *high}, {"restMl", rest}});
      listing.add(surface.name, fixed(*low, 1) + " to " + fixed(*high, 1) + " ml");
      if (i == 0 && rest > 0) // An open surface has no volume.
        outerChange = std::max(*high - rest, rest - *low) / rest;
    }
    outcome.json["maxRelativeOuterChange"] = outerChange;
    listing.add("outer change", fixed(100 * outerChange, 1) + " % at most");
    addIndices(played, measured, rate, outcome, listing);
    if (measured.walls)
      addWalls(*measured.walls, outcome.json, listing);
    if (played.retargeted)
      addFit(*played.retargeted, outcome.json, listing);
    if (!measured.signs.empty())
      outcome.json["signs"] = measured.signs;
    for (const auto& [key, target] :
         {std::pair("csv", csv_), std::pair("movie", movie_), std::pair("folder", frames_),
          std::pair("sheet", sheet_), std::pair("handles", handlesOut_),
          std::pair("landmarksFile", landmarksOut_), std::pair("volumeCurve", volumeCurve_)})
      if (!target.empty()) {
        outcome.json[key] = target;
        listing.add(key, target);
      }
    outcome.text = listing.text();
    return outcome;
  }

  PlayRequest request_;
  std::string handlesOut_;
  std::string landmarksOut_;
  std::string volumeCurve_;
  double rate_ = 0; ///< 0: the sequence's own.
  int cycles_ = 1;
  double framesPerSecond_ = 25;
  std::string frames_;
  std::string movie_;
  std::string csv_;
  std::string sheet_;
  int columns_ = 6;
  SignsOption signs_;
  std::string size_ = "1280x800";
  StageOptions stage_;
};

} // namespace

std::unique_ptr<Command> playCommand() {
  return std::make_unique<PlayCommand>();
}

} // namespace viscera::app::cli

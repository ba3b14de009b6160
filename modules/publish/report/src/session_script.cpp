#include "viscera/report/session_script.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include <nlohmann/json.hpp>

#include "viscera/circulation/scenario.h"
#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/core/text.h"
#include "viscera/document/open_files.h"
#include "viscera/live/sequence_file.h"
#include "viscera/presentation/space_parts.h"

namespace viscera::report {
namespace {

using nlohmann::ordered_json;

constexpr const char* kEnd = "END_OF_FILE"; ///< No line of the JSON files is this.
constexpr const char* kRest = "handles.mrk.json";
constexpr const char* kPose = "pose.mrk.json";
constexpr const char* kCage = "cage.off";
constexpr const char* kSequence = "recorded.sequence.json";
constexpr const char* kLandmarks = "landmarks.mrk.json";
constexpr const char* kSchema = "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/"
                                "Markups/Resources/Schema/markups-schema-v1.0.3.json#";

/// A word of the shell, whatever is in it.
std::string word(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) ||
           (c < 128 && std::string_view("-_./:@=,+%").find(static_cast<char>(c)) != std::string_view::npos);
  });
  if (plain)
    return text;
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

/// One line of a comment, whatever is in it: what a name holds must not end the line and become a command.
std::string comment(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  return "# " + text + '\n';
}

/// A file's name that every system takes, for an organ.
std::string stemOf(const std::string& name) {
  std::string stem;
  for (const char c : name)
    stem += std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 128 ? c : '_';
  return stem.empty() ? "organ" : stem;
}

std::string numberText(double value) {
  return ordered_json(value).dump();
}

std::string dumped(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

/// A group of points as 3D Slicer keeps it, one point a line.
std::string listText(const std::string& name, const Vec3& color, const std::vector<std::string>& labels,
                     const std::vector<Vec3>& places) {
  const ordered_json rgb = {color.x(), color.y(), color.z()};
  std::string text = "{\"type\": \"Fiducial\", \"name\": " + dumped(name) +
                     ", \"coordinateSystem\": \"LPS\", \"coordinateUnits\": \"mm\",\n \"display\": " +
                     dumped({{"color", rgb}, {"selectedColor", rgb}}) + ", \"controlPoints\": [\n";
  for (std::size_t i = 0; i < places.size(); ++i)
    text += "  " +
            dumped({{"id", std::to_string(i + 1)},
                    {"label", labels[i]},
                    {"position", {places[i].x(), places[i].y(), places[i].z()}},
                    {"positionStatus", "defined"}}) +
            (i + 1 < places.size() ? ",\n" : "\n");
  return text + " ]}";
}

std::string markupsText(const std::vector<std::string>& lists) {
  std::string text = "{\"@schema\": \"" + std::string(kSchema) + "\", \"markups\": [\n";
  for (std::size_t i = 0; i < lists.size(); ++i)
    text += lists[i] + (i + 1 < lists.size() ? ",\n" : "\n");
  return text + "]}\n";
}

/// Writes the script from its beginning to its end.
class Writer {
public:
  explicit Writer(const ScriptSource& source) : source_(source), state_(source.state) {
    const bool played = source.view.shownPose.rows() == state_.pose->rows() && state_.pose->rows() > 0;
    pose_ = played ? source.view.shownPose : *state_.pose;
    const Points rest = state_.rig->restPositions();
    for (Eigen::Index row = 0; row < pose_.rows(); ++row)
      if (pose_.row(row) != rest.row(row))
        moved_.push_back(row);
  }

  SessionScript run() {
    begin();
    if (!state_.rig->handles.empty())
      writeHandles();
    for (const auto& organ : *state_.organs)
      writeOrgan(*organ);
    writeStress();
    writeMotion();
    writePicture();
    writeLeftOut();
    return std::move(script_);
  }

private:
  void say(const std::string& text) { script_.text += comment(text); }
  void paragraph(const std::string& text) {
    script_.text += '\n';
    say(text);
  }
  void command(const std::vector<std::string>& words) {
    std::string line = "viscera";
    for (const std::string& one : words)
      line += ' ' + word(one);
    script_.text += line + '\n';
    script_.commands.push_back(std::move(line));
  }
  void file(const char* name, const std::string& contents) {
    script_.text += std::string("cat > ") + name + " <<'" + kEnd + "'\n" + contents + kEnd + "\n";
  }

  void begin();
  void writeHandles();
  void writeOrgan(const document::Organ& organ);
  void addMarks(const document::Organ& organ, std::vector<std::string>& words) const;
  void writeStress();
  void writeMotion();
  void writeChosen(const presentation::MotionChoice& motion);
  void writeKeySequence();
  std::string onlyInSession(bool driven) const;
  bool playSession(const std::string& reason, const std::string& table, bool driven);
  void writePicture();
  void writeLeftOut();
  static std::string landmarksText(const live::Landmarks& landmarks);
  /// The handles, the pose and the coordinates, as all commands take them.
  std::vector<std::string> bound(std::vector<std::string> words) const;
  std::vector<std::string> system() const;
  /// How a command finds an organ; nothing when only a session that is not saved holds it.
  std::optional<std::string> nameOf(const document::Organ& organ);
  std::string outputOf(const document::Organ& organ, const std::string& ending);
  bool isStill() const { return moved_.empty(); }

  const ScriptSource& source_;
  const document::DocumentState& state_;
  Points pose_;
  std::vector<Eigen::Index> moved_;
  std::map<document::OrganId, std::optional<std::string>> names_;
  std::map<document::OrganId, std::string> stems_;
  SessionScript script_;
};

void Writer::begin() {
  const std::string name = source_.session.filename().string();
  script_.text = "#!/bin/sh\n";
  say(name.empty() ? "A session of Viscera " VISCERA_VERSION " that is not saved, as commands."
                   : "The session " + name + " as commands of Viscera " VISCERA_VERSION ".");
  say("They make the same shapes and numbers. Run them in a folder of their own: files are written there.");
  script_.text += "set -e\n";
  std::set<std::string> taken;
  for (const auto& organ : *state_.organs) {
    std::string stem = stemOf(organ->name);
    for (int number = 2; !taken.insert(stem).second; ++number)
      stem = stemOf(organ->name) + '-' + std::to_string(number);
    stems_[organ->id] = stem;
  }
}

void Writer::writeHandles() {
  const document::Rig& rig = *state_.rig;
  std::set<document::HandleId> grouped;
  std::vector<std::string> lists;
  const auto add = [&](const std::string& name, const Vec3& color,
                       const std::vector<document::HandleId>& ids) {
    std::vector<std::string> labels;
    std::vector<Vec3> places;
    for (const document::HandleId id : ids) {
      const document::Handle& handle = rig.handles[static_cast<std::size_t>(rig.indexOf(id))];
      labels.push_back(handle.label);
      places.push_back(handle.rest);
    }
    if (!ids.empty())
      lists.push_back(listText(name, color, labels, places));
  };
  for (const document::Group& group : rig.groups) {
    add(group.name, group.color, group.handles);
    grouped.insert(group.handles.begin(), group.handles.end());
  }
  std::vector<document::HandleId> others;
  for (const document::Handle& handle : rig.handles)
    if (!grouped.count(handle.id))
      others.push_back(handle.id);
  add("Handles", {1.0, 0.5, 0.2}, others);
  paragraph("The handles at rest, in mm, LPS.");
  file(kRest, markupsText(lists));
  if (!isStill()) {
    std::vector<std::string> labels;
    std::vector<Vec3> places;
    for (const Eigen::Index row : moved_) {
      labels.push_back(rig.handles[static_cast<std::size_t>(row)].label);
      places.emplace_back(pose_.row(row).transpose());
    }
    paragraph(source_.view.shownPose.rows() > 0
                  ? "The handles that the sequence has moved, at the instant that the session shows."
                  : "The handles that are moved.");
    file(kPose, markupsText({listText("Pose", {1.0, 0.5, 0.2}, labels, places)}));
  }
  if (rig.cage.empty())
    return;

  std::map<document::HandleId, std::size_t> corners;
  std::string points, triangles;
  for (const document::CageTriangle& triangle : rig.cage) {
    triangles += '3';
    for (const document::HandleId id : triangle) {
      const auto [corner, isNew] = corners.emplace(id, corners.size());
      if (isNew) {
        const Vec3& at = rig.handles[static_cast<std::size_t>(rig.indexOf(id))].rest;
        points += numberText(at.x()) + ' ' + numberText(at.y()) + ' ' + numberText(at.z()) + '\n';
      }
      triangles += ' ' + std::to_string(corner->second);
    }
    triangles += '\n';
  }
  paragraph("The cage over the handles.");
  file(kCage, "OFF\n" + std::to_string(corners.size()) + ' ' + std::to_string(rig.cage.size()) + " 0\n" +
                  points + triangles);
}

std::vector<std::string> Writer::system() const {
  std::vector<std::string> words = {"--system", state_.system->id};
  for (const auto& [name, value] : state_.system->parameters.all())
    words.insert(words.end(), {"--param", name + '=' + numberText(value)});
  if (!state_.rig->cage.empty())
    words.insert(words.end(), {"--cage", kCage});
  return words;
}

std::vector<std::string> Writer::bound(std::vector<std::string> words) const {
  words.insert(words.end(), {"--handles", kRest, "--pose", isStill() ? kRest : kPose});
  const std::vector<std::string> coordinates = system();
  words.insert(words.end(), coordinates.begin(), coordinates.end());
  return words;
}

/// Whether the organ's file is still what was read.
bool isInItsFile(const document::Organ& organ) {
  std::error_code unreachable;
  if (organ.file.empty() || organ.origin.fileHash.empty() ||
      !std::filesystem::exists(organ.file, unreachable))
    return false;
  try {
    const document::Organ now = document::readOrgan(organ.file);
    return now.mesh->points == organ.mesh->points && now.mesh->triangles == organ.mesh->triangles;
  } catch (const Error&) {
    return false;
  }
}

std::optional<std::string> Writer::nameOf(const document::Organ& organ) {
  const auto known = names_.find(organ.id);
  if (known != names_.end())
    return known->second;
  std::optional<std::string> name;
  const std::string& sample = organ.origin.sample;
  if (const std::size_t at = sample.find('@'); at != std::string::npos)
    name = "sample:" + sample.substr(0, at) +
           (organ.origin.surface.empty() ? "" : "/" + organ.origin.surface) + sample.substr(at);
  else if (isInItsFile(organ))
    name = absolutePath(organ.file).string();
  else if (!source_.session.empty()) {
    const auto same = std::count_if(state_.organs->begin(), state_.organs->end(),
                                    [&](const auto& other) { return other->name == organ.name; });
    const auto place = std::find_if(state_.organs->begin(), state_.organs->end(),
                                    [&](const auto& other) { return other->id == organ.id; });
    name = absolutePath(source_.session).string() + '/' +
           (same == 1 ? organ.name : std::to_string(place - state_.organs->begin() + 1));
  }
  names_[organ.id] = name;
  return name;
}

std::string Writer::outputOf(const document::Organ& organ, const std::string& ending) {
  return stems_.at(organ.id) + ending;
}

void Writer::writeOrgan(const document::Organ& organ) {
  const auto name = nameOf(organ);
  paragraph(organ.name + (state_.rig->handles.empty() ? ", as it is."
                          : isStill()                 ? ", at rest."
                                                      : ", posed."));
  if (!name)
    return say("Its surface is in no file: save the session and copy its commands again.");
  if (organ.volumeLocked)
    say("Its volume is locked: the pose already keeps it, so that no --lock-volume is needed.");
  if (state_.rig->handles.empty())
    return command({"info", *name});
  std::vector<std::string> words = bound({"deform", *name});
  const document::Mobility usual = document::usualMobility(organ.file.stem().string());
  if (organ.mobility != usual || usual != document::Mobility::bends)
    words.insert(words.end(), {"--mobility", document::nameOf(organ.mobility)});
  words.insert(words.end(), {"-o", outputOf(organ, ".vtp")});
  command(words);
}

/// The probes and profiles that are pinned in the organ; those of the window have the same numbers.
void Writer::addMarks(const document::Organ& organ, std::vector<std::string>& words) const {
  constexpr int kDigits = 9;
  const auto placeOf = [](const document::StressProbe& probe) {
    return significant(probe.rest.x(), kDigits) + "," + significant(probe.rest.y(), kDigits) + "," +
           significant(probe.rest.z(), kDigits);
  };
  const document::StressMarks& marks = *state_.stressMarks;
  for (const document::StressProbe& probe : marks.probes)
    if (probe.organ == organ.id)
      words.insert(words.end(), {"--probe", placeOf(probe)});
  for (const document::StressLine& line : marks.lines)
    if (const document::StressProbe* from = marks.probe(line.from), *to = marks.probe(line.to);
        from && to && from->organ == organ.id)
      words.insert(words.end(), {"--profile", placeOf(*from) + ":" + placeOf(*to)});
}

void Writer::writeStress() {
  if (!source_.view.shown.stress || state_.rig->handles.empty())
    return;
  const auto organ = presentation::currentOrgan(state_, source_.view.selection.organ);
  const auto name = organ ? nameOf(*organ) : std::nullopt;
  if (!name)
    return;
  paragraph("The stress inside " + organ->name + '.');
  std::vector<std::string> words = bound({"stress", *name});
  for (const auto& cavity : *state_.organs) {
    if (cavity->parent != organ->id || !cavity->closed())
      continue;
    if (const auto inside = nameOf(*cavity))
      words.insert(words.end(), {"--cavity", *inside});
    else
      say("Its cavity " + cavity->name + " is in no file and is taken for tissue here.");
  }
  words.insert(words.end(), {"--witnesses", std::to_string(source_.view.stress.witnesses), "-o",
                             outputOf(*organ, ".stress.vtu"), "--csv", outputOf(*organ, ".stress.csv")});
  addMarks(*organ, words);
  command(words);
  if (source_.view.stress.peak)
    say("The maximum over a cycle has no command: the window finds it in the Stress mode.");
}

std::string Writer::landmarksText(const live::Landmarks& landmarks) {
  std::vector<std::string> labels;
  std::vector<Vec3> places;
  for (const live::Landmark& point : landmarks.points) {
    labels.push_back(point.role);
    places.push_back(point.position);
  }
  return markupsText({listText("Landmarks", {0.2, 0.7, 0.6}, labels, places)});
}

void Writer::writeMotion() {
  const presentation::ViewState& view = source_.view;
  const int chosen = view.playing ? view.playing->motion : view.motions.empty() ? -1 : 0;
  if (chosen < 0 || static_cast<std::size_t>(chosen) >= view.motions.size())
    return writeKeySequence();
  writeChosen(view.motions[static_cast<std::size_t>(chosen)]);
}

void Writer::writeChosen(const presentation::MotionChoice& motion) {
  const auto organ = state_.organ(motion.organ);
  if (!organ)
    return;
  const std::string sequence = live::sequenceOf(motion.recipe);
  if (sequence.empty())
    return paragraph("Nothing is known of how the session's sequence was made.");
  std::vector<std::string> words = {"play", sequence};
  std::string landmarks;
  if (const auto* fitted = std::get_if<live::FittedMotion>(&motion.recipe)) {
    const auto name = nameOf(*organ);
    if (!name)
      return paragraph("The sequence was fitted to " + organ->name + ", which is in no file.");
    words.insert(words.end(), {"--organ", *name});
    if (!fitted->given.points.empty()) {
      landmarks = landmarksText(fitted->given);
      words.insert(words.end(), {"--landmarks", kLandmarks});
    }
  } else if (const auto* shipped = std::get_if<live::SampleMotion>(&motion.recipe)) {
    const std::string& sample = organ->origin.sample;
    if (const std::size_t at = sample.find('@'); at != std::string::npos)
      words.insert(words.end(), {"--organ", "sample:" + sample.substr(0, at) + '@' +
                                                sample_organs::nameOf(shipped->resolution)});
  }
  const auto& playing = source_.view.playing;
  const document::CirculationChoice& circulation = *state_.circulation;
  const bool driven = circulation.drives && live::sampleHeartOf(motion.recipe);
  if (driven)
    words.insert(words.end(), {"--scenario", circulation.scenario});
  else if (playing && playing->ratePerMinute > 0)
    words.insert(words.end(), {"--rate", numberText(playing->ratePerMinute)});
  words.insert(words.end(), {"--csv", stemOf(sequence) + ".csv"});
  paragraph("The sequence, over one cycle.");
  if (playSession(onlyInSession(driven), stemOf(sequence) + ".csv", driven))
    return;
  if (!landmarks.empty())
    file(kLandmarks, landmarks);
  command(words);
}

/// Why `viscera play` needs the session for its motion; empty: its other arguments suffice.
std::string Writer::onlyInSession(bool driven) const {
  const document::CirculationChoice& circulation = *state_.circulation;
  if (driven && circulation.parameters != circulation::scenarioParameters(circulation.scenario))
    return "The heart follows a circulation with parameters of its own";
  for (const auto& locked : *state_.organs)
    if (locked->volumeLocked)
      return "The volume of " + locked->name + " is kept while it plays";
  return state_.rig->cage.empty() ? "" : "The organs hang on a cage";
}

/// Plays the session itself where there is a reason to; false: there is none, or it is not saved.
bool Writer::playSession(const std::string& reason, const std::string& table, bool driven) {
  if (reason.empty())
    return false;
  if (source_.session.empty()) {
    say(reason + ", which viscera play takes from a session only: save it and copy its commands again.");
    return false;
  }
  say(reason + ": the session itself is played.");
  std::vector<std::string> words = {"play", absolutePath(source_.session).string()};
  if (!driven && source_.view.playing && source_.view.playing->ratePerMinute > 0)
    words.insert(words.end(), {"--rate", numberText(source_.view.playing->ratePerMinute)});
  words.insert(words.end(), {"--csv", table});
  command(words);
  return true;
}

void Writer::writeKeySequence() {
  if (state_.keySequence->keys.empty() || state_.rig->handles.empty())
    return;
  paragraph("The key sequence, over one cycle.");
  file(kSequence, live::textOf(live::sequenceFile(state_)));
  if (playSession(onlyInSession(false), "recorded.csv", false) || !state_.rig->cage.empty())
    return;
  for (const auto& organ : *state_.organs) {
    const auto name = nameOf(*organ);
    if (!name)
      continue;
    std::vector<std::string> words = {"play", kSequence, "--organ", *name};
    if (source_.view.playing && source_.view.playing->ratePerMinute > 0)
      words.insert(words.end(), {"--rate", numberText(source_.view.playing->ratePerMinute)});
    words.insert(words.end(), {"--csv", outputOf(*organ, ".recorded.csv")});
    command(words);
  }
}

void Writer::writePicture() {
  if (!source_.session.empty()) {
    paragraph("The picture, as the session shows it.");
    return command({"render", absolutePath(source_.session).string(), "-o", "picture.png"});
  }
  std::vector<std::string> words = {"render"};
  for (const auto& organ : *state_.organs)
    if (const auto name = nameOf(*organ); name && organ->look.visible)
      words.push_back(*name);
  if (words.size() == 1)
    return;
  if (!state_.rig->handles.empty()) {
    words.insert(words.end(), {kRest, "--pose", isStill() ? kRest : kPose});
    const std::vector<std::string> coordinates = system();
    words.insert(words.end(), coordinates.begin(), coordinates.end());
    if (source_.view.shown.stress)
      words.push_back("--stress");
  }
  paragraph("A picture. Colours, opacity and the camera are a session's only: save it, and viscera render "
            "draws them.");
  words.insert(words.end(), {"-o", "picture.png"});
  command(words);
}

void Writer::writeLeftOut() {
  if (state_.measurements->empty())
    return;
  paragraph("No command exports measurements. In the window, File > Export more > Export measurements writes "
            "these:");
  for (const document::Measurement& measurement : *state_.measurements)
    say("  " + measurement.name + " (" + document::nameOf(measurement.kind) + ')');
}

} // namespace

SessionScript sessionScript(const ScriptSource& source) {
  return Writer(source).run();
}

} // namespace viscera::report

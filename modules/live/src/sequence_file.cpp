#include "viscera/live/sequence_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/system_commands.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;
using Track = sequences::KeyframedSequence::Track;

constexpr std::string_view kEnding = ".sequence.json";
/// Handles apart by more than this part of the rig's size are other handles.
constexpr double kSameRest = 1e-6;

constexpr const char* kFormat = "viscera-sequence";
constexpr int kVersion = 1;
constexpr Eigen::Index kFewestKeyedHandles = 4;

constexpr JsonReader::Format kSequenceFormat = {kFormat, kVersion, "sequence",
                                                "choose a file that Viscera has saved as .sequence.json",
                                                "record and save the sequence again"};

/// Reads one file; every message names it.
class SequenceReader : private JsonReader {
public:
  explicit SequenceReader(const std::string& where) : JsonReader(where, kSequenceFormat) {}

  SequenceFile read(const std::string& text) {
    const ordered_json root = parse(text);
    Track& track = file_.track;
    if (root.contains("name"))
      track.name = textOf(root, "name", "");
    readHandles(root);
    readGroups(root);
    track.periodSeconds = numberOf(field(root, "periodSeconds", ""), "periodSeconds");
    if (root.contains("loop"))
      track.loop = flagOf(root, "loop", "");
    if (root.contains("interpolation"))
      track.interpolation =
          named(sequences::interpolationFromName, root, "interpolation", "", "eased, curve");
    readSystem(root);
    readOrgans(root);
    readKeys(root);
    try {
      const sequences::KeyframedSequence check(track);
    } catch (const DataError& error) {
      throw DataError(error.problem(), phrase("%1, %2", where(), error.where()), error.tryThis());
    }
    return std::move(file_);
  }

private:
  void readHandles(const ordered_json& root) {
    const ordered_json& list = listOf(root, "handles", "");
    Points& rest = file_.track.restHandles;
    rest.resize(static_cast<Eigen::Index>(list.size()), 3);
    if (rest.rows() < kFewestKeyedHandles)
      fail(phrase("It has %n {handle|handles}; a sequence needs four at least", list.size()), "handles");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string place = "handle " + std::to_string(i + 1);
      requireObject(list[i], place);
      const std::string label = textOf(list[i], "label", place);
      if (!rows_.emplace(label, static_cast<int>(i)).second)
        fail(diagnostic("the label \"%1\" comes twice", label), place,
             "give every handle a label of its own");
      rest.row(static_cast<Eigen::Index>(i)) =
          vectorOf(field(list[i], "rest", place), place + " \"" + label + "\"").transpose();
      file_.labels.push_back(label);
    }
  }

  int rowOf(const ordered_json& label, const std::string& place) const {
    const auto row = label.is_string() ? rows_.find(label.get<std::string>()) : rows_.end();
    if (row == rows_.end())
      fail(diagnostic("It names the handle %1, which is not among \"handles\"", label.dump()), place);
    return row->second;
  }

  void readGroups(const ordered_json& root) {
    if (!root.contains("groups"))
      return;
    std::set<int> grouped;
    for (const ordered_json& item : listOf(root, "groups", "")) {
      const std::string place = "group " + std::to_string(file_.track.groups.size() + 1);
      requireObject(item, place);
      sequences::HandleGroup group{textOf(item, "name", place), {1.0, 0.5, 0.2}, {}};
      if (item.contains("color"))
        group.color = colorOf(item.at("color"), place + ", color");
      for (const ordered_json& label : listOf(item, "handles", place)) {
        group.handles.push_back(rowOf(label, place));
        if (!grouped.insert(group.handles.back()).second)
          fail(diagnostic("the handle %1 is in two groups", label.dump()), place);
      }
      std::sort(group.handles.begin(), group.handles.end());
      file_.track.groups.push_back(std::move(group));
    }
  }

  void readSystem(const ordered_json& root) {
    if (!root.contains("system"))
      return;
    const ordered_json& item = root.at("system");
    requireObject(item, "system");
    document::SystemChoice choice;
    choice.id = textOf(item, "id", "system");
    if (item.contains("parameters")) {
      requireObject(item.at("parameters"), "system parameters");
      for (const auto& [name, value] : item.at("parameters").items())
        choice.parameters.set(name, numberOf(value, "system parameter " + name));
    }
    file_.system = std::move(choice);
  }

  void readOrgans(const ordered_json& root) {
    if (!root.contains("organs"))
      return;
    for (const ordered_json& item : listOf(root, "organs", "")) {
      const std::string place = "organ " + std::to_string(file_.organs.size() + 1);
      requireObject(item, place);
      geometry::TriangleMesh mesh;
      const ordered_json& points = listOf(item, "points", place);
      const ordered_json& triangles = listOf(item, "triangles", place);
      mesh.points.resize(static_cast<Eigen::Index>(points.size() / 3), 3);
      mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size() / 3), 3);
      if (points.size() % 3 != 0 || triangles.size() % 3 != 0 || triangles.empty())
        fail(diagnostic("its points and triangles are no lists of threes"), place);
      for (std::size_t i = 0; i < points.size(); ++i)
        mesh.points.data()[i] = numberOf(points[i], place + ", points");
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (!triangles[i].is_number_unsigned() || triangles[i].get<std::uint64_t>() >= points.size() / 3)
          fail(diagnostic("a triangle refers to a point that does not exist"), place);
        mesh.triangles.data()[i] = triangles[i].get<std::int32_t>();
      }
      geometry::requireValid(mesh, where() + ", " + place);
      file_.organs.push_back(
          {textOf(item, "name", place), std::make_shared<const geometry::TriangleMesh>(std::move(mesh))});
    }
  }

  void readKeys(const ordered_json& root) {
    for (const ordered_json& item : listOf(root, "keys", "")) {
      const std::string place = "key " + std::to_string(file_.track.keys.size() + 1);
      requireObject(item, place);
      sequences::Keyframe key;
      key.seconds = numberOf(field(item, "seconds", place), place + ", seconds");
      if (item.contains("easing"))
        key.easing = named(sequences::easingFromName, item, "easing", place, "linear, smooth, in, out, hold");
      key.pose = file_.track.restHandles;
      const ordered_json& pose = field(item, "pose", place);
      requireObject(pose, place + ", pose");
      for (const auto& [label, position] : pose.items())
        key.pose.row(rowOf(label, place)) =
            vectorOf(position, place + ", handle \"" + label + "\"").transpose();
      file_.track.keys.push_back(std::move(key));
    }
  }

  SequenceFile file_;
  std::map<std::string, int> rows_;
};

ordered_json keyOf(const sequences::Keyframe& key, const SequenceFile& sequence) {
  ordered_json pose = ordered_json::object();
  for (std::size_t i = 0; i < sequence.labels.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (key.pose.row(row) != sequence.track.restHandles.row(row))
      pose[sequence.labels[i]] = jsonOf(key.pose.row(row).transpose());
  }
  return {{"seconds", key.seconds}, {"easing", nameOf(key.easing)}, {"pose", std::move(pose)}};
}

} // namespace

std::string textOf(const SequenceFile& sequence) {
  const Track& track = sequence.track;
  ordered_json root{{"format", kFormat},  {"version", kVersion},
                    {"name", track.name}, {"coordinateSystem", "LPS"},
                    {"units", "mm"},      {"periodSeconds", track.periodSeconds},
                    {"loop", track.loop}, {"interpolation", nameOf(track.interpolation)}};
  if (sequence.system) {
    root["system"]["id"] = sequence.system->id;
    root["system"]["parameters"] = ordered_json::object();
    for (const auto& [name, value] : sequence.system->parameters.all())
      root["system"]["parameters"][name] = value;
  }
  root["handles"] = ordered_json::array();
  for (std::size_t i = 0; i < sequence.labels.size(); ++i)
    root["handles"].push_back(
        {{"label", sequence.labels[i]},
         {"rest", jsonOf(track.restHandles.row(static_cast<Eigen::Index>(i)).transpose())}});
  root["groups"] = ordered_json::array();
  for (const sequences::HandleGroup& group : track.groups) {
    ordered_json item{{"name", group.name}, {"color", jsonOf(group.color)}};
    item["handles"] = ordered_json::array();
    for (const int row : group.handles)
      item["handles"].push_back(sequence.labels[static_cast<std::size_t>(row)]);
    root["groups"].push_back(std::move(item));
  }
  root["keys"] = ordered_json::array();
  for (const sequences::Keyframe& key : track.keys)
    root["keys"].push_back(keyOf(key, sequence));
  for (const SequenceOrgan& organ : sequence.organs) {
    const auto& points = organ.mesh->points;
    const auto& triangles = organ.mesh->triangles;
    root["organs"].push_back(
        {{"name", organ.name},
         {"points", std::vector<double>(points.data(), points.data() + points.size())},
         {"triangles", std::vector<std::int32_t>(triangles.data(), triangles.data() + triangles.size())}});
  }
  return root.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

namespace {

/// Whether the rig has the file's handles; fills `ids` with theirs, in the file's order.
bool hasHandles(const document::Rig& rig, const SequenceFile& sequence,
                std::vector<document::HandleId>& ids) {
  const Points& rest = sequence.track.restHandles;
  const double apart = kSameRest * std::max(boundsOf(rest).diagonal(), 1.0);
  for (std::size_t i = 0; i < sequence.labels.size(); ++i) {
    const int row = rig.indexOf(sequence.labels[i]);
    if (row < 0)
      return false;
    const document::Handle& handle = rig.handles[static_cast<std::size_t>(row)];
    if ((handle.rest - rest.row(static_cast<Eigen::Index>(i)).transpose()).norm() > apart)
      return false;
    ids.push_back(handle.id);
  }
  return true;
}

document::KeySequence keySequenceFrom(const SequenceFile& sequence,
                                      const std::vector<document::HandleId>& ids) {
  const auto& track = sequence.track;
  document::KeySequence keySequence{track.name, track.periodSeconds, track.loop, track.interpolation, {}};
  for (const sequences::Keyframe& frame : track.keys) {
    document::SequenceKey key{{}, frame.seconds, frame.easing, {}};
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const Vec3 moved = (frame.pose.row(row) - track.restHandles.row(row)).transpose();
      if (moved != Vec3::Zero())
        key.displacements[ids[i]] = moved;
    }
    keySequence.keys.push_back(std::move(key));
  }
  return keySequence;
}

} // namespace

bool isSequenceFile(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return name.ends_with(kEnding);
}

SequenceFile readSequence(const std::filesystem::path& file) {
  return SequenceReader(file.string()).read(readText(file));
}

void writeSequence(const std::filesystem::path& file, const SequenceFile& sequence) {
  if (!isSequenceFile(file))
    throw CannotCreateError("the name of a sequence file ends in .sequence.json", file.string(),
                            phrase("name it %1", file.stem().string() + std::string(kEnding)));
  const std::string text = textOf(sequence);
  writeAtomically(file, [&text](std::ostream& stream) { stream << text; });
}

SequenceFile sequenceFile(const document::DocumentState& state) {
  const auto sequence = document::sequenceOf(*state.keySequence, *state.rig);
  if (!sequence)
    throw UsageError("The key sequence has no key", {}, "add a key first");
  SequenceFile file{sequence->track(), {}, *state.system, {}};
  for (const document::Handle& handle : state.rig->handles)
    file.labels.push_back(handle.label);
  return file;
}

document::Rig rigOf(const SequenceFile& sequence) {
  document::Rig rig = document::rigAt(sequence.track.restHandles);
  for (std::size_t i = 0; i < rig.handles.size(); ++i)
    rig.handles[i].label = sequence.labels[i];
  for (const sequences::HandleGroup& group : sequence.track.groups)
    rig.addGroup(group.name, group.color, group.handles);
  return rig;
}

document::Command openSequence(SequenceFile sequence) {
  const Text name = phrase("Open sequence %1", named(sequence.track.name));
  return {
      name,
      [sequence = std::move(sequence), name](const document::DocumentState& before, document::IdSource& ids) {
        document::DocumentState state = before;
        std::vector<document::HandleId> handles;
        if (!hasHandles(*state.rig, sequence, handles)) {
          state = document::replaceRig(rigOf(sequence), name).apply(state, ids);
          if (sequence.system)
            state = document::setSystem(*sequence.system).apply(state, ids);
          handles.clear();
          for (const document::Handle& handle : state.rig->handles)
            handles.push_back(handle.id);
        }
        return document::replaceKeySequence(keySequenceFrom(sequence, handles)).apply(state, ids);
      },
      {}};
}

document::Command correctKeys(SequenceFile corrected, std::vector<std::size_t> keys,
                              std::vector<document::CorrectedContour> corrections) {
  return {"Correct contour",
          [corrected = std::move(corrected), keys = std::move(keys),
           corrections = std::move(corrections)](const document::DocumentState& before, document::IdSource&) {
            std::vector<document::HandleId> handles;
            if (!hasHandles(*before.rig, corrected, handles))
              throw UsageError("The handles are no longer those of the motion that was found in the images",
                               "key sequence", "find the motion again, or undo the change of the handles");
            const document::KeySequence found = keySequenceFrom(corrected, handles);
            document::KeySequence changed = *before.keySequence;
            for (const std::size_t index : keys) {
              const auto key = std::find_if(
                  changed.keys.begin(), changed.keys.end(), [&](const document::SequenceKey& each) {
                    return std::abs(each.seconds - found.keys[index].seconds) < sequences::kShortestSpan;
                  });
              if (key == changed.keys.end())
                throw UsageError(phrase("There is no key at phase %1 any more", index), "key sequence",
                                 "find the motion again, or undo the change of the keys");
              key->displacements = found.keys[index].displacements;
            }
            changed.corrections = corrections;
            document::DocumentState state = before;
            state.keySequence = std::make_shared<const document::KeySequence>(std::move(changed));
            return state;
          },
          {}};
}

} // namespace viscera::live

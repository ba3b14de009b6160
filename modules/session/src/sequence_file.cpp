#include "viscera/session/sequence_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <ostream>
#include <sstream>
#include <utility>

#include "edit.h"
#include "json_reader.h"
#include "sequence_json.h"
#include "viscera/core/atomic_file.h"
#include "viscera/session/recording_commands.h"
#include "viscera/session/system_commands.h"

namespace viscera::session {
namespace {

constexpr std::string_view kEnding = ".sequence.json";
/// Handles apart by more than this part of the rig's size are other handles.
constexpr double kSameRest = 1e-6;

/// Whether the rig has the file's handles; fills `ids` with theirs, in the file's order.
bool hasHandles(const Rig& rig, const SequenceFile& sequence, std::vector<HandleId>& ids) {
  const Points& rest = sequence.track.restHandles;
  const double apart = kSameRest * std::max(boundsOf(rest).diagonal(), 1.0);
  for (std::size_t i = 0; i < sequence.labels.size(); ++i) {
    const int row = rig.indexOf(sequence.labels[i]);
    if (row < 0)
      return false;
    const Handle& handle = rig.handles[static_cast<std::size_t>(row)];
    if ((handle.rest - rest.row(static_cast<Eigen::Index>(i)).transpose()).norm() > apart)
      return false;
    ids.push_back(handle.id);
  }
  return true;
}

Recording recordingFrom(const SequenceFile& sequence, const std::vector<HandleId>& ids) {
  const auto& track = sequence.track;
  Recording recording{track.name, track.periodSeconds, track.loop, track.interpolation, {}};
  for (const sequences::Keyframe& frame : track.keys) {
    RecordedKey key{{}, frame.seconds, frame.easing, {}};
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const Vec3 moved = (frame.pose.row(row) - track.restHandles.row(row)).transpose();
      if (moved != Vec3::Zero())
        key.displacements[ids[i]] = moved;
    }
    recording.keys.push_back(std::move(key));
  }
  return recording;
}

} // namespace

bool isSequenceFile(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return name.ends_with(kEnding);
}

SequenceFile readSequence(const std::filesystem::path& file) {
  return sequenceFromJson(readText(file), file.string());
}

void writeSequence(const std::filesystem::path& file, const SequenceFile& sequence) {
  if (!isSequenceFile(file))
    throw CannotCreateError("the name of a sequence file ends in .sequence.json", file.string(),
                            "name it " + file.stem().string() + std::string(kEnding));
  const std::string text = sequenceToJson(sequence);
  writeAtomically(file, [&text](std::ostream& stream) { stream << text; });
}

SequenceFile sequenceFile(const DocumentState& state) {
  const auto sequence = sequenceOf(*state.recording, *state.rig);
  if (!sequence)
    throw UsageError("Nothing is recorded", {}, "record a pose first");
  SequenceFile file{sequence->track(), {}, *state.system};
  for (const Handle& handle : state.rig->handles)
    file.labels.push_back(handle.label);
  return file;
}

NewRig rigOf(const SequenceFile& sequence) {
  NewRig rig;
  rig.handles = newHandles(sequence.track.restHandles);
  for (std::size_t i = 0; i < rig.handles.size(); ++i)
    rig.handles[i].label = sequence.labels[i];
  for (const sequences::HandleGroup& group : sequence.track.groups)
    rig.groups.push_back({group.name, group.color, group.handles});
  return rig;
}

Command openSequence(SequenceFile sequence) {
  const std::string name = "Open sequence " + sequence.track.name;
  return {name,
          [sequence = std::move(sequence), name](const DocumentState& before, IdSource& ids) {
            DocumentState state = before;
            std::vector<HandleId> handles;
            if (!hasHandles(*state.rig, sequence, handles)) {
              state = replaceRig(rigOf(sequence), name).apply(state, ids);
              if (sequence.system)
                state = setSystem(*sequence.system).apply(state, ids);
              handles.clear();
              for (const Handle& handle : state.rig->handles)
                handles.push_back(handle.id);
            }
            return replaceRecording(recordingFrom(sequence, handles)).apply(state, ids);
          },
          {}};
}

} // namespace viscera::session

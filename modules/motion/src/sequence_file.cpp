#include "viscera/motion/sequence_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <ostream>
#include <sstream>
#include <utility>

#include "sequence_json.h"
#include "viscera/core/atomic_file.h"
#include "viscera/document/edit.h"
#include "viscera/document/json_reader.h"
#include "viscera/document/recording_commands.h"
#include "viscera/document/system_commands.h"

namespace viscera::motion {
namespace {

constexpr std::string_view kEnding = ".sequence.json";
/// Handles apart by more than this part of the rig's size are other handles.
constexpr double kSameRest = 1e-6;

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

document::Recording recordingFrom(const SequenceFile& sequence, const std::vector<document::HandleId>& ids) {
  const auto& track = sequence.track;
  document::Recording recording{track.name, track.periodSeconds, track.loop, track.interpolation, {}};
  for (const sequences::Keyframe& frame : track.keys) {
    document::RecordedKey key{{}, frame.seconds, frame.easing, {}};
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
  return sequenceFromJson(document::readText(file), file.string());
}

void writeSequence(const std::filesystem::path& file, const SequenceFile& sequence) {
  if (!isSequenceFile(file))
    throw CannotCreateError("the name of a sequence file ends in .sequence.json", file.string(),
                            "name it " + file.stem().string() + std::string(kEnding));
  const std::string text = sequenceToJson(sequence);
  writeAtomically(file, [&text](std::ostream& stream) { stream << text; });
}

SequenceFile sequenceFile(const document::DocumentState& state) {
  const auto sequence = document::sequenceOf(*state.recording, *state.rig);
  if (!sequence)
    throw UsageError("Nothing is recorded", {}, "record a pose first");
  SequenceFile file{sequence->track(), {}, *state.system, {}};
  for (const document::Handle& handle : state.rig->handles)
    file.labels.push_back(handle.label);
  return file;
}

document::NewRig rigOf(const SequenceFile& sequence) {
  document::NewRig rig;
  rig.handles = document::newHandles(sequence.track.restHandles);
  for (std::size_t i = 0; i < rig.handles.size(); ++i)
    rig.handles[i].label = sequence.labels[i];
  for (const sequences::HandleGroup& group : sequence.track.groups)
    rig.groups.push_back({group.name, group.color, group.handles});
  return rig;
}

document::Command openSequence(SequenceFile sequence) {
  const std::string name = "Open sequence " + sequence.track.name;
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
        return document::replaceRecording(recordingFrom(sequence, handles)).apply(state, ids);
      },
      {}};
}

} // namespace viscera::motion

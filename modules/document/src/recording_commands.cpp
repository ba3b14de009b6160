#include "viscera/document/recording_commands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/text.h"
#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

using sequences::kShortestSpan;

DocumentState withRecording(DocumentState state, Recording recording) {
  state.recording = std::make_shared<const Recording>(std::move(recording));
  return state;
}

RecordedKey& requireKey(Recording& recording, KeyId id) {
  for (RecordedKey& key : recording.keys)
    if (key.id == id)
      return key;
  throw UsageError("There is no such key any more", "key " + std::to_string(id.value));
}

/// The key at that time, or null.
RecordedKey* keyAt(Recording& recording, double seconds) {
  for (RecordedKey& key : recording.keys)
    if (std::abs(key.seconds - seconds) < kShortestSpan)
      return &key;
  return nullptr;
}

void sortByTime(Recording& recording) {
  std::stable_sort(recording.keys.begin(), recording.keys.end(),
                   [](const RecordedKey& a, const RecordedKey& b) { return a.seconds < b.seconds; });
}

/// How far each handle is from its rest now.
std::map<HandleId, Vec3> presentDisplacements(const DocumentState& state) {
  std::map<HandleId, Vec3> displacements;
  for (std::size_t i = 0; i < state.rig->handles.size(); ++i) {
    const Handle& handle = state.rig->handles[i];
    const Vec3 moved = state.pose->row(static_cast<Eigen::Index>(i)).transpose() - handle.rest;
    if (moved != Vec3::Zero())
      displacements[handle.id] = moved;
  }
  return displacements;
}

void requireHandles(const DocumentState& state) {
  if (state.rig->handles.empty())
    throw UsageError("There are no handles whose pose could be recorded", {}, "place some first");
}

Recording withPeriod(Recording recording, double period, bool stretch) {
  for (RecordedKey& key : recording.keys)
    key.seconds *= stretch ? period / recording.periodSeconds : 1;
  recording.periodSeconds = period;
  return recording;
}

} // namespace

Command recordKey(double seconds, sequences::Easing easing) {
  return {"Record key",
          [=](const DocumentState& state, IdSource& ids) {
            requireHandles(state);
            Recording recording = *state.recording;
            if (RecordedKey* there = keyAt(recording, seconds)) {
              there->displacements = presentDisplacements(state);
              return withRecording(state, std::move(recording));
            }
            recording.keys.push_back({ids.next<KeyId>(), seconds, easing, presentDisplacements(state)});
            sortByTime(recording);
            return withRecording(state, std::move(recording));
          },
          {}};
}

Command moveKey(KeyId key, double seconds) {
  return {"Move key",
          [=](const DocumentState& state, IdSource&) {
            Recording recording = *state.recording;
            RecordedKey& moved = requireKey(recording, key);
            moved.seconds = seconds;
            sortByTime(recording);
            return withRecording(state, std::move(recording));
          },
          "key/" + std::to_string(key.value)};
}

Command replaceKey(KeyId key) {
  return {"Replace pose of key",
          [=](const DocumentState& state, IdSource&) {
            Recording recording = *state.recording;
            requireKey(recording, key).displacements = presentDisplacements(state);
            return withRecording(state, std::move(recording));
          },
          {}};
}

Command removeKeys(std::vector<KeyId> keys) {
  const std::string name = edit::counted("Remove", keys.size(), "key");
  return {name,
          [keys = std::move(keys)](const DocumentState& state, IdSource&) {
            Recording recording = *state.recording;
            for (const KeyId key : keys)
              requireKey(recording, key);
            std::erase_if(recording.keys, [&keys](const RecordedKey& one) {
              return std::find(keys.begin(), keys.end(), one.id) != keys.end();
            });
            return withRecording(state, std::move(recording));
          },
          {}};
}

Command setEasing(std::vector<KeyId> keys, sequences::Easing easing) {
  return {"Easing " + nameOf(easing),
          [keys = std::move(keys), easing](const DocumentState& state, IdSource&) {
            Recording recording = *state.recording;
            for (const KeyId key : keys)
              requireKey(recording, key).easing = easing;
            return withRecording(state, std::move(recording));
          },
          {}};
}

Command editRecording(RecordingEdit change) {
  return {"Change recording",
          [change = std::move(change)](const DocumentState& state, IdSource&) {
            Recording recording = *state.recording;
            if (change.periodSeconds)
              recording = withPeriod(std::move(recording), *change.periodSeconds, change.stretch);
            recording.name = change.name.value_or(recording.name);
            recording.loop = change.loop.value_or(recording.loop);
            recording.interpolation = change.interpolation.value_or(recording.interpolation);
            return withRecording(state, std::move(recording));
          },
          {}};
}

Command replaceRecording(Recording recording) {
  return {"Replace recording",
          [recording = std::move(recording)](const DocumentState& state, IdSource& ids) {
            Recording replaced = recording;
            replaced.name = replaced.name.empty() ? Recording().name : toUtf8(replaced.name);
            sortByTime(replaced);
            for (RecordedKey& key : replaced.keys)
              key.id = ids.next<KeyId>();
            return withRecording(state, std::move(replaced));
          },
          {}};
}

} // namespace viscera::document

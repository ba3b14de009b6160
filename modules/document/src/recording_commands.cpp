#include "viscera/document/recording_commands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

using sequences::kShortestSpan;

constexpr const char* kKind = "key";

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

void setPeriod(Recording& recording, double period, bool stretch) {
  for (RecordedKey& key : recording.keys)
    key.seconds *= stretch ? period / recording.periodSeconds : 1;
  recording.periodSeconds = period;
}

} // namespace

Command recordKey(double seconds, sequences::Easing easing) {
  return edit::onPart(
      "Record key", &DocumentState::recording,
      [=](Recording& recording, const DocumentState& state, IdSource& ids) {
        requireHandles(state);
        if (RecordedKey* there = keyAt(recording, seconds)) {
          there->displacements = presentDisplacements(state);
          return;
        }
        recording.keys.push_back({ids.next<KeyId>(), seconds, easing, presentDisplacements(state)});
        sortByTime(recording);
      });
}

Command moveKey(KeyId key, double seconds) {
  return edit::onPart(
      "Move key", &DocumentState::recording,
      [=](Recording& recording) {
        edit::require(recording.keys, key, kKind).seconds = seconds;
        sortByTime(recording);
      },
      "key/" + std::to_string(key.value));
}

Command replaceKey(KeyId key) {
  return edit::onPart("Replace pose of key", &DocumentState::recording,
                      [=](Recording& recording, const DocumentState& state, IdSource&) {
                        edit::require(recording.keys, key, kKind).displacements = presentDisplacements(state);
                      });
}

Command removeKeys(std::vector<KeyId> keys) {
  const std::string name = phrase("Remove {key|%n keys}", keys.size());
  return edit::onPart(name, &DocumentState::recording, [keys = std::move(keys)](Recording& recording) {
    edit::remove(recording.keys, keys, kKind);
  });
}

Command setEasing(std::vector<KeyId> keys, sequences::Easing easing) {
  return edit::onPart(phrase("Easing %1", nameOf(easing)), &DocumentState::recording,
                      [keys = std::move(keys), easing](Recording& recording) {
                        for (const KeyId key : keys)
                          edit::require(recording.keys, key, kKind).easing = easing;
                      });
}

Command editRecording(RecordingEdit change) {
  return edit::onPart("Change recording", &DocumentState::recording,
                      [change = std::move(change)](Recording& recording) {
                        if (change.periodSeconds)
                          setPeriod(recording, *change.periodSeconds, change.stretch);
                        recording.name = change.name.value_or(recording.name);
                        recording.loop = change.loop.value_or(recording.loop);
                        recording.interpolation = change.interpolation.value_or(recording.interpolation);
                      });
}

Command replaceRecording(Recording recording) {
  return edit::onPart(
      "Replace recording", &DocumentState::recording,
      [recording = std::move(recording)](Recording& replaced, const DocumentState&, IdSource& ids) {
        replaced = recording;
        replaced.name = replaced.name.empty() ? Recording().name : toUtf8(replaced.name);
        sortByTime(replaced);
        for (RecordedKey& key : replaced.keys)
          key.id = ids.next<KeyId>();
      });
}

} // namespace viscera::document

#include "viscera/document/key_sequence_commands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

using sequences::kShortestSpan;

constexpr const char* kKeyKind = "key";

/// The key at that time, or null.
SequenceKey* keyAt(KeySequence& keySequence, double seconds) {
  for (SequenceKey& key : keySequence.keys)
    if (std::abs(key.seconds - seconds) < kShortestSpan)
      return &key;
  return nullptr;
}

void sortByTime(KeySequence& keySequence) {
  std::stable_sort(keySequence.keys.begin(), keySequence.keys.end(),
                   [](const SequenceKey& a, const SequenceKey& b) { return a.seconds < b.seconds; });
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

void setPeriod(KeySequence& keySequence, double period, bool stretch) {
  for (SequenceKey& key : keySequence.keys)
    key.seconds *= stretch ? period / keySequence.periodSeconds : 1;
  keySequence.periodSeconds = period;
}

} // namespace

Command recordKey(double seconds, sequences::Easing easing) {
  return edit::onPart(
      "Record key", &DocumentState::keySequence,
      [=](KeySequence& keySequence, const DocumentState& state, IdSource& ids) {
        requireHandles(state);
        if (SequenceKey* there = keyAt(keySequence, seconds)) {
          there->displacements = presentDisplacements(state);
          return;
        }
        keySequence.keys.push_back({ids.next<KeyId>(), seconds, easing, presentDisplacements(state)});
        sortByTime(keySequence);
      });
}

Command moveKey(KeyId key, double seconds) {
  return edit::onPart(
      "Move key", &DocumentState::keySequence,
      [=](KeySequence& keySequence) {
        edit::require(keySequence.keys, key, kKeyKind).seconds = seconds;
        sortByTime(keySequence);
      },
      "key/" + std::to_string(key.value));
}

Command replaceKey(KeyId key) {
  return edit::onPart("Replace pose of key", &DocumentState::keySequence,
                      [=](KeySequence& keySequence, const DocumentState& state, IdSource&) {
                        edit::require(keySequence.keys, key, kKeyKind).displacements =
                            presentDisplacements(state);
                      });
}

Command removeKeys(std::vector<KeyId> keys) {
  const Text name = phrase("Remove {key|%n keys}", keys.size());
  return edit::onPart(name, &DocumentState::keySequence, [keys = std::move(keys)](KeySequence& keySequence) {
    edit::remove(keySequence.keys, keys, kKeyKind);
  });
}

Command setEasing(std::vector<KeyId> keys, sequences::Easing easing) {
  return edit::onPart(phrase("Easing %1", nameOf(easing)), &DocumentState::keySequence,
                      [keys = std::move(keys), easing](KeySequence& keySequence) {
                        for (const KeyId key : keys)
                          edit::require(keySequence.keys, key, kKeyKind).easing = easing;
                      });
}

Command editKeySequence(KeySequenceEdit change) {
  return edit::onPart("Change key sequence", &DocumentState::keySequence,
                      [change = std::move(change)](KeySequence& keySequence) {
                        if (change.periodSeconds)
                          setPeriod(keySequence, *change.periodSeconds, change.stretch);
                        keySequence.name = change.name.value_or(keySequence.name);
                        keySequence.loop = change.loop.value_or(keySequence.loop);
                        keySequence.interpolation = change.interpolation.value_or(keySequence.interpolation);
                      });
}

Command replaceKeySequence(KeySequence keySequence) {
  return edit::onPart(
      "Replace key sequence", &DocumentState::keySequence,
      [keySequence = std::move(keySequence)](KeySequence& replaced, const DocumentState&, IdSource& ids) {
        replaced = keySequence;
        replaced.name = replaced.name.empty() ? KeySequence().name : toUtf8(replaced.name);
        sortByTime(replaced);
        for (SequenceKey& key : replaced.keys)
          key.id = ids.next<KeyId>();
      });
}

} // namespace viscera::document

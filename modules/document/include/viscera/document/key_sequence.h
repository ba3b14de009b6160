#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/document/ids.h"
#include "viscera/document/rig.h"
#include "viscera/sequences/keyframes.h"

namespace viscera::document {

/// A key of a key sequence: a pose with its time. It refers to handles by their ids, so that it stays valid
/// when handles are added, removed, or moved at rest.
struct SequenceKey {
  KeyId id;
  double seconds = 0;
  sequences::Easing easing = sequences::Easing::smooth; ///< From here to the next key.
  std::map<HandleId, Vec3> displacements;               ///< From rest, mm; handles at rest are not in it.

  friend bool operator==(const SequenceKey&, const SequenceKey&) = default;
};

/// A contour that the user corrected in a slice of the document's study at one phase; the keys around that
/// phase meet it.
struct CorrectedContour {
  std::int64_t phase = 0;   ///< Of the cycle, the first is 0.
  std::int64_t slice = 0;   ///< Of the study.
  std::string surface;      ///< The name of the organ that it belongs to.
  std::vector<Vec3> points; ///< mm, in the slice's plane.

  friend bool operator==(const CorrectedContour&, const CorrectedContour&) = default;
};

/// The key sequence of a document: poses with their times, made by the user or found in a series, which can
/// be played as a motion. An empty one has no keys.
struct KeySequence {
  std::string name = "Recorded";
  double periodSeconds = 2;
  bool loop = true;
  sequences::Interpolation interpolation = sequences::Interpolation::eased;
  std::vector<SequenceKey> keys; ///< In order of time.
  std::vector<CorrectedContour> corrections =
      {}; ///< Of a motion found in images, in the order of their making.

  /// The key with that id, or null.
  const SequenceKey* key(KeyId id) const;

  friend bool operator==(const KeySequence&, const KeySequence&) = default;
};

/// The pose of a key for the handles of `rig`, `n x 3` mm: a handle that the key does not know is at rest.
Points poseOf(const SequenceKey& key, const Rig& rig);

/// The key sequence as a sequence that can be played with these handles, with the rig's groups (those that
/// share no handle with an earlier one); null when it has no keys or there are no handles.
std::shared_ptr<const sequences::KeyframedSequence> sequenceOf(const KeySequence& keySequence,
                                                               const Rig& rig);

} // namespace viscera::document

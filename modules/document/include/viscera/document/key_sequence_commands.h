#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/document/command.h"

/// Commands that change the key sequence of the document. All throw `UsageError` for keys that are not there.
namespace viscera::document {

/// Records the present pose at `seconds`. Where there is a key already, its pose is replaced and its easing
/// stays.
Command recordKey(double seconds, sequences::Easing easing = sequences::Easing::smooth);

/// Moves a key in time. Moves of one key one after the other are one undo step.
Command moveKey(KeyId key, double seconds);

/// Takes the present pose for a key.
Command replaceKey(KeyId key);

Command removeKeys(std::vector<KeyId> keys);
Command setEasing(std::vector<KeyId> keys, sequences::Easing easing);

/// The changes of a key sequence: its name, period and others. What is given is changed, all else stays. A
/// shorter period than the last key needs is refused; with `stretch` the keys keep their part of the period.
struct KeySequenceEdit {
  std::optional<std::string> name = {};
  std::optional<double> periodSeconds = {};
  bool stretch = false;
  std::optional<bool> loop = {};
  std::optional<sequences::Interpolation> interpolation = {};
};
Command editKeySequence(KeySequenceEdit change);

/// Replaces the key sequence by another one, whose keys get new ids.
Command replaceKeySequence(KeySequence keySequence);

} // namespace viscera::document

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/document/command.h"
#include "viscera/document/key_sequence.h"
#include "viscera/document/rig_commands.h"

/// Reads and writes key sequences as `.sequence.json` files (docs/file_formats.md).
namespace viscera::live {

/// A surface that a sequence was made for, at rest.
struct SequenceOrgan {
  std::string name;
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< mm LPS; never null.
};

/// The contents of a sequence file: everything that is needed to play it.
struct SequenceFile {
  sequences::KeyframedSequence::Track track;    ///< Handles at rest in the order of `labels`; groups; keys.
  std::vector<std::string> labels;              ///< One for each handle, unique.
  std::optional<document::SystemChoice> system; ///< The coordinates it was recorded with, if the file states
                                                ///< them.
  std::vector<SequenceOrgan> organs;            ///< The organs that it moves, if the file contains them.
};

/// Whether the name ends like a sequence file (.sequence.json).
bool isSequenceFile(const std::filesystem::path& file);

/// Reads a sequence file. Throws `NoInputError` when it cannot be read and `DataError` that names file, key
/// and field for one that is cut off or no such file, of a later version, with another unit or axes, with
/// numbers that are not finite, handles that share a label, keys that share a time or lie outside the period,
/// a pose for an unknown handle, fewer than four handles, or an unknown easing.
SequenceFile readSequence(const std::filesystem::path& file);

/// The text that `writeSequence` writes, with enough digits to restore every bit of a number.
std::string textOf(const SequenceFile& sequence);

/// Writes a sequence file; reading it back gives the same bits. Atomic. Throws `CannotCreateError`.
void writeSequence(const std::filesystem::path& file, const SequenceFile& sequence);

/// The key sequence of a document as contents of a sequence file. Throws `UsageError` when nothing is
/// recorded.
SequenceFile sequenceFile(const document::DocumentState& state);

/// The rig of a sequence file, in its order.
document::Rig rigOf(const SequenceFile& sequence);

/// The command that opens a sequence file in the document, one undo step: when the rig has all its handles by
/// label (at their rest places to 1e-6 of the size), only the key sequence; else also the file's handles and,
/// if stated, its coordinates.
document::Command openSequence(SequenceFile sequence);

/// Gives keys of the document's key sequence the poses that `corrected` has at their times, and the sequence
/// these corrected contours in the place of those that it had: one undo step. `keys` are indices of
/// `corrected.track.keys`; all other keys stay as they are. When applied it throws `UsageError` where the
/// document's handles are others, or where a key is no longer at its time.
document::Command correctKeys(SequenceFile corrected, std::vector<std::size_t> keys,
                              std::vector<document::CorrectedContour> corrections);

} // namespace viscera::live

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/document/open_files.h"
#include "viscera/medical_io/assess_surface.h"

/// Files on their way into a document, as long as somebody looks at them. Everything here is a value: a
/// worker makes the next draft of a copy, and what is not accepted is forgotten.
namespace viscera::document {

/// One organ of a draft.
struct DraftOrgan {
  std::string name;
  std::string file; ///< Its file's name, without folders.
  std::shared_ptr<const geometry::TriangleMesh> asRead;
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< As repaired so far.
  std::vector<std::string> repairs;                   ///< Ids of what was done, in order.
  medical_io::SurfaceAssessment assessment;           ///< Of `mesh`.
  bool included = true;                               ///< Whether it will become an organ.
};

/// What some files hold, and what was found out about it.
struct ImportDraft {
  OpenedFiles files;
  std::vector<DraftOrgan> organs;                 ///< As many as `files.organs`.
  std::optional<medical_io::Finding> arrangement; ///< When organs do not lie to each other as in a body.

  /// Something that a user should look at before it is accepted.
  bool questionable() const;
  /// Whether anything is left to accept.
  bool empty() const;
};

/// Looks at everything that was read. Throws `Cancelled`. Some tenths of a second an organ.
ImportDraft draftOf(OpenedFiles files, Progress& progress);

/// The draft with one repair (an id of `medical_io::surfaceRepairs`) done to the organs at these places, and
/// assessed anew. Throws `DataError` naming the organ when a surface cannot be repaired that way,
/// `Cancelled`.
ImportDraft repaired(ImportDraft draft, const std::vector<std::size_t>& organs, const std::string& repair,
                     Progress& progress);

/// The draft with one organ as it was read.
ImportDraft reverted(ImportDraft draft, std::size_t organ, Progress& progress);

/// The draft with one organ taken along or left out. O(organs).
ImportDraft withIncluded(ImportDraft draft, std::size_t organ, bool included);

/// What is to be added to the document: the organs that are included, as they were repaired, each with a
/// warning that names its repairs. A cavity goes with the organ that it is in.
OpenedFiles accepted(const ImportDraft& draft);

} // namespace viscera::document

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/progress.h"
#include "viscera/document/open_files.h"
#include "viscera/medical_io/assess_patient.h"
#include "viscera/medical_io/assess_surface.h"
#include "viscera/medical_io/surface_repairs.h"

/// The contents of files that the user checks and repairs before they are imported into a document.
/// Everything here is a value: a worker makes the next draft from a copy, and a draft that is not accepted is
/// dropped.
namespace viscera::document {

/// One organ of an import draft, with its findings and the repairs done.
struct DraftOrgan {
  std::string name;
  std::string file; ///< Its file's name, without folders.
  std::shared_ptr<const geometry::TriangleMesh> asRead;
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< As repaired so far.
  std::vector<std::string> repairs;                   ///< Ids of what was done, in order.
  std::optional<medical_io::SurfaceChange> change;    ///< By the last repair, where it made the surface anew.
  std::optional<medical_io::SurfaceChange> remade;    ///< By the last remeshing, whatever was done after it.
  std::shared_ptr<const geometry::TriangleMesh> beforeRemesh; ///< Null when the last repair was another one.
  double resolutionMm = 0;                                    ///< Of the last remeshing.
  std::optional<DataError> refusal;                           ///< Why the last repair was not possible.
  medical_io::SurfaceAssessment assessment;                   ///< Of `mesh`.
  bool included = true;                                       ///< Whether it will become an organ.
  /// The doubt about its side that the other organs have answered, so that `assessment` has it no more.
  std::optional<medical_io::Finding> answered = {};
};

/// The contents of some files before their import, with the findings about them.
struct ImportDraft {
  OpenedFiles files;
  std::vector<DraftOrgan> organs;                 ///< As many as `files.organs`.
  medical_io::PatientAssessment patient;          ///< Of the included organs together.
  std::optional<medical_io::Finding> arrangement; ///< A finding about organs that are not arranged as in a
                                                  ///< body; the first of `patient`.
  std::optional<medical_io::Finding> size;        ///< A finding about the size of all of them.

  /// Whether a user should check the draft before it is accepted.
  bool questionable() const;
  /// Whether the draft holds nothing that could be accepted.
  bool empty() const;
};

/// Makes a draft of files that were read, and assesses every organ. Throws `Cancelled`. Some tenths of a
/// second an organ.
ImportDraft draftOf(OpenedFiles files, Progress& progress);

/// The draft with one repair (an id of `medical_io::surfaceRepair`) done to the organs at these places, and
/// assessed anew. Remeshing after remeshing begins with the surface before, so that a finer one has its
/// details. An organ that cannot be repaired that way stays as it is, with the reason as its `refusal`.
/// Throws `Cancelled`.
ImportDraft repaired(ImportDraft draft, const std::vector<std::size_t>& organs, const std::string& repair,
                     Progress& progress);

/// The draft with one organ as it was read.
ImportDraft reverted(ImportDraft draft, std::size_t organ, Progress& progress);

/// The draft with the organs at these places taken along or left out. O(organs).
ImportDraft withIncluded(ImportDraft draft, const std::vector<std::size_t>& organs, bool included);

/// A finding that several organs share, so that it can be shown and repaired once for all.
struct SharedFinding {
  medical_io::FindingSubject subject = medical_io::FindingSubject::size;
  medical_io::FindingSeverity severity = medical_io::FindingSeverity::doubt; ///< The worst.
  std::vector<std::size_t> organs;                                           ///< The organs with this
                                                                             ///< finding.
  std::vector<std::string> repairs;    ///< Those that help every one of them, best first.
  std::vector<std::size_t> repairable; ///< The organs that a repair is for.
  bool ofThePatient = false;           ///< The finding concerns the whole patient and is not shown for single
                                       ///< organs.
};

/// The findings that two or more of the included organs share, the gravest and the most frequent first. The
/// unit of length is one for a patient: where the sizes of more than half are in doubt, the unit that most of
/// them need is the one repair (the first on a tie), and it is for all organs read from surface files, also
/// for those whose size is not conclusive. O(organs).
std::vector<SharedFinding> sharedFindings(const ImportDraft& draft);

/// The files to add to the document: the included organs, as repaired, each with a warning that names its
/// repairs. A cavity is only included with the organ that it is in.
OpenedFiles accepted(const ImportDraft& draft);

} // namespace viscera::document

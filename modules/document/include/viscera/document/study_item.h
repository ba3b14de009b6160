#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/document/command.h"
#include "viscera/medical_io/cine_study.h"

namespace viscera::document {

/// The cine study of the document: images of the patient in planes of their own, over the heart's cycle.
/// Immutable once in a document, and shared by all states that have it. A session names its place; the
/// pictures stay in their files, and a bounded number of them is decoded at a time.
struct StudyItem {
  std::string name;                                   ///< "MR, patient1".
  std::shared_ptr<const medical_io::CineStudy> study; ///< Never null.
  std::filesystem::path place;                        ///< The folder or file that it was read from.
  std::string hash = {};                              ///< `studyHash`; empty: not known.
};

/// A series of a study, for lists.
struct StudySeries {
  int number = 0;
  std::string description; ///< "cine_trufi_retro 4CH"; may be empty.
  std::string date;        ///< "20240301"; empty: not stated.
  medical_io::CinePlane plane = medical_io::CinePlane::other;
  std::vector<std::size_t> slices; ///< Of the study's.
  std::size_t phases = 0;          ///< Read, of the slice with the most.
  std::size_t phasesInCycle = 0;   ///< That there should be in that slice.
  double intervalSeconds = 0;      ///< Of the first slice; 0: not known.
  double spacingMm = 0;            ///< Between columns.
  double thicknessMm = 0;          ///< Of a slice; 0: not stated.
};

/// The series of a study in its order. O(slices).
std::vector<StudySeries> seriesOf(const medical_io::CineStudy& study);

/// A hash of the study's series, planes and phases, not of the pictures: 16 hexadecimal digits. O(pictures).
std::string studyHash(const medical_io::CineStudy& study);

/// Whether two studies have the same contents; nothing is equal to nothing only.
bool identical(const std::shared_ptr<const StudyItem>& a, const std::shared_ptr<const StudyItem>& b);

/// Makes a study of the document from one that was read, named by its modality and place.
StudyItem studyItem(medical_io::CineStudy study, const std::filesystem::path& place);

/// Whether the planes of a study are its own: its first slice is oblique, more than 10 degrees from every
/// axis of the patient, or, unless it is of CT, thicker than twice its pixels. On the patient's axes little
/// would be seen of it. May decode a picture: throws `DataError` where that is damaged.
bool hasOwnPlanes(const medical_io::CineStudy& study);

/// Reads a cine study for a document, without accessing one: a folder with two series or more over a heart's
/// cycle, or with one whose planes are its own, or a file of volumes over time with such
/// planes. None for others: those are scans with phases. None also for images of several patients and others
/// that cannot be read as a study: who reads them as scans says what is wrong. Throws `Cancelled`. O(files);
/// for a file by its header where it is none.
std::optional<StudyItem> findStudy(const std::filesystem::path& place, Progress& progress);

/// Reads the study that a session names, of any number of series. Throws what `medical_io::readCineStudy`
/// throws.
StudyItem readStudy(const std::filesystem::path& place, Progress& progress);

/// Opens a study in the document, in place of the present one and of the scan.
Command openStudy(StudyItem item);

/// Removes the study from the document. Throws `UsageError` when there is none.
Command closeStudy();

} // namespace viscera::document

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "viscera/phantom/phantom_options.h"

namespace viscera::phantom {

/// What is true of the phantom at one instant.
struct PhantomPhase {
  double seconds = 0;
  double beatFraction = 0;
  double inspiration = 0;
  std::map<std::string, double> volumesMl; ///< Of the surfaces, by tissue.
};

/// What was written.
struct PhantomReport {
  std::vector<PhantomPhase> phases;
  std::vector<std::string> files; ///< Relative to the folder; phantom.json describes all others.
  double ejectionFraction = 0;    ///< Of the left ventricle; 0 without a heartbeat.
  double foldedMl = 0; ///< The most that the motion folds in a phase; the inverse is a guess there.
};

/// Makes the phantom and writes it into a folder, which is made when it is not there:
/// - ct: ct_NN (HU), one file a phase; cine: a DICOM series for each plane, cine/NAME/NN.dcm;
/// - labels_NN of every phase, for a cine those of the whole body as well;
/// - with `overTime` one ct.seq.nrrd (ct.nii.gz) and one labels.seq.nrrd (labels.nii.gz) of all phases
///   instead;
/// - forward_NN, displacements at places at rest, and backward_NN, from places to those at rest; of still
///   tissue zero;
/// - phantom.json: tissues, planes with their shifts, and of every phase time, volumes, landmarks and strain.
///
/// The same options give the same bytes, for any number of threads. Throws `UsageError` for options out of
/// range, `CannotCreateError`, `Cancelled`; files that are complete stay. Seconds a phase.
PhantomReport writePhantom(const std::filesystem::path& folder, const PhantomOptions& options,
                           const sample_organs::SampleLibrary& library, Progress& progress,
                           Threads threads = {});

} // namespace viscera::phantom

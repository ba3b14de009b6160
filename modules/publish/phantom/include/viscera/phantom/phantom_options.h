#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viscera/phantom/phantom_motion.h"
#include "viscera/phantom/render.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::phantom {

/// The planes of a cine study: a stack across the left ventricle's axis, and three planes along it.
struct SliceLayout {
  int shortAxis = 9;    ///< Slices of the stack, 0 to 40.
  double gapMm = 2;     ///< Between one slice and the next, where nothing is imaged; 0 to 40.
  bool longAxis = true; ///< Planes of two, three and four chambers.
};

enum class Modality { ct, cine, labels };

/// What `writePhantom` makes.
///
///     PhantomOptions options;
///     options.spacing = spacingFrom("1.5,1.5,8");
///     options.slices = slicesFrom({"sax:9,2", "lax"});
///     setNoise("rician:15", options);
struct PhantomOptions {
  MotionOptions motion;
  Modality modality = Modality::ct;
  Vec3 spacing = Vec3::Constant(3); ///< mm; of a cine the pixels' sides and the slices' thickness.
  SliceLayout slices;
  Contrast::Noise noise = Contrast::Noise::none;
  double deviation = 0;      ///< Of the noise: HU, or the MR signal's unit (blood has some 360).
  double shiftSlicesMm = 0;  ///< How far each slice of a cine lies aside, as breath-holds differ; 0 to 30.
  int phases = 20;           ///< Over the period, 1 to 200.
  double fieldSpacingMm = 8; ///< Of the displacement fields; 0: none are written.
  std::uint64_t seed = 1;
  std::string format = ".nrrd"; ///< Of volumes and fields: ".nrrd" or ".nii.gz".
  /// One file over time for the CT and one for the labels, in the place of one for each phase: a NIfTI of
  /// four dimensions, or a sequence of 3D Slicer (.seq.nrrd). Takes memory for all phases.
  bool overTime = false;
  sample_organs::Resolution resolution = sample_organs::Resolution::medium;
};

/// "2,2,8": three numbers of mm from 0.2 to 40. Throws `UsageError`.
Vec3 spacingFrom(const std::string& text);
/// "sax:9,2" (slices and gap) and "lax", in any order. Throws `UsageError`.
SliceLayout slicesFrom(const std::vector<std::string>& words);
/// "rician:15", "gaussian:20": sets noise and deviation. Throws `UsageError`.
void setNoise(const std::string& text, PhantomOptions& options);
/// "ct", "cine", "labels". Throws `UsageError`.
Modality modalityFrom(const std::string& name);
std::string nameOf(Modality modality);
/// Throws `UsageError` for options out of range and for those that do not go together.
void requireSound(const PhantomOptions& options);

} // namespace viscera::phantom

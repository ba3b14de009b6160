#pragma once

#include <vector>

#include "dicom/dicom_header.h"

/// Sorts the DICOM slices of a folder into scans, and finds gaps and other doubts, by their positions and
/// not by file names. Works on headers only, without files and pixels.
namespace viscera::medical_io {

/// Slices of one series that have the same size, directions and spacing: by indices into all frames.
struct SliceGroup {
  std::vector<std::size_t> frames;
  int ofSeries = 0;                  ///< Its number among those of the same series, the largest first.
  std::vector<ScanFinding> findings; ///< Of slices in the series that are in no group with it.
};

/// The slices of a phase, in the order of their places, that a scan has.
struct SlicePart {
  std::size_t first = 0, last = 0; ///< Both included.
  bool resampled = false;          ///< All of them, on an even grid that is made from them.
};

/// A slice that is made of two neighbours: of `below`, an index into the stack's frames, and of the next one,
/// which has the weight `above`.
struct SliceMix {
  std::size_t below = 0;
  double above = 0;
};

/// A scan of evenly spaced slices.
struct SliceStack {
  std::vector<std::size_t> frames; ///< Along k, by indices into all frames.
  std::vector<SliceMix> mixes;     ///< The slices of the grid where these are not the frames; else empty.
  SlicePart part;
  std::size_t slices = 0; ///< As many as the phase has.
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  std::vector<ScanFinding> findings; ///< First of all whether slices were left out or mixed.

  std::size_t depth() const { return mixes.empty() ? frames.size() : mixes.size(); }
};

/// One phase's slices, before they are ordered.
struct SlicePhase {
  std::vector<std::size_t> frames;
  double timeMs = 0;
};

/// All frames of a list of files, with the file of each.
struct FrameList {
  std::vector<DicomHeader> files;
  std::vector<DicomFrame> frames; ///< With `file` set.
};

/// Groups of all series; the first frame's place in the list decides their order.
std::vector<SliceGroup> groupFrames(const FrameList& list);

/// The phases of a group, at least one, in order of time: told by temporal position, by trigger, by a part of
/// the heart's cycle or by time of acquisition where each place has as many slices. Copies of one slice
/// are left out and reported.
std::vector<SlicePhase> phasesOf(const FrameList& list, const SliceGroup& group,
                                 std::vector<ScanFinding>& findings);

/// Orders a phase's slices along their normal: the longest part of them that is even to 1 %, and where that
/// is not all of them, every other even part of three slices or more, and last all of them resampled to one
/// grid, where they lie on a line.
std::vector<SliceStack> stackSlices(const FrameList& list, const SlicePhase& phase);

} // namespace viscera::medical_io

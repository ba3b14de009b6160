#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "viscera/medical_io/cine_study.h"
#include "viscera/medical_io/sample_slice.h"
#include "viscera/medical_io/slice_frame.h"
#include "viscera/presentation/scan_look.h"

/// Slices and phases of a cine study that are shown, and where their pixels lie. Nothing is made up between
/// slices or between phases.
namespace viscera::presentation {

/// The slices that the three panes show: those of the look where the study has them; else the middle of the
/// short axis, the plane with four chambers and the one with two, or the planes most like them. O(slices).
std::array<std::size_t, 3> cineSlices(const medical_io::CineStudy& study, const CineLook& look);

/// The slices that the wheel reaches from this one, in their order: its stack, along the normal of the
/// first slice, else all that belong to no stack. O(slices).
std::vector<std::size_t> cineGroup(const medical_io::CineStudy& study, std::size_t slice);

/// The slice so many places further in its group; it stops at the ends.
std::size_t cineStepped(const medical_io::CineStudy& study, std::size_t slice, int steps);

/// The picture of a slice that belongs to a fraction of the cycle, around the end of the cycle as well; none
/// where the picture that should be there is missing. O(phases).
std::optional<std::size_t> cinePhase(const medical_io::CineSlice& slice, double fraction);

/// The fraction of the cycle `steps` pictures of this slice away from the one at `fraction`, [0, 1); goes
/// round. O(phases).
double cineStep(const medical_io::CineSlice& slice, double fraction, int steps);

/// The fraction of the cycle `seconds` later in a cycle of `cycleSeconds`: goes round with `loop`, else stops
/// at 1.
double cineAdvanced(double fraction, double seconds, double cycleSeconds, bool loop);

/// Seconds of the study's cycle: the median of its slices' own; 1 where none is known. O(slices).
double cineSeconds(const medical_io::CineStudy& study);

/// The plane of a slice; its normal points to the reader of a `cineFrame`.
geometry::Plane cinePlane(const medical_io::CineGeometry& geometry);

/// A picture of `width x height` pixels with all of a slice in it, seen as the scanner shows it.
medical_io::SliceFrame cineFrame(const medical_io::CineGeometry& geometry, const SliceFraming& framing,
                                 int width, int height);

/// The letters at the left, right, lower and upper edge: "R", or "RA" where the edge lies between two sides.
std::array<std::string, 4> cineEdges(const medical_io::SliceFrame& frame);

/// A picture's values at the pixels of a frame in its plane, between its pixels bilinear with `smooth`; NaN
/// outside of the picture and where it was not measured. O(pixels of the frame).
void sampleCine(const medical_io::CineImage& image, const medical_io::CineGeometry& geometry,
                const medical_io::SliceFrame& frame, bool smooth, medical_io::ValueImage& values);

/// Level and width from the 1st and 99th percentile of every slice's first picture. Pictures that cannot be
/// decoded are left out. O(pixels of the slices).
medical_io::ValueWindow cineWindow(const medical_io::CineStudy& study);

/// The line in which a plane cuts a frame's picture, from edge to edge in its pixels; none where it passes
/// by, or is nearly parallel. O(1).
std::optional<std::array<Eigen::Vector2d, 2>> cineCross(const medical_io::SliceFrame& frame,
                                                        const geometry::Plane& plane);

} // namespace viscera::presentation

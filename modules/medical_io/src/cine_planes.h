#pragma once

#include "viscera/medical_io/cine_study.h"

namespace viscera::medical_io {

/// Stacks the slices of a study, tells what its planes show, and says what lies between and beside them.
/// Slices keep their order.
///
/// The short axis is a stack whose normal is near the usual long axis of a left ventricle, or whose series
/// says so; a plane along its normal is named by its direction around that axis, from the front wall (0
/// degrees, two chambers) to the septum: three chambers at 60 and four at 120 degrees. A plane farther than
/// 20 degrees from these is as its description says, or a long axis.
void arrangePlanes(CineStudy& study);

/// How a series is called in a sentence: its number, or its description where it has none.
Text seriesLabel(const CineSlice& slice);

} // namespace viscera::medical_io

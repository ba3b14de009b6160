#pragma once

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/motion/motion_series.h"
#include "viscera/motion/retarget.h"

namespace viscera::motion {

/// The textbook's beat that a heart with cavities is to have.
struct TextbookBeat {
  double ejectionFraction = 0.58; ///< Of the left ventricle: the mean of healthy men (docs/sequences.md).
  double ratePerMinute = 75;
  std::size_t phases = 25;
  Landmarks given; ///< Of the outer surface; what is missing is found by its shape.
};

/// A series of phases that one image of a heart (`readOnePhase`; its outer surface first, a cavity for each
/// chamber, named so that `heartChamber` knows it) has while it beats as the textbook's: what `trackMotion`
/// takes. The first phase is the image, taken as the end of diastole. The outer surface moves as
/// `retargetSequence` moves it; the left ventricle narrows about its long axis by what the ejection fraction
/// wants, the right one towards the septum by as much blood; atria fill by what the outer surface leaves
/// them, so that muscle keeps its volume, and where there are none the outer surface follows. Throws what
/// `retargetSequence` throws, `DataError` without a ventricle, `UsageError` for an ejection fraction outside
/// (0.1, 0.8), `Cancelled`. Some seconds.
MotionSeries textbookSeries(const MotionSeries& heart, const TextbookBeat& beat, Progress& progress,
                            Threads threads = {});

} // namespace viscera::motion

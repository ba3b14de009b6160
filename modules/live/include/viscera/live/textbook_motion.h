#pragma once

#include <memory>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/document/document.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/patient_motion.h"
#include "viscera/live/retarget.h"

namespace viscera::live {

/// Ejection fraction, rate and number of phases of the textbook's beat for a heart with cavities.
struct TextbookBeat {
  double ejectionFraction = 0.58; ///< Of the left ventricle: the mean of healthy men (docs/sequences.md).
  double ratePerMinute = 75;
  std::size_t phases = 25;
  Landmarks given; ///< Landmarks of the outer surface; missing ones are found by its shape.
};

/// Makes a series of phases from one image of a heart (`readOnePhase`; its outer surface first, a cavity for
/// each chamber with a name that `anatomy::chamberNamed` knows) that beats like the textbook's heart. The
/// result is an input for `trackMotion`. The first phase is the image, taken as the end of diastole. The
/// outer surface moves as `retargetSequence` moves it; the left ventricle narrows about its long axis to
/// reach the ejection fraction, the right one towards the septum by the same volume; the atria take the
/// remaining volume of the outer surface, so that muscle keeps its volume, and where there are none the outer
/// surface follows. Throws what `retargetSequence` throws, `DataError` without a ventricle, `UsageError` for
/// an ejection fraction outside (0.1, 0.8), `Cancelled`. Some seconds.
MotionSeries textbookSeries(const MotionSeries& heart, const TextbookBeat& beat, Progress& progress,
                            Threads threads = {});

/// Finds the heart to which an organ belongs as the heart itself or one of its chambers: the organ around a
/// chamber, else the organ itself. None where no ventricle is among its closed cavities.
std::shared_ptr<const document::Organ> heartWithCavities(const document::OrganList& organs,
                                                         const document::Organ& organ);

/// The textbook's beat for a heart of a document and its chambers, as a key sequence of handles around and in
/// them. Cavities that are no chambers, and open ones, are carried along. Throws what `textbookSeries` and
/// `trackMotion` throw. Some seconds.
PatientMotion textbookMotion(const document::OrganList& organs, const document::Organ& heart,
                             const TextbookBeat& beat, Progress& progress, Threads threads = {});

} // namespace viscera::live

#pragma once

#include <memory>
#include <optional>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/document/document.h"
#include "viscera/live/heart_tissue.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::presentation {

/// The sample heart that a view's cut opens. Its tissue is drawn in place of its surfaces, and its
/// chambers and vessels are empty, or full of blood.
struct OpenedHeart {
  live::SampleHeartOrgans heart;
  bool blood = false;
};

/// The heart whose tissue the view shows: while the cut is on, the outer surface is visible, and the plane
/// meets it at rest. None under a stress map, which has a cut of its own, and where there is no sample heart.
/// The state of what the view shows alone: the document does not change. O(points).
std::optional<OpenedHeart> openedHeart(const document::DocumentState& state, const ViewState& view);

/// The tissue for a picture of that view, from the library's cache or made (seconds); null where the view
/// opens no heart. Throws what `live::makeHeartTissue` throws.
std::shared_ptr<const live::HeartTissue> heartTissueFor(const document::DocumentState& state,
                                                        const ViewState& view,
                                                        const sample_organs::SampleLibrary& library,
                                                        Progress& progress, Threads threads = {});

} // namespace viscera::presentation

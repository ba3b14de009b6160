#include "viscera/presentation/opened_heart.h"

#include <utility>

#include "seen_document.h"
#include "viscera/presentation/resection.h"

namespace viscera::presentation {
namespace {

bool meets(const scene::CutPlane& plane, const Points& points) {
  const Values heights = points * plane.normal;
  const double level = plane.origin.dot(plane.normal);
  return heights.minCoeff() < level && heights.maxCoeff() > level;
}

} // namespace

std::optional<OpenedHeart> openedHeart(const document::DocumentState& state, const ViewState& view) {
  if (!view.cut.on || view.shown.stress)
    return std::nullopt;
  SeenDocument seen;
  const document::DocumentState& shown = seen.of(state, view.organsSeen);
  auto heart = live::sampleHeartIn(shown);
  if (!heart || !meets(planeOf(view.cut, shown), heart->outer->mesh->points))
    return std::nullopt;
  return OpenedHeart{std::move(*heart), view.cut.blood};
}

std::shared_ptr<const live::HeartTissue> heartTissueFor(const document::DocumentState& state,
                                                        const ViewState& view,
                                                        const sample_organs::SampleLibrary& library,
                                                        Progress& progress, Threads threads) {
  const auto opened = openedHeart(state, view);
  return opened ? live::makeHeartTissue(opened->heart, library, progress, threads) : nullptr;
}

} // namespace viscera::presentation

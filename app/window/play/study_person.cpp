#include "window/play/study_person.h"

#include "viscera/anatomy/norms.h"
#include "viscera/heart/heart_numbers.h"
#include "window/view/view_model.h"

namespace viscera::app {

std::optional<double> statedBodySurface(const medical_io::CineStudy& study) {
  if (study.heightCm <= 0 || study.weightKg <= 0)
    return std::nullopt;
  const double surface = heart::bodySurfaceM2(study.heightCm, study.weightKg);
  return surface >= anatomy::kSmallestBodySurfaceM2 && surface <= anatomy::kLargestBodySurfaceM2
             ? std::optional(surface)
             : std::nullopt;
}

void takePerson(const medical_io::CineStudy& study, ViewModel& view) {
  const auto surface = statedBodySurface(study);
  if (surface && view.state().person.bodySurfaceM2 <= 0)
    view.change([&surface](presentation::ViewState& state) { state.person.bodySurfaceM2 = *surface; });
}

} // namespace viscera::app

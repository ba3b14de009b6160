#include "window/slices/cine_panes.h"

#include <cmath>

#include "viscera/document/study_item.h"
#include "viscera/presentation/cine_view.h"
#include "window/style/language.h"
#include "window/view/picture.h"

namespace viscera::app {

CinePanes::CinePanes(Workspace& workspace, ViewModel& model)
    : workspace_(workspace), model_(model), presenter_({}, translated) {
  presenter_.setDecimalMark(decimalMark());
}

void CinePanes::scroll(int pane, double steps) {
  const medical_io::CineStudy& study = *workspace_.state().study->study;
  const auto place = static_cast<std::size_t>(pane);
  const std::size_t now = presentation::cineSlices(study, model_.state().scan.cine)[place];
  const int whole = static_cast<int>(steps > 0 ? std::ceil(steps) : std::floor(steps));
  const auto next = static_cast<int>(presentation::cineStepped(study, now, whole));
  model_.change([&](presentation::ViewState& view) { view.scan.cine.slices[place] = next; });
}

medical_io::ValueWindow CinePanes::window() const {
  const presentation::ScanLook& look = model_.state().scan;
  return look.width > 0
             ? presentation::windowOf(look, {})
             : presentation::windowOf(look, presentation::cineWindow(*workspace_.state().study->study));
}

} // namespace viscera::app

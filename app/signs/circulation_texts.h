#pragma once

#include <QString>

#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/presentation/circulation_figure.h"

namespace viscera::app {

/// The meaning of the colours of a circulation's curves, as rich text in that language.
QString circulationLegendText(const presentation::ShownCirculation* before, const Wording& language);

/// The panels of a circulation's strip, with axes in that language.
std::vector<scene::CurvePanel> circulationPanels(const presentation::ShownCirculation& shown,
                                                 const presentation::ShownCirculation* before,
                                                 const presentation::StripLook& look,
                                                 const Wording& language);

} // namespace viscera::app

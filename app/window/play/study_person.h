#pragma once

#include <optional>

#include "viscera/medical_io/cine_study.h"

namespace viscera::app {

class ViewModel;

/// The body surface of a study's patient by Mosteller, m2; none where its files do not state height and
/// weight, or those are not of an adult, for whom there are normal ranges.
std::optional<double> statedBodySurface(const medical_io::CineStudy& study);

/// Takes it for the normal ranges, unless a body surface is there that a user has given.
void takePerson(const medical_io::CineStudy& study, ViewModel& view);

} // namespace viscera::app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/circulation/curves.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/response.h"
#include "viscera/core/phrase.h"
#include "viscera/presentation/circulation_figure.h"

namespace viscera::app::cli {

/// Computed numbers of the circulation as JSON, with the keys of `viscera circulate --json`.
nlohmann::ordered_json circulationJson(const circulation::Indices& indices);

/// Computed numbers of the circulation as lines of text.
std::string circulationText(const circulation::Indices& indices);

/// One row of the table that `viscera circulate --vary` prints, as JSON: the parameter's value and the
/// numbers that answer to it.
nlohmann::ordered_json responseJson(const circulation::ResponsePoint& point);

/// A solved circulation with its indices, as figures draw it.
presentation::ShownCirculation shownOf(const Text& name, const circulation::Parameters& parameters,
                                       const circulation::PeriodicState& state);

/// Writes the curves as columns, a header first. Throws `CannotCreateError`.
void writeCurves(const std::filesystem::path& file, const std::vector<circulation::NamedCurve>& curves);

} // namespace viscera::app::cli

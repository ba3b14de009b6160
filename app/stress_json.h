#pragma once

#include <nlohmann/json.hpp>

#include "window/stress/stress_look.h"

namespace viscera::app {

/// How a stress map is looked at, as sessions have it (docs/session_format.md).
nlohmann::ordered_json stressJson(const StressLook& look);

/// What is missing or out of range is as at first.
StressLook stressLookOf(const nlohmann::ordered_json& item);

} // namespace viscera::app

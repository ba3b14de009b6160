#pragma once

#include <QString>

#include <string>

namespace viscera::app {

/// What a button for a repair (an id of `medical_io::surfaceRepairs`) says: "Fill holes".
QString repairName(const std::string& id);

/// What it does, as a sentence for its tooltip.
QString repairTip(const std::string& id);

} // namespace viscera::app

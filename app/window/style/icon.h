#pragma once

#include <QIcon>

namespace viscera::app {

/// An icon of our own set (`resources/icons/<name>.svg`), drawn at any size in the palette's text colour;
/// dimmed when disabled, in the accent colour when checked. Follows a change of theme by itself.
QIcon icon(const char* name);

} // namespace viscera::app

#pragma once

#include <QColor>
#include <QIcon>

#include <functional>

#include "viscera/core/arrays.h"

class QPoint;
class QWidget;

namespace viscera::app {

QColor asColor(const Vec3& color);
Vec3 asVec3(const QColor& color);

/// A rounded square of that colour, for lists.
QIcon swatch(const QColor& color);

/// Lets the user choose a colour beside what was clicked: tissue colours at once, any other from a dialog
/// that does not block the window. `chosen` is called for every colour that is tried, `finished` at the end.
void chooseColor(QWidget* parent, const QPoint& globalPlace, const QColor& present,
                 std::function<void(const QColor&)> chosen, std::function<void()> finished);

} // namespace viscera::app

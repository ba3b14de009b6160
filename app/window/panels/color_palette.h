#pragma once

#include <QColor>
#include <QIcon>

#include <functional>
#include <optional>

#include "viscera/core/arrays.h"
#include "viscera/document/organ.h"

class QPoint;
class QWidget;

namespace viscera::app {

QColor asColor(const Vec3& color);
Vec3 asVec3(const QColor& color);

/// A rounded square of that colour, for lists.
QIcon swatch(const QColor& color);

/// The colour of the tissue named in a file or organ name ("liver_left.vtk" is liver); none for other names.
std::optional<QColor> tissueColor(const QString& name);

/// The colour that an organ called `name` gets from its tissue: where its file gives it none, and where that
/// paints it all over in a pure colour, in which tables of label maps number what no tissue looks like. None:
/// it keeps what it has.
std::optional<Vec3> tissueColorFor(const QString& name, const document::Organ& organ);

/// Lets the user choose a colour beside what was clicked: tissue colours at once, any other from a dialog
/// that does not block the window. `chosen` is called for every colour that is tried, `finished` at the end.
void chooseColor(QWidget* parent, const QPoint& globalPlace, const QColor& present,
                 std::function<void(const QColor&)> chosen, std::function<void()> finished);

} // namespace viscera::app

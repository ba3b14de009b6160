#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace viscera::app {

/// Appends the first of these endings to a file name from a save dialog if the name has none of them. Since
/// the dialog has asked about another file name, asks before an existing file would be replaced, and returns
/// an empty name if the user declines.
QString asNewFile(QWidget* parent, const QString& chosen, const QStringList& endings);

} // namespace viscera::app

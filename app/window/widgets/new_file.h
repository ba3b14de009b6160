#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace viscera::app {

/// The file that a dialog for saving has given, with the first of these endings where it has none of them.
/// That is another file than the one that the dialog asked about: asks before it would be replaced, and
/// returns an empty name when the user does not want that.
QString asNewFile(QWidget* parent, const QString& chosen, const QStringList& endings);

} // namespace viscera::app

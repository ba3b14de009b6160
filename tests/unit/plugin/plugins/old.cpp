#include <QObject>
#include <QtPlugin>

namespace viscera::tests {

/// Made for an interface of long ago.
class OldPlugin final : public QObject {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "org.viscera.CoordinateSystemPlugin/0" FILE "manifest.json")
};

} // namespace viscera::tests

#include "old.moc"

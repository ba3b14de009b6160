#include "window/work/settings.h"

#include <QDir>
#include <QFileInfo>

#include <utility>

namespace viscera::app {
namespace {
constexpr int kRecentFiles = 10;
constexpr const char* kRecentKey = "files/recent";
} // namespace

Settings::Settings(const QString& file) {
  if (!file.isEmpty())
    store_ = std::make_unique<QSettings>(file, QSettings::IniFormat);
}

Settings::Settings(QVariantMap values) : memory_(std::move(values)) {}

QString Settings::standardFile() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
         QStringLiteral("/viscera/viscera.ini");
}

QVariant Settings::value(const char* key, const QVariant& standard) const {
  if (memory_)
    return memory_->value(QLatin1String(key), standard);
  return store_ ? store_->value(QLatin1String(key), standard) : standard;
}

void Settings::setValue(const char* key, const QVariant& value) {
  if (memory_)
    memory_->insert(QLatin1String(key), value);
  if (store_)
    store_->setValue(QLatin1String(key), value);
}

QString Settings::folder(const char* key, QStandardPaths::StandardLocation standard) const {
  for (const QString& folder : {value(key).toString(), QStandardPaths::writableLocation(standard)})
    if (!folder.isEmpty() && QFileInfo(folder).isDir())
      return folder;
  return QDir::homePath();
}

void Settings::remove(const char* key) {
  if (memory_)
    memory_->remove(QLatin1String(key));
  if (store_)
    store_->remove(QLatin1String(key));
}

QStringList Settings::recentFiles() const {
  QStringList present;
  for (const QString& file : value(kRecentKey).toStringList())
    if (QFileInfo::exists(file))
      present.push_back(file);
  return present;
}

void Settings::addRecentFiles(const QStringList& files) {
  QStringList recent = value(kRecentKey).toStringList();
  for (const QString& file : files) {
    const QString absolute = QFileInfo(file).absoluteFilePath();
    recent.removeAll(absolute);
    recent.push_front(absolute);
  }
  setValue(kRecentKey, QStringList(recent.mid(0, kRecentFiles)));
}

} // namespace viscera::app

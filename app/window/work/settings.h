#pragma once

#include <QSettings>
#include <QStandardPaths>
#include <QString>
#include <QVariant>

#include <memory>
#include <optional>

namespace viscera::app {

/// Keys of `Settings::folder`: of the file dialogs that have no folder of their own, and of those for
/// sequences, pictures and movies.
inline constexpr const char* kFolderKey = "files/folder";
inline constexpr const char* kSequencesFolderKey = "files/sequences";
inline constexpr const char* kPicturesFolderKey = "files/pictures";
inline constexpr const char* kMoviesFolderKey = "record/folder";

/// The user's settings of the window, an INI file under `$XDG_CONFIG_HOME/viscera`. Passed by reference to
/// the parts of the window that need it.
class Settings {
public:
  /// Keeps everything in `file`; an empty name keeps nothing (tests, screenshots).
  explicit Settings(const QString& file);
  /// Keeps everything in memory, beginning with these values.
  explicit Settings(QVariantMap values);

  /// `$XDG_CONFIG_HOME/viscera/viscera.ini`
  static QString standardFile();

  QVariant value(const char* key, const QVariant& standard = {}) const;
  void setValue(const char* key, const QVariant& value);
  /// The folder remembered under this key; if there is none or it does not exist, the user's standard folder
  /// for such files; if that does not exist either, the home folder.
  QString folder(const char* key, QStandardPaths::StandardLocation standard) const;
  /// The settings that are kept in memory.
  QVariantMap values() const { return memory_.value_or(QVariantMap()); }
  /// Forgets one value.
  void remove(const char* key);

  /// The files opened last, the newest first; at most ten, those that are gone left out.
  QStringList recentFiles() const;
  void addRecentFiles(const QStringList& files);

private:
  std::unique_ptr<QSettings> store_;
  std::optional<QVariantMap> memory_;
};

} // namespace viscera::app

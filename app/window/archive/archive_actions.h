#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <filesystem>
#include <functional>
#include <memory>

#include "viscera/medical_io/archive_origin.h"
#include "window/archive/archive_client.h"
#include "window/archive/archive_dialog.h"

class QWidget;

namespace viscera::app {

class Actions;
class Settings;
class Workspace;

/// The action *From the archive*: opens its dialog, fetches what the user chooses there, and has it opened as
/// any other file; fetches anew what a session misses.
class ArchiveActions final : public QObject {
  Q_OBJECT

public:
  /// `open` opens files and folders as if the user had chosen them. All have to live longer.
  ArchiveActions(Workspace& workspace, Settings& settings, std::function<void(const QStringList&)> open,
                 QWidget* window);

  /// Adds "file.fromArchive".
  void addTo(Actions& actions);
  ArchiveClient& client() { return client_; }
  ArchiveDialog* dialog() { return dialog_; }
  /// Shows the dialog.
  void show();
  /// Fetches what a session misses, whose file or folder is called `name`, and calls `then` with the folder
  /// to look for it in.
  void fetchAgain(const medical_io::ArchiveOrigin& origin, const std::string& name,
                  std::function<void(const QString& folder)> then);

private:
  void fetch(const ArchiveDialog::Choice& choice);
  void say(const QString& sentence, bool wrong);

  Workspace& workspace_;
  Settings& settings_;
  std::function<void(const QStringList&)> open_;
  QWidget* window_;
  ArchiveClient client_;
  QPointer<ArchiveDialog> dialog_;
};

} // namespace viscera::app

#pragma once

#include <QObject>
#include <QStringList>

#include "viscera/session/open_files.h"
#include "window/handle_placer.h"
#include "window/settings.h"
#include "window/workspace.h"

class QWidget;

namespace viscera::app {

/// Files in and out, on a worker: nothing blocks, and what fails leaves the document as it was and says one
/// thing.
class FileActions final : public QObject {
  Q_OBJECT

public:
  FileActions(Workspace& workspace, HandlePlacer& placer, Settings& settings, QWidget* window);

  /// Asks for files and opens them.
  void chooseAndOpen();
  /// Opens organs and handles as one undo step. Sample organs make room for the first files; later ones come
  /// beside those there are. Organs that come without handles get some.
  void open(const QStringList& files);
  /// Asks where to, and writes the handles at rest as `.mrk.json`.
  void chooseAndSaveHandles();
  void saveHandles(const QString& file);
  /// Asks where to, and writes the current organ as it is posed now.
  void chooseAndExportOrgan();
  void exportOrgan(const QString& file);

Q_SIGNALS:
  void filesOpened();
  void recentFilesChanged();

private:
  QString folder() const;
  void rememberFolder(const QString& file);
  void take(const session::OpenedFiles& opened, const QStringList& files);
  /// Gives organs that are named after a tissue its colour.
  void dressNewOrgans();
  void sayWarnings(const std::vector<std::string>& warnings);
  void saySaved(const QString& what, const QString& file);

  Workspace& workspace_;
  HandlePlacer& placer_;
  Settings& settings_;
  QWidget* window_;
};

} // namespace viscera::app

#pragma once

#include <QObject>
#include <QPointer>

#include <memory>

#include "window/export/dicom_dialog.h"
#include "window/timeline/playback.h"

class QWidget;

namespace viscera::app {

class Actions;
class ArchiveClient;
class Settings;
class Workspace;

/// Exports organs as DICOM objects (File > Export as DICOM...): asks what is wanted, has a worker make the
/// files in a folder or send them to an archive, and says what was written.
class DicomExports final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window that it needs; all have to live longer.
  struct Window {
    Workspace& workspace;
    Playback& playback;
    ArchiveClient& archives;
    Settings& settings;
  };

  DicomExports(Window window, QWidget* parent);

  /// Adds "export.dicom".
  void addTo(Actions& actions);
  /// Shows the dialog.
  void show();
  DicomDialog* dialog() { return dialog_; }
  /// Writes or sends what is chosen, of the window as it is now.
  void write(const DicomDialog::Choice& choice);

private:
  struct Material;
  struct Made;

  std::shared_ptr<Material> material(const DicomDialog::Choice& choice) const;
  static Made make(const Material& material, const std::string& folder, Progress& progress);
  static QString summary(const Made& made);
  void readIdentity();
  QString newFolder() const;
  void send(const clinic::ArchiveConnection& archive, std::shared_ptr<Material> material);

  Window window_;
  QWidget* parent_;
  QPointer<DicomDialog> dialog_;
};

} // namespace viscera::app

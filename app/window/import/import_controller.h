#pragma once

#include <QObject>
#include <QStringList>

#include <functional>

#include "viscera/document/import_draft.h"
#include "viscera/presentation/presenter.h"

namespace viscera::app {

class FileActions;
class ImportPanel;
class Picture;
class Workspace;

/// Controls the import of files that the user checks first: holds the draft, has a worker repair it, and
/// shows it in the import panel and the view. Accepting is one undo step; cancelling leaves everything as it
/// was.
class ImportController final : public QObject {
  Q_OBJECT

public:
  ImportController(Workspace& workspace, FileActions& files, Picture& picture, QObject* parent);
  ~ImportController() override;

  /// The panel; the widget that shows it takes ownership.
  ImportPanel* panel() const { return panel_; }
  bool isOpen() const { return open_; }
  const document::ImportDraft& draft() const { return draft_; }

  /// Opens the import panel with these files. If it already holds files, shows a message and does nothing.
  void begin(document::ImportDraft draft, const QStringList& files);
  void accept();
  void cancel();
  void repair(const std::vector<std::size_t>& organs, const std::string& repair);

  /// Cancels the import when the watched widget is closed.
  bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void opened();
  void closed();

private:
  /// Makes the next draft on a worker, shows it, and says which of these organs were refused.
  void work(const QString& name, const std::vector<std::size_t>& organs,
            std::function<document::ImportDraft(Progress&)> next);
  void sayRefusals(const std::vector<std::size_t>& organs);
  void revert(std::size_t organ);
  void include(const std::vector<std::size_t>& organs, bool included);
  void show();
  void preview();
  void addRemoved(std::vector<presentation::TransientSurface>& surfaces) const;
  /// Shows in red what a repair would remove from that organ.
  void previewRemoval(std::size_t organ, const std::string& repair);
  void close();

  Workspace& workspace_;
  FileActions& files_;
  ImportPanel* panel_;
  Picture& picture_;
  Bounds previewed_;          ///< In the picture.
  std::size_t fromOrgan_ = 0; ///< Of which `removed_` is a part.
  std::string removal_;       ///< The repair that would remove it; empty: none is being chosen.
  document::ImportDraft draft_;
  QStringList names_;
  bool open_ = false;
};

} // namespace viscera::app

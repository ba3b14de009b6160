#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "viscera/document/autosave.h"
#include "viscera/document/session_file.h"
#include "viscera/medical_io/archive_origin.h"
#include "window/session/session_view.h"
#include "window/work/actions.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

class QWidget;

namespace viscera::app {

/// Opens and saves the session: knows its file, whether it has unsaved changes, and its recovery file.
/// Workers read and write; a failure leaves the document and the file unchanged and shows one message.
class SessionFiles final : public QObject {
  Q_OBJECT

public:
  /// The user's answer to the question about unsaved changes.
  enum class Answer { save, discard, cancel };

  SessionFiles(Workspace& workspace, Playback& playback, SessionView& view, Settings& settings,
               QWidget* window);

  /// Adds "file.new", "file.save", "file.saveAs" and "file.recover".
  void addTo(Actions& actions);

  /// The file of the session; empty for one that was never saved.
  const QString& file() const { return file_; }
  /// "liver.viscera", or the name of one without a file.
  QString name() const;
  /// Whether there are changes that are not saved.
  bool modified() const { return !workspace_.undo().isClean() || view_.slides() != savedSlides_; }
  /// The present contents of the session to save.
  document::SessionContents contents() const;

  /// Saves to the session's file, or asks for one. Calls `then` when it is saved.
  void save(std::function<void()> then = {});
  /// Asks for a file and whether to store the surfaces in it, and saves.
  void chooseAndSave(std::function<void()> then = {});
  void saveTo(const QString& file, bool embed, std::function<void()> then = {});
  /// Opens a session in place of the present one; asks first if that has unsaved changes. Also looks for
  /// organs' files in the folder `alsoIn`.
  void open(const QString& file, const QString& alsoIn = {}) {
    whenSaved([this, file, alsoIn] { read(file, std::nullopt, alsoIn); });
  }
  /// Begins an empty document; asks first if there are unsaved changes.
  void begin();
  /// Calls `then` once changes are saved or the user discards them. Returns false if the answer is still
  /// awaited or the user cancels.
  bool whenSaved(std::function<void()> then);

  /// Begins to save recovery files in this folder.
  void startAutosave(const std::filesystem::path& folder,
                     double delaySeconds = document::Autosave::kDelaySeconds);
  /// Offers to open the recovery files of earlier runs of the program.
  void offerRecovery();
  /// Opens the newest of these recovery files.
  void recover();
  /// Called when the program ends unexpectedly: writes unsaved work to the recovery file and waits until that
  /// is done. Returns false if there is no unsaved work, or no recovery file. Throws when it cannot be
  /// written.
  bool writeRecoveryFile();
  /// Called when the program ends and all changes are saved or discarded.
  void endCleanly();

  /// Replaces, for tests, the dialog that asks about unsaved changes.
  void setQuestion(std::function<Answer(const QString& name)> question) { question_ = std::move(question); }

Q_SIGNALS:
  /// The session's file or its saved state has changed.
  void changed();
  void recentFilesChanged();
  /// The user wants to have fetched what the session in this file misses: a file or folder of that name.
  void fetchWanted(const viscera::medical_io::ArchiveOrigin& origin, const QString& name,
                   const QString& session);
  /// Another document was opened.
  void opened();

public Q_SLOTS:
  /// Called when a sample organ has replaced everything. If the document was `untouched`, the session counts
  /// as saved; if the sample is the `first` thing in the window, loading it cannot be undone.
  void sampleLoaded(const QString& name, bool untouched, bool first);

private:
  void read(const QString& file, std::optional<document::Recovery> recovery, const QString& alsoIn = {});
  void take(const document::OpenedSession& session, const QString& file);
  void takeContents(const document::SessionContents& contents, const QString& file);
  /// The parts of a session that decide whether it has unsaved changes.
  struct Kept {
    document::DocumentState state;
    std::vector<presentation::Slide> slides;
  };

  /// Called after writing. `embed`: whether the file holds the surfaces; none: it was written for a session
  /// that is no longer open.
  void wrote(const QString& file, std::optional<bool> embed, const Kept& kept);
  void takeSlides();
  void onView();
  /// Shows the warnings of an opened session, and offers to look for missing files if `file` can be opened
  /// again.
  void sayWarnings(const document::OpenedSession& session, const QString& file);
  void lookForFiles(const QString& file);
  void onUndo();
  /// Shows the session's name and whether it is saved in the window's title.
  void syncTitle();
  void autosaveIfDue();
  document::SessionContents recoveryContents() const;
  Answer ask() const;

  Workspace& workspace_;
  Playback& playback_;
  SessionView& view_;
  Settings& settings_;
  QWidget* window_;
  QString file_;
  bool embed_ = false;
  int session_ = 0; ///< Number of the present document; increases with every document that is opened.
  std::vector<presentation::Slide> savedSlides_;
  std::vector<presentation::Slide> seenSlides_;
  std::vector<document::MissingOrgan> missing_;
  nlohmann::ordered_json missingScan_;  ///< A scan of the session file that was not found.
  nlohmann::ordered_json missingStudy_; ///< The same of a cine study.
  JobQueue writes_;                     ///< A queue of its own, so that saving does not wait for long jobs.
  std::unique_ptr<document::Autosave> autosave_;
  std::vector<document::Recovery> recoveries_;
  QString recoveryText_; ///< The text of the offer to recover the first of them.
  std::function<Answer(const QString&)> question_;
  bool autosaveFailed_ = false; ///< A message about the failure was shown.
  bool wasModified_ = false;
  QTimer timer_;
  Subscription subscription_;
};

} // namespace viscera::app

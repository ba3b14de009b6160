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
#include "window/actions.h"
#include "window/session/session_view.h"
#include "window/settings.h"
#include "window/workspace.h"

class QWidget;

namespace viscera::app {

/// Opens and saves the session: knows its file, whether it has unsaved changes, and its recovery file.
/// Workers read and write; a failure leaves the document and the file unchanged and shows one message.
class SessionFiles final : public QObject {
  Q_OBJECT

public:
  /// What is to become of changes that are not saved.
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
  /// Everything that is saved, as it is now.
  document::SessionContents contents() const;

  /// Saves to the session's file, or asks for one. `then` follows once it is saved.
  void save(std::function<void()> then = {});
  /// Asks for a file, and whether the surfaces are to be inside.
  void chooseAndSave(std::function<void()> then = {});
  void saveTo(const QString& file, bool embed, std::function<void()> then = {});
  /// Opens a session in place of what there is; asks first when that is not saved.
  /// Organs' files are looked for in the folder `alsoIn`, too.
  void open(const QString& file, const QString& alsoIn = {}) {
    whenSaved([this, file, alsoIn] { read(file, std::nullopt, alsoIn); });
  }
  /// An empty document; asks first.
  void begin();
  /// Calls `then` when no change can be lost any more: all is saved, or the user does not want it. False
  /// when the answer is still awaited, or no.
  bool whenSaved(std::function<void()> then);

  /// From now on the work is kept in recovery files in this folder.
  void startAutosave(const std::filesystem::path& folder,
                     double delaySeconds = document::Autosave::kDelaySeconds);
  /// Offers what an earlier run of the program has left.
  void offerRecovery();
  /// Opens the youngest of what was left.
  void recover();
  /// The program ends without having been asked to: brings unsaved work into the recovery file and waits for
  /// that. False when there is nothing to keep, or it is not kept. Throws when it cannot be written.
  bool keepNow();
  /// Everything is saved or not wanted, and the program ends.
  void endCleanly();

  /// Another way to ask than a dialog, for tests.
  void setQuestion(std::function<Answer(const QString& name)> question) { question_ = std::move(question); }

Q_SIGNALS:
  /// Another file, or saved, or not saved any more.
  void changed();
  void recentFilesChanged();
  /// A document was opened in place of the one before.
  void opened();

public Q_SLOTS:
  /// A sample organ took the place of everything: nothing that somebody has to save when `untouched`, and no
  /// step that could be undone when it is the `first` thing in the window.
  void sampleLoaded(const QString& name, bool untouched, bool first);

private:
  void read(const QString& file, std::optional<document::Recovery> recovery, const QString& alsoIn = {});
  void take(const document::OpenedSession& session, const QString& file);
  void takeContents(const document::SessionContents& contents, const QString& file);
  /// What a session file keeps, and undo or the user can change.
  struct Kept {
    document::DocumentState state;
    std::vector<presentation::Slide> slides;
  };

  /// Whether surfaces are inside; none: it was written for a session that is no longer open.
  void wrote(const QString& file, std::optional<bool> embed, const Kept& kept);
  void takeSlides();
  void onView();
  /// Offers to look for files that are missing where `file` can be opened again.
  void sayWarnings(const document::OpenedSession& session, const QString& file);
  void lookForFiles(const QString& file);
  void onUndo();
  /// Says in the window's title which session it is and whether it is saved.
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
  int session_ = 0; ///< Another number for every document that takes the place of the one before.
  std::vector<presentation::Slide> savedSlides_;
  std::vector<presentation::Slide> seenSlides_;
  std::vector<document::MissingOrgan> missing_;
  std::string missingScan_; ///< As in the session file, of a scan that was not found there.
  JobQueue writes_;         ///< Of its own: saving waits for no long work.
  std::unique_ptr<document::Autosave> autosave_;
  std::vector<document::Recovery> recoveries_;
  QString recoveryText_; ///< The offer of the first of them.
  std::function<Answer(const QString&)> question_;
  bool autosaveFailed_ = false; ///< It was said.
  bool wasModified_ = false;
  QTimer timer_;
  Subscription subscription_;
};

} // namespace viscera::app

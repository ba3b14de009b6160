#include "window/session/session_files.h"

#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <chrono>
#include <utility>

#include "window/widgets/new_file.h"
#include "window/work/mailbox.h"

namespace viscera::app {
namespace {

constexpr const char* kSessionEnding = ".viscera";
constexpr int kLookMilliseconds = 1000;
constexpr int kSavedSeconds = 4;
constexpr std::size_t kShownSessionWarnings = 4;

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool isMissingFile(const document::SurfaceFinding& surface) {
  return surface.state == document::SurfaceFinding::State::missing && !surface.source.starts_with("sample:");
}

/// What an archive has of a session that misses its images.
struct LostImages {
  medical_io::ArchiveOrigin origin;
  std::string name; ///< Of the file or folder.
};

std::optional<LostImages> lostToArchive(const document::SessionContents& contents) {
  for (const nlohmann::ordered_json* record : {&contents.missingScan, &contents.missingStudy})
    if (auto origin = document::archiveOriginOf(*record))
      return LostImages{std::move(*origin),
                        std::filesystem::path(record->value("absolute", std::string())).filename().string()};
  return std::nullopt;
}

QDateTime dateOf(const document::Recovery& recovery) {
  const auto age = std::filesystem::file_time_type::clock::now() - recovery.written;
  return QDateTime::currentDateTime().addSecs(-std::chrono::duration_cast<std::chrono::seconds>(age).count());
}

} // namespace

SessionFiles::SessionFiles(Workspace& workspace, Playback& playback, SessionView& view, Settings& settings,
                           QWidget* window)
    : QObject(window), workspace_(workspace), playback_(playback), view_(view), settings_(settings),
      window_(window), writes_(mailbox()) {
  subscription_ = workspace.undo().onChange([this] { onUndo(); });
  connect(&view, &SessionView::changed, this, &SessionFiles::onView);
  connect(&timer_, &QTimer::timeout, this, &SessionFiles::autosaveIfDue);
  connect(this, &SessionFiles::changed, this, &SessionFiles::syncTitle);
  syncTitle();
}

void SessionFiles::addTo(Actions& actions) {
  actions.add("file.new",
              {tr("&New session"), nullptr, {QKeySequence::New}, tr("Start with an empty session")},
              [this] { begin(); });
  actions.add("file.save", {tr("&Save"), "save", {QKeySequence::Save}, tr("Save the session")},
              [this] { save(); });
  actions.add("file.saveAs",
              {tr("Save &as..."), nullptr, {tr("Ctrl+Shift+S")}, tr("Save the session in another file")},
              [this] { chooseAndSave(); });
  actions.add("file.recover",
              {tr("&Recover unsaved work"),
               nullptr,
               {},
               tr("Open the copy that Viscera kept when it ended without saving")},
              [this] { recover(); });
  actions.enableWhile({"file.recover"}, [this] { return !recoveries_.empty(); });
  connect(this, &SessionFiles::changed, &actions, &Actions::sync);
}

void SessionFiles::syncTitle() {
  const bool nameless = file_.isEmpty() && !modified();
  window_->setWindowTitle((nameless ? tr("Viscera") : name()) + QStringLiteral("[*]"));
  window_->setWindowModified(modified());
  window_->setWindowFilePath(file_);
}

QString SessionFiles::name() const {
  return file_.isEmpty() ? tr("Untitled session") : QFileInfo(file_).fileName();
}

document::SessionContents SessionFiles::contents() const {
  document::SessionContents contents;
  contents.state = workspace_.state();
  contents.view = view_.saved();
  contents.embedSurfaces = contents.embedScan = embed_;
  contents.missing = missing_;
  contents.missingScan = missingScan_;
  contents.missingStudy = missingStudy_;
  return contents;
}

void SessionFiles::save(std::function<void()> then) {
  if (file_.isEmpty())
    chooseAndSave(std::move(then));
  else
    saveTo(file_, embed_, std::move(then));
}

void SessionFiles::chooseAndSave(std::function<void()> then) {
  const QString pattern = QStringLiteral(" (*%1)").arg(QLatin1String(kSessionEnding));
  const QString linked = tr("Session that names its organs' files") + pattern;
  const QString embedded = tr("Session with all surfaces and the scan inside") + pattern;
  QString chosen = embed_ ? embedded : linked;
  const QString folder = settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString start =
      file_.isEmpty() ? folder + QLatin1Char('/') + tr("session") + QLatin1String(kSessionEnding) : file_;
  const QString file =
      asNewFile(window_,
                QFileDialog::getSaveFileName(window_, tr("Save the session as"), start,
                                             linked + QStringLiteral(";;") + embedded, &chosen),
                {QLatin1String(kSessionEnding)});
  if (!file.isEmpty())
    saveTo(file, chosen == embedded, std::move(then));
}

void SessionFiles::saveTo(const QString& file, bool embed, std::function<void()> then) {
  document::SessionContents saved = contents();
  saved.embedSurfaces = saved.embedScan = embed;
  const Kept kept{saved.state, view_.slides()};
  writes_.submit<bool>(
      tr("Saving %1").arg(QFileInfo(file).fileName()).toStdString(), {},
      [path = file.toStdString(), saved = std::move(saved)](Progress& progress) {
        document::writeSession(path, saved, progress);
        return true;
      },
      [this, file, embed, kept, session = session_, then = std::move(then)](JobResult<bool> result) {
        if (result.error)
          workspace_.report(*result.error);
        if (!result.value)
          return;
        wrote(file, session == session_ ? std::optional(embed) : std::nullopt, kept);
        if (then && session == session_)
          then();
      });
}

void SessionFiles::wrote(const QString& file, std::optional<bool> embed, const Kept& kept) {
  const QString whole = QFileInfo(file).absoluteFilePath();
  settings_.setValue(kFolderKey, QFileInfo(whole).absolutePath());
  settings_.addRecentFiles({whole});
  if (embed) {
    file_ = whole;
    embed_ = *embed;
    savedSlides_ = kept.slides;
    workspace_.undo().markSaved(kept.state);
  }
  workspace_.note(tr("Saved as %1").arg(whole), kSavedSeconds);
  Q_EMIT recentFilesChanged();
  onUndo();
  Q_EMIT changed();
}

bool SessionFiles::whenSaved(std::function<void()> then) {
  const Answer answer = modified() ? ask() : Answer::discard;
  if (answer == Answer::cancel)
    return false;
  if (answer == Answer::save) {
    save(std::move(then));
    return false;
  }
  then();
  return true;
}

SessionFiles::Answer SessionFiles::ask() const {
  if (question_)
    return question_(name());
  QMessageBox box(QMessageBox::Question, tr("Save changes?"),
                  file_.isEmpty() ? tr("Save this session?") : tr("Save the changes of %1?").arg(name()),
                  QMessageBox::NoButton, window_);
  box.setInformativeText(tr("If you discard them, the changes since the last saving are lost."));
  QPushButton* save = box.addButton(tr("&Save"), QMessageBox::AcceptRole);
  QPushButton* discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
  box.addButton(tr("&Cancel"), QMessageBox::RejectRole);
  box.setDefaultButton(save);
  box.exec();
  return box.clickedButton() == save      ? Answer::save
         : box.clickedButton() == discard ? Answer::discard
                                          : Answer::cancel;
}

void SessionFiles::begin() {
  whenSaved([this] {
    workspace_.jobs().cancelAll();
    takeContents({}, {});
    view_.forget();
    takeSlides();
    Q_EMIT opened();
  });
}

void SessionFiles::read(const QString& file, std::optional<document::Recovery> recovery,
                        const QString& alsoIn) {
  std::vector<std::filesystem::path> folders;
  if (!alsoIn.isEmpty())
    folders.emplace_back(alsoIn.toStdString());
  workspace_.inBackground<document::OpenedSession>(
      tr("Opening %1").arg(QFileInfo(file).fileName()), "open",
      [path = file.toStdString(), folders, library = sample_organs::standardLibrary()](Progress& progress) {
        return document::readSession(path, library, progress, folders);
      },
      [this, file, recovery,
       asked = Kept{workspace_.state(), view_.slides()}](const document::OpenedSession& session) {
        const auto takeIt = [this, file, recovery, session] {
          const QString whole = QFileInfo(file).absoluteFilePath();
          if (!recovery) {
            take(session, whole);
            return sayWarnings(session, whole);
          }
          take(session, QString::fromStdString(session.contents.recovers.string()));
          sayWarnings(session, {});
          workspace_.undo().markUnsaved();
          if (autosave_)
            autosave_->adopt(*recovery);
        };
        // If something was changed while the file was read, the user has to be asked again.
        if (workspace_.state() == asked.state && view_.slides() == asked.slides)
          takeIt();
        else
          whenSaved(takeIt);
      });
}

void SessionFiles::take(const document::OpenedSession& session, const QString& file) {
  takeContents(session.contents, file);
  if (!file.isEmpty()) {
    settings_.addRecentFiles({file});
    settings_.setValue(kFolderKey, QFileInfo(file).absolutePath());
    Q_EMIT recentFilesChanged();
  }
  Q_EMIT opened();
  workspace_.guarded([&] { view_.apply(session.contents.view); });
  takeSlides();
}

/// The document of a session in place of the one before; nothing of that one is left.
void SessionFiles::takeContents(const document::SessionContents& contents, const QString& file) {
  if (autosave_)
    autosave_->clear();
  ++session_;
  playback_.forgetAll();
  workspace_.selection().clear();
  workspace_.undo().reset({}); // The ids of the other document mean nothing here.
  workspace_.undo().reset(contents.state);
  file_ = file;
  embed_ = contents.embedSurfaces;
  missing_ = contents.missing;
  missingScan_ = contents.missingScan;
  missingStudy_ = contents.missingStudy;
  Q_EMIT changed();
}

/// The slides of the view are as they were saved.
void SessionFiles::takeSlides() {
  seenSlides_ = savedSlides_ = view_.slides();
  onUndo();
}

void SessionFiles::onView() {
  if (seenSlides_ == view_.slides())
    return;
  seenSlides_ = view_.slides();
  onUndo();
}

void SessionFiles::sayWarnings(const document::OpenedSession& session, const QString& file) {
  const std::vector<Text>& warnings = session.warnings;
  if (warnings.empty())
    return;
  const bool missing =
      !file.isEmpty() && (!session.contents.missingScan.empty() || !session.contents.missingStudy.empty() ||
                          std::any_of(session.surfaces.begin(), session.surfaces.end(), isMissingFile));
  // Whether no organ could be opened, so that the document is empty.
  const bool all = missing && session.contents.state.organs->empty();
  const std::size_t shown = all ? warnings.size() : std::min(warnings.size(), kShownSessionWarnings);
  QStringList lines;
  for (std::size_t i = 0; i < shown; ++i)
    lines.push_back(asSentence(warnings[i]));
  if (warnings.size() > shown)
    lines.push_back(tr("And %n more.", nullptr, static_cast<int>(warnings.size() - shown)));
  Message message{Message::Severity::warning, lines.join(QLatin1Char('\n')), {}, 0};
  if (const auto lost = missing ? lostToArchive(session.contents) : std::nullopt)
    message.offers.push_back({tr("Fetch it from %1").arg(text(lost->origin.archive)), [this, lost, file] {
                                Q_EMIT fetchWanted(lost->origin, text(lost->name), file);
                              }});
  if (missing)
    message.offers.push_back({tr("Look for files..."), [this, file] { lookForFiles(file); }});
  workspace_.say(message);
}

void SessionFiles::lookForFiles(const QString& file) {
  const QString folder = QFileDialog::getExistingDirectory(
      window_, tr("Choose the folder with the missing files"), QFileInfo(file).absolutePath());
  if (!folder.isEmpty())
    open(file, folder);
}

void SessionFiles::startAutosave(const std::filesystem::path& folder, double delaySeconds) {
  recoveries_ = document::findRecoveries(folder);
  autosave_ = std::make_unique<document::Autosave>(folder, mailbox(), steadySeconds, delaySeconds);
  timer_.start(kLookMilliseconds);
  onUndo();
  Q_EMIT changed();
}

document::SessionContents SessionFiles::recoveryContents() const {
  document::SessionContents kept = contents();
  kept.recovers = file_.toStdString();
  kept.embedScan = false; // Would write a hundred megabytes every minute that are in a file already.
  return kept;
}

void SessionFiles::autosaveIfDue() {
  if (!autosave_ || !autosave_->due() || workspace_.undo().stepOpen())
    return;
  autosave_->write(recoveryContents(), [this](std::shared_ptr<const Error> error) {
    if (error && !autosaveFailed_)
      workspace_.report(*error);
    autosaveFailed_ = error != nullptr;
  });
}

void SessionFiles::onUndo() {
  const bool now = modified();
  if (autosave_ && now)
    autosave_->changed();
  if (autosave_ && !now && wasModified_)
    autosave_->clear();
  if (now != wasModified_) {
    wasModified_ = now;
    Q_EMIT changed();
  }
}

void SessionFiles::offerRecovery() {
  if (recoveries_.empty())
    return;
  const document::Recovery offered = recoveries_.front();
  const QString when = QLocale().toString(dateOf(offered), QLocale::ShortFormat);
  Message message;
  message.severity = Message::Severity::warning;
  message.text = tr("Viscera ended without saving. It has kept a copy of the work of %1.").arg(when);
  message.offers.push_back({tr("Recover"), [this] { recover(); }});
  message.offers.push_back({tr("Discard"), [this, offered] {
                              document::discard(offered);
                              std::erase_if(recoveries_, [&offered](const document::Recovery& recovery) {
                                return recovery.file == offered.file;
                              });
                              Q_EMIT changed();
                              offerRecovery();
                            }});
  recoveryText_ = message.text;
  workspace_.say(message);
}

void SessionFiles::recover() {
  if (recoveries_.empty())
    return;
  whenSaved([this] {
    const document::Recovery recovery = recoveries_.front();
    recoveries_.erase(recoveries_.begin());
    workspace_.retract(recoveryText_);
    read(QString::fromStdString(recovery.file.string()), recovery);
    Q_EMIT changed();
  });
}

bool SessionFiles::writeRecoveryFile() {
  if (!autosave_ || !modified())
    return false;
  autosave_->writeNow(recoveryContents());
  return true;
}

void SessionFiles::endCleanly() {
  timer_.stop();
  if (autosave_)
    autosave_->clear();
}

void SessionFiles::sampleLoaded(const QString&, bool untouched, bool first) {
  if (!untouched || !file_.isEmpty())
    return;
  if (first) // The sample is the first content, so there is no earlier state for undo.
    workspace_.undo().reset(workspace_.state());
  else
    workspace_.undo().markUntouched();
}

} // namespace viscera::app

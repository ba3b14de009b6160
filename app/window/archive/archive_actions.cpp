#include "window/archive/archive_actions.h"

#include <algorithm>
#include <system_error>
#include <vector>

#include "window/archive/password_dialog.h"
#include "window/work/actions.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr const char* kChosenKey = "archive/chosen";
constexpr const char* kDicomEnding = ".dcm";

/// What is opened of a fetched folder: its only image, or all of it.
QString placeIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> images;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
    if (entry.path().filename() != medical_io::kArchiveOriginFile)
      images.push_back(entry.path());
  const bool one = images.size() == 1 && images.front().extension() == kDicomEnding;
  return text((one ? images.front() : folder).string());
}

} // namespace

ArchiveActions::ArchiveActions(Workspace& workspace, Settings& settings,
                               std::function<void(const QStringList&)> open, QWidget* window)
    : QObject(window), workspace_(workspace), settings_(settings), open_(std::move(open)), window_(window),
      client_(clinic::systemKeyRing(), clinic::archiveConnectionsFile()) {
  client_.setQuestion([this](const clinic::ArchiveConnection& connection, bool refused, bool canKeep) {
    return PasswordDialog::ask(connection, refused, canKeep, dialog_ ? dialog_.data() : window_);
  });
  connect(&client_, &ArchiveClient::failed, this, [this](const QString& sentence) {
    if (!dialog_) // Else it says so itself.
      say(sentence, true);
  });
}

void ArchiveActions::addTo(Actions& actions) {
  actions.add("file.fromArchive",
              {tr("From the &archive..."),
               "patient",
               {},
               tr("Search a hospital's archive (PACS) for a patient and open a series")},
              [this] { show(); });
}

void ArchiveActions::show() {
  if (!dialog_) {
    dialog_ = new ArchiveDialog(client_, settings_.value(kChosenKey).toString(), window_);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_.data(), &ArchiveDialog::openWanted, this, &ArchiveActions::fetch);
    connect(dialog_.data(), &ArchiveDialog::archiveChosen, this,
            [this](const QString& name) { settings_.setValue(kChosenKey, name); });
  }
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

void ArchiveActions::say(const QString& sentence, bool wrong) {
  workspace_.say({wrong ? Message::Severity::error : Message::Severity::info, sentence, {}, wrong ? 0 : 8});
}

void ArchiveActions::fetch(const ArchiveDialog::Choice& choice) {
  std::filesystem::path folder = clinic::archiveFolder() / choice.studyUid;
  if (!choice.seriesUid.empty())
    folder /= choice.seriesUid;
  client_.retrieve(choice.connection, choice.studyUid, choice.seriesUid, folder, [this, folder] {
    if (dialog_)
      dialog_->close();
    open_({placeIn(folder)});
  });
}

void ArchiveActions::fetchAgain(const medical_io::ArchiveOrigin& origin, const std::string& name,
                                std::function<void(const QString& folder)> then) {
  std::vector<clinic::ArchiveConnection> all;
  if (!workspace_.guarded([&] { all = client_.connections(); }))
    return;
  const auto found = std::find_if(all.begin(), all.end(), [&](const clinic::ArchiveConnection& each) {
    return each.name == origin.archive;
  });
  if (found == all.end()) {
    show();
    return say(
        tr("No archive is called %1 here. Add it, then open the session again.").arg(text(origin.archive)),
        true);
  }
  // The session looks for a file in the folder, or for a folder of that name.
  const bool isFile = std::filesystem::path(name).extension() == kDicomEnding;
  const std::string own = origin.seriesUid.empty() ? origin.studyUid : origin.seriesUid;
  const bool isName = !name.empty() && name != "." && name != ".."; // A session comes from strangers.
  const std::filesystem::path folder =
      clinic::archiveFolder() / "sessions" / (isFile || !isName ? own : name);
  say(tr("Fetching from %1").arg(text(origin.archive)), false);
  client_.retrieve(*found, origin.studyUid, origin.seriesUid, folder,
                   [folder, then = std::move(then)] { then(text(folder.string())); });
}

} // namespace viscera::app

#include "window/import/file_actions.h"

#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>
#include <iterator>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/document/session_file.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/presentation/presenter.h"
#include "window/import/arriving_surfaces.h"
#include "window/style/language.h"
#include "window/widgets/new_file.h"

namespace viscera::app {
namespace {

/// Part of the diagonal of an organ.
constexpr double kSamePlace = 1e-3;

bool sameBox(const Bounds& a, const Bounds& b) {
  const double most = kSamePlace * b.diagonal();
  return (a.low - b.low).cwiseAbs().maxCoeff() <= most && (a.high - b.high).cwiseAbs().maxCoeff() <= most;
}

/// Whether organs in one box are one organ twice, by its name or by every vertex.
bool isTwice(const document::Organ& a, const document::Organ& b) {
  if (a.mesh == b.mesh || a.name == b.name)
    return true;
  return a.mesh->points.rows() == b.mesh->points.rows() &&
         (a.mesh->points - b.mesh->points).cwiseAbs().maxCoeff() <=
             kSamePlace * boundsOf(b.mesh->points).diagonal();
}

constexpr int kShownFileWarnings = 3;
constexpr const char* kHandleEnding = ".mrk.json";

QString patterns(const std::vector<std::string>& extensions) {
  QStringList list;
  for (const std::string& extension : extensions)
    list.push_back(QStringLiteral("*") + text(extension));
  return list.join(QLatin1Char(' '));
}

/// Several series to choose from; the phases of one are opened together.
bool hasSeveralScans(const std::filesystem::path& place, Progress& progress) {
  if (!medical_io::isScan(place) || medical_io::isLabelMap(place))
    return false;
  return medical_io::listScans(place, progress).size() > 1;
}

/// The files that are there; all of them where none is.
QStringList thoseThere(const QStringList& files) {
  QStringList there;
  std::copy_if(files.begin(), files.end(), std::back_inserter(there),
               [](const QString& file) { return QFileInfo::exists(file); });
  return there.isEmpty() ? files : there;
}

} // namespace

FileActions::FileActions(Workspace& workspace, HandlePlacer& placer, Settings& settings, QWidget* window)
    : QObject(window), workspace_(workspace), placer_(placer), settings_(settings), window_(window) {}

void FileActions::addTo(Actions& actions) {
  actions.add("file.open",
              {tr("&Open..."),
               "open",
               {QKeySequence::Open},
               tr("Open a session, organs, label maps, handles or a scan")},
              [this] { chooseAndOpen(); });
  actions.add("file.openFolder",
              {tr("Open a &folder of masks..."),
               "organs",
               {},
               tr("Open one patient: a folder with one mask for each organ, as TotalSegmentator writes it")},
              [this] { chooseAndOpenFolder(); });
  actions.add("file.check",
              {tr("&Import with check..."),
               "patient",
               {tr("Ctrl+Shift+O")},
               tr("Check and repair the contents of files before importing them")},
              [this] { chooseAndOpen(true); });
  actions.add("handles.save",
              {tr("Save &handles..."), "save", {}, tr("Save the handles at rest as Slicer markups")},
              [this] { chooseAndSaveHandles(); });
  actions.add("file.export",
              {tr("&Export organ..."), "export", {tr("Ctrl+E")}, tr("Export the organ in its present pose")},
              [this] { chooseAndExportOrgan(); });
  actions.add("cage.load",
              {tr("Load a &cage..."),
               "open",
               {},
               tr("For coordinates that need a cage: load a closed surface around the organ; its vertices "
                  "become the handles")},
              [this] { chooseAndLoadCage(); });
  actions.enableWhile({"file.export"}, [this] { return !workspace_.document().organs().empty(); });
  actions.enableWhile({"handles.save"}, [this] { return !workspace_.document().rig().handles.empty(); });
  actions.enableWhile({"cage.load"}, [this] { return workspace_.systemTraits().needsCage; });
}

QString FileActions::folder() const {
  return settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation);
}

void FileActions::rememberFolder(const QString& file) {
  settings_.setValue(kFolderKey, QFileInfo(file).absolutePath());
}

void FileActions::chooseAndOpen(bool check) {
  const QString surfaces = patterns(medical_io::endingsOf(medical_io::FileKind::surface));
  const QString labels = patterns(medical_io::endingsOf(medical_io::FileKind::labelMap));
  const QString handles = QStringLiteral("*%1 *.fcsv").arg(QLatin1String(kHandleEnding));
  QStringList filters;
  if (openSession_)
    filters << tr("Sessions, organs, label maps, handles and scans (*.viscera %1 %2 %3)")
                   .arg(surfaces, labels, handles)
            << tr("Sessions (*.viscera)");
  else
    filters << tr("Organs, label maps and handles (%1 %2 %3)").arg(surfaces, labels, handles);
  filters << tr("Organs (%1)").arg(surfaces) << tr("Label maps (%1)").arg(labels)
          << tr("Handles (%1)").arg(handles) << tr("All files (*)");
  const QStringList files =
      QFileDialog::getOpenFileNames(window_, tr("Open"), folder(), filters.join(QStringLiteral(";;")));
  if (!files.isEmpty())
    open(files, check);
}

void FileActions::chooseAndOpenFolder() {
  const QString chosen =
      QFileDialog::getExistingDirectory(window_, tr("Open a folder with one mask for each organ"), folder());
  if (!chosen.isEmpty())
    open({chosen});
}

void FileActions::open(const QStringList& files, bool check) {
  if (openSession_ && files.size() == 1 && document::isSessionFile(files.front().toStdString()))
    return openSession_(files.front());
  named_ = files;
  failures_.clear();
  const QStringList there = thoseThere(files);
  std::vector<std::filesystem::path> paths;
  for (const QString& file : there)
    paths.emplace_back(file.toStdString());
  const QString name = there.size() == 1 ? tr("Opening %1").arg(QFileInfo(there.front()).fileName())
                                         : tr("Opening %n files", nullptr, static_cast<int>(there.size()));
  const ArrivingSurfaces::Ticket arriving = arriving_ ? arriving_->begin(replacesPresent()) : nullptr;
  workspace_.jobs().submit<Read>(
      name.toStdString(), "open",
      [paths, arrives = ArrivingSurfaces::listener(arriving),
       sessions = openSession_ ? document::Sessions::alone : document::Sessions::nowhere,
       scan = workspace_.state().scan](Progress& progress) {
        return readAll(paths, arrives, sessions, scan, progress);
      },
      [this, files, check, arriving](JobResult<Read> result) {
        if (arriving_)
          arriving_->end(arriving, result.value.has_value());
        if (result.error)
          reportOpenFailure(*result.error, files, check);
        if (result.value)
          applyReadFiles(std::move(*result.value), files, check);
      });
}

FileActions::Read FileActions::readAll(const std::vector<std::filesystem::path>& files,
                                       const document::ArrivingOrganListener& arrives,
                                       document::Sessions sessions,
                                       const std::shared_ptr<const document::ScanItem>& scan,
                                       Progress& progress) {
  Read read;
  std::error_code ignored;
  const bool labels = std::filesystem::is_directory(files[0], ignored) && medical_io::isLabelMap(files[0]);
  if (files.size() == 1 && medical_io::isScan(files[0]) && !labels)
    read.study = document::findStudy(files[0], progress);
  if (read.study)
    return read;
  read.several = files.size() == 1 && hasSeveralScans(files[0], progress);
  if (read.several)
    return read;
  read.draft = document::draftOf(document::openPatient(files, progress, arrives, sessions, scan), progress);
  read.scan = read.draft.files.scan;
  return read;
}

QStringList FileActions::missingAmong(const QStringList& files) {
  QStringList lines;
  for (const QString& file : files)
    if (!QFileInfo::exists(file))
      lines.push_back(tr("%1 was not found.").arg(file));
  return lines;
}

QString FileActions::unopenedBeside(const std::filesystem::path& file) const {
  return named_.contains(text(file.string())) ? (missingAmong(named_) + failures_).join(QLatin1Char('\n'))
                                              : QString();
}

/// The exception only concerns the first file, so the message lists all missing files.
void FileActions::reportOpenFailure(const Error& error, const QStringList& files, bool check) {
  const QStringList missing = missingAmong(files);
  if (missing.isEmpty())
    return workspace_.report(error);
  const bool there = QFileInfo::exists(QString::fromStdString(error.where().english()));
  sayProblems(missing, there ? QStringList(sentenceOf(error)) : QStringList(), check);
}

void FileActions::sayProblems(const QStringList& missing, const QStringList& failures, bool check) {
  Message message{Message::Severity::error, (missing + failures).join(QLatin1Char('\n')), {}, 0};
  if (!missing.isEmpty())
    message.offers.push_back({tr("Look for files..."), [this, check] { chooseAndOpen(check); }});
  workspace_.say(message);
}

void FileActions::applyReadFiles(Read read, const QStringList& files, bool check) {
  const QStringList missing = missingAmong(files);
  QStringList opened = thoseThere(files); // They may be opened again: they become the recent files.
  const bool others = !read.draft.organs.empty() || read.draft.files.rig;
  failures_.clear();
  for (const Error& failure : read.draft.files.failures)
    failures_.push_back(sentenceOf(failure));
  for (const std::filesystem::path& file : read.draft.files.leftOut)
    opened.removeAll(QString::fromStdString(file.string()));
  if (read.several)
    Q_EMIT scansFound(opened.front());
  if (read.study)
    return takeImages(document::openStudy(*std::move(read.study)), opened, true);
  if (read.scan)
    takeImages(document::openScan(*read.scan), opened, !others);
  if (others || !(read.scan || read.several))
    reviewOrImport(std::move(read.draft), opened, check);
  if (!missing.isEmpty() || !failures_.isEmpty()) // Last: a message takes the place of the one before it.
    sayProblems(missing, failures_, check);
}

bool FileActions::replacesPresent() const {
  // Sample organs are replaced by opened files.
  const document::OrganList& present = workspace_.document().organs();
  return std::all_of(present.begin(), present.end(), [](const auto& o) { return !o->origin.sample.empty(); });
}

void FileActions::takeImages(const document::Command& open, const QStringList& files, bool alone) {
  workspace_.undo().seal();
  if (!workspace_.perform(open))
    return;
  if (alone) {
    settings_.addRecentFiles(files);
    rememberFolder(files.front());
    Q_EMIT recentFilesChanged();
  }
  Q_EMIT scanOpened();
}

void FileActions::reviewOrImport(document::ImportDraft draft, const QStringList& files, bool check) {
  const bool odd = draft.questionable();
  if (checker_ && !draft.organs.empty() && (odd || check))
    return checker_(std::move(draft), files);
  take(document::accepted(draft), files);
  if (!odd && !draft.organs.empty())
    Q_EMIT foundNothingOdd(files);
}

void FileActions::take(const document::ImportDraft& draft, const QStringList& files) {
  document::OpenedFiles opened = document::accepted(draft);
  opened.warnings.clear(); // The user has seen them in the check; they stay with the organs.
  take(std::move(opened), files);
}

void FileActions::take(document::OpenedFiles opened, const QStringList& files) {
  // Before the organs are added, because list, charts, pictures and maps are rebuilt for every change of
  // present organs.
  const document::OrganList& present = workspace_.document().organs();
  const bool replaces = !opened.organs.empty() && replacesPresent();
  const std::size_t firstNew = replaces ? 0 : present.size();
  const QString name = tr("Open %1").arg(QFileInfo(files.front()).fileName());
  const auto place = [this](const document::Organ&, const document::OrganList& organs) {
    return placer_.commandOrBox(organs);
  };
  workspace_.undo().seal();
  if (!workspace_.perform(document::openCommand(name.toStdString(), opened, replaces, place)))
    return;
  settings_.addRecentFiles(files);
  rememberFolder(files.front());
  Q_EMIT recentFilesChanged();
  chooseOpened(firstNew);
  Q_EMIT filesOpened();
  sayWarnings(opened.warnings, coveredBy(firstNew));
}

void FileActions::chooseOpened(std::size_t firstNew) {
  const document::OrganList& organs = workspace_.document().organs();
  if (firstNew >= organs.size())
    return;
  const auto whole = std::count_if(organs.begin() + static_cast<std::ptrdiff_t>(firstNew), organs.end(),
                                   [](const auto& organ) { return !organ->parent; });
  workspace_.selection().setOrgan(whole > 1 ? document::OrganId{} : organs[firstNew]->id);
}

/// Two files of one name may be two states of one organ: of two surfaces at one place only one is seen.
QStringList FileActions::coveredBy(std::size_t firstNew) const {
  const document::OrganList& organs = workspace_.document().organs();
  std::vector<Bounds> boxes;
  for (const auto& organ : organs)
    boxes.push_back(boundsOf(organ->mesh->points));
  QStringList lines;
  for (std::size_t later = std::max<std::size_t>(firstNew, 1); later < organs.size(); ++later)
    for (std::size_t sooner = 0; sooner < later; ++sooner)
      if (sameBox(boxes[later], boxes[sooner]) && isTwice(*organs[later], *organs[sooner])) {
        lines.push_back(tr("%1 lies exactly where %2 lies already: only one of them is seen.")
                            .arg(inWords(presentation::labelOf(*organs[later])),
                                 inWords(presentation::labelOf(*organs[sooner]))));
        break;
      }
  return lines;
}

void FileActions::sayWarnings(const std::vector<Text>& warnings, QStringList lines) {
  if (warnings.empty() && lines.isEmpty())
    return;
  for (const Text& warning : warnings)
    lines.push_back(inWords(warning));
  if (lines.size() > kShownFileWarnings) {
    const int more = static_cast<int>(lines.size()) - kShownFileWarnings;
    lines = lines.mid(0, kShownFileWarnings);
    lines.push_back(tr("%n more findings; see the organs' pages in Explore mode", nullptr, more));
  }
  workspace_.note(lines.join(QLatin1Char('\n')), 15);
}

void FileActions::chooseAndSaveHandles() {
  QString file = QFileDialog::getSaveFileName(
      window_, tr("Save handles"), folder() + QStringLiteral("/handles") + QLatin1String(kHandleEnding),
      tr("Slicer markups (*%1 *.fcsv)").arg(QLatin1String(kHandleEnding)));
  file = asNewFile(window_, file, {QLatin1String(kHandleEnding), QStringLiteral(".fcsv")});
  if (!file.isEmpty())
    saveHandles(file);
}

void FileActions::saveHandles(const QString& file) {
  const bool done = workspace_.guarded([&] {
    if (workspace_.document().rig().handles.empty())
      throw UsageError("there are no handles to save", {}, "place some first");
    medical_io::writeHandles(file.toStdString(), document::handleFile(workspace_.document().rig()));
  });
  if (done)
    saySaved(tr("Handles"), file);
}

void FileActions::chooseAndLoadCage() {
  const QString file =
      QFileDialog::getOpenFileName(window_, tr("Load a cage"), folder(),
                                   tr("Closed surfaces (%1);;All files (*)")
                                       .arg(patterns(medical_io::endingsOf(medical_io::FileKind::surface))));
  if (!file.isEmpty())
    loadCage(file);
}

void FileActions::loadCage(const QString& file) {
  workspace_.inBackground<document::GivenCage>(
      tr("Reading the cage %1").arg(QFileInfo(file).fileName()), "cage",
      [path = file.toStdString()](Progress& progress) { return document::readCage(path, progress); },
      [this, file](const document::GivenCage& cage) { takeCage(cage, file); });
}

void FileActions::takeCage(const document::GivenCage& cage, const QString& file) {
  const int vertices = static_cast<int>(cage.mesh->points.rows());
  workspace_.note( // First, because messages about the binding are more important.
      document::handlesAtAllVertices(workspace_.document().rig(), *cage.mesh)
          ? tr("The handles at the vertices of %1 are now the corners of the cage.").arg(text(cage.name))
          : tr("The %n vertices of %1 are now the handles.", nullptr, vertices).arg(text(cage.name)));
  workspace_.undo().seal();
  if (workspace_.perform(document::takeCage(cage)))
    rememberFolder(file);
}

void FileActions::chooseAndExportOrgan() {
  const auto organ = workspace_.currentOrgan();
  if (!organ)
    return workspace_.note(tr("There is no organ to export. Open one first."), 6);
  const QString start = folder() + QLatin1Char('/') + text(organ->name) + QStringLiteral(".vtp");
  const QString file = QFileDialog::getSaveFileName(
      window_, tr("Export the organ in its present pose"), start,
      tr("Surfaces (%1)").arg(patterns(medical_io::endingsOf(medical_io::FileKind::surface))));
  if (!file.isEmpty())
    exportOrgan(file);
}

void FileActions::exportOrgan(const QString& file) {
  const auto organ = workspace_.currentOrgan();
  if (!organ)
    return;
  geometry::TriangleMesh mesh = *organ->mesh;
  mesh.points = workspace_.live().points(organ->id);
  workspace_.inBackground<bool>(
      tr("Exporting %1").arg(inWords(presentation::labelOf(*organ))), Workspace::slotOf(file),
      [mesh = std::move(mesh), path = file.toStdString(), name = organ->name](Progress&) {
        medical_io::writeSurface(path, mesh, {.name = name});
        return true;
      },
      [this, file, name = text(organ->name)](bool) { saySaved(name, file); });
}

void FileActions::saySaved(const QString& what, const QString& file) {
  rememberFolder(file);
  workspace_.noteWritten(tr("%1 written to %2").arg(what, file), file);
}

} // namespace viscera::app

#include "window/slices/scan_actions.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>

#include <algorithm>
#include <utility>

#include "viscera/document/scan_fit.h"

namespace viscera::app {
namespace {

using presentation::ScanLook;
using presentation::ViewState;

constexpr std::size_t kShownFindings = 3;

/// Level and width for kinds of tissue in a CT, in Hounsfield units.
struct Preset {
  const char* id;
  const char* name;
  double level, width;
};
constexpr Preset kPresets[] = {
    {"scan.softTissue", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "Soft &tissue"), 40, 400},
    {"scan.lung", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "&Lung"), -600, 1500},
    {"scan.bone", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "&Bone"), 400, 1800},
    {"scan.brain", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "B&rain"), 40, 80},
    {"scan.liver", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "Li&ver"), 60, 160},
    {"scan.angio", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "&Angiography"), 300, 600}};

/// How thick slices can be, mm.
struct Thickness {
  const char* id;
  double mm;
};
constexpr Thickness kThicknesses[] = {
    {"scan.slab0", 0}, {"scan.slab5", 5}, {"scan.slab10", 10}, {"scan.slab20", 20}};

/// A layout: the 3D view, all four views, or one slice.
struct Layout {
  const char* id;
  const char* layout;
  const char* name;
  int key;
};
constexpr Layout kLayouts[] = {
    {"layout.3d", "3d", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "&3D view alone"),
     static_cast<int>(Qt::SHIFT) + static_cast<int>(Qt::Key_F6)},
    {"layout.four", "four", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "&Four views"), Qt::Key_F6},
    {"layout.axial", "axial", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "&Axial slice"), Qt::Key_F7},
    {"layout.coronal", "coronal", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "&Coronal slice"),
     Qt::Key_F8},
    {"layout.sagittal", "sagittal", QT_TRANSLATE_NOOP("viscera::app::ScanActions", "&Sagittal slice"),
     Qt::Key_F9}};

QString lineOf(const medical_io::ScanSeries& series) {
  QString line = QStringLiteral("%1  %2  %3 x %4 x %5")
                     .arg(text(series.modality), text(series.description))
                     .arg(series.size[0])
                     .arg(series.size[1])
                     .arg(series.size[2]);
  const medical_io::SliceRange& slices = series.slices;
  if (slices.resampled)
    line += ScanActions::tr(", all %n slices, resampled to an even grid", nullptr, slices.all);
  else if (slices.last - slices.first + 1 < slices.all)
    line += ScanActions::tr(", slices %1 to %2 of %3").arg(slices.first).arg(slices.last).arg(slices.all);
  return line.trimmed();
}

/// What can be opened at a place: every series, with all of its phases.
struct Offer {
  QString line;
  medical_io::ScanOptions options;
};

std::vector<Offer> offersOf(const std::vector<medical_io::ScanSeries>& series) {
  std::vector<Offer> offers;
  for (const medical_io::ScanSeries& item : series) {
    QString line = QStringLiteral("%1. %2").arg(offers.size() + 1).arg(lineOf(item));
    if (item.phases > 1)
      line += ScanActions::tr("  %n phases", nullptr, item.phases);
    offers.push_back({line, {item.id, 0}});
  }
  return offers;
}

/// What the user chooses: one of several scans, or which slices of one that is not even.
QString questionOf(const std::vector<medical_io::ScanSeries>& series) {
  const medical_io::SliceRange& first = series.front().slices;
  const int read = first.last - first.first + 1;
  const bool one = std::all_of(series.begin(), series.end(), [&](const medical_io::ScanSeries& other) {
    return other.files == series.front().files;
  });
  if (one && series.size() > 1 && read < first.all)
    return ScanActions::tr("The slices are not at even distances: at most %1 of %2 are. What shall be read?")
        .arg(read)
        .arg(first.all);
  return ScanActions::tr("The folder has several scans. Which one?");
}

/// The first offer of the series that a file belongs to; the first of all for a folder.
int offerOf(const QString& place, const std::vector<medical_io::ScanSeries>& series) {
  const std::string name = QFileInfo(place).fileName().toStdString();
  int offer = 0;
  for (const medical_io::ScanSeries& item : series) {
    if (QFileInfo(place).isFile() &&
        std::any_of(item.files.begin(), item.files.end(),
                    [&name](const std::filesystem::path& file) { return file.filename() == name; }))
      return offer;
    ++offer;
  }
  return 0;
}

} // namespace

ScanActions::ScanActions(Workspace& workspace, ViewModel& view, Settings& settings, QWidget* window)
    : QObject(window), workspace_(workspace), view_(view), settings_(settings), window_(window) {}

void ScanActions::addTo(Actions& actions) {
  actions.add("file.openScan",
              {tr("Open a &scan..."), "patient", {}, tr("Open a CT or MR beside the organs")},
              [this] { chooseAndOpen(false); });
  actions.add("file.openSeries",
              {tr("Open a DICOM &series..."), "patient", {}, tr("Open a folder of DICOM files as a scan")},
              [this] { chooseAndOpen(true); });
  actions.add("scan.close", {tr("C&lose the scan"), nullptr, {}, tr("Close the scan; the organs stay")},
              [this] {
                workspace_.perform(workspace_.state().study ? document::closeStudy() : document::closeScan());
              });
  actions.enableWhile({"scan.close"}, [this] { return workspace_.state().scan || workspace_.state().study; });
  makeLayouts(actions);
  makePresets(actions);
  makeSwitches(actions);
}

void ScanActions::addChoice(Actions& actions, const char* id, const Actions::Description& description,
                            std::function<bool(const ScanLook&)> chosen,
                            std::function<void(ScanLook&)> choose) {
  QAction* action = actions.add(id, description, [this, choose = std::move(choose)] {
    view_.change([&choose](ViewState& view) { choose(view.scan); });
  });
  action->setCheckable(true);
  const auto sync = [this, action, chosen = std::move(chosen)] {
    action->setChecked(chosen(view_.state().scan));
  };
  connect(&view_, &ViewModel::changed, action, sync);
  // A click on the checked action leaves it checked.
  connect(action, &QAction::triggered, action, sync);
  sync();
}

void ScanActions::makeLayouts(Actions& actions) {
  for (const Layout& layout : kLayouts) {
    layouts_.push_back(layout.id);
    addChoice(
        actions, layout.id, {tr(layout.name), "view", {layout.key}, {}},
        [id = std::string(layout.layout)](const ScanLook& look) { return look.layout == id; },
        [id = std::string(layout.layout)](ScanLook& look) { look.layout = id; });
    connect(actions[layout.id], &QAction::triggered, this, &ScanActions::layoutChosen);
  }
}

void ScanActions::makePresets(Actions& actions) {
  const auto show = [this, &actions](const char* id) { menu_.addAction(actions[id]); };
  addChoice(
      actions, "scan.automatic",
      {tr("A&utomatic"),
       nullptr,
       {},
       tr("Level and width that the scan's file proposes, or found from its values")},
      [](const ScanLook& look) { return look.width <= 0; },
      [](ScanLook& look) { look.level = look.width = 0; });
  show("scan.automatic");
  for (const Preset& preset : kPresets) {
    addChoice(
        actions, preset.id,
        {tr(preset.name), nullptr, {}, tr("Level %1, width %2").arg(preset.level).arg(preset.width)},
        [preset](const ScanLook& look) { return look.level == preset.level && look.width == preset.width; },
        [preset](ScanLook& look) {
          look.level = preset.level;
          look.width = preset.width;
        });
    show(preset.id);
  }
}

void ScanActions::makeSwitches(Actions& actions) {
  struct Switch {
    const char* id;
    Actions::Description description;
    bool ScanLook::*part;
  };
  const Switch all[] = {
      {"scan.contours",
       {tr("&Contours"), nullptr, {}, tr("Draw the organs' contours on the slices")},
       &ScanLook::contours},
      {"scan.rest",
       {tr("Contours at &rest"), "ghost", {}, tr("Draw thin contours of the organs at rest as well")},
       &ScanLook::rest},
      {"scan.standing", {tr("Slices in the &3D view"), "patient", {}, {}}, &ScanLook::standing},
      {"scan.bent",
       {tr("&Warp the scan"), "deform", {}, tr("Show the scan as the pose warps it")},
       &ScanLook::warped},
      {"scan.smooth", {tr("S&mooth between voxels"), nullptr, {}, {}}, &ScanLook::smooth},
      {"scan.maximum",
       {tr("Ma&ximum of thick slices"),
        nullptr,
        {},
        tr("Show the largest value across a thick slice instead of the mean")},
       &ScanLook::maximum}};
  menu_.addSeparator();
  for (const Switch& item : all) {
    view_.addToggle(actions, item.id, item.description,
                    [part = item.part](ViewState& view) -> bool& { return view.scan.*part; });
    switches_.push_back(item.id);
    menu_.addAction(actions[item.id]);
  }
  QMenu* thickness = menu_.addMenu(tr("&Thickness"));
  for (const Thickness& item : kThicknesses) {
    addChoice(
        actions, item.id,
        {item.mm > 0 ? tr("Slices of %1 mm").arg(item.mm) : tr("Thin slices"), nullptr, {}, {}},
        [mm = item.mm](const ScanLook& look) { return look.slabMm == mm; },
        [mm = item.mm](ScanLook& look) { look.slabMm = mm; });
    thickness->addAction(actions[item.id]);
  }
}

void ScanActions::chooseAndOpen(bool folder) {
  const QString start = settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString chosen =
      folder ? QFileDialog::getExistingDirectory(window_, tr("Open a folder of DICOM files"), start)
             : QFileDialog::getOpenFileName(
                   window_, tr("Open a scan"), start,
                   tr("Scans (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;All files (*)"));
  if (!chosen.isEmpty())
    open(chosen);
}

void ScanActions::open(const QString& place) {
  workspace_.inBackground<Found>(
      tr("Reading %1").arg(QFileInfo(place).fileName()), "scan",
      [path = place.toStdString()](Progress& progress) {
        Found found{document::findStudy(path, progress), {}};
        if (!found.study)
          found.series = medical_io::listScans(path, progress);
        return found;
      },
      [this, place](Found found) { take(place, std::move(found)); });
}

void ScanActions::take(const QString& place, Found found) {
  if (!found.study)
    return choose(place, found.series);
  if (!workspace_.perform(document::openStudy(*std::move(found.study))))
    return;
  settings_.setValue(kFolderKey, QFileInfo(place).absolutePath());
  opened();
}

void ScanActions::choose(const QString& place, const std::vector<medical_io::ScanSeries>& series) {
  const std::vector<Offer> offers = offersOf(series);
  if (offers.size() < 2)
    return read(place, {});
  QStringList lines;
  for (const Offer& offer : offers)
    lines << offer.line;
  bool chosen = false;
  const QString line = QInputDialog::getItem(window_, tr("Open a scan"), questionOf(series), lines,
                                             offerOf(place, series), false, &chosen);
  if (chosen)
    read(place, offers[static_cast<std::size_t>(lines.indexOf(line))].options);
}

void ScanActions::read(const QString& place, const medical_io::ScanOptions& options) {
  workspace_.inBackground<document::ScanItem>(
      tr("Opening %1").arg(QFileInfo(place).fileName()), "scan",
      [path = place.toStdString(), options](Progress& progress) {
        return document::openScanFile(path, options, progress);
      },
      [this, place](document::ScanItem item) {
        if (!workspace_.perform(document::openScan(std::move(item))))
          return;
        settings_.setValue(kFolderKey, QFileInfo(place).absolutePath());
        opened();
      });
}

/// Shows new images with their own level, width and places.
void ScanActions::showFromHere() {
  const bool alone = workspace_.document().organs().empty();
  const auto item = workspace_.state().scan;
  const double fraction = item ? document::fractionOf(*item) : 0;
  view_.change([alone, fraction](ViewState& view) {
    const ScanLook before = view.scan;
    view.scan = {};
    view.scan.cine.fraction = fraction;
    view.scan.layout = before.layout == "3d" ? "four" : before.layout;
    view.scan.standing = before.standing || alone; // Else the 3D view would be empty.
    view.scan.warped = before.warped;
  });
  Q_EMIT layoutChosen();
}

void ScanActions::opened() {
  const auto item = workspace_.state().scan;
  const auto study = workspace_.state().study;
  if (!item && !study)
    return;
  showFromHere();
  if (study)
    return reportScanFindings(study->study->findings, false);
  std::vector<Text> odd;
  bool partly = false;
  for (const medical_io::ScanFinding& finding : item->scan->findings) {
    odd.push_back(finding.sentence);
    partly = partly || finding.kind == medical_io::ScanFinding::Kind::partRead;
  }
  if (item->time)
    odd.insert(odd.end(), item->time->findings.begin(), item->time->findings.end());
  for (const Text& sentence : document::scanFit(workspace_.state()))
    odd.push_back(sentence);
  reportScanFindings(odd, partly);
}

void ScanActions::reportScanFit() {
  reportScanFindings(document::scanFit(workspace_.state()), false);
}

void ScanActions::reportScanFindings(const std::vector<Text>& sentences, bool partly) {
  if (sentences.empty())
    return;
  QStringList lines;
  for (std::size_t i = 0; i < std::min(kShownFindings, sentences.size()); ++i)
    lines << asSentence(sentences[i]);
  if (sentences.size() > kShownFindings)
    lines << tr("%n more: see Scan on the page of Explore.", nullptr,
                static_cast<int>(sentences.size() - kShownFindings));
  const document::DocumentState& state = workspace_.state();
  const QString said = text(state.study ? state.study->name : state.scan->name) + QStringLiteral(": ") +
                       lines.join(QLatin1Char('\n'));
  if (!partly)
    return workspace_.note(said, 15);
  workspace_.say(
      {Message::Severity::warning,
       said,
       {{tr("Read other slices..."), [this, place = text(state.scan->file.string())] { open(place); }}}});
}

} // namespace viscera::app

#include "window_monkey.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialog>
#include <QElapsedTimer>
#include <QMenu>
#include <QTabBar>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "../window_probe.h"
#include "label_files.h"
#include "printed.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/document/validate.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/surface_file.h"
#include "window/import/import_controller.h"
#include "window/session/session_files.h"
#include "window/view/view_area.h"

namespace viscera::tests {
namespace {

constexpr int kLongestWait = 90000;   ///< ms, until a cancelled job must have ended.
constexpr int kLeastPatience = 10000; ///< ms, once a job of the run was cancelled.
constexpr int kTick = 5;              ///< ms between looks at a window that works.
/// ms, after which also those parts of the window have come round that wait for the hand to rest.
constexpr int kPause = 130;
/// Of the fourth numbers, those above have the hand rest: one action in fifty, or most of a run would be
/// rest.
constexpr double kRest = 0.98;
constexpr double kVolumeTolerance = 1e-9;

/// How far the slider of the number of witness points goes, to 20,000: ten times as many need gigabytes and
/// minutes.
constexpr double kWitnessReach = 0.66;

/// What would leave the window or ask the desktop for something.
const QStringList kLeftAlone = {QStringLiteral("file.quit")};

template <typename List>
auto& pick(List& list, double which) {
  return list[std::min<std::size_t>(static_cast<std::size_t>(which * static_cast<double>(list.size())),
                                    static_cast<std::size_t>(list.size()) - 1)];
}

struct Kind {
  const char* name;
  int weight;
};
constexpr std::array<Kind, 12> kKinds = {{{"open", 3},
                                          {"trigger", 24},
                                          {"widget", 22},
                                          {"drag", 16},
                                          {"click", 6},
                                          {"key", 8},
                                          {"wheel", 3},
                                          {"undo", 8},
                                          {"redo", 4},
                                          {"session", 3},
                                          {"window", 3},
                                          {"play", 8}}};

/// What is under way in a view, for a message.
std::string workOf(app::Workspace& workspace) {
  std::string work;
  for (const JobInfo& job : workspace.jobs().jobs())
    work += "; " + job.name.english() + (job.running ? " runs" : " waits");
  return work + (workspace.live().busy() ? "; an organ is being bound" : "");
}

/// The visible and enabled widgets.
std::vector<QWidget*> usableWidgets(QWidget& window) {
  std::vector<QWidget*> usable;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || !widget->isEnabled())
      continue;
    if (qobject_cast<QAbstractButton*>(widget) || qobject_cast<QAbstractSlider*>(widget) ||
        qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QComboBox*>(widget) ||
        qobject_cast<QAbstractItemView*>(widget) || qobject_cast<QTabBar*>(widget))
      usable.push_back(widget);
  }
  return usable;
}

std::string nameOf(const QObject& object) {
  const auto* button = qobject_cast<const QAbstractButton*>(&object);
  return std::string(object.metaObject()->className()) + " " + object.objectName().toStdString() +
         (button ? " \"" + button->text().toStdString() + "\"" : std::string());
}

void slideTo(QAbstractSlider& slider, double place) {
  const double reach = slider.objectName() == QLatin1String("stressWitnessSteps") ? kWitnessReach : 1;
  slider.setValue(slider.minimum() + int(place * reach * (slider.maximum() - slider.minimum())));
}

void useItems(QAbstractItemView& items, const MonkeyAction& action) {
  if (!items.model() || items.model()->rowCount() == 0)
    return;
  const int row = static_cast<int>(action.b * items.model()->rowCount());
  const int column = static_cast<int>(action.c * items.model()->columnCount());
  const QPoint place = items.visualRect(items.model()->index(row, column)).center();
  QTest::mouseClick(items.viewport(), Qt::LeftButton, action.d < 0.2 ? Qt::ControlModifier : Qt::NoModifier,
                    place);
}

/// Without those digits of numbers that a camera does not keep: VTK makes its upward vector one long whenever
/// it is set.
std::string withoutLastDigits(const std::string& text) {
  constexpr int kKept = 12; ///< After the point.
  std::string kept;
  int digits = -1; ///< After the point of a number; -1: not in one.
  for (const char letter : text) {
    digits = letter == '.'                                                     ? 0
             : digits >= 0 && std::isdigit(static_cast<unsigned char>(letter)) ? digits + 1
                                                                               : -1;
    if (digits <= kKept)
      kept += letter;
  }
  return kept;
}

/// Where two files begin to differ; empty where they are the same.
std::string difference(const std::string& first, const std::string& second) {
  const std::string before = withoutLastDigits(first), after = withoutLastDigits(second);
  if (before == after)
    return {};
  constexpr std::size_t kShown = 160;
  const auto place = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  const auto differs = static_cast<std::size_t>(place.first - before.begin());
  const std::size_t from = differs - std::min(differs, kShown / 2);
  return "saved again, it is another file: ..." + before.substr(from, kShown) + "... became ..." +
         after.substr(from, kShown) + "...";
}

} // namespace

std::string lineOf(const MonkeyAction& action) {
  std::ostringstream line;
  line << action.kind << ' ' << action.a << ' ' << action.b << ' ' << action.c << ' ' << action.d
       << (action.hasty ? " hasty" : "");
  return line.str();
}

MonkeyAction actionFrom(const std::string& line) {
  MonkeyAction action;
  std::istringstream words(line);
  std::string hasty;
  words >> action.kind >> action.a >> action.b >> action.c >> action.d >> hasty;
  action.hasty = hasty == "hasty";
  return action;
}

std::vector<MonkeyAction> randomActions(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random() >> 12U) / (1U << 20U); };
  int all = 0;
  for (const Kind& kind : kKinds)
    all += kind.weight;
  std::vector<MonkeyAction> actions;
  for (int i = 0; i < count; ++i) {
    int left = static_cast<int>(number() * all);
    std::size_t kind = 0;
    while ((left -= kKinds.at(kind).weight) >= 0)
      ++kind;
    MonkeyAction action{kKinds.at(kind).name, number(), number(), number(), number()};
    action.hasty = number() < 0.15;
    actions.push_back(actionFrom(lineOf(action))); // With the digits that a file has.
  }
  return actions;
}

std::string nameOf(Invariant invariant) {
  constexpr std::array<const char*, 12> kNames = {
      "nothing",  "silence",     "memory",      "work that ends", "the document", "what is shown",
      "the pose", "the volumes", "undoing all", "redoing all",    "the session",  "the window's close"};
  return kNames.at(static_cast<std::size_t>(invariant));
}

void Violation::add(Invariant which, const std::string& what) {
  if (what.empty())
    return;
  if (invariant == Invariant::none)
    invariant = which;
  text += (text.empty() ? "" : "; ") + what;
}

void Violation::add(const Violation& other) {
  add(other.invariant, other.text);
}

WindowMonkey::WindowMonkey() {
  QDesktopServices::setUrlHandler(QStringLiteral("file"), &refused_, "take");
  makeFiles();
  settings_ = std::make_unique<app::Settings>(folder_.filePath(QStringLiteral("viscera.ini")));
  for (const char* kind : {"files/pictures", "record/folder"})
    settings_->setValue(kind, folder_.path());
  window_ =
      std::make_unique<app::MainWindow>(*settings_, coordinates::builtInRegistry(), [this] { return now_; });
  window_->sessions().setQuestion([](const QString&) { return app::SessionFiles::Answer::discard; });
  window_->setUnwrittenQuestion([](const QStringList&) { return true; }); // It closes without these files.
  window_->resize(960, 640);
  window_->show();
  window_->activateWindow(); // Keys go to the window that is active.
  if (!QTest::qWaitForWindowActive(window_.get()))
    throw std::runtime_error("the window does not become active");
  setViewSize(*window_, 320, 240); // Software draws it: small pictures, more actions.
  settle();
  begin_ = window_->workspace().state();
  changes_ = window_->workspace().onChange([this](const document::Change& change) {
    document::UndoStack& undo = window_->workspace().undo();
    if (!change.interactive && !undo.canUndo() &&
        !undo.canRedo()) // Another document, whose first state this is.
      begin_ = window_->workspace().state();
  });
}

WindowMonkey::~WindowMonkey() {
  QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
}

void WindowMonkey::makeFiles() {
  for (const auto& [name, radius] : {std::pair("ball.stl", 60.0), std::pair("large.vtp", 90.0)}) {
    const QString file = folder_.filePath(QString::fromLatin1(name));
    medical_io::writeSurface(file.toStdString(), sphere(3, radius));
    files_ << file;
  }
  geometry::TriangleMesh open = sphere(2, 40);
  open.triangles.conservativeResize(open.triangles.rows() - 9, 3);
  files_ << folder_.filePath(QStringLiteral("open.ply"));
  medical_io::writeSurface(files_.back().toStdString(), open);
  const auto put = [this](const char* name, const std::string& bytes) {
    files_ << folder_.filePath(QString::fromLatin1(name));
    std::ofstream(files_.back().toStdString(), std::ios::binary) << bytes;
  };
  put("broken.vtk", "# vtk DataFile Version 3.0\nbroken\nASCII\nDATASET POLYDATA\nPOINTS 900 float\n0 0");
  LabelImage labels = emptyLabels({24, 20, 16});
  addBall(labels, Vec3(0, 0, 0), 9, 1);
  addBall(labels, Vec3(14, 0, 0), 5, 2);
  put("labels.nii", niftiFile(labels));
  for (std::size_t voxel = 0; voxel < labels.voxels.size(); ++voxel) // Too many values for labels: a scan.
    labels.voxels[voxel] = static_cast<std::int16_t>(voxel % 4000 - 1000 + 300 * labels.voxels[voxel]);
  put("scan.nii", niftiFile(labels));
}

void WindowMonkey::act(const MonkeyAction& action) {
  using Do = std::function<void(const MonkeyAction&)>;
  static const auto doIt = [](void (WindowMonkey::*member)(const MonkeyAction&)) { return member; };
  const std::map<std::string, Do> kinds = {
      {"open", [this](const MonkeyAction& a) { openSomething(a.a); }},
      {"trigger", [this](const MonkeyAction& a) { triggerAction(a.a); }},
      {"widget", std::bind_front(doIt(&WindowMonkey::useWidget), this)},
      {"drag", std::bind_front(doIt(&WindowMonkey::dragInView), this)},
      {"click", std::bind_front(doIt(&WindowMonkey::clickInView), this)},
      {"key", std::bind_front(doIt(&WindowMonkey::pressKey), this)},
      {"wheel",
       [this](const MonkeyAction& a) {
         const QPoint at = placeInView(a.a, a.b);
         QWheelEvent event(at, window_->viewArea().view()->mapToGlobal(at), {}, {0, a.c < 0.5 ? 120 : -120},
                           Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
         QApplication::sendEvent(window_->viewArea().view(), &event);
       }},
      {"undo", [this](const MonkeyAction&) { window_->actions()["edit.undo"]->trigger(); }},
      {"redo", [this](const MonkeyAction&) { window_->actions()["edit.redo"]->trigger(); }},
      {"session", std::bind_front(doIt(&WindowMonkey::saveAndOpen), this)},
      {"window", std::bind_front(doIt(&WindowMonkey::changeWindow), this)},
      {"play", std::bind_front(doIt(&WindowMonkey::play), this)}};
  did_ = action.kind;
  QTimer closer; // A dialog that runs a loop of its own is left as it came.
  QObject::connect(&closer, &QTimer::timeout, [this] { dismissDialogs(); });
  closer.start(kTick);
  kinds.at(action.kind)(action);
  pump();
  if (!action.hasty)
    settle();
  if (action.d > kRest)
    QTest::qWait(kPause);
  dismissDialogs();
}

void WindowMonkey::dismissDialogs() {
  if (QWidget* popup = QApplication::activePopupWidget())
    popup->close();
  for (QWidget* top : QApplication::topLevelWidgets())
    if (auto* dialog = qobject_cast<QDialog*>(top); dialog && dialog->isVisible())
      dialog->reject();
}

/// Handles the events that are there.
void WindowMonkey::pump() {
  QCoreApplication::processEvents();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

/// Waits for the work that was begun. Some attempts of the thesis take hours for a stress map: what takes
/// longer than the monkey's patience it cancels, as a user would.
void WindowMonkey::settle() {
  stuck_ = false;
  if (comesToPeace(patience_))
    return;
  patience_ = kLeastPatience;
  auto& cancel = *window_->findChild<QAbstractButton*>(QStringLiteral("cancelJob"));
  stuck_ = !comesToPeace(kLongestWait, [&cancel] { cancel.click(); });
}

/// Handles events until nothing is under way any more, for at most so many ms. Returns whether that came.
bool WindowMonkey::comesToPeace(int milliseconds, const std::function<void()>& meanwhile) {
  constexpr int kQuietLooks = 3;
  QElapsedTimer timer;
  timer.start();
  QTimer tick; // Wakes the loop where nothing else does.
  tick.start(kTick);
  int quiet = 0;
  while (quiet < kQuietLooks && timer.elapsed() < milliseconds) {
    pump();
    quiet = atPeace(*window_) ? quiet + 1 : 0;
    if (quiet > 0)
      continue;
    if (meanwhile)
      meanwhile();
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return quiet == kQuietLooks;
}

void WindowMonkey::openSomething(double which) {
  static const std::vector<QString> samples = {QStringLiteral("heart"), QStringLiteral("liver"),
                                               QStringLiteral("stomach"), QStringLiteral("kidney_left")};
  if (which < 0.4) {
    const QString& sample = pick(samples, which / 0.4);
    did_ += " sample " + sample.toStdString();
    window_->samples().load(sample, which < 0.2);
    return;
  }
  const QString& file = pick(files_, (which - 0.4) / 0.6);
  did_ += " " + file.section(QLatin1Char('/'), -1).toStdString();
  window_->files().open({file});
}

void WindowMonkey::triggerAction(double which) {
  std::vector<QAction*> enabled;
  for (QAction* action : window_->actions().all())
    if (action->isEnabled() && !kLeftAlone.contains(action->objectName()))
      enabled.push_back(action);
  QAction* action = pick(enabled, which);
  did_ += " " + action->objectName().toStdString() + " \"" + action->text().toStdString() + "\"";
  action->trigger();
}

void WindowMonkey::useWidget(const MonkeyAction& action) {
  const std::vector<QWidget*> usable = usableWidgets(*window_);
  if (usable.empty())
    return;
  QWidget* widget = pick(usable, action.a);
  did_ += " " + nameOf(*widget);
  if (auto* button = qobject_cast<QAbstractButton*>(widget))
    button->click();
  else if (auto* slider = qobject_cast<QAbstractSlider*>(widget))
    slideTo(*slider, action.b);
  else if (auto* spin = qobject_cast<QAbstractSpinBox*>(widget))
    action.b < 0.5 ? spin->stepUp() : spin->stepDown();
  else if (auto* combo = qobject_cast<QComboBox*>(widget); combo && combo->count() > 0) {
    const int index = static_cast<int>(action.b * combo->count());
    combo->setCurrentIndex(index);
    Q_EMIT combo->activated(index);
  } else if (auto* tabs = qobject_cast<QTabBar*>(widget); tabs && tabs->count() > 0)
    tabs->setCurrentIndex(static_cast<int>(action.b * tabs->count()));
  else if (auto* items = qobject_cast<QAbstractItemView*>(widget))
    useItems(*items, action);
}

QPoint WindowMonkey::placeInView(double x, double y) {
  const app::ViewWidget& view = *window_->viewArea().view();
  return {static_cast<int>(x * view.width()), static_cast<int>(y * view.height())};
}

void WindowMonkey::dragInView(const MonkeyAction& action) {
  app::ViewWidget& view = *window_->viewArea().view();
  QPoint from = placeInView(action.a, action.b);
  vtkVisceraHandleSetRepresentation* handles = viewOf(*window_).handles();
  if (action.d < 0.7 && handles->GetNumberOfHandles() > 0) { // Most drags take a handle.
    const int handle = static_cast<int>(action.a * handles->GetNumberOfHandles());
    const Vec3 place = handles->GetPosition(handle);
    double display[3];
    vtkInteractorObserver::ComputeWorldToDisplay(viewOf(*window_).renderer(), place.x(), place.y(), place.z(),
                                                 display);
    from = {static_cast<int>(display[0]), view.height() - 1 - static_cast<int>(display[1])};
    did_ += " handle " + std::to_string(handle);
  }
  const QPoint by(static_cast<int>((action.b - 0.5) * 120), static_cast<int>((action.c - 0.5) * 120));
  const Qt::MouseButton button = action.d > 0.9 ? Qt::RightButton : Qt::LeftButton;
  const auto modifiers = action.d > 0.55 && action.d < 0.6 ? Qt::ShiftModifier : Qt::NoModifier;
  QTest::mouseMove(&view, from);
  QTest::mousePress(&view, button, modifiers, from);
  for (int step = 1; step <= 4; ++step) {
    QTest::mouseMove(&view, from + by * step / 4);
    pump();
  }
  if (action.d > 0.35 && action.d < 0.4) // Changed their mind.
    QTest::keyClick(&view, Qt::Key_Escape);
  QTest::mouseRelease(&view, button, modifiers, from + by);
}

void WindowMonkey::clickInView(const MonkeyAction& action) {
  app::ViewWidget& view = *window_->viewArea().view();
  const QPoint at = placeInView(action.a, action.b);
  const Qt::KeyboardModifiers modifiers = action.d < 0.2   ? Qt::ControlModifier
                                          : action.d < 0.4 ? Qt::ShiftModifier
                                                           : Qt::NoModifier;
  QTest::mouseMove(&view, at);
  QTest::mouseClick(&view, action.c > 0.9 ? Qt::RightButton : Qt::LeftButton, modifiers, at);
  if (action.c >= 0.2)
    return;
  QTest::mouseDClick(&view, Qt::LeftButton, modifiers, at); // The second press alone.
  QTest::mouseRelease(&view, Qt::LeftButton, modifiers, at);
}

void WindowMonkey::pressKey(const MonkeyAction& action) {
  static const std::vector<Qt::Key> keys = {
      Qt::Key_1,      Qt::Key_2,      Qt::Key_3,     Qt::Key_4,      Qt::Key_5,      Qt::Key_Space,
      Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Up,    Qt::Key_Down,   Qt::Key_Delete, Qt::Key_Tab,
      Qt::Key_Escape, Qt::Key_Return, Qt::Key_Comma, Qt::Key_Period, Qt::Key_PageUp, Qt::Key_PageDown,
      Qt::Key_F5,     Qt::Key_F6,     Qt::Key_F11,   Qt::Key_A,      Qt::Key_C,      Qt::Key_H,
      Qt::Key_L,      Qt::Key_M,      Qt::Key_R,     Qt::Key_X};
  const Qt::KeyboardModifiers modifiers = action.b < 0.15  ? Qt::ControlModifier
                                          : action.b < 0.3 ? Qt::ShiftModifier
                                                           : Qt::NoModifier;
  const Qt::Key key = pick(keys, action.a);
  did_ += " " + QKeySequence(int(key) | int(modifiers)).toString().toStdString();
  QTest::keyClick(window_.get(), key, modifiers);
}

void WindowMonkey::saveAndOpen(const MonkeyAction& action) {
  const QString file =
      folder_.filePath(action.a < 0.5 ? QStringLiteral("a.viscera") : QStringLiteral("b.viscera"));
  if (action.b < 0.5) {
    did_ += " save";
    window_->sessions().saveTo(file, action.c < 0.5);
  } else if (action.b < 0.9 && QFile::exists(file)) {
    did_ += " open";
    window_->sessions().open(file);
  } else {
    did_ += " new";
    window_->sessions().begin();
  }
}

void WindowMonkey::changeWindow(const MonkeyAction& action) {
  if (action.a < 0.6)
    action.d > 0.9
        ? window_->resize(900 + static_cast<int>(action.b * 800), 600 + static_cast<int>(action.c * 500))
        : window_->resize(900 + static_cast<int>(action.b * 300), 600 + static_cast<int>(action.c * 200));
  else
    window_->setTheme(action.b < 0.5 ? app::ThemeKind::dark : app::ThemeKind::light);
}

/// Time goes on, whether something plays or not.
void WindowMonkey::play(const MonkeyAction& action) {
  const int frames = 1 + static_cast<int>(action.a * 8);
  for (int frame = 0; frame < frames; ++frame) {
    now_ += 0.01 + 0.09 * action.b;
    window_->playback().advance();
    pump();
  }
}

Violation WindowMonkey::violation() {
  Violation wrong;
  wrong.add(Invariant::silence, takePrinted());
  if (stuck_) {
    app::Comparison& comparison = window_->play().comparison();
    wrong.add(Invariant::end, "the work that was cancelled does not end" + workOf(window_->workspace()) +
                                  (comparison.on() ? workOf(comparison.workspace()) : ""));
  }
  try {
    document::validate(window_->workspace().state());
  } catch (const Error& error) {
    wrong.add(Invariant::document, std::string("the document is not valid: ") + error.what());
  }
  if (window_->workspace().undo().stepOpen()) // The mouse is up again.
    wrong.add(Invariant::undo, "a step is still open");
  if (!atPeace(*window_))
    return wrong;
  if (!window_->imports().isOpen()) // It shows organs that are not in the document yet.
    wrong.add(Invariant::shown, disagreement(*window_));
  // Elsewhere the timeline keeps its place until the sequence is wanted again.
  if (window_->playback().wantedPose() == live::WantedPose::sequence)
    wrong.add(Invariant::timeline, offTheTimeline(window_->workspace(), window_->playback()));
  wrong.add(Invariant::volume, wrongVolumes());
  return wrong;
}

std::string WindowMonkey::wrongVolumes() {
  std::ostringstream wrong;
  for (const auto& organ : window_->workspace().document().organs()) {
    const live::OrganVolume shown = window_->workspace().live().volume(organ->id);
    if (!shown.closed)
      continue;
    const double computed =
        geometry::volume(window_->workspace().live().points(organ->id), organ->mesh->triangles) / kMm3PerMl;
    if (std::abs(computed - shown.nowMl) > kVolumeTolerance * std::max(1.0, std::abs(computed)))
      wrong << organ->name << " has " << computed << " ml, " << shown.nowMl << " are said; ";
  }
  return wrong.str();
}

Violation WindowMonkey::undoViolation() {
  window_->playback().pause();
  settle();
  document::UndoStack& undo = window_->workspace().undo();
  const document::DocumentState end = window_->workspace().state();
  const std::size_t position = undo.position();
  while (undo.canUndo())
    undo.undo();
  settle();
  Violation wrong;
  if (!(window_->workspace().state() == begin_))
    wrong.add(Invariant::undo, "undoing all does not give the first document");
  wrong.add(violation());
  while (undo.canRedo() && undo.position() < position)
    undo.redo();
  settle();
  if (!(window_->workspace().state() == end))
    wrong.add(Invariant::redo, "redoing all does not give the last document");
  wrong.add(violation());
  return wrong;
}

bool WindowMonkey::save(const QString& file, bool embed) {
  bool saved = false;
  window_->sessions().saveTo(file, embed, [&saved] { saved = true; });
  return QTest::qWaitFor([&saved] { return saved; }, kLongestWait);
}

Violation WindowMonkey::sessionViolation() {
  const document::DocumentState state = window_->workspace().state();
  const bool embed = window_->workspace().undo().position() % 2 == 0;
  const QString first = folder_.filePath(QStringLiteral("first.viscera"));
  const QString second = folder_.filePath(QStringLiteral("second.viscera"));
  Violation wrong;
  if (!save(first, embed)) {
    wrong.add(Invariant::session, "it cannot be saved");
    return wrong;
  }
  window_->sessions().open(first);
  settle();
  if (!document::identical(window_->workspace().state(), state))
    wrong.add(Invariant::session, "opened, it is another document than the one that was saved");
  wrong.add(violation());
  if (!save(second, embed))
    wrong.add(Invariant::session, "it cannot be saved again");
  else
    wrong.add(Invariant::session,
              difference(contentsOf(first.toStdString()), contentsOf(second.toStdString())));
  return wrong;
}

Violation WindowMonkey::closeViolation() {
  window_->samples().load(QStringLiteral("stomach"), true); // It closes while that is under way.
  pump();
  changes_ = {};
  window_->close();
  window_.reset();
  pump();
  Violation wrong;
  wrong.add(Invariant::closing, takePrinted());
  return wrong;
}

} // namespace viscera::tests

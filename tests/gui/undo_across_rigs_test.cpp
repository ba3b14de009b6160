#include "window_test.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include "clouds.h"
#include "session_scene.h"
#include "shapes.h"
#include "sway.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/rig_commands.h"
#include "window_probe.h"

namespace viscera::tests {
namespace {

using document::HandleId;
using document::OrganId;

constexpr double kHandleRadius = 70, kOrganRadius = 25;
/// Rigs of all these sizes meet in a walk.
constexpr int kSizes[] = {8, 13, 24, 38};
constexpr int kFewestWitnesses = live::WitnessOptions::kFewest;

/// Points spread over a sphere, a little off it, so that no two rigs are alike.
Points spread(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> off(-3, 3);
  Points points(count, 3);
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double r = std::sqrt(1 - z * z);
    points.row(i) = kHandleRadius * Eigen::RowVector3d(r * std::cos(turn * i), r * std::sin(turn * i), z) +
                    drawPlace(off, random).transpose();
  }
  return points;
}

/// Some are so fine that they are bound by a worker, while the window goes on.
document::NewOrgan anyBall(std::mt19937& random) {
  std::uniform_real_distribution<double> off(-8, 8);
  const Vec3 center = drawPlace(off, random);
  const int levels = std::uniform_int_distribution<int>(0, 4)(random) == 0 ? 5 : 2;
  return {document::makeOrgan("Ball", sphere(levels, kOrganRadius, center)), -1};
}

/// Random steps in a window whose documents have rigs of different sizes. A step depends on nothing but the
/// seed, its number and what the window shows, so that any part of a walk can be done again.
class Walk {
public:
  Walk(app::MainWindow& window, double& clock, unsigned seed) : window_(window), clock_(clock), seed_(seed) {
    listening_ = QObject::connect(&window.workspace(), &app::Workspace::messageRaised, &window,
                                  [this](const app::Message& message) {
                                    if (message.severity == app::Message::Severity::error)
                                      errors_ += message.text.toStdString() + "; ";
                                  });
    app::StressLook look = window.stress().model().look();
    look.witnesses = kFewestWitnesses;
    window.stress().model().setLook(look);
  }
  ~Walk() { QObject::disconnect(listening_); }
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;

  /// Does the step of that number. Returns what is wrong afterwards, empty when all is well.
  std::string step(int number) {
    random_.seed(seed_ * 1'000'003U + static_cast<unsigned>(number));
    errors_.clear();
    name_.clear();
    const std::size_t handles = rig().handles.size();
    const bool followed = playback().showing();
    try {
      act();
      crossings_ += followed && rig().handles.size() != handles ? 1 : 0;
      if (const std::string wrong = check(); !wrong.empty())
        return wrong;
      if (number % kFullCheckEvery == 0)
        return checkAgainstFresh();
    } catch (const std::exception& error) {
      return std::string("an exception came out: ") + error.what();
    }
    return {};
  }
  const std::string& name() const { return name_; }
  /// How often another number of handles came while a sequence was shown.
  int crossings() const { return crossings_; }

private:
  static constexpr int kFullCheckEvery = 25;

  document::UndoStack& undo() { return window_.workspace().undo(); }
  const document::DocumentState& state() { return window_.workspace().state(); }
  const document::Rig& rig() { return *state().rig; }
  app::Playback& playback() { return window_.playback(); }
  int number(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  double real(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  Vec3 vector(double size) { return {real(-size, size), real(-size, size), real(-size, size)}; }
  HandleId anyHandle() {
    return rig().handles.empty() ? HandleId{} : rig().handles[number(int(rig().handles.size()))].id;
  }
  std::shared_ptr<const document::Organ> anyOrgan() {
    return state().organs->empty() ? nullptr : (*state().organs)[number(int(state().organs->size()))];
  }

  /// Does a command in the window that the document accepts; one that it refuses is no step.
  void perform(const document::Command& command) {
    document::IdSource ids;
    ids.reserve(HandleId{1'000'000'000});
    try {
      command.apply(state(), ids);
    } catch (const Error&) {
      name_ += " (refused)";
      return;
    }
    if (!window_.workspace().perform(command))
      errors_ += "what the document accepts did not go through; ";
  }

  void act();
  void actOnTime(int kind);
  void actOnDocument(int kind);
  void actOnLooks(int kind);
  void newMotion();
  std::string check();
  std::string checkColours();
  std::string checkSelection();
  std::optional<Points> expectedPose();
  std::string checkAgainstFresh();

  app::MainWindow& window_;
  double& clock_;
  unsigned seed_;
  std::mt19937 random_;
  std::string name_, errors_;
  int crossings_ = 0;
  QMetaObject::Connection listening_;
};

void Walk::act() {
  const int kind = number(100);
  if (kind < 22) {
    name_ = "undo";
    window_.actions()["edit.undo"]->trigger();
  } else if (kind < 36) {
    name_ = "redo";
    window_.actions()["edit.redo"]->trigger();
  } else if (kind < 40) {
    const auto steps = static_cast<std::size_t>(number(int(undo().names().size()) + 1));
    name_ = "go to " + std::to_string(steps) + " of " + std::to_string(undo().names().size());
    window_.workspace().guarded([&] { undo().goTo(steps); });
  } else if (kind < 60) {
    actOnTime(number(10));
  } else if (kind < 84) {
    actOnDocument(number(14));
  } else {
    actOnLooks(number(9));
  }
}

/// As a sample comes into the window: organ, handles and motion in place of all there is, in one step.
void Walk::newMotion() {
  const int size = kSizes[number(int(std::size(kSizes)))];
  name_ = "sequence of " + std::to_string(size) + " handles with its organ";
  const auto motion = std::make_shared<Sway>(
      spread(size, random_), std::vector<Swing>{{0, Vec3(20, 0, 0)}, {size / 2, Vec3(0, 15, 5), 1.0}});
  const auto organ = anyBall(random_);
  playback().setSequence(nullptr, {});
  const bool done = window_.workspace().guarded([&] {
    document::UndoStack::Step step(undo(), "Sample");
    undo().perform(document::removeAllOrgans());
    undo().perform(document::replaceRig({}));
    undo().perform(document::addOrgans({organ}));
    undo().perform(document::replaceRig(document::rigOf(*motion)));
    step.finish();
  });
  if (!done)
    return;
  playback().setSequence(motion, state().organs->front()->id);
  window_.workspace().selection().setOrgan(state().organs->front()->id);
  const int then = number(4);
  if (then == 0) {
    name_ += ", looked at in its middle";
    playback().seek(0.4);
  } else if (then < 3) {
    name_ += then == 1 ? ", playing" : ", played and paused";
    playback().play();
    clock_ += 0.2;
    playback().advance();
    if (then == 2)
      playback().pause();
  }
}

void Walk::actOnTime(int kind) {
  switch (kind) {
  case 0:
  case 1:
    return newMotion();
  case 2: {
    const auto motions = playback().motions();
    name_ = "choose a motion";
    if (!motions.empty())
      playback().choose(motions[number(int(motions.size()))].sequence.get());
    return;
  }
  case 3:
    name_ = "play";
    return playback().play();
  case 4:
    name_ = "pause";
    return playback().pause();
  case 5:
  case 6: {
    const double to = real(0, 1);
    name_ = "seek " + std::to_string(to);
    return playback().seek(to);
  }
  case 7:
    name_ = "stop";
    return playback().stop();
  default:
    name_ = "a frame later";
    clock_ += 0.07;
    return playback().advance();
  }
}

void Walk::actOnDocument(int kind) {
  switch (kind) {
  case 0:
    name_ = "add an organ";
    return perform(document::addOrgans({anyBall(random_)}));
  case 1:
    name_ = "remove an organ";
    if (state().organs->size() > 1 || number(4) == 0)
      if (const auto organ = anyOrgan())
        perform(document::removeOrgans({organ->id}));
    return;
  case 2: {
    name_ = "add two handles";
    const Vec3 a = vector(1).normalized() * 85, b = vector(1).normalized() * 95;
    return perform(document::addHandles({{a}, {b}}));
  }
  case 3:
    name_ = "remove a handle";
    if (rig().handles.size() > 6)
      perform(document::removeHandles({anyHandle()}));
    return;
  case 4: {
    const int size = kSizes[number(int(std::size(kSizes)))];
    name_ = "replace the rig by " + std::to_string(size) + " handles";
    return perform(document::replaceRig(document::rigAt(spread(size, random_))));
  }
  case 5: {
    name_ = "move a handle at rest";
    const HandleId id = anyHandle();
    if (!id)
      return;
    const Vec3 to = rig().handles[rig().indexOf(id)].rest + vector(3);
    return perform(document::moveRestHandles({id}, row(to.x(), to.y(), to.z())));
  }
  case 6:
  case 7: {
    name_ = "move a handle in the pose";
    const HandleId id = anyHandle();
    if (!id)
      return;
    const Vec3 to = state().pose->row(rig().indexOf(id)).transpose() + vector(12);
    return perform(document::moveHandles({id}, row(to.x(), to.y(), to.z())));
  }
  case 8:
    name_ = "reset the pose";
    return perform(document::resetPose());
  case 9:
    name_ = "lock or unlock a volume";
    if (const auto organ = anyOrgan())
      perform(document::setVolumeLocked(organ->id, !organ->volumeLocked && number(3) == 0));
    return;
  case 10: {
    const char* systems[] = {"s-celestial", "t-celestial", "mean-value"};
    const char* system = systems[number(3)];
    name_ = std::string("coordinates ") + system;
    return perform(document::setSystem({system, {}}));
  }
  case 11:
    name_ = "hide or lock a handle";
    if (const HandleId id = anyHandle()) {
      document::HandleEdit edit;
      (number(2) == 0 ? edit.visible : edit.locked) = number(2) == 0;
      perform(document::editHandles({id}, edit));
    }
    return;
  case 12: {
    name_ = "record a key";
    const double at = 0.1 * number(18);
    return perform(document::recordKey(at));
  }
  default:
    name_ = "show or hide an organ";
    if (const auto organ = anyOrgan()) {
      document::OrganLook look = organ->look;
      look.visible = !look.visible;
      look.opacity = number(3) == 0 ? 0.4 : 1;
      perform(document::setOrganLook(organ->id, look));
    }
  }
}

void Walk::actOnLooks(int kind) {
  const auto toggle = [this](const char* id) {
    name_ = std::string("switch ") + id;
    window_.actions()[id]->toggle();
  };
  switch (kind) {
  case 0:
  case 1:
  case 2: {
    // Stress takes a while to fill each organ: less often.
    const auto& modes = window_.modes().all();
    std::string mode = modes[std::size_t(number(int(modes.size())))]->description().id;
    if (mode == "stress" && number(3) != 0)
      mode = "play";
    name_ = "mode " + mode;
    return window_.setMode(mode);
  }
  case 3: {
    name_ = "select handles";
    std::vector<HandleId> ids;
    for (int i = number(4); i > 0 && !rig().handles.empty(); --i)
      ids.push_back(anyHandle());
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return window_.workspace().selection().setHandles(ids);
  }
  case 4: {
    name_ = "select an organ";
    const auto organ = anyOrgan();
    return window_.workspace().selection().setOrgan(organ ? organ->id : OrganId{});
  }
  case 5:
    return toggle("view.ghost");
  case 6:
    return toggle("handles.influence");
  case 7:
    return toggle("view.handles");
  default:
    name_ = "let the window draw";
    QApplication::processEvents();
  }
}

/// The pose that has to be seen; none where a locked volume may change it.
std::optional<Points> Walk::expectedPose() {
  if (window_.mode() == "handles")
    return rig().restPositions();
  if (!playback().showing())
    return *state().pose;
  for (const auto& organ : *state().organs)
    if (organ->volumeLocked)
      return std::nullopt;
  Points pose;
  playback().sequence()->poseAt(playback().player().secondsInCycle(), playback().player().ratePerMinute(),
                                pose);
  return pose;
}

std::string Walk::check() {
  // Another sequence is shown when the event loop comes round, before anybody sees a frame.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
  std::string wrong;
  // A lock that no pose of a sequence can keep is said, as it should be.
  if (!errors_.empty() && errors_.find("volume cannot be kept") == std::string::npos)
    wrong = "an error was raised: " + errors_;
  wrong += disagreement(window_);
  if (!wrong.empty())
    return wrong;
  const Points& shown = window_.workspace().live().shownPose();
  if (const auto expected = expectedPose(); expected && shown.rows() > 0)
    if (expected->rows() != shown.rows() || !((*expected - shown).cwiseAbs().maxCoeff() <= 1e-9))
      return std::string("the pose that is shown is not the one of ") +
             (window_.mode() == "handles" ? "rest; "
              : playback().showing()      ? "the timeline's instant; "
                                          : "the document; ");
  return checkColours() + checkSelection();
}

std::string Walk::checkColours() {
  const bool wanted = window_.mode() == "stress" || (window_.actions()["handles.influence"]->isChecked() &&
                                                     window_.workspace().selection().currentHandle());
  for (const auto& organ : *state().organs)
    if (!wanted && shownOrgan(window_, *organ).colouredByNumbers)
      return organ->name + " is coloured by numbers that nobody asked for; ";
  return {};
}

std::string Walk::checkSelection() {
  const document::Selection& selection = window_.workspace().selection();
  for (const HandleId id : selection.handles())
    if (rig().indexOf(id) < 0)
      return "a handle is selected that is gone; ";
  if (selection.organ() && !state().organ(selection.organ()))
    return "an organ is selected that is gone; ";
  if (selection.group() && rig().indexOf(selection.group()) < 0)
    return "a group is selected that is gone; ";
  return {};
}

/// What somebody sees who opens the same document anew, and looks at the same pose.
std::string Walk::checkAgainstFresh() {
  if (!QTest::qWaitFor([this] { return atPeace(window_); }, 120000))
    return "the window's work has no end; ";
  if (const std::string wrong = check(); !wrong.empty())
    return "once all work was done: " + wrong;
  document::Document document;
  document::UndoStack undo(document);
  ManualEventLoop box;
  JobQueue jobs(box.post());
  live::LiveBinding fresh(document, window_.workspace().registry(), jobs,
                          {std::numeric_limits<double>::infinity(), {}});
  undo.reset(state());
  live::LiveBinding& live = window_.workspace().live();
  if (!rig().handles.empty())
    fresh.showPose(live.shownPose());
  std::ostringstream wrong;
  for (const auto& organ : *state().organs) {
    if (fresh.status(organ->id).state != live.status(organ->id).state)
      wrong << organ->name
            << " is bound in another state than a fresh one: " << live.status(organ->id).message << "; ";
    else if (!((fresh.points(organ->id) - live.points(organ->id)).cwiseAbs().maxCoeff() <= 1e-9))
      wrong << organ->name << " is not where a fresh one is; ";
    else if (std::abs(fresh.volume(organ->id).nowMl - live.volume(organ->id).nowMl) > 1e-9)
      wrong << organ->name << " has another volume than a fresh one; ";
    for (const auto& line : window_.volumes().lines())
      if (line.organ == organ->id && line.side == 0 && line.restMl != live.volume(organ->id).restMl)
        wrong << "the chart has another volume at rest for " << organ->name << "; ";
  }
  return wrong.str();
}

/// A window of its own for each walk.
class UndoAcrossRigs : public WindowTest, public testing::WithParamInterface<unsigned> {
protected:
  bool coarseSamples() const override { return true; }

  /// What went wrong, and after which of the steps.
  struct Failure {
    std::size_t step = 0;
    std::string what;
    std::vector<std::string> names;
  };

  std::optional<Failure> walk(const std::vector<int>& numbers) {
    now_ = 0;
    reopenWindow();
    setViewSize(window(), 120, 90);
    Walk walk(window(), now_, GetParam());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::string wrong = walk.step(numbers[i]);
      crossings_ = walk.crossings();
      names.push_back(std::to_string(numbers[i]) + ": " + walk.name());
      if (!wrong.empty())
        return Failure{i, wrong, names};
    }
    return std::nullopt;
  }

  /// Leaves out steps without which it goes wrong as well, for a while.
  Failure shrink(Failure failure, std::vector<int> numbers) {
    numbers.resize(failure.step + 1);
    QElapsedTimer timer;
    timer.start();
    for (std::size_t part = numbers.size() / 2; part > 0 && timer.elapsed() < kLongestShrink; part /= 2)
      for (std::size_t begin = 0; begin + 1 < numbers.size() && timer.elapsed() < kLongestShrink;) {
        std::vector<int> fewer = numbers;
        const auto from = fewer.begin() + static_cast<std::ptrdiff_t>(begin);
        fewer.erase(from, from + static_cast<std::ptrdiff_t>(std::min(part, fewer.size() - 1 - begin)));
        if (auto again = walk(fewer)) {
          failure = *again;
          numbers = fewer;
          numbers.resize(failure.step + 1);
        } else {
          begin += part;
        }
      }
    return failure;
  }

  int crossings_ = 0; ///< Of the last walk.

  static constexpr int kSteps = 2500;
  static constexpr int kFewestCrossings = 25;
  static constexpr qint64 kLongestShrink = 40000;
};

TEST_P(UndoAcrossRigs, ShowsWhatAFreshWindowWouldAfterEveryRandomStep) {
  std::vector<int> numbers;
  const char* steps = std::getenv("VISCERA_WALK_STEPS");
  for (int i = 1; i <= (steps ? std::atoi(steps) : kSteps); ++i)
    numbers.push_back(i);
  const auto failure = walk(numbers);
  if (!failure) {
    EXPECT_GE(crossings_, kFewestCrossings) << "the walk has to go across rigs while a sequence is shown";
    return;
  }
  const Failure smallest = shrink(*failure, numbers);
  std::ostringstream trace;
  for (const std::string& name : smallest.names)
    trace << "\n  " << name;
  FAIL() << "seed " << GetParam() << ", step " << numbers[failure->step] << ": " << failure->what
         << "\nIt takes no more than these steps for: " << smallest.what << trace.str();
}

INSTANTIATE_TEST_SUITE_P(Seeds, UndoAcrossRigs, testing::Values(11U, 23U, 37U, 51U));

} // namespace
} // namespace viscera::tests

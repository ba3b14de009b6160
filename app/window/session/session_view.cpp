#include "window/session/session_view.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/document/rig_commands.h"
#include "viscera/presentation/presenter.h"
#include "viscera/sequences/volume_curve.h"
#include "window/compare/comparison.h"
#include "window/lecture/slides.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {
/// A motion computed anew differs by rounding alone.
constexpr double kSameMotionMm = 0.01;
/// The field of a view with the numbers of a measured motion.
constexpr const char* kMeasuredField = "measured";
constexpr const char* kMotionsSlot = "motions";
} // namespace

/// A saved view, and the sequences that it needs.
struct SessionView::Wanted {
  presentation::ViewState view;
  document::DocumentState document; ///< Of the session.
  /// The sequences of the view's motions, once they are made; null where an organ is missing.
  std::vector<std::shared_ptr<const sequences::Sequence>> sequences;
};

SessionView::SessionView(Window window, QObject* parent) : QObject(parent), window_(std::move(window)) {
  connect(&window_.view, &ViewModel::changed, this, &SessionView::changed);
  subscription_ = window_.workspace.live().onEvent([this](const live::LiveEvent&) {
    if (waiting_ && !window_.workspace.live().busy())
      QMetaObject::invokeMethod(this, &SessionView::prescribeWaiting, Qt::QueuedConnection);
  });
}

void SessionView::forget() {
  stopMakingMotions();
  waiting_.reset();
  window_.comparison.end();
  window_.view.change([](presentation::ViewState& state) {
    state.slides.clear();
    state.person = presentation::ViewState().person;
    state.cut = {};
    state.cycleEnds = {};
    state.organsSeen.clear();
    state.scan = {};
    state.stress = presentation::habitOf(state.stress);
    state.stress.cut = false;
  });
}

presentation::ViewState SessionView::state(bool shown) const {
  presentation::ViewState state = window_.picture.state();
  if (const auto& before = window_.slides.lookBefore(); before && !shown) {
    state.cut = before->cut;
    state.labels = before->labels;
    state.partNames = before->partNames;
    state.organsSeen = before->organs;
  }
  state.camera = presentation::cameraOf(window_.picture.view());
  if (const auto& stress = window_.picture.presenter().stressValues(); stress.ready())
    state.stress.range = stress.range();
  gatherMotions(state);
  state.compared = window_.comparison.compared();
  if (window_.playback.showing() && !waiting_)
    state.shownPose = window_.workspace.live().shownPose();
  if (making_ && stillShows(*making_))
    gatherWanted(state);
  return state;
}

nlohmann::ordered_json SessionView::saved() const {
  nlohmann::ordered_json view = presentation::toJson(state());
  if (const auto measured = window_.measured.record())
    view[kMeasuredField] = live::toJson(*measured);
  return view;
}

/// Before its sequence is shown, which draws it.
void SessionView::recallMeasured(const nlohmann::ordered_json& view) {
  if (const auto measured = view.find(kMeasuredField); measured != view.end())
    window_.workspace.guarded([&] { window_.measured.recall(live::measuredRecordFrom(*measured)); });
}

void SessionView::gatherMotions(presentation::ViewState& state) const {
  const live::Player& player = window_.playback.player();
  int present = -1;
  for (const Playback::Motion& motion : window_.playback.motions()) {
    if (std::holds_alternative<std::monostate>(motion.recipe))
      continue;
    if (motion.sequence.get() == window_.playback.sequence())
      present = static_cast<int>(state.motions.size());
    state.motions.push_back({motion.organ, motion.recipe});
  }
  if (window_.playback.sequence())
    state.playing = presentation::Playing{present,        player.fraction(), player.ratePerMinute(),
                                          player.speed(), player.loop(),     window_.playback.showing()};
  const bool waits = waiting_ && waiting_->sequence == window_.playback.sharedSequence();
  const auto prescribed = waits ? std::optional(waiting_->volume) : player.runner().prescribed();
  if (!state.playing || !prescribed)
    return;
  presentation::Prescribed kept{prescribed->organ, prescribed->file, {}};
  for (const sequences::Key& key : prescribed->milliliters.keys())
    kept.curve.push_back({key.at, key.value});
  state.playing->prescribed = std::move(kept);
}

/// What will be shown once the motions are created: they come after those that are there by now.
void SessionView::gatherWanted(presentation::ViewState& state) const {
  const presentation::ViewState& wanted = making_->view;
  std::vector<int> rows; // In `state`, of each wanted motion.
  for (const presentation::MotionChoice& motion : wanted.motions) {
    const bool there =
        making_->document.organ(motion.organ) && window_.workspace.document().organ(motion.organ);
    rows.push_back(there ? static_cast<int>(state.motions.size()) : -1);
    if (there)
      state.motions.push_back(motion);
  }
  if (const auto& playing = wanted.playing) {
    const bool made = playing->motion >= 0 && playing->motion < static_cast<int>(rows.size());
    const int row = made ? rows[static_cast<std::size_t>(playing->motion)] : -1;
    if (playing->motion < 0 || row >= 0) {
      state.playing = playing;
      state.playing->motion = row;
    }
  }
  if (wanted.compared)
    state.compared = wanted.compared;
  if (making_->document == window_.workspace.state())
    state.shownPose = wanted.shownPose;
}

void SessionView::apply(const nlohmann::ordered_json& saved) {
  Wanted wanted{presentation::viewFromJson(saved, window_.workspace.document().circulation()),
                window_.workspace.state(),
                {}};
  stopMakingMotions();
  waiting_.reset();
  window_.comparison.end(); // The session has its own, or none.
  recallMeasured(saved);
  const presentation::ViewState& state = wanted.view;
  window_.modes.choose(state.mode);
  window_.workspace.selection().setOrgan(state.selection.organ);
  window_.workspace.selection().setGroup(state.selection.group);
  window_.workspace.selection().setHandles(state.selection.handles);
  window_.view.change([&state](presentation::ViewState& view) {
    presentation::ViewState opened = state;
    opened.mode = view.mode; // The mode that is on says what is to be seen.
    opened.shown = view.shown;
    opened.camera.reset(); // Other parts of the window have the rest, see `state`.
    opened.selection = {};
    opened.motions.clear();
    opened.playing.reset();
    opened.compared.reset();
    opened.shownPose.resize(0, 3);
    view = std::move(opened);
  });
  if (state.camera)
    presentation::lookFrom(*state.camera, window_.view.state(), window_.picture.view());
  else
    Q_EMIT framingWanted();
  makeMotions(std::move(wanted));
}

void SessionView::makeMotions(Wanted wanted) {
  if (wanted.view.motions.empty())
    return show(wanted);
  making_ = std::make_shared<const Wanted>(std::move(wanted));
  window_.workspace.jobs().submit<Wanted>(
      tr("Preparing the motion").toStdString(), kMotionsSlot,
      [wanted = making_, library = sample_organs::standardLibrary()](Progress& progress) {
        Wanted made = *wanted;
        for (const presentation::MotionChoice& motion : made.view.motions) {
          const auto organ = made.document.organ(motion.organ);
          made.sequences.push_back(organ ? live::makeMotion(motion.recipe, *organ, library, progress)
                                         : nullptr);
        }
        return made;
      },
      [this, wanted = making_](const JobResult<Wanted>& made) {
        if (wanted != making_) // Another session has been opened.
          return;
        making_.reset();
        if (made.error)
          window_.workspace.report(*made.error);
        if (made.value && stillShows(*made.value))
          show(*made.value);
      });
}

void SessionView::stopMakingMotions() {
  making_.reset();
  window_.workspace.jobs().cancelSlot(kMotionsSlot);
}

/// False once other organs, such as a sample, have taken the place of the session's.
bool SessionView::stillShows(const Wanted& wanted) const {
  const document::OrganList& organs = *wanted.document.organs;
  return organs.empty() || std::any_of(organs.begin(), organs.end(), [this](const auto& organ) {
           return window_.workspace.document().organ(organ->id) != nullptr;
         });
}

void SessionView::show(const Wanted& wanted) {
  Playback& playback = window_.playback;
  for (std::size_t i = 0; i < wanted.sequences.size(); ++i) {
    const presentation::MotionChoice& motion = wanted.view.motions[i];
    if (wanted.sequences[i] && window_.workspace.document().organ(motion.organ))
      playback.offer(wanted.sequences[i], motion.organ, motion.recipe);
  }
  if (wanted.view.playing)
    play(wanted);
  if (wanted.view.compared) // It shows the present motion, too.
    window_.comparison.restore(*wanted.view.compared);
}

void SessionView::play(const Wanted& wanted) {
  Playback& playback = window_.playback;
  const presentation::Playing& playing = *wanted.view.playing;
  if (playing.motion >= 0 && playing.motion < static_cast<int>(wanted.sequences.size()))
    playback.choose(wanted.sequences[static_cast<std::size_t>(playing.motion)].get());
  if (playback.sequence() && playing.ratePerMinute > 0) {
    // A heart that follows a circulation gets the rate of that.
    playback.setRate(std::clamp(playing.ratePerMinute, playback.sequence()->lowestRatePerMinute(),
                                playback.sequence()->highestRatePerMinute()));
    playback.setSpeed(playing.speed);
    playback.setLooping(playing.loop);
    if (playing.prescribed)
      prescribe(*playing.prescribed);
    if (playing.shown) {
      const bool others = takeHandlesOfToday();
      playback.seek(playing.fraction);
      if (others)
        return sayMotionChanged(tr("it has other handles"));
      if (!waiting_) // While a prescribed volume waits, the handles are where the sequence alone moves them.
        warnAboutChangedMotion(wanted.view.shownPose);
    } else if (playing.fraction > 0 && playback.wantedPose() != live::WantedPose::sequence) {
      playback.setPlace(playing.fraction);
    }
  }
}

/// A motion that was shown moved the session's handles; where this version makes it with other ones, it takes
/// these. Returns whether it did.
bool SessionView::takeHandlesOfToday() {
  const Playback& playback = window_.playback;
  return !playback.player().movable() &&
         window_.workspace.perform(document::replaceRig(document::rigOf(*playback.sequence()),
                                                        tr("Use the sequence's handles").toStdString()));
}

void SessionView::sayMotionChanged(const QString& how) {
  window_.workspace.say(
      {Message::Severity::warning,
       tr("This version moves the organ differently from the one that saved the session: %1.").arg(how),
       {},
       0});
}

/// Shows a message for an invalid curve or volumes that cannot be reached; the sequence plays without them.
void SessionView::prescribe(const presentation::Prescribed& prescribed) {
  if (!window_.workspace.document().organ(prescribed.organ))
    return; // Its file is missing, for which another message is shown.
  window_.workspace.guarded([&] {
    waiting_ = Waiting{{prescribed.organ, sequences::volumeCurve(prescribed.curve), prescribed.file},
                       window_.playback.sharedSequence()};
  });
  if (!window_.workspace.live().busy())
    prescribeWaiting();
}

void SessionView::prescribeWaiting() {
  const auto waiting = std::exchange(waiting_, std::nullopt);
  if (waiting && waiting->sequence == window_.playback.sharedSequence())
    window_.playback.prescribe(waiting->volume);
}

/// Warns when this version of the program computes the saved motion differently: the view then shows other
/// positions of the handles than the session was saved with.
void SessionView::warnAboutChangedMotion(const Points& saved) {
  const Points& now = window_.workspace.live().shownPose();
  if (saved.rows() != now.rows() || saved.rows() == 0)
    return;
  const double apart = (saved - now).rowwise().norm().maxCoeff();
  if (apart > kSameMotionMm)
    sayMotionChanged(tr("handles differ by up to %1 mm").arg(formatDigits(apart, 2)));
}

} // namespace viscera::app

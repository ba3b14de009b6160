#include "window/work/binding_messages.h"

#include <algorithm>
#include <utility>

#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/presentation/presenter.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

constexpr int kNoteSeconds = 12;

} // namespace

BindingMessages::BindingMessages(Workspace& workspace, MessageBar* bar, QObject* parent, Workspace* repaired)
    : QObject(parent), workspace_(workspace), repaired_(repaired ? *repaired : workspace), bar_(bar) {
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (event.status)
      sync();
  }));
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      retractOfGone();
  }));
}

/// The offers of a message end with it.
BindingMessages::~BindingMessages() {
  if (bar_ && !shown_.isEmpty())
    bar_->retract(shown_);
}

void BindingMessages::followMotion() {
  if (moving_ != moved_())
    sync();
}

void BindingMessages::sync() {
  moving_ = moved_();
  using State = live::BindingStatus::State;
  double seconds = 0;
  QStringList notes;
  bool allBound = !workspace_.document().organs().empty();
  for (const auto& organ : workspace_.document().organs()) {
    const live::BindingStatus status = workspace_.live().status(organ->id);
    if (status.state == State::failed || status.state == State::stale) {
      const Message message = messageFor(*organ, status);
      if (message.text != shown_ || bar_->text().isEmpty())
        bar_->showMessage(message);
      shown_ = message.text;
      return;
    }
    allBound = allBound && status.state == State::bound;
    seconds += status.report.seconds;
    for (const Text& note : status.report.notes)
      if (!notes.contains(asSentence(note)))
        notes.push_back(asSentence(note));
  }
  if (!allBound)
    return;
  // Only our own message: another one may have come since.
  if (!shown_.isEmpty() && bar_->text() == shown_)
    bar_->dismiss();
  shown_.clear();
  showNotes(notes);
  Q_EMIT bound(seconds);
}

/// An organ that is gone, by an undo say, tells nothing any more.
void BindingMessages::retractOfGone() {
  using State = live::BindingStatus::State;
  const auto& organs = workspace_.document().organs();
  const bool any = std::any_of(organs.begin(), organs.end(), [this](const auto& organ) {
    const State state = workspace_.live().status(organ->id).state;
    return state == State::failed || state == State::stale;
  });
  if (!any && bar_ && !shown_.isEmpty())
    bar_->retract(std::exchange(shown_, {}));
}

/// Notes change their numbers with every move of a drag; only one more of them is news.
void BindingMessages::showNotes(const QStringList& notes) {
  const bool news = notes.size() > notes_.size();
  notes_ = notes;
  if (!news)
    return;
  bar_->showMessage({Message::Severity::info, notes.join(QLatin1Char(' ')), {}, kNoteSeconds});
}

Message BindingMessages::messageFor(const document::Organ& organ, const live::BindingStatus& status) const {
  Message message;
  message.severity = Message::Severity::warning;
  if (status.state == live::BindingStatus::State::stale) {
    message.text = tr("%1 is not bound to these handles: binding was cancelled.")
                       .arg(inWords(presentation::labelOf(organ)));
    message.offers.push_back(
        {tr("Bind now"), [this] { workspace_.guarded([this] { workspace_.live().rebind(); }); }});
    return message;
  }
  if (status.givenCage) {
    message.text = asSentence(status.message);
    if (status.outsideCage > 0)
      message.text = tr("%n vertices of %1 have no coordinates in the cage.", nullptr, status.outsideCage)
                         .arg(inWords(presentation::labelOf(organ)));
    message.offers.push_back(
        {tr("Use the hull as the cage"), [this] { repaired_.perform(document::dropCage()); }});
    message.offers.push_back(
        {tr("Undo"), [this] { repaired_.guarded([this] { repaired_.undo().undo(); }); }});
    return message;
  }
  if (!status.inNoRegion.empty()) {
    message.text =
        tr("%n vertices of %1 lie in no group's region.", nullptr, static_cast<int>(status.inNoRegion.size()))
            .arg(inWords(presentation::labelOf(organ)));
    message.offers.push_back({tr("Add enclosing group"), [this, id = organ.id, vertices = status.inNoRegion] {
                                repaired_.perform(document::addEnclosingGroup(id, vertices));
                              }});
    return message;
  }
  if (status.outsideHull > 0 && moving_) {
    message.text = tr("%n vertices of %1 lie outside the handles of the motion, so %1 stays at rest.",
                      nullptr, status.outsideHull)
                       .arg(inWords(presentation::labelOf(organ)));
    return message;
  }
  if (status.outsideHull > 0) {
    message.text = tr("%n vertices of %1 lie outside the handles' hull.", nullptr, status.outsideHull)
                       .arg(inWords(presentation::labelOf(organ)));
    message.offers.push_back(
        {tr("Add enclosing handles"), [this] { repaired_.perform(document::addEnclosingHandles()); }});
    return message;
  }
  message.text = asSentence(status.message);
  message.offers.push_back({tr("Undo"), [this] { repaired_.guarded([this] { repaired_.undo().undo(); }); }});
  return message;
}

} // namespace viscera::app

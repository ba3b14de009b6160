#include "window/quiz/quiz_tool.h"

#include <QDateTime>

#include <algorithm>
#include <random>
#include <utility>

#include "viscera/heart/heart_valves.h"
#include "window/style/language.h"
#include "window/view/picture.h"

namespace viscera::app {
namespace {

/// How many phases a quiz about a heart asks for.
constexpr std::size_t kPhasesAsked = 3;

/// The phases of the textbook's beat, each once, in an order that the seed chooses.
std::vector<QuizTool::AskedPhase> askedPhases(unsigned seed) {
  using heart::CardiacCycle;
  const heart::CardiacBeat beat = CardiacCycle().beat(CardiacCycle::kStandardRateBpm);
  std::vector<QuizTool::AskedPhase> asked;
  for (const sequences::Phase& phase : CardiacCycle::phases(CardiacCycle::kStandardRateBpm)) {
    const QString name = inWords(phase.name.capitalised());
    if (std::any_of(asked.begin(), asked.end(), [&](const auto& other) { return other.name == name; }))
      continue;
    const double middle = (phase.begin + phase.end) / 2 * beat.times().cycle;
    const heart::ValveInstants valves = heart::textbookValves(beat, middle);
    const auto isOpen = [&](heart::HeartValve valve) {
      return valves[static_cast<std::size_t>(valve)].areaMm2 > 0;
    };
    const int open = isOpen(heart::HeartValve::mitral) ? 0 : isOpen(heart::HeartValve::aortic) ? 1 : 2;
    asked.push_back({name, open});
  }
  std::mt19937 random(seed);
  for (std::size_t left = asked.size(); left > 1; --left)
    std::swap(asked[left - 1], asked[random() % left]);
  asked.resize(std::min(asked.size(), kPhasesAsked));
  return asked;
}

} // namespace

QuizTool::QuizTool(Workspace& workspace, Picture& picture, QObject* parent)
    : QObject(parent), workspace_(workspace), picture_(picture) {
  documents_ = workspace.onChange([this](const document::Change& change) {
    if (active() && change.organs())
      end();
  });
}

bool QuizTool::possible() const {
  return !presentation::clickableParts(workspace_.document().organs()).empty();
}

QString QuizTool::nameOf(const presentation::Part& part) const {
  return inWords(presentation::nameOf(part, workspace_.document().organs()));
}

void QuizTool::begin() {
  organs_ = workspace_.state().organs;
  const auto seed = static_cast<unsigned>(QDateTime::currentMSecsSinceEpoch()); // Another order each time.
  quiz_.emplace(presentation::clickableParts(*organs_), seed);
  const bool valves = std::any_of(organs_->begin(), organs_->end(), [](const auto& organ) {
    return std::any_of(organ->places.begin(), organ->places.end(),
                       [](const auto& place) { return place.ringMm > 0; });
  });
  phases_ = valves ? askedPhases(seed) : std::vector<AskedPhase>();
  right_ = wrong_ = 0;
  result_.clear();
  ask();
}

void QuizTool::end() {
  if (!active())
    return;
  quiz_.reset();
  organs_.reset();
  phases_.clear();
  question_.clear();
  result_.clear();
  picture_.setNamedParts(std::nullopt);
  Q_EMIT changed();
}

QString QuizTool::score() const {
  return right_ + wrong_ > 0 ? tr("%1 right, %2 wrong").arg(right_).arg(wrong_) : QString();
}

QStringList QuizTool::choices() const {
  if (!active() || quiz_->asked() || phases_.empty())
    return {};
  return {inWords(named("Mitral valve")), inWords(named("Aortic valve")), tr("Neither")};
}

void QuizTool::ask() {
  const int all = static_cast<int>(quiz_->all().size()), found = static_cast<int>(quiz_->found().size());
  if (const presentation::Part* part = quiz_->asked())
    question_ =
        tr("Click: %1").arg(nameOf(*part)) + QStringLiteral("\n") + tr("%1 of %2").arg(found + 1).arg(all);
  else if (!phases_.empty())
    question_ = tr("%1: which valve is open?").arg(phases_.front().name);
  else
    question_ = quiz_->mistakes() == 0
                    ? tr("All %1 found without a mistake.").arg(all)
                    : tr("All %1 found, with %n mistakes.", nullptr, quiz_->mistakes()).arg(all);
  picture_.setNamedParts(quiz_->found());
  Q_EMIT changed();
}

bool QuizTool::click(const ClickedPlace* place) {
  if (!active() || !quiz_->asked())
    return false;
  const auto chosen = place
                          ? presentation::nearestPart(quiz_->all(), place->organ,
                                                      workspace_.live().points(place->organ), place->position)
                          : std::nullopt;
  if (!chosen)
    return true; // A click beside the organs is no answer.
  const QString asked = nameOf(*quiz_->asked());
  const bool right = quiz_->answer(*chosen);
  ++(right ? right_ : wrong_);
  result_ = right ? tr("Right: %1").arg(asked) : tr("No, that is nearer to: %1").arg(nameOf(*chosen));
  ask();
  return true;
}

void QuizTool::choose(int choice) {
  const QStringList offered = choices();
  if (choice < 0 || choice >= offered.size())
    return;
  const AskedPhase asked = phases_.front();
  phases_.erase(phases_.begin());
  const bool right = choice == asked.open;
  ++(right ? right_ : wrong_);
  const QString answer = asked.name + QStringLiteral(": ") + offered.at(asked.open);
  result_ = right ? tr("Right: %1").arg(answer) : tr("No. %1").arg(answer);
  ask();
}

} // namespace viscera::app

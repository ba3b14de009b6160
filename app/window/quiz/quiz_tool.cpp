#include "window/quiz/quiz_tool.h"

#include <QDateTime>

#include "window/language.h"
#include "window/view/picture.h"

namespace viscera::app {

QuizTool::QuizTool(Workspace& workspace, Picture& picture, QObject* parent)
    : QObject(parent), workspace_(workspace), picture_(picture) {
  documents_ = workspace.onChange([this](const document::Change& change) {
    if (active() && change.organs())
      end();
  });
}

bool QuizTool::possible() const {
  return !presentation::partsOf(workspace_.document().organs()).empty();
}

QString QuizTool::nameOf(const presentation::Part& part) const {
  return inWords(presentation::nameOf(part, workspace_.document().organs()));
}

void QuizTool::begin() {
  organs_ = workspace_.state().organs;
  const auto seed = static_cast<unsigned>(QDateTime::currentMSecsSinceEpoch()); // Another order each time.
  quiz_.emplace(presentation::partsOf(*organs_), seed);
  result_.clear();
  ask();
}

void QuizTool::end() {
  if (!active())
    return;
  quiz_.reset();
  organs_.reset();
  question_.clear();
  result_.clear();
  picture_.setNamedParts(std::nullopt);
  Q_EMIT changed();
}

void QuizTool::ask() {
  const int all = static_cast<int>(quiz_->all().size()), found = static_cast<int>(quiz_->found().size());
  if (const presentation::Part* part = quiz_->asked())
    question_ = tr("Click: %1").arg(nameOf(*part));
  else
    question_ = quiz_->mistakes() == 0
                    ? tr("All %1 found without a mistake.").arg(all)
                    : tr("All %1 found, with %n mistakes.", nullptr, quiz_->mistakes()).arg(all);
  if (quiz_->asked())
    question_ += QStringLiteral("\n") + tr("%1 of %2").arg(found + 1).arg(all);
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
  result_ = quiz_->answer(*chosen) ? tr("Right: %1").arg(asked)
                                   : tr("No, that is nearer to: %1").arg(nameOf(*chosen));
  ask();
  return true;
}

} // namespace viscera::app

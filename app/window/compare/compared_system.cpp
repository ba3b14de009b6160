#include "window/compare/compared_system.h"

namespace viscera::app {
namespace {

constexpr const char* kWithoutCage = "t-celestial";
constexpr int kNarrowestChooser = 64; ///< Room for the first letters of a name.

std::string firstChoice(const document::SystemChoice& other) {
  return other.id == kWithoutCage ? document::SystemChoice().id : kWithoutCage;
}

} // namespace

ComparedSystem::ComparedSystem(Workspace& first, Workspace& second, MessageBar* messages, QObject* parent)
    : QObject(parent), first_(first), second_(second), messages_(second, messages, nullptr, &first) {
  auto choice = std::make_shared<document::SystemChoice>();
  choice->id = firstChoice(first.document().system());
  choice_ = std::move(choice);
  subscriptions_.push_back(first.selection().onChange([this] { followSelection(); }));
}

SystemCombo* ComparedSystem::makeChooser() {
  chooser_ = new SystemCombo(second_.registry());
  chooser_->setObjectName(QStringLiteral("secondSystem"));
  chooser_->setAccessibleName(tr("Coordinates of the second view"));
  chooser_->setToolTip(tr("Coordinate system that binds the same organs to the same handles in this view"));
  chooser_->setMinimumContentsLength(14);
  chooser_->setMinimumWidth(kNarrowestChooser);
  chooser_->setSystem(choice_->id);
  connect(chooser_, &SystemCombo::systemChosen, this, &ComparedSystem::choose);
  return chooser_;
}

void ComparedSystem::choose(const std::string& id) {
  auto choice = std::make_shared<document::SystemChoice>();
  choice->id = id;
  choice_ = std::move(choice);
  if (chooser_)
    chooser_->setSystem(id);
  Q_EMIT chosen();
}

document::DocumentState ComparedSystem::applied(document::DocumentState state) const {
  state.system = choice_;
  return state;
}

void ComparedSystem::followSelection() {
  const document::Selection& first = first_.selection();
  document::Selection& second = second_.selection();
  if (second.handles() != first.handles())
    second.setHandles(first.handles());
  if (second.organ() != first.organ())
    second.setOrgan(first.organ());
}

} // namespace viscera::app

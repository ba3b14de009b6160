#include "window/compare/compared_system.h"

namespace viscera::app {
namespace {

constexpr const char* kWithoutCage = "t-celestial";

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

QComboBox* ComparedSystem::makeChooser() {
  chooser_ = new QComboBox;
  chooser_->setObjectName(QStringLiteral("secondSystem"));
  chooser_->setAccessibleName(tr("Coordinates of the second view"));
  chooser_->setToolTip(tr("The coordinates that tie the same organs to the same handles in this view"));
  chooser_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  chooser_->setMinimumContentsLength(14);
  for (const plugin::Registry::Entry& entry : second_.registry().list())
    chooser_->addItem(text(entry.system->name()), text(entry.system->id()));
  chooser_->setCurrentIndex(chooser_->findData(text(choice_->id)));
  connect(chooser_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { choose(chooser_->itemData(index).toString().toStdString()); });
  return chooser_;
}

void ComparedSystem::choose(const std::string& id) {
  auto choice = std::make_shared<document::SystemChoice>();
  choice->id = id;
  choice_ = std::move(choice);
  if (chooser_)
    chooser_->setCurrentIndex(chooser_->findData(text(id)));
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

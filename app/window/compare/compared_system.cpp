#include "window/compare/compared_system.h"

namespace viscera::app {
namespace {

constexpr const char* kWithoutCage = "t-celestial";

std::string firstChoice(const document::SystemChoice& other) {
  return other.id == kWithoutCage ? document::SystemChoice().id : kWithoutCage;
}

} // namespace

ComparedSystem::ComparedSystem(const Side& first, const HandleScene& handles, const Side& second,
                               MessageBar* messages, QObject* parent)
    : QObject(parent), first_(first), second_(second), poses_(second.workspace, view_),
      firstHandles_(handles),
      handles_(std::make_unique<HandleScene>(second.workspace, poses_, view_, second.view.view())),
      messages_(second.workspace, messages, nullptr, &first.workspace) {
  auto choice = std::make_shared<document::SystemChoice>();
  choice->id = firstChoice(first.workspace.document().system());
  choice_ = std::move(choice);
  connect(handles_.get(), &HandleScene::changed, &second.view, &ViewWidget::scheduleRender);
  connect(&first.organs, &OrganScene::changed, this, &ComparedSystem::followLook);
  connect(&handles, &HandleScene::changed, this, &ComparedSystem::followLook);
  subscriptions_.push_back(first.workspace.selection().onChange([this] { followSelection(); }));
}

ComparedSystem::~ComparedSystem() {
  second_.organs.setGhostShown(false);
  second_.organs.setInfluenceShown(false);
}

QComboBox* ComparedSystem::makeChooser() {
  chooser_ = new QComboBox;
  chooser_->setObjectName(QStringLiteral("secondSystem"));
  chooser_->setAccessibleName(tr("Coordinates of the second view"));
  chooser_->setToolTip(tr("The coordinates that tie the same organs to the same handles in this view"));
  chooser_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  chooser_->setMinimumContentsLength(14);
  for (const plugin::Registry::Entry& entry : second_.workspace.registry().list())
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

void ComparedSystem::mirrored() {
  followSelection();
  followLook();
}

document::DocumentState ComparedSystem::applied(document::DocumentState state) const {
  state.system = choice_;
  return state;
}

void ComparedSystem::followLook() {
  if (second_.organs.ghostShown() != first_.organs.ghostShown())
    second_.organs.setGhostShown(first_.organs.ghostShown());
  if (second_.organs.influenceShown() != first_.organs.influenceShown())
    second_.organs.setInfluenceShown(first_.organs.influenceShown());
  view_.change([this](presentation::ViewState& view) { view.handles = firstHandles_.shown(); });
}

void ComparedSystem::followSelection() {
  const document::Selection& first = first_.workspace.selection();
  document::Selection& second = second_.workspace.selection();
  if (second.handles() != first.handles())
    second.setHandles(first.handles());
  if (second.organ() != first.organ())
    second.setOrgan(first.organ());
}

} // namespace viscera::app

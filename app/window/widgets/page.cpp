#include "window/widgets/page.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::app {
namespace {

constexpr int kPageSpacing = 8;

} // namespace

CollapsibleSection::CollapsibleSection(const QString& title, QWidget* contents, bool open, QWidget* parent)
    : QWidget(parent), title_(new QToolButton(this)), contents_(contents) {
  auto* column = makeLayout<QVBoxLayout>(this, 4);
  title_->setObjectName(QStringLiteral("foldTitle"));
  title_->setText(title);
  title_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  title_->setCheckable(true);
  title_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  embolden(title_);
  column->addWidget(title_);
  column->addWidget(contents_);
  connect(title_, &QToolButton::toggled, this, &CollapsibleSection::setOpen);
  setOpen(open);
}

void CollapsibleSection::setOpen(bool open) {
  title_->setChecked(open);
  title_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  contents_->setVisible(open);
}

bool CollapsibleSection::isOpen() const {
  return title_->isChecked();
}

Page::Page(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(12, 12, 12, 12);
  column_->setSpacing(kPageSpacing);
}

QWidget* Page::addSection(const QString& title) {
  auto* section = new QWidget(this);
  section_ = makeLayout<QVBoxLayout>(section, kPageSpacing);
  auto* head = new QWidget(section);
  auto* column = makeLayout<QVBoxLayout>(head);
  if (column_->count() > 0) {
    auto* line = new QFrame(head);
    line->setObjectName(QStringLiteral("line"));
    column->addSpacing(4);
    column->addWidget(line);
  }
  auto* label = new QLabel(title, head);
  label->setObjectName(QStringLiteral("sectionTitle"));
  column->addWidget(label);
  column_->addWidget(section);
  add(head);
  return section;
}

void Page::addFolded(const QString& title, QWidget* contents, bool open) {
  section_ = nullptr;
  add(new CollapsibleSection(title, contents, open, this));
}

void Page::add(QWidget* widget) {
  (section_ ? section_ : column_)->addWidget(widget);
  facts_ = nullptr;
}

QLabel* Page::addFact(const QString& name) {
  if (!facts_) {
    facts_ = new QGridLayout;
    facts_->setContentsMargins(0, 0, 0, 0);
    facts_->setHorizontalSpacing(12);
    facts_->setVerticalSpacing(4);
    facts_->setColumnStretch(1, 1);
    (section_ ? section_ : column_)->addLayout(facts_);
  }
  auto* label = new QLabel(name, this);
  label->setObjectName(QStringLiteral("muted"));
  auto* value = new WrappedLabel(this);
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  const int row = facts_->count() / 2;
  facts_->addWidget(label, row, 0, Qt::AlignLeft | Qt::AlignTop); // Beside the value's first line.
  facts_->addWidget(value, row, 1);
  value->setProperty("name", QVariant::fromValue<QWidget*>(label));
  return value;
}

void Page::setFactShown(QLabel* value, bool shown) {
  value->setVisible(shown);
  value->property("name").value<QWidget*>()->setVisible(shown);
}

QLabel* Page::addRemark(const QString& text) {
  QLabel* label = makeRemark(text, this);
  add(label);
  return label;
}

QPushButton* Page::addButton(QAction* action) {
  QPushButton* button = makeActionButton(action, this);
  add(button);
  return button;
}

void Page::addCheck(QAction* action) {
  auto* box = new QCheckBox(action->iconText(), this);
  box->setToolTip(action->toolTip());
  box->setChecked(action->isChecked());
  box->setEnabled(action->isEnabled());
  connect(box, &QCheckBox::clicked, action, &QAction::trigger);
  connect(action, &QAction::changed, box, [box, action] {
    box->setEnabled(action->isEnabled());
    box->setToolTip(action->toolTip());
  });
  connect(action, &QAction::toggled, box, &QCheckBox::setChecked);
  add(box);
}

void Page::finish() {
  column_->addStretch(1);
}

} // namespace viscera::app

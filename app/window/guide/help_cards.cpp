#include "window/guide/help_cards.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QShowEvent>
#include <QTextEdit>
#include <QToolButton>

#include <algorithm>
#include <utility>

#include "window/guide/key_table.h"
#include "window/widgets/flow_layout.h"
#include "window/widgets/pointing_frame.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

/// The card of the welcome takes one in so many parts of the view's height at most,
constexpr int kPartsOfView = 3;
/// and leaves so much of its width free at the sides.
constexpr int kBesideCard = 24;

/// Adds the actions with a key, menu by menu, each once.
void collect(const QList<QAction*>& actions, QList<QAction*>& found) {
  for (QAction* action : actions) {
    if (action->menu())
      collect(action->menu()->actions(), found);
    else if (!action->shortcuts().isEmpty() && !found.contains(action))
      found.push_back(action);
  }
}

} // namespace

WelcomeCard::WelcomeCard(QMenu* samples, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("welcomeCard"));
  auto* outer = makeLayout<QHBoxLayout>(this, 8, {16, 8, 8, 8});
  auto* row = new FlowLayout(nullptr, 8);
  outer->addLayout(row, 1);
  auto* title = new QLabel(tr("Welcome"), this);
  embolden(title);
  row->addWidget(title);
  const auto addButton = [&](const QString& label, const QString& tip) {
    auto* button = new QPushButton(label, this);
    button->setToolTip(tip);
    row->addWidget(button);
    return button;
  };
  auto* open = addButton(tr("Open a patient..."), tr("Choose organ surfaces of a patient (Ctrl+O)"));
  auto* sample = addButton(tr("Sample organs"), tr("Organs that come with the program"));
  auto* task = addButton(tr("First task"), tr("Drag a dot, and see the organ follow"));
  task->setObjectName(QStringLiteral("firstTask"));
  auto* tour = addButton(tr("Two-minute tour"), tr("The parts of the window, step by step"));
  title->setMinimumHeight(open->sizeHint().height());
  title->setContentsMargins(0, 0, 4, 0);
  sample->setMenu(samples);
  sample->setObjectName(QStringLiteral("menuButton"));
  auto* closeButton =
      makeIconButton("close", tr("Close this card (Help > Welcome shows it again)"), this, 14);
  closeButton->setAccessibleName(tr("Close this card"));
  closeButton->setMinimumHeight(open->sizeHint().height());
  outer->addWidget(closeButton, 0, Qt::AlignTop); // In the first row, however many there are.
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  lesser_ = {title, task, tour, open};
  parent->installEventFilter(this);
  connect(open, &QPushButton::clicked, this, &WelcomeCard::openRequested);
  connect(task, &QPushButton::clicked, this, &WelcomeCard::taskRequested);
  connect(tour, &QPushButton::clicked, this, &WelcomeCard::tourRequested);
  connect(closeButton, &QToolButton::clicked, this, [this] {
    hide();
    Q_EMIT closed();
  });
}

bool WelcomeCard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible())
    fit();
  return QFrame::eventFilter(watched, event);
}

void WelcomeCard::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  fit();
}

void WelcomeCard::fit() {
  const QSize room = parentWidget()->size();
  for (QWidget* part : findChildren<QWidget*>())
    part->ensurePolished(); // Before, it has another size.
  for (QWidget* part : lesser_)
    part->show();
  for (QWidget* part : lesser_)
    if (heightIn(room.width()) > room.height() / kPartsOfView)
      part->hide();
  Q_EMIT heightTaken(heightIn(room.width()));
}

/// The height of the card in a view of that width.
int WelcomeCard::heightIn(int width) const {
  return layout()->totalHeightForWidth(std::min(width - kBesideCard, layout()->totalSizeHint().width()));
}

/// Not where the window is hidden with all that is in it.
void WelcomeCard::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  if (isHidden())
    Q_EMIT heightTaken(0);
}

TourCard::TourCard(std::vector<TourStep> steps, QWidget* parent)
    : QFrame(parent), steps_(std::move(steps)), title_(new QLabel(this)), count_(new QLabel(this)),
      text_(new QLabel(this)), back_(new QPushButton(tr("Back"), this)), next_(new QPushButton(this)) {
  setObjectName(QStringLiteral("welcomeCard"));
  setFixedWidth(400);
  auto* column = makeLayout<QVBoxLayout>(this, 8, {16, 10, 12, 14});
  auto* heading = new QHBoxLayout;
  embolden(title_, 1.25);
  count_->setObjectName(QStringLiteral("muted"));
  auto* closeButton = makeIconButton("close", tr("End the tour"), this, 14);
  heading->addWidget(title_, 1);
  heading->addWidget(count_);
  heading->addWidget(closeButton);
  column->addLayout(heading);
  text_->setWordWrap(true);
  column->addWidget(text_);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  next_->setObjectName(QStringLiteral("primary"));
  column->addLayout(buttons);
  connect(closeButton, &QToolButton::clicked, this, &QWidget::hide);
  connect(back_, &QPushButton::clicked, this, [this] { goTo(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] {
    if (step_ + 1 < steps_.size())
      goTo(step_ + 1);
    else
      hide();
  });
  hide();
}

TourCard::~TourCard() {
  dropFrames();
}

void TourCard::start() {
  show();
  goTo(0);
  raise();
  next_->setFocus();
  qApp->installEventFilter(this);
}

namespace {

/// Whether a widget takes letters or chooses by Return, so that the keys of the tour are its own.
bool takesKeys(const QWidget* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QTextEdit*>(widget) ||
         qobject_cast<const QPlainTextEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QComboBox*>(widget) || qobject_cast<const QMenu*>(widget) ||
         (qobject_cast<const QAbstractButton*>(widget) && widget->hasFocus());
}

} // namespace

bool TourCard::eventFilter(QObject* watched, QEvent* event) {
  const bool override = event->type() == QEvent::ShortcutOverride;
  if ((!override && event->type() != QEvent::KeyPress) || !isVisible())
    return QFrame::eventFilter(watched, event);
  const auto* pressed = static_cast<QKeyEvent*>(event);
  const int key = pressed->key();
  const auto* widget = qobject_cast<QWidget*>(watched);
  const bool ours = (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space) &&
                    (pressed->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (!ours || !widget || widget->window() != window() || (takesKeys(widget) && !isAncestorOf(widget)))
    return QFrame::eventFilter(watched, event);
  event->accept();
  if (!override && !pressed->isAutoRepeat())
    next_->click();
  return true;
}

void TourCard::goTo(std::size_t step) {
  step_ = step;
  const TourStep& present = steps_[step];
  title_->setText(present.title);
  text_->setText(present.text);
  count_->setText(tr("%1 of %2").arg(step + 1).arg(steps_.size()));
  back_->setEnabled(step > 0);
  next_->setText(step + 1 < steps_.size() ? tr("Next") : tr("Done"));
  if (present.enter)
    present.enter();
  adjustSize();
  dropFrames();
  for (const QString& name : present.targets)
    if (auto* target = window()->findChild<QWidget*>(name))
      frames_.push_back(new PointingFrame(*target));
}

/// Later: the frames are the window's children, and it may be hiding or deleting its children just now.
void TourCard::dropFrames() {
  for (const QPointer<PointingFrame>& frame : frames_)
    if (frame)
      frame->deleteLater();
  frames_.clear();
}

void TourCard::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  if (event->spontaneous()) // The window was merely minimised.
    return;
  qApp->removeEventFilter(this);
  dropFrames();
}

ShortcutCard::ShortcutCard(const QMenuBar& menus, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("welcomeCard"));
  auto* column = makeLayout<QVBoxLayout>(this, -1, {16, 10, 8, 12});
  auto* heading = new QHBoxLayout;
  auto* title = new QLabel(tr("Mouse and keys"), this);
  embolden(title, 1.25);
  auto* closeButton = makeIconButton("close", tr("Close (Esc)"), this, 14);
  closeButton->setAccessibleName(tr("Close"));
  connect(closeButton, &QToolButton::clicked, this, &QWidget::hide);
  heading->addWidget(title, 1);
  heading->addWidget(closeButton);
  column->addLayout(heading);
  std::vector<std::pair<QString, QString>> rows = {{tr("Left drag"), tr("Rotate, or move a handle")},
                                                   {tr("Middle, Shift+left drag"), tr("Pan")},
                                                   {tr("Right drag, wheel"), tr("Zoom")},
                                                   {tr("Click"), tr("Select, or add a handle")},
                                                   {tr("Shift or Ctrl+click"), tr("Add to the selection")},
                                                   {tr("Esc"), tr("Cancel a drag, close a message")}};
  QList<QAction*> actions;
  collect(menus.actions(), actions);
  for (const QAction* action : actions) {
    QString meaning = action->text();
    meaning.remove(QLatin1Char('&'));
    rows.emplace_back(action->shortcut().toString(QKeySequence::NativeText), meaning);
  }
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("panelScroll"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(new KeyTable(rows, scroll));
  scroll->setMinimumSize(200, 100);
  column->addWidget(scroll, 1);
  const QSize content = scroll->widget()->sizeHint();
  scroll->setMaximumHeight(content.height() + 4);
  setMaximumWidth(content.width() + 48);
  hide();
}

} // namespace viscera::app

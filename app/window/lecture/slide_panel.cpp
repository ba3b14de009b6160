#include "window/lecture/slide_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QListWidget>
#include <QTimer>

#include "window/widgets/ready_made.h"

namespace viscera::app {

SlidePanel::SlidePanel(Slides& slides, const Actions& actions, QWidget* parent)
    : QWidget(parent), slides_(slides), list_(new QListWidget(this)) {
  auto* column = makeLayout<QVBoxLayout>(this, 6, {8, 4, 8, 8});
  auto* buttons = makeLayout<QHBoxLayout>(nullptr, 2);
  for (const char* id : {"slides.add", "slides.remove", "slides.previous", "slides.next", "view.lecture"}) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(actions[id]);
    button->setAutoRaise(true);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  column->addLayout(buttons);
  list_->setObjectName(QStringLiteral("slideList"));
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  column->addWidget(list_, 1);
  column->addWidget(makeRemark(
      tr("Keep views as slides, then show them with F5 and Page Down. The session keeps them."), this));
  connect(&slides, &Slides::changed, this, &SlidePanel::fill);
  connect(list_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { slides_.show(list_->row(item)); });
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (!filling_)
      slides_.rename(list_->row(item), item->text());
  });
  // The list has moved its row already and is filled anew, which must not happen within its own event.
  connect(list_->model(), &QAbstractItemModel::rowsMoved, this,
          [this](const QModelIndex&, int from, int, const QModelIndex&, int before) {
            QTimer::singleShot(
                0, this, [this, from, to = before > from ? before - 1 : before] { slides_.move(from, to); });
          });
  fill();
}

void SlidePanel::fill() {
  filling_ = true;
  const int count = static_cast<int>(slides_.all().size());
  while (list_->count() > count)
    delete list_->takeItem(list_->count() - 1);
  for (int row = 0; row < count; ++row) {
    if (row >= list_->count())
      list_->addItem(QString());
    QListWidgetItem* item = list_->item(row);
    item->setText(QString::fromStdString(slides_.all()[static_cast<std::size_t>(row)].caption));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled);
  }
  list_->setCurrentRow(slides_.current());
  filling_ = false;
}

} // namespace viscera::app

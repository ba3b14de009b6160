#include "window/play/sequence_list.h"

#include <QEvent>
#include <QFile>
#include <QSignalBlocker>

#include <algorithm>

#include "viscera/live/sequence_setup.h"
#include "viscera/presentation/presenter.h"
#include "window/style/icon.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

constexpr QSize kPicture(76, 57);
constexpr int kPictureColumns = 3;

/// The picture for a light or a dark panel; sequences of the user have a sign.
QIcon pictureOf(const QString& id, bool dark) {
  const QString file = QStringLiteral(":/viscera/sequences/%1_%2.png")
                           .arg(id, dark ? QStringLiteral("dark") : QStringLiteral("light"));
  if (!QFile::exists(file))
    return icon("beat");
  QIcon picture(file);
  picture.addFile(file, {}, QIcon::Selected); // Framed, not tinted: a tinted one looks disabled.
  return picture;
}

} // namespace

SequenceList::SequenceList(Workspace& workspace, Playback& playback, QWidget* parent)
    : QListWidget(parent), workspace_(workspace), playback_(playback) {
  setObjectName(QStringLiteral("sequenceList"));
  setAccessibleName(tr("Sequences"));
  setViewMode(IconMode);
  setMovement(Static);
  setResizeMode(Adjust);
  setWordWrap(true);
  setIconSize(kPicture);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  const auto choose = [this](QListWidgetItem* item) {
    Q_EMIT sequenceChosen(item->data(Qt::UserRole).toString());
  };
  connect(this, &QListWidget::itemClicked, this, choose);
  connect(this, &QListWidget::itemActivated, this, [this, choose](QListWidgetItem* item) {
    if (!QListWidget::underMouse()) // A click was told already.
      choose(item);
  });
  connect(&playback, &Playback::stateChanged, this, &SequenceList::rebuild);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      rebuild();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { rebuild(); }));
  rebuild();
}

void SequenceList::addSequence(const Item& one) {
  const bool dark = palette().color(QPalette::Base).lightness() < 128;
  auto* item = new QListWidgetItem(pictureOf(one.id, dark), one.name, this);
  item->setData(Qt::UserRole, one.id);
  item->setToolTip(one.tip);
  item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
}

std::vector<SequenceList::Item> SequenceList::wanted() const {
  std::vector<Item> items;
  const auto add = [&](const QString& id, const QString& name, const QString& tip) {
    if (std::none_of(items.begin(), items.end(), [&](const Item& item) { return item.id == id; }))
      items.push_back({id, name, tip});
  };
  const auto organ = workspace_.currentOrgan();
  const bool own = organ && organ->origin.sample.empty();
  for (const live::SampleSequence& sample : live::sampleSequences())
    if (own && live::matchesOrgan(sample, organ->name) == live::SequenceMatch::yes)
      add(text(sample.id), inWords(sample.name),
          tr("%1: can be fitted to %2").arg(inWords(sample.name), inWords(presentation::labelOf(*organ))));
  for (const live::SampleSequence& sample : live::sampleSequences())
    add(text(sample.id), inWords(sample.name),
        tr("%1: shows the sample organ and plays").arg(inWords(sample.name)));
  for (const Playback::Motion& motion : playback_.motions())
    add(text(motion.sequence->id()), inWords(motion.sequence->name()), inWords(motion.sequence->name()));
  return items;
}

void SequenceList::rebuild() {
  std::vector<Item> items = wanted();
  if (items != shown_) {
    const QSignalBlocker quiet(this);
    clear();
    for (const Item& item : items)
      addSequence(item);
    shown_ = std::move(items);
    setFixedHeight(sizeHint().height()); // Another number of pictures may need another line.
  }
  syncCurrent();
}

void SequenceList::syncCurrent() {
  const QSignalBlocker quiet(this);
  const sequences::Sequence* sequence = playback_.sequence();
  setCurrentRow(-1);
  for (int row = 0; sequence && row < count(); ++row)
    if (item(row)->data(Qt::UserRole).toString() == text(sequence->id()))
      setCurrentRow(row);
}

QSize SequenceList::sizeHint() const {
  const int lines = (count() + kPictureColumns - 1) / kPictureColumns;
  return {kPictureColumns * kPicture.width(), lines * gridSize().height() + 4};
}

void SequenceList::resizeEvent(QResizeEvent* event) {
  const int line = kPicture.height() + 2 * fontMetrics().height() + 16;
  const QSize grid((viewport()->width() - 1) / kPictureColumns, line);
  if (grid != gridSize()) {
    setGridSize(grid);
    setFixedHeight(sizeHint().height());
  }
  QListWidget::resizeEvent(event);
}

void SequenceList::changeEvent(QEvent* event) {
  QListWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange)
    return;
  const bool dark = palette().color(QPalette::Base).lightness() < 128;
  for (int row = 0; row < count(); ++row)
    item(row)->setIcon(pictureOf(item(row)->data(Qt::UserRole).toString(), dark));
}

} // namespace viscera::app

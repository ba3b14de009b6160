#include "window/panels/sequence_list.h"

#include <QEvent>
#include <QFile>
#include <QSignalBlocker>

#include "viscera/motion/sequence_setup.h"
#include "window/style/icon.h"

namespace viscera::app {
namespace {

constexpr QSize kPicture(76, 57);
constexpr int kColumns = 3;

/// The picture for a light or a dark panel; sequences of the user have a sign.
QIcon pictureOf(const QString& id, bool dark) {
  const QString file = QStringLiteral(":/viscera/sequences/%1_%2.png")
                           .arg(id, dark ? QStringLiteral("dark") : QStringLiteral("light"));
  return QFile::exists(file) ? QIcon(file) : icon("beat");
}

} // namespace

SequenceList::SequenceList(Playback& playback, QWidget* parent) : QListWidget(parent), playback_(playback) {
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
  rebuild();
}

void SequenceList::addSequence(const QString& id, const QString& name, const QString& tip) {
  const bool dark = palette().color(QPalette::Base).lightness() < 128;
  auto* item = new QListWidgetItem(pictureOf(id, dark), name, this);
  item->setData(Qt::UserRole, id);
  item->setToolTip(tip);
  item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
}

void SequenceList::rebuild() {
  std::vector<std::pair<QString, QString>> all;
  for (const motion::SampleSequence& sample : motion::sampleSequences())
    all.emplace_back(text(sample.id), text(sample.name));
  const std::size_t ours = all.size();
  for (const Playback::Motion& motion : playback_.motions()) {
    const std::pair<QString, QString> one(text(motion.sequence->id()), text(motion.sequence->name()));
    const auto known = [&](const auto& other) { return other.first == one.first; };
    if (std::none_of(all.begin(), all.end(), known))
      all.push_back(one);
  }
  const auto shown = [this](std::size_t row) {
    return item(static_cast<int>(row))->data(Qt::UserRole).toString();
  };
  bool same = count() == static_cast<int>(all.size());
  for (std::size_t row = 0; same && row < all.size(); ++row)
    same = shown(row) == all[row].first;
  if (!same) {
    const QSignalBlocker quiet(this);
    clear();
    for (std::size_t row = 0; row < all.size(); ++row)
      addSequence(all[row].first, all[row].second,
                  row < ours ? tr("%1: shows the sample organ and plays").arg(all[row].second)
                             : all[row].second);
    updateGeometry();
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
  const int lines = (count() + kColumns - 1) / kColumns;
  return {kColumns * kPicture.width(), lines * gridSize().height() + 4};
}

void SequenceList::resizeEvent(QResizeEvent* event) {
  const int line = kPicture.height() + 2 * fontMetrics().height() + 16;
  const QSize grid((viewport()->width() - 1) / kColumns, line);
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

#include "window/guide/key_table.h"

#include <QLabel>
#include <QResizeEvent>

#include <algorithm>

namespace viscera::app {
namespace {

constexpr int kBesideKeys = 12;
constexpr int kBetweenKeyColumns = 28;
constexpr int kBetweenKeyRows = 4;
constexpr int kBetweenStackedRows = 10;
constexpr int kColumnsOfKeys = 2;

/// The width of a text on one line; a pixel more at each end, or rounding breaks it.
int lineWidth(const QLabel& label) {
  return label.fontMetrics().size(Qt::TextSingleLine, label.text()).width() + 2;
}

/// The width of its longest word.
int leastWidth(const QLabel& label) {
  return label.minimumSizeHint().width();
}

} // namespace

KeyTable::KeyTable(const std::vector<std::pair<QString, QString>>& rows, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("page"));
  setAttribute(Qt::WA_StyledBackground);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  for (const auto& [keys, meaning] : rows) {
    const Row row{new QLabel(keys, this), new QLabel(meaning, this)};
    row.meaning->setObjectName(QStringLiteral("muted"));
    for (QLabel* label : {row.keys, row.meaning}) {
      label->setWordWrap(true);
      label->ensurePolished(); // Its type is what widths come from.
    }
    rows_.push_back(row);
  }
}

QSize KeyTable::sizeHint() const {
  int keys = 0, meaning = 0;
  for (const Row& row : rows_) {
    keys = std::max(keys, lineWidth(*row.keys));
    meaning = std::max(meaning, lineWidth(*row.meaning));
  }
  const int width =
      kColumnsOfKeys * (keys + kBesideKeys + meaning) + (kColumnsOfKeys - 1) * kBetweenKeyColumns;
  return {width, arrange(width, false)};
}

QSize KeyTable::minimumSizeHint() const {
  int width = 0;
  for (const Row& row : rows_)
    width = std::max({width, leastWidth(*row.keys), leastWidth(*row.meaning)});
  return {width, 1};
}

int KeyTable::heightForWidth(int width) const {
  return arrange(width, false);
}

void KeyTable::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange(width(), true);
}

KeyTable::Shares KeyTable::sharesOf(int width) const {
  int keys = 0, leastKeys = 0, leastMeaning = 0;
  for (const Row& row : rows_) {
    keys = std::max(keys, lineWidth(*row.keys));
    leastKeys = std::max(leastKeys, leastWidth(*row.keys));
    leastMeaning = std::max(leastMeaning, leastWidth(*row.meaning));
  }
  for (int columns = kColumnsOfKeys; columns > 0; --columns) {
    const int each = (width - (columns - 1) * kBetweenKeyColumns) / columns - kBesideKeys;
    if (leastKeys + leastMeaning > each)
      continue;
    // Some of what the mouse does is longer than keys are: it takes two lines before meanings do.
    const int share = std::clamp(each / 2, leastKeys, each - leastMeaning);
    const int taken = std::min(keys, share);
    return {columns, taken, each - taken, false};
  }
  return {1, width, width, true};
}

int KeyTable::arrange(int width, bool place) const {
  const Shares shares = sharesOf(width);
  const std::size_t inColumn = (rows_.size() + static_cast<std::size_t>(shares.columns) - 1) /
                               static_cast<std::size_t>(shares.columns);
  const Qt::Alignment side = shares.stacked ? Qt::AlignLeft : Qt::AlignRight;
  int left = 0, y = 0, lowest = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (i > 0 && i % inColumn == 0) {
      left += shares.keys + kBesideKeys + shares.meaning + kBetweenKeyColumns;
      y = 0;
    }
    const Row& row = rows_[i];
    const int keys = row.keys->heightForWidth(shares.keys);
    const int meaning = row.meaning->heightForWidth(shares.meaning);
    const int height = shares.stacked ? keys + meaning : std::max(keys, meaning);
    if (place) {
      row.keys->setAlignment(side | Qt::AlignVCenter);
      row.keys->setGeometry(left, y, shares.keys, shares.stacked ? keys : height);
      row.meaning->setGeometry(shares.stacked ? left : left + shares.keys + kBesideKeys,
                               shares.stacked ? y + keys : y, shares.meaning,
                               shares.stacked ? meaning : height);
    }
    lowest = std::max(lowest, y + height);
    y += height + (shares.stacked ? kBetweenStackedRows : kBetweenKeyRows);
  }
  return lowest;
}

} // namespace viscera::app

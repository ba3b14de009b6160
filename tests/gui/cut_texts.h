#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QListView>
#include <QRadioButton>
#include <QScrollArea>
#include <QStatusBar>
#include <QStyleOptionComboBox>
#include <QStyleOptionFrame>
#include <QStyleOptionHeader>
#include <QStyleOptionTab>
#include <QTabBar>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "window/compare/side_header.h"
#include "window/widgets/elided_check.h"
#include "window/widgets/elided_label.h"
#include "window/widgets/system_combo.h"

namespace viscera::tests {

/// The texts of a window that can be seen and are cut off, each with its place and the logical pixels that it
/// lacks. What may be cut off is excused here, each with its reason; nothing else is.
using CutTexts = std::set<std::string>;

/// What no widget need show to the pixel.
inline constexpr int kCutRounding = 1;

inline void noteCut(const std::string& where, const QString& text, int lack, CutTexts& cut) {
  if (lack > kCutRounding)
    cut.insert(where + ": \"" + text.toStdString() + "\" lacks " + std::to_string(lack) + " pixels");
}

/// Whether a text says that it gives way: it ends in an ellipsis, and its whole is in the tip.
inline bool saysItIsCut(const QString& text, const QWidget& widget) {
  return text.contains(QChar(0x2026)) && !widget.toolTip().isEmpty();
}

/// Labels that may end with an ellipsis: the hint in the status bar says again what the tip of the mode's
/// button says; the source of normal ranges has first gone through its shorter forms; the header of a
/// compared view has the names of an organ and of a phase and volumes in whatever room two views leave.
inline bool mayShorten(const app::ElidedLabel& label) {
  return qobject_cast<const QStatusBar*>(label.parentWidget()) ||
         label.objectName() == QLatin1String("chartSource") ||
         qobject_cast<const app::SideHeader*>(label.parentWidget());
}

inline int lackOf(const QLabel& label) {
  if (const auto* elided = qobject_cast<const app::ElidedLabel*>(&label)) {
    const bool whole = !elided->text().isEmpty() && !elided->text().contains(QChar(0x2026)); // In some form.
    return whole || mayShorten(*elided) ? 0
                                        : std::max(0, elided->widthFor(elided->fullText()) - elided->width());
  }
  if (label.text().isEmpty() || saysItIsCut(label.text(), label))
    return 0;
  if (label.wordWrap())
    return std::max(0, label.heightForWidth(label.width()) - label.height());
  return std::max(0, label.sizeHint().width() - label.width());
}

/// Boxes that shorten leave some letters, and the tip has the whole.
inline int lackOf(const QAbstractButton& button) {
  constexpr int kFewestOfAName = 3;
  const auto* named = qobject_cast<const app::ElidedCheck*>(&button);
  if (named && named->shownText().size() > kFewestOfAName)
    return 0;
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  if (button.text().isEmpty() || saysItIsCut(button.text(), button) ||
      (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()))
    return 0;
  const bool marked = qobject_cast<const QCheckBox*>(&button) || qobject_cast<const QRadioButton*>(&button);
  const int wide = marked ? button.sizeHint().width()
                          : button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width();
  return std::max(0, wide - button.width());
}

/// Of the entry that a closed list shows. One that shortens its entry leaves some letters, and the tooltip
/// has the whole.
inline int lackOf(const QComboBox& list) {
  constexpr int kFewestLetters = 3;
  const auto* system = qobject_cast<const app::SystemCombo*>(&list);
  if (system && system->shownText().size() > kFewestLetters)
    return 0;
  QStyleOptionComboBox option;
  option.initFrom(&list);
  option.editable = list.isEditable();
  const int wide =
      list.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &list).width();
  const int icon = list.itemIcon(list.currentIndex()).isNull() ? 0 : list.iconSize().width() + 4;
  return std::max(0, list.fontMetrics().size(0, list.currentText()).width() + icon - wide);
}

inline QString textOf(const QLabel& label) {
  const auto* elided = qobject_cast<const app::ElidedLabel*>(&label);
  return elided ? elided->fullText() : label.text();
}
inline QString textOf(const QAbstractButton& button) {
  return button.text();
}
inline QString textOf(const QComboBox& list) {
  return list.currentText();
}

template <class Widget>
void collectCut(const QWidget& window, const std::string& where, CutTexts& cut) {
  for (const auto* widget : window.findChildren<Widget*>())
    if (widget->isVisible())
      noteCut(where, textOf(*widget), lackOf(*widget), cut);
}

/// What a spin box's field has for its text.
inline int roomOf(const QLineEdit& field) {
  constexpr int kMarginOfQt = 2; // QLineEdit leaves it on both sides and writes on one if it has to.
  QStyleOptionFrame option;
  option.initFrom(&field);
  option.rect = field.contentsRect();
  option.lineWidth = field.hasFrame() ? field.style()->pixelMetric(QStyle::PM_DefaultFrameWidth) : 0;
  option.state |= QStyle::State_Sunken;
  const QRect inside = field.style()->subElementRect(QStyle::SE_LineEditContents, &option, &field);
  const QMargins margins = field.textMargins();
  return inside.width() - margins.left() - margins.right() - kMarginOfQt;
}

/// The number as it stands, with prefix and unit, and the words that stand for the smallest number, which one
/// step brings.
inline void collectCutNumbers(const QWidget& window, const std::string& where, CutTexts& cut) {
  for (const auto* box : window.findChildren<QAbstractSpinBox*>()) {
    const auto* field = box->findChild<QLineEdit*>();
    if (!field || !box->isVisible())
      continue;
    for (const QString& text : {box->text(), box->specialValueText()})
      noteCut(where, text, field->fontMetrics().horizontalAdvance(text) - roomOf(*field), cut);
  }
}

/// The names of columns. None is excused: a name of a column that cannot be read names nothing.
inline void collectCutHeads(const QWidget& window, const std::string& where, CutTexts& cut) {
  for (const auto* head : window.findChildren<QHeaderView*>()) {
    if (head->orientation() == Qt::Vertical)
      continue;
    for (int section = 0; head->isVisible() && head->model() && section < head->count(); ++section) {
      const QString text = head->model()->headerData(section, head->orientation()).toString();
      if (text.isEmpty() || head->isSectionHidden(section))
        continue;
      QStyleOptionHeader option;
      option.initFrom(head);
      option.state |= QStyle::State_Horizontal;
      option.rect = QRect(0, 0, head->sectionSize(section), head->height());
      option.section = section;
      option.orientation = head->orientation();
      option.text = text;
      const int room = head->style()->subElementRect(QStyle::SE_HeaderLabel, &option, head).width();
      noteCut(where, text, head->fontMetrics().size(0, text).width() - room, cut);
    }
  }
}

/// The entries of one list, tree or table. Excused is an entry with a tip: the views put an ellipsis where
/// they shorten, and the tip has the whole name of an organ, a measurement, a file or a reading, which are of
/// any length. In lists of pictures (`QListView::IconMode`) names stand in several lines below them.
inline void collectCutEntries(const QAbstractItemView& view, const std::string& where, CutTexts& cut) {
  const QAbstractItemModel& model = *view.model();
  const auto* pictures = qobject_cast<const QListView*>(&view);
  if (pictures && pictures->viewMode() == QListView::IconMode)
    return;
  const auto* tree = qobject_cast<const QTreeView*>(&view);
  std::vector<QModelIndex> parents = {view.rootIndex()};
  while (!parents.empty()) {
    const QModelIndex parent = parents.back();
    parents.pop_back();
    for (int row = 0; row < model.rowCount(parent); ++row) {
      const QModelIndex first = model.index(row, 0, parent);
      if (tree && tree->isExpanded(first))
        parents.push_back(first);
      for (int column = 0; column < model.columnCount(parent); ++column) {
        const QModelIndex entry = model.index(row, column, parent);
        const QRect place = view.visualRect(entry); // Empty where it is hidden or has no place.
        const QString text = entry.data().toString();
        if (place.isEmpty() || text.isEmpty() || !entry.data(Qt::ToolTipRole).toString().isEmpty() ||
            view.indexWidget(entry))
          continue;
        const bool scrolls = view.horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff;
        const int outside = scrolls ? 0 : std::max(0, place.right() - view.viewport()->rect().right());
        noteCut(where, text, view.sizeHintForIndex(entry).width() - place.width() + outside, cut);
      }
    }
  }
}

inline void collectCutEntries(const QWidget& window, const std::string& where, CutTexts& cut) {
  for (const auto* view : window.findChildren<QAbstractItemView*>())
    if (view->isVisible() && view->model() && !qobject_cast<const QHeaderView*>(view))
      collectCutEntries(*view, where, cut);
}

inline void collectCutTabs(const QWidget& window, const std::string& where, CutTexts& cut) {
  for (const auto* bar : window.findChildren<QTabBar*>())
    for (int tab = 0; bar->isVisible() && tab < bar->count(); ++tab) {
      if (bar->count() == 1)
        continue; // Qt draws no tab for a panel that is alone.
      QStyleOptionTab option;
      option.initFrom(bar);
      option.rect = bar->tabRect(tab);
      option.shape = bar->shape();
      option.text = bar->tabText(tab);
      const int room = bar->style()->subElementRect(QStyle::SE_TabBarTabText, &option, bar).width();
      const int outside = std::max(0, option.rect.right() - bar->rect().right());
      noteCut(where, option.text,
              bar->fontMetrics().size(Qt::TextShowMnemonic, option.text).width() - room + outside, cut);
    }
}

/// Labels, buttons and lists of one parent that lie over each other.
inline void collectOverlaps(const QWidget& window, const std::string& where, CutTexts& found) {
  const auto nameOf = [](const QWidget& widget) {
    const QString name = widget.objectName().isEmpty() ? widget.accessibleName() : widget.objectName();
    return std::string(widget.metaObject()->className()) + ' ' + name.toStdString();
  };
  std::map<const QWidget*, std::vector<const QWidget*>> siblings;
  for (const auto* widget : window.findChildren<QWidget*>()) {
    const bool speaks = qobject_cast<const QLabel*>(widget) || qobject_cast<const QAbstractButton*>(widget) ||
                        qobject_cast<const QComboBox*>(widget);
    if (!speaks || !widget->isVisible())
      continue;
    for (const QWidget* other : siblings[widget->parentWidget()])
      if (other->geometry().intersects(widget->geometry()))
        found.insert(where + ": " + nameOf(*other) + " lies over " + nameOf(*widget));
    siblings[widget->parentWidget()].push_back(widget);
  }
}

/// The words in the row of a page that asks for most width.
inline QString widestRowOf(const QWidget& page) {
  QStringList widest;
  int most = 0;
  for (const auto* layout : page.findChildren<QLayout*>()) {
    QStringList words;
    for (int i = 0; i < layout->count(); ++i)
      if (const QWidget* widget = layout->itemAt(i)->widget(); widget && widget->isVisible()) {
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        words += label ? textOf(*label) : button ? textOf(*button) : widget->objectName();
      }
    const int wanted = layout->minimumSize().width();
    if (!words.isEmpty() && wanted >= most) { // Of a row within a row, the inner one.
      most = wanted;
      widest = words;
    }
  }
  return widest.join(QStringLiteral(" | "));
}

/// Pages that scroll downwards only and are wider than what shows them: the right edge of each line is cut.
inline void collectPages(const QWidget& window, const std::string& where, CutTexts& found) {
  for (const auto* area : window.findChildren<QScrollArea*>())
    if (area->isVisible() && area->widget() && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff)
      noteCut(
          where,
          QStringLiteral("page %1, the widest row of which is %2")
              .arg(QLatin1String(area->widget()->metaObject()->className()), widestRowOf(*area->widget())),
          area->widget()->width() - area->viewport()->width(), found);
}

/// Panels that lie over each other: what is below asks for more width than the window has.
inline void collectOverlappingPanels(const QWidget& window, const std::string& where, CutTexts& found) {
  std::vector<const QDockWidget*> shown;
  for (const auto* panel : window.findChildren<QDockWidget*>()) {
    if (!panel->isVisible() || panel->isFloating() || !window.rect().intersects(panel->geometry()))
      continue; // Qt keeps a panel below another one's tab outside the window.
    for (const QDockWidget* other : shown)
      if (other->geometry().intersects(panel->geometry()))
        found.insert(where + ": panel " + panel->objectName().toStdString() + " lies over " +
                     other->objectName().toStdString());
    shown.push_back(panel);
  }
}

/// All of the above.
inline void collectAll(const QWidget& window, const std::string& where, CutTexts& found) {
  collectOverlappingPanels(window, where, found);
  collectCut<QLabel>(window, where, found);
  collectCut<QAbstractButton>(window, where, found);
  collectCut<QComboBox>(window, where, found);
  collectCutNumbers(window, where, found);
  collectCutHeads(window, where, found);
  collectCutEntries(window, where, found);
  collectCutTabs(window, where, found);
  collectOverlaps(window, where, found);
  collectPages(window, where, found);
}

} // namespace viscera::tests

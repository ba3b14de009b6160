#pragma once

#include <QWidget>

class QAction;
class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace viscera::app {

/// A section of a page that a click on its title folds and unfolds.
class CollapsibleSection final : public QWidget {
  Q_OBJECT

public:
  /// Takes `contents`.
  CollapsibleSection(const QString& title, QWidget* contents, bool open, QWidget* parent = nullptr);

  void setOpen(bool open);
  bool isOpen() const;

private:
  QToolButton* title_;
  QWidget* contents_;
};

/// A page of the properties panel: titled sections from top to bottom.
class Page : public QWidget {
  Q_OBJECT

public:
  explicit Page(QWidget* parent = nullptr);

protected:
  /// Begins a section; returns it, with its title, for `setSectionShown`.
  QWidget* addSection(const QString& title);
  /// Shows a section, or hides it where it would be empty: a page of dashes says nothing.
  static void setSectionShown(QWidget* section, bool shown) { section->setVisible(shown); }
  /// A section that can be folded, after the present one.
  void addFolded(const QString& title, QWidget* contents, bool open);
  void add(QWidget* widget);
  /// A line of a name and a value that can be selected; returns the value.
  QLabel* addFact(const QString& name);
  /// Shows or hides a line that `addFact` has made.
  static void setFactShown(QLabel* value, bool shown);
  /// A quiet sentence.
  QLabel* addRemark(const QString& text);
  /// A button that does an action of the window and shows its name and state.
  QPushButton* addButton(QAction* action);
  /// A check box for a checkable action.
  void addCheck(QAction* action);
  /// Call it last: the remaining space of the page stays empty.
  void finish();

private:
  QVBoxLayout* column_;            ///< Of the sections.
  QVBoxLayout* section_ = nullptr; ///< Of the present section; null between sections.
  QGridLayout* facts_ = nullptr;   ///< The layout of the present section, in which successive facts are
                                   ///< aligned: a grid gives values that break into lines their height.
};

} // namespace viscera::app

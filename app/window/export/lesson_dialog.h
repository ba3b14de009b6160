#pragma once

#include <QDialog>

#include "viscera/lesson/lesson_plan.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPlainTextEdit;
class QTableWidget;

namespace viscera::app {

/// A dialog that shows every text of a lesson to be checked and changed before export, and asks for the kind
/// of file.
class LessonDialog final : public QDialog {
  Q_OBJECT

public:
  explicit LessonDialog(const lesson::LessonPlan& plan, QWidget* parent = nullptr);

  /// The plan with the texts as they are in the dialog.
  lesson::LessonPlan plan() const;
  /// Whether the user chose a page; else animated glTF.
  bool wantsPage() const;

private:
  QWidget* makeTexts();
  /// A warning to show before the user passes the file on; empty for none.
  QString caution() const;

  mutable lesson::LessonPlan plan_; ///< `textsOf` returns references into it.
  QLineEdit* title_;
  QPlainTextEdit* notes_;
  QTableWidget* texts_;
  QComboBox* format_;
  QComboBox* language_;
  QCheckBox* handles_;
};

} // namespace viscera::app

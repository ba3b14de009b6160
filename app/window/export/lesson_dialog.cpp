#include "window/export/lesson_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr int kKind = 0, kText = 1;
constexpr std::size_t kInTheTable = 2; ///< Behind title and notes, which have fields of their own.

} // namespace

LessonDialog::LessonDialog(const lesson::LessonPlan& plan, QWidget* parent)
    : QDialog(parent), plan_(plan), title_(new QLineEdit(text(plan.title))),
      notes_(new QPlainTextEdit(text(plan.notes))), texts_(new QTableWidget), format_(new QComboBox),
      language_(new QComboBox), handles_(new QCheckBox(tr("Handles that a reader can drag"))) {
  setWindowTitle(tr("Export lesson"));
  setObjectName(QStringLiteral("lessonDialog"));
  resize(640, 540); // Of 1920 x 1200 pixels at 200 % a dialog has 960 x 600 less its frame.
  format_->addItem(tr("Web page for any browser (.html)"));
  format_->addItem(tr("Animated glTF scene (.glb)"));
  language_->setObjectName(QStringLiteral("lessonLanguage"));
  language_->addItem(tr("Language of the window"), QString());
  for (const lesson::PageLanguage& language : lesson::pageLanguages())
    language_->addItem(text(language.name), text(language.code));
  language_->setToolTip(tr("Language of the page's buttons and messages; the texts below stay as they are"));
  handles_->setChecked(plan.ownHandles || plan.placedHandles > 0);
  title_->setObjectName(QStringLiteral("lessonTitle"));
  notes_->setObjectName(QStringLiteral("lessonNotes"));
  notes_->setMaximumHeight(96);
  notes_->setTabChangesFocus(true);

  auto* remark = new QLabel(
      tr("A reader of the lesson sees only these texts: it holds no file names, no dates and no hidden "
         "organs. Check the texts for names of patients; double-click a text to change it.") +
      QLatin1Char(' ') + caution());
  remark->setWordWrap(true);
  auto* form = new QFormLayout;
  form->addRow(tr("Title"), title_);
  form->addRow(tr("Notes"), notes_);
  form->addRow(tr("Format"), format_);
  form->addRow(tr("Language"), language_);
  form->addRow(QString(), handles_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Save)->setText(tr("Save as..."));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(remark);
  column->addLayout(form);
  column->addWidget(makeTexts());
  column->addWidget(buttons);
}

QWidget* LessonDialog::makeTexts() {
  const std::vector<lesson::LessonText> all = lesson::textsOf(plan_);
  texts_->setObjectName(QStringLiteral("lessonTexts"));
  texts_->setAccessibleName(tr("Texts of the lesson"));
  texts_->setColumnCount(2);
  texts_->setRowCount(static_cast<int>(all.size() - kInTheTable));
  texts_->setHorizontalHeaderLabels({tr("Kind"), tr("Text")});
  texts_->horizontalHeader()->setSectionResizeMode(kKind, QHeaderView::ResizeToContents);
  texts_->horizontalHeader()->setSectionResizeMode(kText, QHeaderView::Stretch);
  texts_->verticalHeader()->hide();
  for (std::size_t i = kInTheTable; i < all.size(); ++i) {
    const int row = static_cast<int>(i - kInTheTable);
    auto* kind = new QTableWidgetItem(text(all[i].kind));
    kind->setFlags(Qt::ItemIsEnabled);
    texts_->setItem(row, kKind, kind);
    texts_->setItem(row, kText, new QTableWidgetItem(text(*all[i].text)));
    texts_->item(row, kText)->setToolTip(text(*all[i].text));
  }
  return texts_;
}

QString LessonDialog::caution() const {
  for (const lesson::PlannedSurface& surface : plan_.surfaces)
    for (const char* word : {"skin", "head", "face", "body"})
      if (text(surface.title).contains(QLatin1String(word), Qt::CaseInsensitive))
        return tr("The shape of a head or a face can identify a patient.");
  return {};
}

lesson::LessonPlan LessonDialog::plan() const {
  const std::vector<lesson::LessonText> all = lesson::textsOf(plan_);
  *all[0].text = title_->text().toStdString();
  *all[1].text = notes_->toPlainText().toStdString();
  for (std::size_t i = kInTheTable; i < all.size(); ++i)
    *all[i].text = texts_->item(static_cast<int>(i - kInTheTable), kText)->text().toStdString();
  lesson::LessonPlan plan = plan_;
  plan.language = language_->currentData().toString().toStdString();
  if (!handles_->isChecked()) {
    plan.ownHandles = false;
    plan.placedHandles = 0;
  }
  return plan;
}

bool LessonDialog::wantsPage() const {
  return format_->currentIndex() == 0;
}

} // namespace viscera::app

#include "window/guide/guide_window.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QUrl>

#include <algorithm>

#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr int kGuideWidth = 1000, kGuideHeight = 700, kListWidth = 280;
/// Headings below are in the page, but not in the list without a search.
constexpr int kListedLevel = 2;
constexpr int kPageRole = Qt::UserRole, kSectionRole = Qt::UserRole + 1;

} // namespace

GuideWindow::GuideWindow(QWidget* parent)
    : QDialog(parent, Qt::Window), pages_(guidePages()), search_(new QLineEdit), count_(new QLabel),
      sections_(new QListWidget), browser_(new QTextBrowser) {
  setObjectName(QStringLiteral("guide"));
  setWindowTitle(tr("User guide"));
  resize(kGuideWidth, kGuideHeight);
  auto* split = new QSplitter(this);
  makeLayout<QVBoxLayout>(this, 0, {8, 8, 8, 8})->addWidget(split);
  split->addWidget(makeList());
  browser_->setOpenLinks(false);
  browser_->document()->setDocumentMargin(12);
  browser_->setAccessibleName(windowTitle());
  split->addWidget(browser_);
  split->setStretchFactor(1, 1);
  split->setSizes({kListWidth, kGuideWidth - kListWidth});
  connect(browser_, &QTextBrowser::anchorClicked, this, &GuideWindow::follow);
  connect(search_, &QLineEdit::textChanged, this, &GuideWindow::search);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    if (sections_->count() > 0)
      sections_->setCurrentRow((sections_->currentRow() + 1) % sections_->count());
  });
  connect(sections_, &QListWidget::currentRowChanged, this, &GuideWindow::chooseRow);
  search();
}

QWidget* GuideWindow::makeList() {
  auto* box = new QWidget(this);
  auto* column = makeLayout<QVBoxLayout>(box, 4);
  search_->setObjectName(QStringLiteral("guideSearch"));
  search_->setPlaceholderText(tr("Search the guide"));
  search_->setAccessibleName(search_->placeholderText());
  search_->setClearButtonEnabled(true);
  count_->setObjectName(QStringLiteral("muted"));
  sections_->setObjectName(QStringLiteral("guideSections"));
  sections_->setAccessibleName(tr("Sections"));
  sections_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  sections_->setTextElideMode(Qt::ElideRight);
  column->addWidget(search_);
  column->addWidget(count_);
  column->addWidget(sections_, 1);
  return box;
}

/// Lists the sections with all words: those that have them in their titles first.
void GuideWindow::search() {
  const QStringList words = wordsOf(search_->text());
  const QSignalBlocker quiet(sections_);
  sections_->clear();
  for (const bool inTitle : {true, false})
    for (std::size_t page = 0; page < pages_.size(); ++page)
      for (std::size_t s = 0; s < pages_[page].sections.size(); ++s) {
        const GuideSection& section = pages_[page].sections[s];
        const bool titled = std::all_of(words.begin(), words.end(), [&](const QString& word) {
          return section.title.contains(word, Qt::CaseInsensitive);
        });
        if (titled != inTitle || !holds(section, words) || (words.isEmpty() && section.level > kListedLevel))
          continue;
        auto* item = new QListWidgetItem(QString(section.level > 1 ? 2 : 0, QLatin1Char(' ')) + section.title,
                                         sections_);
        item->setToolTip(section.title);
        item->setData(kPageRole, static_cast<qulonglong>(page));
        item->setData(kSectionRole, static_cast<qulonglong>(s));
        if (section.level == 1) {
          QFont font = item->font();
          font.setBold(true);
          item->setFont(font);
        }
      }
  count_->setText(words.isEmpty() ? QString() : tr("%n sections", nullptr, sections_->count()));
  markWords();
}

void GuideWindow::chooseRow(int row) {
  if (const QListWidgetItem* item = sections_->item(row))
    showSection(item->data(kPageRole).toULongLong(), item->data(kSectionRole).toULongLong());
}

void GuideWindow::open(const QString& page, const QString& anchor) {
  for (std::size_t p = 0; p < pages_.size(); ++p) {
    if (pages_[p].name != page)
      continue;
    const auto& all = pages_[p].sections;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const GuideSection& section) { return section.anchor == anchor; });
    showSection(p, found == all.end() ? 0 : static_cast<std::size_t>(found - all.begin()));
    QDialog::show();
    raise();
    activateWindow();
    search_->setFocus();
    return;
  }
}

void GuideWindow::follow(const QUrl& link) {
  if (!link.isRelative()) {
    QDesktopServices::openUrl(link);
    return;
  }
  const QString name = link.path().isEmpty() ? pages_[shown_].name : link.path();
  open(name, link.fragment());
}

void GuideWindow::showSection(std::size_t page, std::size_t section) {
  if (page != shown_) {
    shown_ = page;
    browser_->document()->setMarkdown(pages_[page].markdown, QTextDocument::MarkdownDialectGitHub);
    markWords();
  }
  std::size_t heading = 0;
  for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next())
    if (block.blockFormat().headingLevel() > 0 && heading++ == section) {
      const QRectF place = browser_->document()->documentLayout()->blockBoundingRect(block);
      browser_->verticalScrollBar()->setValue(section == 0 ? 0 : static_cast<int>(place.top()));
      browser_->setTextCursor(QTextCursor(block));
      return;
    }
}

void GuideWindow::markWords() {
  QList<QTextEdit::ExtraSelection> marks;
  QTextCharFormat format;
  format.setBackground(palette().highlight());
  format.setForeground(palette().highlightedText());
  for (const QString& word : wordsOf(search_->text()))
    for (QTextCursor at = browser_->document()->find(word); !at.isNull();
         at = browser_->document()->find(word, at))
      marks.push_back({at, format});
  browser_->setExtraSelections(marks);
}

} // namespace viscera::app

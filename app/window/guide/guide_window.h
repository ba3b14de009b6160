#pragma once

#include <QDialog>

#include <vector>

#include "window/guide/guide_pages.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;
class QUrl;

namespace viscera::app {

/// The user's guide in a window of its own, beside which the program stays usable: a list of the sections of
/// all pages, which words narrow down, and the page.
class GuideWindow final : public QDialog {
  Q_OBJECT

public:
  explicit GuideWindow(QWidget* parent);

  /// Opens a page at one of its headings, the page's begin for an unknown one.
  void open(const QString& page, const QString& anchor);
  const std::vector<GuidePage>& pages() const { return pages_; }

private:
  QWidget* makeList();
  void search();
  void chooseRow(int row);
  void follow(const QUrl& link);
  /// Shows section `section` of that page.
  void showSection(std::size_t page, std::size_t section);
  /// Marks the words that are searched for.
  void markWords();

  std::vector<GuidePage> pages_;
  std::size_t shown_ = SIZE_MAX; ///< The page in the browser; SIZE_MAX: none yet.
  QLineEdit* search_;
  QLabel* count_;
  QListWidget* sections_;
  QTextBrowser* browser_;
};

} // namespace viscera::app

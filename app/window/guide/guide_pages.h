#pragma once

#include <QString>
#include <QStringList>

#include <vector>

/// The pages of the user's guide, which the program has within, and their sections.
namespace viscera::app {

/// A heading of a page with the text below it, down to the next heading.
struct GuideSection {
  QString title;
  QString anchor; ///< Of links: the title in small letters, with hyphens, without marks.
  QString words;  ///< Title and text in small letters, to be searched.
  int level = 1;
};

/// One page.
struct GuidePage {
  QString name;     ///< "user_guide.md", as links have it.
  QString markdown; ///< Without its pictures, which the program does not have within.
  std::vector<GuideSection> sections;
};

/// All pages, the guide itself first. Reads the program's resources: some milliseconds.
std::vector<GuidePage> guidePages();

/// The anchor of a heading, as links have it.
QString anchorOf(const QString& title);

/// The words of a question, in small letters.
QStringList wordsOf(const QString& question);

/// Whether a section has every one of the words.
bool holds(const GuideSection& section, const QStringList& words);

} // namespace viscera::app

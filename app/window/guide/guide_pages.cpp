#include "window/guide/guide_pages.h"

#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace viscera::app {
namespace {

/// Pages in the order of a reader; those of resources/guide/guide.qrc.
constexpr std::array kPages = {"user_guide",     "tutor_guide", "patient_motion",   "file_formats",
                               "sample_organs",  "sequences",   "circulation",      "stress",
                               "coordinates",    "lessons",     "reference_values", "glossary",
                               "session_format", "python"};

void addSection(std::vector<GuideSection>& sections, const QString& heading) {
  const int level = static_cast<int>(heading.indexOf(QLatin1Char(' ')));
  QString title = heading.mid(level).trimmed();
  title.remove(QLatin1Char('`'));
  sections.push_back({title, anchorOf(title), title.toLower(), level});
}

std::vector<GuideSection> sectionsOf(const QString& markdown) {
  static const QRegularExpression heading(QStringLiteral("^#{1,6} "));
  std::vector<GuideSection> sections;
  bool code = false;
  for (const QString& line : markdown.split(QLatin1Char('\n'))) {
    if (line.startsWith(QLatin1String("```")))
      code = !code;
    if (!code && heading.match(line).hasMatch())
      addSection(sections, line);
    else if (!sections.empty())
      sections.back().words += QLatin1Char('\n') + line.toLower();
  }
  return sections;
}

} // namespace

QString anchorOf(const QString& title) {
  static const QRegularExpression marks(QStringLiteral("[^\\w\\- ]"),
                                        QRegularExpression::UseUnicodePropertiesOption);
  return title.toLower().remove(marks).replace(QLatin1Char(' '), QLatin1Char('-'));
}

std::vector<GuidePage> guidePages() {
  static const QRegularExpression picture(QStringLiteral("!\\[[^\\]]*\\]\\([^)]*\\)"));
  std::vector<GuidePage> pages;
  for (const char* id : kPages) {
    const QString name = QLatin1String(id) + QStringLiteral(".md");
    QFile file(QStringLiteral(":/viscera/guide/") + name);
    if (!file.open(QIODevice::ReadOnly))
      continue;
    const QString markdown = QString::fromUtf8(file.readAll()).remove(picture);
    pages.push_back({name, markdown, sectionsOf(markdown)});
  }
  return pages;
}

QStringList wordsOf(const QString& question) {
  return question.toLower().split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts);
}

bool holds(const GuideSection& section, const QStringList& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return section.words.contains(word); });
}

} // namespace viscera::app

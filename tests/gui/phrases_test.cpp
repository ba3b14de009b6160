#include <QAction>
#include <QDirIterator>
#include <QFile>
#include <QMenu>
#include <QRegularExpression>
#include <QTextStream>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "play_fixture.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/rig_commands.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/medical_io/plausible_size.h"
#include "window/language.h"
#include "window/movie/movie_plan.h"
#include "window/phrase_translator.h"
#include "window/widgets/message_bar.h"

namespace viscera::tests {
namespace {

using app::InstalledLanguage;
using app::messageInWords;

/// Modules of whose texts the window shows nearly all: everything in words there needs its translations.
constexpr const char* kSpeaking[] = {"anatomy",  "coordinates",  "core",          "deformation",   "document",
                                     "geometry", "live",         "localised_scc", "medical_io",    "motion",
                                     "plugin",   "presentation", "publish",       "sample_organs", "scene"};

/// Files of these modules that no window shows: measurements for the documentation and the command line,
/// TetGen's own program, what only authors of organ definitions read, and files in a language of their own
/// (HTML, commands of a shell with their comments, words of files' names for organs; what the systems of
/// organs are called has a test of its own).
constexpr const char* kSilent[] = {
    "/coordinates/src/measure/",      "/live/src/taught_quantities.cpp",
    "/circulation/src/published.cpp", "/presentation/src/circulation_figure.cpp",
    "/deformation/tetgen_worker/",    "/sample_organs/src/definition/",
    "/sample_organs/src/surface/",    "/report/src/page_markup.cpp",
    "/report/src/session_script.cpp", "/anatomy/src/table/",
    "/anatomy/src/organ_facts.cpp",   "/anatomy/src/phrase_index.cpp"};

QStringList sourcesOf(const QString& folder) {
  QStringList files;
  QDirIterator all(QStringLiteral(VISCERA_SOURCE_DIR "/") + folder, {"*.cpp", "*.h"}, QDir::Files,
                   QDirIterator::Subdirectories);
  while (all.hasNext())
    files.push_back(all.next());
  return files;
}

QString readSource(const QString& file) {
  QFile device(file);
  EXPECT_TRUE(device.open(QIODevice::ReadOnly)) << file.toStdString();
  return QString::fromUtf8(device.readAll());
}

QString unquoted(const QString& literals) {
  static const QRegularExpression between(QStringLiteral(R"("\s*")"));
  QString text = literals.trimmed();
  text = text.mid(1, text.size() - 2);
  text.replace(QStringLiteral("\\\""), QStringLiteral("\x01"));
  text.remove(between);
  text.replace(QStringLiteral("\\u00b1"), QChar(0xb1)).replace(QStringLiteral("\\xC2\\xB2"), QChar(0xb2));
  return text.replace(QLatin1Char('\x01'), QLatin1Char('"'));
}

/// The patterns of `phrase("...", ...)`, and of `said("...", ...)` in reports and lessons.
std::set<QString> patternsIn(const QString& source) {
  static const QRegularExpression call(
      QStringLiteral(R"(\b(?:phrase|said)\(\s*((?:"(?:[^"\\\n]|\\.)*"\s*)+))"));
  std::set<QString> patterns;
  for (auto calls = call.globalMatch(source); calls.hasNext();)
    patterns.insert(unquoted(calls.next().captured(1)));
  return patterns;
}

/// Literals of several words that a user may read: no includes, no formats of printf, no keys of files,
/// no texts for developers.
std::set<QString> textsIn(const QString& source) {
  static const QRegularExpression token(
      QStringLiteral(R"re(//[^\n]*|R"\([\s\S]*?\)"|'(?:[^'\\\n]|\\.)'|((?:"(?:[^"\\\n]|\\.)*"\s*)+))re"));
  static const QRegularExpression words(QStringLiteral(R"([A-Za-z]{2,} +[A-Za-z0-9%"]|^an? [a-z]+$)"));
  static const QRegularExpression none(QStringLiteral(
      R"(%[.0-9]*[dgfsxu]\b|^qhull|^surf |^group color/|^(doubled|missing) slice$|^mixed sizes$|^uneven spacing$)"
      R"(|\\n|^# |^element face|^(axis mins|(byte|line) skip|data file|space (directions|origin|units))$)"
      R"(|^((un)?signed|short|long) [a-z ]+$|^kidney (left|right)$|^label map$)"
      // Units, fonts, where a number is published, and how the circulation's parameters were found.
      R"(|^mmHg s/ml$|^(Noto|DejaVu|Liberation) Sans$|doi 10\.|^form: |^0 in health$|^fitted to the values)"));
  static const QRegularExpression forDevelopers(
      QStringLiteral(R"((static_assert|logic_error|assert|invalid_argument)\([^;]*$)"));
  std::set<QString> texts;
  for (auto tokens = token.globalMatch(source); tokens.hasNext();) {
    const QRegularExpressionMatch found = tokens.next();
    const QString text = unquoted(found.captured(1));
    const QString before =
        source.mid(std::max(0, found.capturedStart() - 200), std::min(200, found.capturedStart()));
    if (text.contains(words) && !text.contains(none) && !before.contains(forDevelopers))
      texts.insert(text);
  }
  return texts;
}

/// What errors that the window itself throws say.
std::set<QString> errorsIn(const QString& source) {
  static const QRegularExpression thrown(
      QStringLiteral(R"(\b(?:Usage|Data|NoInput|CannotCreate)?Error\(([^;]*);)"));
  static const QRegularExpression translated(QStringLiteral(R"(\btr\(\s*("(?:[^"\\\n]|\\.)*"\s*)+)"));
  std::set<QString> texts;
  for (auto errors = thrown.globalMatch(source); errors.hasNext();)
    texts.merge(textsIn(errors.next().captured(1).remove(translated)));
  return texts;
}

class Phrases : public ::testing::TestWithParam<const char*> {};

TEST_P(Phrases, OfTheNumericalModulesAreTranslated) {
  QTranslator translator;
  ASSERT_TRUE(
      translator.load(QStringLiteral(":/viscera/translations/viscera_%1").arg(QLatin1String(GetParam()))));
  std::set<QString> texts;
  for (const QString& file : sourcesOf(QStringLiteral("modules")) + sourcesOf(QStringLiteral("app/window")))
    texts.merge(patternsIn(readSource(file)));
  EXPECT_GT(texts.size(), 80u);
  for (const QString& file : sourcesOf(QStringLiteral("app/window")))
    texts.merge(errorsIn(readSource(file)));
  for (const char* module : kSpeaking)
    for (const QString& file : sourcesOf(QStringLiteral("modules/") + QLatin1String(module)))
      if (std::none_of(std::begin(kSilent), std::end(kSilent),
                       [&](const char* silent) { return file.contains(QLatin1String(silent)); }))
        texts.merge(textsIn(readSource(file)));
  EXPECT_GT(texts.size(), 500u);
  // Lessons have their texts in viscera_*.ts, since their page is written in any of the languages.
  const auto known = [&](const char* context, const QString& text) {
    return !translator.translate(context, text.toUtf8().constData()).isEmpty();
  };
  for (const QString& text : texts)
    EXPECT_TRUE(known("viscera::presentation", text) || known("Lesson", text))
        << text.toStdString() << " has no translation; write it into resources/translations/names_"
        << GetParam() << ".ts";
}

INSTANTIATE_TEST_SUITE_P(All, Phrases, ::testing::Values("ca", "de", "es", "fr"),
                         [](const auto& language) { return std::string(language.param); });

/// Axes and phases of a circulation, movie formats and slices come to the window as texts of their modules.
TEST(PhraseTranslator, NamesTheCirculationItsPhasesAndSlices) {
  const InstalledLanguage spanish(QStringLiteral("es"));
  EXPECT_EQ(messageInWords("ejection"), QStringLiteral("eyección"));
  EXPECT_EQ(messageInWords("filling"), QStringLiteral("llenado"));
  EXPECT_EQ(messageInWords("Heartbeat: Rest"), QStringLiteral("Latido: Reposo"));
  EXPECT_EQ(messageInWords("LV (ml)"), QStringLiteral("VI (ml)"));
  EXPECT_EQ(messageInWords("RV (ml)"), QStringLiteral("VD (ml)"));
  EXPECT_EQ(messageInWords("Sagittal"), QStringLiteral("Sagital"));
  EXPECT_EQ(app::inWords("degrees"), QStringLiteral("grados"));
  EXPECT_EQ(app::infoOf(app::MovieFormat::ogg).name, QStringLiteral("Película Ogg (.ogv)"));
}

TEST(PhraseTranslator, KnowsThePatternOfATextAndTranslatesItsParts) {
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(messageInWords("Lock 3 handles"), QStringLiteral("3 Griffe sperren"));
  EXPECT_EQ(messageInWords("Lock handle"), QStringLiteral("Griff sperren"));
  EXPECT_EQ(messageInWords("Circulation: Exercise, changed"),
            QStringLiteral("Kreislauf: Belastung, geändert"));
  EXPECT_EQ(messageInWords("heart.stl: the surface is inside out"),
            QStringLiteral("heart.stl: die Oberfläche ist umgestülpt"));
  EXPECT_EQ(messageInWords("Add %1 of Mr. Schmidt"), QStringLiteral("%1 of Mr. Schmidt hinzufügen"))
      << "a name is no pattern";
  EXPECT_EQ(messageInWords("The pose has 12 handles, the document 8"),
            QStringLiteral("Die Pose hat 12 Griffe, das Dokument 8"));
  EXPECT_EQ(messageInWords("It has 3 phases; a motion needs four at least"),
            QStringLiteral("Es gibt 3 Phasen; eine Bewegung braucht mindestens vier"));
  EXPECT_EQ(messageInWords("The label \"LV\" is missing in phase 3"),
            QStringLiteral("Das Label „LV“ fehlt in Phase 3"));
  EXPECT_EQ(messageInWords("2 of 800 vertices have no coordinates: 1 lie outside the handles' hull, by up "
                           "to 4.5 mm"),
            QStringLiteral("2 von 800 Eckpunkten haben keine Koordinaten: 1 liegen außerhalb der Hülle der "
                           "Griffe, bis zu 4,5 mm"));
  EXPECT_EQ(messageInWords("40 x 40 x 30 voxels of 1 x 1 x 2.5 mm around 0.5, -12.0, 3.5"),
            QStringLiteral("40 x 40 x 30 Voxel von 1 x 1 x 2,5 mm um 0,5; -12,0; 3,5"));
  EXPECT_EQ(messageInWords("beat.csv, line 3"), QStringLiteral("beat.csv, Zeile 3"));
}

TEST(PhraseTranslator, NamesOrgansInSentencesAsTheLanguageDoes) {
  const std::string doubt =
      medical_io::doubtAboutVolume("liver", 5).value_or("5 ml are the volume of a liver");
  {
    const InstalledLanguage german(QStringLiteral("de"));
    EXPECT_TRUE(
        app::asSentence(doubt).startsWith(QStringLiteral("Eine Leber mit 5 ml ist nicht lebensgroß")));
    EXPECT_EQ(app::inWords(live::describe(live::StressQuantity::rotationalStress).peakName),
              QStringLiteral("Maximaler Rotationsstress"));
  }
  const InstalledLanguage spanish(QStringLiteral("es"));
  EXPECT_TRUE(app::asSentence(doubt).startsWith(QStringLiteral("Un hígado de 5 ml no es")));
}

TEST(PhraseTranslator, SaysWhatMotionsAndTheCirculationRefuse) {
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(messageInWords("The ventricles cannot be brought to their volumes: left off by 1.25 ml, right by "
                           "2.00 ml; atria: left off by 3.00 ml, right by 4.00 ml"),
            QStringLiteral("Die Ventrikel lassen sich nicht auf ihre Volumina bringen: links fehlen 1,25 ml, "
                           "rechts 2,00 ml; Vorhöfe: links 3,00 ml, rechts 4,00 ml"));
  EXPECT_EQ(messageInWords("fitting phase 3"), QStringLiteral("Anpassung von Phase 3"));
  EXPECT_EQ(messageInWords("from 0.2 to 4 mmHg s/ml"), QStringLiteral("von 0,2 bis 4 mmHg s/ml"));
  EXPECT_EQ(
      messageInWords("women and men, mean +- 2 standard deviations, for 1.80 m2 of body surface"),
      QStringLiteral("Frauen und Männer, Mittel ± 2 Standardabweichungen, für 1,80 m² Körperoberfläche"));
  EXPECT_EQ(messageInWords("3 triangles of EPI are turned over"),
            QStringLiteral("3 Dreiecke von EPI sind umgeklappt"));
}

TEST(PhraseTranslator, TakesAJoiningPatternOnlyWhereNoWordsAreKnown) {
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(messageInWords("The organ is open: 3 boundary edges"),
            QStringLiteral("Das Organ ist offen: 3 Randkanten"))
      << "and not \"%1: %2\" of something unknown";
  EXPECT_EQ(messageInWords("EPI, phase 2"), QStringLiteral("EPI, Phase 2"));
}

TEST(PhraseTranslator, BeginsWhatAnErrorSaysWithACapital) {
  const InstalledLanguage german(QStringLiteral("de"));
  const DataError error(phrase("the surface is open (%n boundary {edge|edges}), so it has no volume", 1),
                        "Heart", "close its holes first");
  EXPECT_EQ(app::sentenceOf(error),
            QStringLiteral("Herz: Die Oberfläche ist offen (1 Randkante) und hat kein Volumen. Schließen Sie "
                           "zuerst ihre Löcher."));
}

TEST(PhraseTranslator, LeavesEnglishAndWhatNobodyTranslatedAsItIs) {
  EXPECT_EQ(messageInWords("Lock 3 handles"), QStringLiteral("Lock 3 handles"));
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(messageInWords("Schmidt's second liver"), QStringLiteral("Schmidt's second liver"));
  EXPECT_EQ(messageInWords("Lock many handles"), QStringLiteral("Lock many handles"));
  EXPECT_EQ(app::inWords("Open heart"), QStringLiteral("Open heart")) << "a name and no step";
}

TEST(Phrases, NameTheBeatOfACirculationInTheLanguage) {
  const auto namesIn = [](const char* code) {
    const InstalledLanguage language(QString::fromLatin1(code));
    return QStringList(
        {app::inWords("Heartbeat: Rest"), app::inWords("Heartbeat: mine"), app::inWords("Patient: Rest")});
  };
  EXPECT_EQ(namesIn("de"), QStringList({"Herzschlag: Ruhe", "Herzschlag: mine", "Patient: Rest"}));
  EXPECT_EQ(namesIn("fr").front(), QStringLiteral("Battement du cœur\u00a0: Repos"));
}

class GermanSteps : public PlayMode {
  InstalledLanguage german_{QStringLiteral("de")};
};

TEST_F(GermanSteps, AreNamedInGermanAndSoIsARefusal) {
  std::vector<document::HandleId> handles;
  for (const document::Handle& handle : document().rig().handles)
    if (handles.size() < 3)
      handles.push_back(handle.id);
  document::HandleEdit lock;
  lock.locked = true;
  window().workspace().perform(document::editHandles(handles, lock));
  EXPECT_EQ(window().workspace().undo().undoName(), "Lock 3 handles");
  const QList<QAction*> actions = window().findChildren<QAction*>();
  EXPECT_TRUE(std::any_of(actions.begin(), actions.end(), [](const QAction* action) {
    return action->text().contains(QStringLiteral("3 Griffe sperren"));
  }));
  window().workspace().guarded([this] { window().workspace().perform(document::setPose(Points(2, 3))); });
  EXPECT_TRUE(message().contains(QStringLiteral("Die Pose hat 2 Griffe"))) << message().toStdString();
}

} // namespace
} // namespace viscera::tests

#include <QAction>
#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QMenu>
#include <QRegularExpression>
#include <QTextStream>
#include <QTranslator>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "play_fixture.h"
#include "viscera/anatomy/norms.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/circulation_commands.h"
#include "viscera/document/group_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/medical_io/plausible_size.h"
#include "window/movie/movie_plan.h"
#include "window/style/language.h"
#include "window/widgets/message_bar.h"
#include "words.h"

namespace viscera::tests {
namespace {

using app::InstalledLanguage;
using app::inWords;

/// Modules of whose texts the window shows nearly all: everything in words there needs its translations.
constexpr const char* kSpeaking[] = {"anatomy",  "coordinates",  "core",          "deformation",   "document",
                                     "geometry", "live",         "localised_scc", "medical_io",    "motion",
                                     "plugin",   "presentation", "publish",       "sample_organs", "scene"};

/// Files of these modules that no window shows: measurements for the documentation and the command line,
/// TetGen's own program, what only authors of organ definitions read, and files in a language of their own
/// (HTML, commands of a shell with their comments, words of files' names for organs; what the systems of
/// organs are called has a test of its own, and the window translates names of segments word by word).
constexpr const char* kSilent[] = {
    "/coordinates/src/measure/",      "/live/src/taught_quantities.cpp",
    "/circulation/src/published.cpp", "/presentation/src/circulation_figure.cpp",
    "/deformation/tetgen_worker/",    "/sample_organs/src/definition/",
    "/sample_organs/src/surface/",    "/report/src/page_markup.cpp",
    "/report/src/session_script.cpp", "/anatomy/src/table/",
    "/anatomy/src/organ_facts.cpp",   "/anatomy/src/phrase_index.cpp",
    "/live/src/strain_files.cpp",     "/strain/src/aha_segments.cpp"};

QStringList sourcesOf(const QString& folder) {
  QStringList files;
  QDirIterator all(QStringLiteral(VISCERA_SOURCE_DIR "/") + folder, {"*.cpp", "*.h"}, QDir::Files,
                   QDirIterator::Subdirectories);
  while (all.hasNext())
    files.push_back(all.next());
  return files;
}

/// Functions of the readers whose literals become parts of diagnostics: what should stand in a file.
constexpr const char* kDetails = "failAtEnd|nextLine|takeCount|takeBytes|take<[a-z0-9_:]+>|axisSize|"
                                 "readValues|values|number|count|integer|whole|"
                                 "checked|checkedCount|coordinate|coordinateFrom|takeCoordinate|threeBytes";

/// The end of a call whose parenthesis opens before `from`; parentheses in literals do not count.
int endOfCall(const QString& source, int from) {
  static const QRegularExpression sign(QStringLiteral(R"re("(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)'|[()])re"));
  int open = 1;
  for (auto signs = sign.globalMatch(source, from); signs.hasNext();) {
    const QRegularExpressionMatch found = signs.next();
    open += found.captured() == QLatin1String("(") ? 1 : found.captured() == QLatin1String(")") ? -1 : 0;
    if (open == 0)
      return found.capturedEnd();
  }
  return source.size();
}

/// The source without calls of `functions` ("one|another").
QString without(const char* functions, const QString& source) {
  const QRegularExpression call(QStringLiteral(R"(\b(?:%1)\()").arg(QLatin1String(functions)));
  QString rest;
  int from = 0;
  for (auto calls = call.globalMatch(source); calls.hasNext();) {
    const QRegularExpressionMatch found = calls.next();
    if (found.capturedStart() < from)
      continue;
    rest += source.mid(from, found.capturedStart() - from);
    from = endOfCall(source, found.capturedEnd());
  }
  return rest + source.mid(from);
}

/// A source without its comments and what stays in English.
QString readSource(const QString& file) {
  QFile device(file);
  EXPECT_TRUE(device.open(QIODevice::ReadOnly)) << file.toStdString();
  static const QRegularExpression comment(QStringLiteral(R"(^\s*//.*$)"),
                                          QRegularExpression::MultilineOption);
  const QString source = without("diagnostic|misuse", QString::fromUtf8(device.readAll()).remove(comment));
  return file.contains(QLatin1String("/medical_io/src/")) ? without(kDetails, source) : source;
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
      R"(%[.0-9]*[dgfsxu]\b|^qhull|^surf |^group color/|^(doubled|missing) slice$|^part read$|^mixed sizes$|^uneven spacing$)"
      R"(|\\n|^# |^element face|^(axis mins|(byte|line) skip|data file|space (directions|origin|units))$)"
      R"(|^((un)?signed|short|long) [a-z ]+$|^kidney (left|right)$|^label map$)"
      // Units, fonts, where a number is published, and how the circulation's parameters were found.
      R"(|^mmHg s/ml$|^(Noto|DejaVu|Liberation) Sans$|doi 10\.|^form: |^0 in health$|^fitted to the values)"
      // What is looked for in a file, and formats' names in tables.
      R"(|^visualization toolkit$|^Viscera (session|sequence)$|^3D Slicer (markups|fiducials)$|^Philips PAR/REC$|^Zeiss CZI$)"
      // What the command line alone says of strain and of diseases.
      R"(|^(basal|mid|apical) [a-z]+$|^(Longitudinal|Circumferential|Radial) strain$|^, time to peak$)"
      R"(|^change of the length of a material contour |^engineering strain )"
      R"(|^(moderate|severe) (stenosis|regurgitation)$|pulmonary hypertension$|^heart failure with reduced ejection)"
      // What names a place in a file.
      R"(|^NIfTI data type $|^system parameter $|^, handle "$)"
      // Elements of VTK's XML formats.
      R"(|^(VTKFile|DataArray|Array) type=|^Piece NumberOf|^PointData Scalars=|AppendedData encoding=|^<\?xml )"));
  // And DICOM's terms for its kinds of objects.
  static const QRegularExpression forDevelopers(QStringLiteral(
      R"((static_assert|logic_error|assert|invalid_argument)\([^;]*$|DicomKind::[a-z]+,\s*$)"));
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
    if (!file.contains(QLatin1String("/bindings/vtk/"))) // ParaView prints these in English.
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
    EXPECT_TRUE(known("viscera::presentation", text) || known("Lesson", text) || !hasWords(text))
        << text.toStdString() << " has no translation; write it into resources/translations/names_"
        << GetParam() << ".ts";
}

INSTANTIATE_TEST_SUITE_P(All, Phrases, ::testing::Values("ca", "de", "es", "fr"),
                         [](const auto& language) { return std::string(language.param); });

/// Axes and phases of a circulation, movie formats and slices come to the window as texts of their modules.
TEST(TextsInWords, NameTheCirculationItsPhasesAndSlices) {
  const InstalledLanguage spanish(QStringLiteral("es"));
  EXPECT_EQ(inWords("ejection"), QStringLiteral("eyección"));
  EXPECT_EQ(inWords("filling"), QStringLiteral("llenado"));
  EXPECT_EQ(inWords(phrase("Heartbeat: %1", document::nameOf(document::CirculationChoice()))),
            QStringLiteral("Latido: Reposo"));
  EXPECT_EQ(inWords("LV (ml)"), QStringLiteral("VI (ml)"));
  EXPECT_EQ(inWords("RV (ml)"), QStringLiteral("VD (ml)"));
  EXPECT_EQ(inWords("Sagittal"), QStringLiteral("Sagital"));
  EXPECT_EQ(inWords("degrees"), QStringLiteral("grados"));
  EXPECT_EQ(app::infoOf(app::MovieFormat::ogg).name, QStringLiteral("Película Ogg (.ogv)"));
}

TEST(TextsInWords, TranslateTheirPatternAndTheirParts) {
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(inWords(phrase("Lock {handle|%n handles}", 3)), QStringLiteral("3 Griffe sperren"));
  EXPECT_EQ(inWords(phrase("Lock {handle|%n handles}", 1)), QStringLiteral("Griff sperren"));
  EXPECT_EQ(inWords(phrase("Lock {handle|%n handles}", std::uint64_t{1} << 40)),
            QStringLiteral("1099511627776 Griffe sperren"));
  EXPECT_EQ(inWords(phrase("Circulation: %1", phrase("%1, changed", named("Exercise")))),
            QStringLiteral("Kreislauf: Belastung, geändert"));
  EXPECT_EQ(inWords(phrase("%1: %2", std::string("heart.stl"), "the surface is inside out")),
            QStringLiteral("heart.stl: die Oberfläche ist umgestülpt"));
  EXPECT_EQ(inWords(phrase("It has %n {phase|phases}; a motion needs four at least", 3)),
            QStringLiteral("Es gibt 3 Phasen; eine Bewegung braucht mindestens vier"));
  EXPECT_EQ(inWords(phrase("The label \"%1\" is missing in %2", std::string("LV"), phrase("phase %1", 3))),
            QStringLiteral("Das Label „LV“ fehlt in Phase 3"));
  EXPECT_EQ(inWords(phrase("%1: %2 lie outside the handles' hull, by up to %3 mm",
                           phrase("%1 of %2 vertices have no coordinates", 2, 800), 1, inDigits(4.5, 6))),
            QStringLiteral("2 von 800 Eckpunkten haben keine Koordinaten: 1 liegen außerhalb der Hülle der "
                           "Griffe, bis zu 4,5 mm"));
  EXPECT_EQ(
      inWords(phrase("%1 x %2 x %3 voxels of %4 x %5 x %6 mm around %7, %8, %9", 40, 40, 30, inDigits(1),
                     inDigits(1), inDigits(2.5), inFixed(0.5, 1), inFixed(-12, 1), inFixed(3.5, 1))),
      QStringLiteral("40 x 40 x 30 Voxel von 1 x 1 x 2,5 mm um 0,5; -12,0; 3,5"));
  EXPECT_EQ(inWords(phrase("%1, line %2", std::string("beat.csv"), 3)), QStringLiteral("beat.csv, Zeile 3"));
  EXPECT_EQ(inWords(phrase("%1, phase %2", named("EPI"), 2)), QStringLiteral("EPI, Phase 2"));
}

/// What only looks like a text of the program is somebody's own: a name, a word of a file.
TEST(TextsInWords, LeaveVerbatimPartsAsTheyAre) {
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(inWords(phrase("Add %1", named("%1 of Mr. Schmidt"))),
            QStringLiteral("%1 of Mr. Schmidt hinzufügen"))
      << "a name is no pattern";
  EXPECT_EQ(inWords(phrase("the format \"%1\" is not known", std::string("Heart"))),
            QStringLiteral("the format \"Heart\" is not known"))
      << "nobody translated it";
  EXPECT_EQ(inWords(std::string("Open heart")), QStringLiteral("Open heart")) << "a name and no step";
  EXPECT_EQ(inWords(Text(std::string("Reset pose"))), QStringLiteral("Reset pose"));
  EXPECT_EQ(inWords("Reset pose"), QStringLiteral("Pose zurücksetzen"));
}

TEST(TextsInWords, NameOrgansInSentencesAsTheLanguageDoes) {
  const std::optional<Text> doubt = medical_io::doubtAboutVolume("liver", 5);
  ASSERT_TRUE(doubt.has_value());
  {
    const InstalledLanguage german(QStringLiteral("de"));
    EXPECT_TRUE(
        app::asSentence(*doubt).startsWith(QStringLiteral("Eine Leber mit 5 ml ist nicht lebensgroß")));
    EXPECT_EQ(inWords(live::describe(live::StressQuantity::rotationalStress).peakName),
              QStringLiteral("Maximaler Rotationsstress"));
  }
  const InstalledLanguage spanish(QStringLiteral("es"));
  EXPECT_TRUE(app::asSentence(*doubt).startsWith(QStringLiteral("Un hígado de 5 ml no es")));
}

TEST(TextsInWords, SayWhatMotionsAndTheCirculationRefuse) {
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(inWords(phrase("The ventricles cannot be brought to their volumes: left off by %1 ml, right by "
                           "%2 ml; atria: left off by %3 ml, right by %4 ml",
                           inFixed(1.25, 2), inFixed(2, 2), inFixed(3, 2), inFixed(4, 2))),
            QStringLiteral("Die Ventrikel lassen sich nicht auf ihre Volumina bringen: links fehlen 1,25 ml, "
                           "rechts 2,00 ml; Vorhöfe: links 3,00 ml, rechts 4,00 ml"));
  EXPECT_EQ(inWords(phrase("fitting phase %1", 3)), QStringLiteral("Anpassung von Phase 3"));
  EXPECT_EQ(inWords(phrase("from %1 to %2 %3", inDigits(0.2), inDigits(4), named("mmHg s/ml"))),
            QStringLiteral("von 0,2 bis 4 mmHg s/ml"));
  EXPECT_EQ(
      inWords(anatomy::meaningOf(anatomy::norm("lv.edv"), {anatomy::Sex::either, 1.8})),
      QStringLiteral("Frauen und Männer, Mittel ± 2 Standardabweichungen, für 1,80 m² Körperoberfläche"));
  EXPECT_EQ(inWords(phrase("%n {triangle|triangles} of %2 {is|are} turned over", 3, named("EPI"))),
            QStringLiteral("3 Dreiecke von EPI sind umgeklappt"));
}

TEST(TextsInWords, BeginWhatAnErrorSaysWithACapital) {
  const InstalledLanguage german(QStringLiteral("de"));
  const DataError error(
      phrase("the surface is open (%n boundary {edge|edges}), so it has no volume that could "
             "be locked",
             1),
      named("Heart"), "close its holes first");
  EXPECT_EQ(app::sentenceOf(error),
            QStringLiteral("Herz: Die Oberfläche ist offen (1 Randkante) und hat kein Volumen, das gesperrt "
                           "werden könnte. Schließen Sie zuerst ihre Löcher."));
}

TEST(TextsInWords, SayOfADamagedFileInEnglishWhatIsWrong) {
  EXPECT_EQ(app::asSentence(diagnostic("line %1 has no area", 3)), QStringLiteral("Line 3 has no area."));
}

TEST(TextsInWords, LeaveEnglishAndWhatNobodyTranslatedAsItIs) {
  EXPECT_EQ(inWords(phrase("Lock {handle|%n handles}", 3)), QStringLiteral("Lock 3 handles"));
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(inWords(named("Schmidt's second liver")), QStringLiteral("Schmidt's second liver"));
  EXPECT_EQ(inWords(phrase("Lock many %1", "handles of nobody")),
            QStringLiteral("Lock many handles of nobody"));
}

TEST(Phrases, NameTheBeatOfACirculationInTheLanguage) {
  const auto namesIn = [](const char* code) {
    const InstalledLanguage language(QString::fromLatin1(code));
    return QStringList({inWords(phrase("Heartbeat: %1", named("Rest"))),
                        inWords(phrase("Heartbeat: %1", std::string("mine"))),
                        inWords(named("Patient: Rest"))});
  };
  EXPECT_EQ(namesIn("de"), QStringList({"Herzschlag: Ruhe", "Herzschlag: mine", "Patient: Rest"}));
  EXPECT_EQ(namesIn("fr").front(), QStringLiteral("Battement du cœur\u00a0: Repos"));
}

/// Steps of a user in the language of the window: what the program named is translated, what the user named
/// is not, even where it reads like a text of the program.
class StepsIn : public ::testing::TestWithParam<const char*> {
protected:
  const InstalledLanguage language_{QString::fromLatin1(GetParam())};

  /// The translation of a pattern of one part, with the part in its place.
  static QString expected(const char* pattern, const QString& part) {
    const QString translation = QCoreApplication::translate("viscera::presentation", pattern);
    EXPECT_NE(translation, QString::fromUtf8(pattern));
    return QString(translation).replace(QStringLiteral("%1"), part);
  }
};

TEST_P(StepsIn, TranslateAPartThatIsAMessageToo) {
  const Text step = document::chooseScenario("exercise").name;
  EXPECT_EQ(step.english(), "Circulation: Exercise");
  const QString part = inWords(named("Exercise"));
  EXPECT_NE(part, QStringLiteral("Exercise"));
  EXPECT_EQ(inWords(step), expected("Circulation: %1", part));
  EXPECT_EQ(inWords(phrase("%1, changed", step)), expected("%1, changed", inWords(step)));
}

TEST_P(StepsIn, LeaveAUsersNameThatReadsLikeAText) {
  for (const char* source : {"Reset pose", "Heartbeat", "the surface is inside out"}) {
    ASSERT_NE(inWords(source), QString::fromUtf8(source)) << "a text of the program";
    const std::filesystem::path file = source;
    EXPECT_EQ(inWords(phrase("Open %1", file.filename().string())),
              expected("Open %1", QString::fromUtf8(source)));
  }
}

TEST_P(StepsIn, SayInOneSentenceThatAFileIsDamagedAndLeaveTheDetailInEnglish) {
  const Text broken = diagnostic("line %1: %2 has no area", 3, "a face");
  const QString detail = QStringLiteral("line 3: a face has no area");
  EXPECT_EQ(inWords(broken), expected("The file cannot be read: %1", detail));
  EXPECT_EQ(inWords(DataError(broken).problem()), expected("The file cannot be read: %1", detail));
  EXPECT_EQ(inWords(misuse("there is no view %1", "heart")),
            expected("Internal error: %1", QStringLiteral("there is no view heart")));
}

INSTANTIATE_TEST_SUITE_P(All, StepsIn, ::testing::Values("ca", "de", "es", "fr"),
                         [](const auto& language) { return std::string(language.param); });

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
  EXPECT_EQ(window().workspace().undo().undoName().english(), "Lock 3 handles");
  const QList<QAction*> actions = window().findChildren<QAction*>();
  EXPECT_TRUE(std::any_of(actions.begin(), actions.end(), [](const QAction* action) {
    return action->text().contains(QStringLiteral("3 Griffe sperren"));
  }));
  window().workspace().guarded([this] { window().workspace().perform(document::setPose(Points(2, 3))); });
  EXPECT_TRUE(message().contains(QStringLiteral("Interner Fehler: The pose has 2 handles")))
      << message().toStdString();
}

} // namespace
} // namespace viscera::tests

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTranslator>
#include <QTreeWidget>
#include <QXmlStreamReader>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "play_fixture.h"
#include "viscera/anatomy/norms.h"
#include "viscera/anatomy/organ_facts.h"
#include "viscera/circulation/parameters.h"
#include "viscera/circulation/readings.h"
#include "viscera/circulation/scenario.h"
#include "viscera/coordinates/registry.h"
#include "viscera/core/phrase.h"
#include "viscera/heart/clinical_numbers.h"
#include "viscera/live/retarget.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/sequences/keyframes.h"
#include "window/handles/handle_table.h"
#include "window/organs/organ_panel.h"
#include "window/stress/stress_mode.h"
#include "window/style/language.h"
#include "window/timeline/phase_scrubber.h"
#include "window/timeline/sample_loader.h"
#include "window/view/picture.h"
#include "words.h"

namespace viscera::tests {
namespace {

using app::InstalledLanguage;

/// One text of a file of translations.
struct Translated {
  QString source;
  QStringList translations; ///< Several where there are plural forms.
  bool finished = true;
};

std::vector<Translated> textsOf(const QString& file) {
  QFile device(file);
  EXPECT_TRUE(device.open(QIODevice::ReadOnly)) << file.toStdString();
  QXmlStreamReader xml(&device);
  std::vector<Translated> texts;
  bool plurals = false;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement)
      continue;
    if (xml.name() == QLatin1String("message")) {
      texts.emplace_back();
      plurals = xml.attributes().hasAttribute(QLatin1String("numerus"));
    } else if (xml.name() == QLatin1String("source")) {
      texts.back().source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      texts.back().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
      if (const QString text = plurals ? QString() : xml.readElementText(); !text.isEmpty())
        texts.back().translations.push_back(text);
    } else if (xml.name() == QLatin1String("numerusform")) {
      texts.back().translations.push_back(xml.readElementText());
    }
  }
  return texts;
}

/// What stands for something else in a text: %1, %n. Of "{voxel|voxels}" one is chosen.
std::multiset<QString> placesIn(QString text) {
  text.remove(QRegularExpression(QStringLiteral(R"(\{[^{}|]*\||\})")));
  std::multiset<QString> places;
  for (int i = 0; i + 1 < text.size(); ++i)
    if (text[i] == QLatin1Char('%') && (text[i + 1].isDigit() || text[i + 1] == QLatin1Char('n')))
      places.insert(text.mid(i, 2));
  return places;
}

QString folderOfTranslations() {
  return QStringLiteral(VISCERA_SOURCE_DIR "/resources/translations/");
}

/// A coordinate system of a plugin, of which only the names are used.
class ForeignSystem final : public coordinates::CoordinateSystem {
public:
  std::string id() const override { return "least-squares"; }
  std::string name() const override { return "Least squares"; }
  std::string summary() const override { return "Fits an affine map around every point"; }
  coordinates::Traits traits() const override { return {}; }
  std::vector<coordinates::Parameter> parameters() const override { return {}; }
  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet&, const Points&,
                                             const coordinates::BindOptions&, Progress&) const override {
    return nullptr;
  }
};

constexpr const char* kTextsOfAPlugin = R"(<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS><TS version="2.1" language="de" sourcelanguage="en">
<context><name>viscera::presentation</name>
<message><source>Least squares</source><translation>Kleinste Quadrate</translation></message>
<message><source>too steep</source><translation>zu steil</translation></message>
<message><source>Heartbeat</source><translation>Etwas anderes</translation></message>
</context></TS>)";

class Translations : public ::testing::TestWithParam<const char*> {};

/// What lupdate makes of a copy of the file and the sources.
std::vector<Translated> broughtUpToDate(const QString& name, QStringList options) {
  const QTemporaryDir folder;
  const QString copy = folder.filePath(name);
  EXPECT_TRUE(QFile::copy(folderOfTranslations() + name, copy));
  const QDir root(QStringLiteral(VISCERA_SOURCE_DIR));
  options << QStringLiteral("-silent") << QStringLiteral("-no-obsolete") << QStringLiteral("-locations")
          << QStringLiteral("none") << root.filePath(QStringLiteral("app"))
          << root.filePath(QStringLiteral("modules")) << QStringLiteral("-ts") << copy;
  EXPECT_EQ(QProcess::execute(QStringLiteral(VISCERA_LUPDATE), options), 0);
  return textsOf(copy);
}

/// The source has the plural, so that it reads well without the file, too.
TEST(EnglishPlurals, HaveBothFormsOfEveryTextWithANumber) {
  const std::vector<Translated> texts =
      broughtUpToDate(QStringLiteral("viscera_en.ts"), {QStringLiteral("-pluralonly")});
  EXPECT_GT(texts.size(), 30u);
  for (const Translated& text : texts) {
    EXPECT_TRUE(text.finished)
        << text.source.toStdString()
        << " has no plural; resources/scripts/update_translations.sh adds it to the file";
    ASSERT_EQ(text.translations.size(), 2) << text.source.toStdString();
    EXPECT_EQ(text.translations[1], text.source);
    EXPECT_FALSE(text.source.contains(QLatin1Char('{'))) << text.source.toStdString();
  }
}

/// The file is what lupdate would make of the sources, with nothing left to translate but what all classes
/// share and what has no words.
TEST_P(Translations, HaveEveryTextOfTheWindow) {
  const std::vector<Translated> texts =
      broughtUpToDate(QStringLiteral("viscera_%1.ts").arg(QLatin1String(GetParam())), {});
  EXPECT_GT(texts.size(), 1000u);
  std::set<QString> shared;
  for (const Translated& text :
       textsOf(folderOfTranslations() + QStringLiteral("names_%1.ts").arg(QLatin1String(GetParam()))))
    if (text.finished && !text.translations.isEmpty())
      shared.insert(text.source);
  for (const Translated& text : texts)
    EXPECT_TRUE((text.finished && !text.translations.isEmpty()) || shared.count(text.source) == 1 ||
                !hasWords(text.source))
        << text.source.toStdString()
        << " has no translation; resources/scripts/update_translations.sh adds it to the file";
}

/// Words that readers have stumbled over do not come back.
TEST(WordsOfTheWindow, AreThoseOfThePeopleWhoUseThem) {
  QMap<QString, QMap<QString, QString>> said; // By language and English text.
  for (const char* language : {"de", "fr", "es", "ca"})
    for (const char* kind : {"viscera", "names"})
      for (const Translated& text :
           textsOf(folderOfTranslations() +
                   QStringLiteral("%1_%2.ts").arg(QLatin1String(kind), QLatin1String(language)))) {
        said[QLatin1String(language)][text.source] = text.translations.join(QLatin1Char('|'));
        for (const char* odd : {"End-systolic and relaxed", "towers above", "Remove from group",
                                "Unsaved changes will be lost"})
          EXPECT_FALSE(text.source.contains(QLatin1String(odd))) << text.source.toStdString();
      }
  EXPECT_TRUE(said[QStringLiteral("de")].contains(QStringLiteral("Save this session?")))
      << "one without a file has no name to ask for";
  EXPECT_TRUE(said[QStringLiteral("de")].contains(QStringLiteral("Take out of group")));
  // The sides are those of one language.
  const std::pair<const char*, const char*> sides[] = {{"&Anterior", "&Vorn"}, {"&Posterior", "&Hinten"},
                                                       {"&Left", "&Links"},    {"&Right", "&Rechts"},
                                                       {"&Superior", "&Oben"}, {"&Inferior", "&Unten"}};
  for (const auto& [english, german] : sides)
    EXPECT_EQ(said[QStringLiteral("de")][QLatin1String(english)], QLatin1String(german));
  EXPECT_EQ(said[QStringLiteral("fr")][QStringLiteral("Play")], QStringLiteral("Lecture")) << "the mode";
  for (const QString& french : said[QStringLiteral("fr")])
    EXPECT_FALSE(french.contains(QStringLiteral("attement du manuel"))) << french.toStdString();
}

/// What two classes say alike stands once, in names_*.ts.
TEST(SharedTranslations, AreNotRepeatedByClasses) {
  const QTemporaryDir folder;
  const QDir from(folderOfTranslations());
  for (const QString& name : from.entryList({QStringLiteral("*.ts")}))
    ASSERT_TRUE(QFile::copy(from.filePath(name), folder.filePath(name)));
  QProcess script;
  script.start(
      QStringLiteral("python3"),
      {QStringLiteral(VISCERA_SOURCE_DIR "/resources/scripts/share_translations.py"), folder.path()});
  ASSERT_TRUE(script.waitForFinished());
  EXPECT_EQ(script.readAllStandardOutput().trimmed(), QByteArray("0 texts removed, 0 of them shared now"))
      << "resources/scripts/update_translations.sh moves them";
}

/// A class of the window finds a shared text by its own context; Qt's classes do not.
TEST(SharedTranslations, AreFoundByEveryClass) {
  const InstalledLanguage french(QStringLiteral("fr"));
  EXPECT_EQ(QCoreApplication::translate("viscera::app::MarksBox", "Remove"), QStringLiteral("Supprimer"));
  EXPECT_EQ(QCoreApplication::translate("viscera::app::NewBox", "open"), QStringLiteral("ouvert"));
  EXPECT_EQ(QCoreApplication::translate("QFileDialog", "open"), QStringLiteral("open"));
  EXPECT_EQ(QCoreApplication::translate("viscera::app::OrganPanel", "open"), QStringLiteral("ouverte"))
      << "its own translation comes first";
}

TEST_P(Translations, KeepWhatStandsForSomethingElse) {
  for (const char* kind : {"viscera", "names"})
    for (const Translated& text :
         textsOf(folderOfTranslations() +
                 QStringLiteral("%1_%2.ts").arg(QLatin1String(kind), QLatin1String(GetParam()))))
      for (const QString& translation : text.translations) {
        std::multiset<QString> expected = placesIn(text.source), found = placesIn(translation);
        if (text.translations.size() > 1 && &translation == &text.translations.front())
          for (auto* places : {&expected, &found}) // "Lock handle" is better than "Lock 1 handle".
            places->erase(QStringLiteral("%n"));
        EXPECT_EQ(found, expected) << translation.toStdString();
        EXPECT_EQ(translation.count(QLatin1Char('&')), text.source.count(QLatin1Char('&')))
            << translation.toStdString();
        EXPECT_FALSE(translation.contains(QLatin1Char('{'))) << translation.toStdString();
      }
}

/// Names that the numerical modules give are in a file of their own.
TEST_P(Translations, HaveTheNamesOfTheNumericalModules) {
  QTranslator translator;
  ASSERT_TRUE(
      translator.load(QStringLiteral(":/viscera/translations/viscera_%1").arg(QLatin1String(GetParam()))));
  const auto expect = [&](const std::string& name) {
    EXPECT_FALSE(name.empty() || translator.translate("viscera::presentation", name.c_str()).isEmpty())
        << name;
  };
  for (const auto& scenario : circulation::scenarios()) {
    expect(scenario.name);
    expect(scenario.summary);
  }
  for (const auto& reading : circulation::readings())
    expect(reading.title);
  for (const auto& parameter : circulation::parameterInfos())
    expect(parameter.title);
  for (const auto& system : anatomy::organSystems())
    expect(system);
  const coordinates::Registry systems = coordinates::builtInRegistry();
  for (const coordinates::Registry::Entry& entry : systems.list())
    for (const coordinates::Parameter& parameter : entry.system->parameters()) {
      std::string label = parameter.name;
      label[0] = static_cast<char>(std::toupper(label[0]));
      expect(label);
    }
  for (const auto& sample : live::sampleSequences()) {
    expect(sample.name);
    for (const auto& role : live::landmarkRoles(sample.id)) {
      expect(role.name);
      expect(role.help);
    }
  }
}

/// Authors with a year and identifiers of publications stay as they are; a source that says more needs words.
TEST_P(Translations, HaveTheSourcesOfNormalValues) {
  static const QRegularExpression publication(QStringLiteral("doi [\\w./()-]+"));
  static const QRegularExpression author(QStringLiteral("\\b[A-Z][\\w-]* \\d{4}( \\([^)]*\\))?"));
  static const QRegularExpression letter(QStringLiteral("[A-Za-z]")), point(QStringLiteral("\\d\\.\\d"));
  QTranslator translator;
  ASSERT_TRUE(
      translator.load(QStringLiteral(":/viscera/translations/viscera_%1").arg(QLatin1String(GetParam()))));
  std::set<std::string> sources;
  for (const anatomy::Norm& norm : anatomy::norms())
    sources.insert(norm.source);
  for (const auto& parameter : circulation::parameterInfos())
    if (parameter.normal)
      sources.insert(parameter.normal->source);
  int sentences = 0;
  for (const std::string& source : sources) {
    if (!QString::fromStdString(source).remove(publication).remove(author).contains(letter))
      continue;
    ++sentences;
    QString translation = translator.translate("viscera::presentation", source.c_str());
    EXPECT_FALSE(translation.isEmpty())
        << source << " has no translation; write it into names_" << GetParam() << ".ts";
    EXPECT_FALSE(translation.remove(publication).contains(point)) << source;
  }
  EXPECT_GT(sentences, 15);
}

TEST_P(Translations, HaveTheNamesOfSampleOrgansAndTheirNormalRanges) {
  QTranslator translator;
  ASSERT_TRUE(
      translator.load(QStringLiteral(":/viscera/translations/viscera_%1").arg(QLatin1String(GetParam()))));
  for (const char* organ : {"Digestive system", "Heart", "Kidney left", "Kidney right", "Liver", "Stomach",
                            "Stomach and bowel"}) {
    EXPECT_FALSE(translator.translate("viscera::presentation", organ).isEmpty()) << organ;
    for (const heart::NormalRange& range : heart::normalRanges(organ))
      EXPECT_FALSE(translator.translate("viscera::presentation", range.name.c_str()).isEmpty()) << range.name;
  }
}

TEST(TextsOfPictures, ArePatternsAndNamesInTheLanguageOfTheWindow) {
  const app::InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(app::translated("phase %1 of %2"), "Phase %1 von %2");
  EXPECT_EQ(app::translated("Mean of %1 mm"), app::wording().translate("Mean of %1 mm", std::nullopt));
  EXPECT_NE(app::translated("Mean of %1 mm"), "Mean of %1 mm");
  EXPECT_EQ(app::translated("short axis"), "Kurzachse");
}

TEST(TextsOfPlugins, AreTakenFromTheFileBesideTheLibrary) {
  const QTemporaryDir folder;
  QFile texts(folder.filePath(QStringLiteral("least_squares_de.ts")));
  ASSERT_TRUE(texts.open(QIODevice::WriteOnly));
  texts.write(kTextsOfAPlugin);
  texts.close();
  ASSERT_EQ(
      QProcess::execute(QStringLiteral(VISCERA_LRELEASE), {QStringLiteral("-silent"), texts.fileName()}), 0);
  coordinates::Registry systems = coordinates::builtInRegistry();
  systems.add(std::make_shared<ForeignSystem>(),
              folder.filePath(QStringLiteral("least_squares.so")).toStdString());
  {
    InstalledLanguage german(QStringLiteral("de"));
    EXPECT_EQ(app::inWords(named("Least squares")), QStringLiteral("Least squares"));
    german.addTextsOf(systems);
    EXPECT_EQ(app::inWords(named("Least squares")), QStringLiteral("Kleinste Quadrate"));
    EXPECT_EQ(app::inWords(Text("too steep").capitalised()), QStringLiteral("Zu steil"));
    EXPECT_EQ(app::inWords(named("Heartbeat")), QStringLiteral("Herzschlag"))
        << "the program's own texts stay";
  }
  EXPECT_EQ(app::inWords(named("Least squares")), QStringLiteral("Least squares"));
  InstalledLanguage spanish(QStringLiteral("es"));
  spanish.addTextsOf(systems); // There is no file for it.
  EXPECT_EQ(app::inWords(named("Least squares")), QStringLiteral("Least squares"));
}

INSTANTIATE_TEST_SUITE_P(All, Translations, ::testing::Values("ca", "de", "es", "fr"),
                         [](const auto& language) { return std::string(language.param); });

TEST(WindowLanguage, IsTheChosenOneElseTheSystemsElseEnglish) {
  const QLocale catalan(QStringLiteral("ca_ES"));
  EXPECT_EQ(app::languageFor({}, catalan), QStringLiteral("ca"));
  EXPECT_EQ(app::languageFor(QStringLiteral("de"), catalan), QStringLiteral("de"));
  EXPECT_EQ(app::languageFor(QStringLiteral("xx"), QLocale(QStringLiteral("fi_FI"))), QStringLiteral("en"));
  EXPECT_EQ(app::languageFor({}, QLocale::c()), QStringLiteral("en"));
}

TEST(WindowLanguage, HasNumbersAndPluralsOfItsOwnAndGoesWithItsObject) {
  const auto voxels = [](int n) {
    return QCoreApplication::translate("viscera::app::WarpExport",
                                       "The pose folds the tissue at %n voxels: their values are estimates.",
                                       nullptr, n);
  };
  {
    const InstalledLanguage german(QStringLiteral("de"));
    EXPECT_EQ(app::formatNumber(1234.5, 1), QStringLiteral("1234,5"));
    EXPECT_EQ(app::listSeparator(), QStringLiteral("; "));
    EXPECT_EQ(app::numberIn(QStringLiteral("0,25")), 0.25);
    EXPECT_EQ(app::numberIn(QStringLiteral("0.25")), 0.25) << "as in a table of another program";
    EXPECT_FALSE(app::numberIn(QStringLiteral("two")));
    EXPECT_EQ(app::inWords(named("Aortic arch")), QStringLiteral("Aortenbogen"));
    EXPECT_EQ(app::inWords(named("A name of somebody")), QStringLiteral("A name of somebody"));
    EXPECT_EQ(app::inWords(named("LV endocardium 12")), QStringLiteral("LV-Endokard 12"));
    EXPECT_EQ(app::inWords(named("Tip of somebody 3")), QStringLiteral("Tip of somebody 3"));
    EXPECT_EQ(app::inWords(phrase("handle %1", named("LV endocardium 12"))),
              QStringLiteral("Griff LV-Endokard 12"));
    EXPECT_TRUE(voxels(3).contains(QLatin1Char('3')) && !voxels(3).contains(QLatin1String("tissue")));
  }
  EXPECT_EQ(app::formatNumber(1234.5, 1), QStringLiteral("1234.5"));
  EXPECT_EQ(app::listSeparator(), QStringLiteral(", "));
  EXPECT_EQ(voxels(1), QStringLiteral("The pose folds the tissue at 1 voxel: their values are estimates."));
}

TEST(WindowNumbers, AreNeverANegativeZero) {
  {
    const InstalledLanguage english(QStringLiteral("en"));
    EXPECT_EQ(app::formatNumber(-0.0004, 3), QStringLiteral("0.000"));
    EXPECT_EQ(app::formatNumber(-0.0, 1), QStringLiteral("0.0"));
    EXPECT_EQ(app::formatNumber(-0.4, 0), QStringLiteral("0"));
    EXPECT_EQ(app::formatNumber(-0.0006, 3), QStringLiteral("-0.001"));
    EXPECT_EQ(app::formatNumber(-10, 0), QStringLiteral("-10"));
    EXPECT_EQ(app::formatDigits(-0.0, 3), QStringLiteral("0"));
    EXPECT_EQ(app::formatDigits(-0.0004, 3), QStringLiteral("-0.0004"));
  }
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(app::formatNumber(-0.0004, 3), QStringLiteral("0,000"));
}

TEST(PhasesOfAKeySequence, AreNamedInTheLanguageOfTheWindow) {
  sequences::KeyframedSequence::Track track;
  track.restHandles = Points::Zero(2, 3);
  track.periodSeconds = 4;
  track.keys = {{1, track.restHandles}, {2, track.restHandles}};
  const sequences::KeyframedSequence sequence(track);
  const auto namesIn = [&](const char* language) {
    const InstalledLanguage installed{QLatin1String(language)};
    app::PhaseScrubber scrubber;
    scrubber.setPhases(sequence.phases(sequence.standardRatePerMinute()), track.periodSeconds);
    QStringList names;
    for (const double fraction : {0.1, 0.3, 0.6}) {
      scrubber.setFraction(fraction);
      EXPECT_EQ(scrubber.phaseText(), scrubber.phaseName());
      names.push_back(scrubber.phaseName());
    }
    return names;
  };
  EXPECT_EQ(namesIn("en"), QStringList({"start", "key 1", "key 2"}));
  EXPECT_EQ(namesIn("de"), QStringList({"Anfang", "Schlüsselbild 1", "Schlüsselbild 2"}));
  EXPECT_EQ(namesIn("es"), QStringList({"inicio", "fotograma clave 1", "fotograma clave 2"}));
  EXPECT_EQ(namesIn("fr"), QStringList({"début", "clé 1", "clé 2"}));
  EXPECT_EQ(namesIn("ca"), QStringList({"inici", "clau 1", "clau 2"}));
}

class GermanWindow : public PlayMode {
  InstalledLanguage german_{QStringLiteral("de")};
};

/// Names are translated where they are shown, and not where something is looked up by them.
TEST_F(GermanWindow, KnowsNormalRangesAndRenamesNothingByItself) {
  const auto* source = window().findChild<QWidget*>(QStringLiteral("chartSource"));
  ASSERT_NE(source, nullptr);
  EXPECT_TRUE(source->isVisible()) << "the stripes of the left ventricle";
  const auto* list = window().findChild<app::OrganPanel*>()->findChild<QTreeWidget*>();
  ASSERT_NE(list, nullptr);
  EXPECT_EQ(list->topLevelItem(0)->text(1), QStringLiteral("Herz"));
  EXPECT_EQ(document().organs().front()->name, "Heart");
}

TEST_F(GermanWindow, WritesNamesBesideTheOrgansAsTheListHasThem) {
  key(Qt::Key_N);
  const auto labels = window().picture().presenter().labels().drawn();
  ASSERT_EQ(labels.size(), 5u);
  EXPECT_EQ(labels[0].text, "Herz");
  EXPECT_EQ(labels[1].text, "LV-Höhle");
}

TEST_F(GermanWindow, NamesTheHandlesOfASequence) {
  const auto& handles = document().rig().handles;
  const int row = document().rig().indexOf("LV endocardium 1");
  ASSERT_GE(row, 0);
  window().actions()["handles.table"]->trigger();
  settle();
  app::HandleModel& model = window().findChild<app::HandleTable*>(QStringLiteral("handleTable"))->model();
  const QModelIndex cell = model.index(row, app::HandleModel::label);
  EXPECT_EQ(cell.data().toString(), QStringLiteral("LV-Endokard 1"));
  EXPECT_FALSE(model.setData(cell, cell.data(Qt::EditRole), Qt::EditRole)) << "nothing was typed";
  EXPECT_EQ(handles[static_cast<std::size_t>(row)].label, "LV endocardium 1");
  const auto lists = window().findChildren<QTreeWidget*>();
  EXPECT_TRUE(std::any_of(lists.begin(), lists.end(), [](const QTreeWidget* list) {
    return !list->findItems(QStringLiteral("LV-Endokard 1"), Qt::MatchExactly | Qt::MatchRecursive).isEmpty();
  })) << "the list of handles";
}

TEST_F(GermanWindow, NamesASampleInSentencesAsTheLanguageDoes) {
  loadSample(QStringLiteral("stomach")); // The first sample of a window is no step.
  EXPECT_EQ(window().workspace().undo().undoName().english(), "Beispiel Magen");
  EXPECT_EQ(app::SampleLoader::title(QStringLiteral("kidney_left")), QStringLiteral("Linke Niere"));
  EXPECT_EQ(app::SampleLoader::title(QStringLiteral("of_somebody")), QStringLiteral("Of somebody"));
}

TEST_F(GermanWindow, GivesStressInItsOwnUnitOfAngles) {
  key(Qt::Key_4);
  const auto& model = window().stress().model();
  ASSERT_TRUE(waitUntil([&] { return model.shown().ready(); }));
  EXPECT_EQ(model.format(12.34), QStringLiteral("12,3 °"));
  const auto* mean = window().findChild<QLabel*>(QStringLiteral("stressMean"));
  ASSERT_NE(mean, nullptr);
  EXPECT_TRUE(waitUntil([&] { return mean->text().endsWith(QStringLiteral(" °")); }))
      << mean->text().toStdString();
}

/// But in the identifiers of publications.
TEST_F(GermanWindow, WritesNoDecimalPoint) {
  static const QRegularExpression point(QStringLiteral("\\d\\.\\d"));
  static const QRegularExpression publication(QStringLiteral("doi [^ ;,)]+"));
  for (const Qt::Key mode : {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5}) {
    key(mode);
    settle();
    for (const QWidget* widget : window().findChildren<QWidget*>()) {
      const auto* label = qobject_cast<const QLabel*>(widget);
      for (QString text : {widget->toolTip(), label ? label->text() : QString()})
        EXPECT_FALSE(text.remove(publication).contains(point))
            << widget->objectName().toStdString() << ": " << text.toStdString();
    }
  }
}

TEST_F(GermanWindow, HasAWordForEverySample) {
  for (const QString& name : window().samples().names())
    EXPECT_NE(app::SampleLoader::nameInWords(name), QString(name).replace(QLatin1Char('_'), QLatin1Char(' ')))
        << name.toStdString();
}

} // namespace
} // namespace viscera::tests

#include "lesson_scene.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include <QByteArray>
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QTranslator>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "build_paths.h"
#include "mesh_differences.h"
#include "page_json.h"
#include "page_strings.h"
#include "temporary_folder.h"

namespace viscera::lesson {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What is between the first `open` and the `close` behind it.
std::string between(const std::string& page, const std::string& open, const std::string& close) {
  const std::size_t begin = page.find(open);
  EXPECT_NE(begin, std::string::npos) << open;
  return page.substr(begin + open.size(), page.find(close, begin + open.size()) - begin - open.size());
}

std::string hashOf(const std::string& text) {
  return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
      .toBase64()
      .toStdString();
}

std::size_t countOf(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

/// A colour of a style, #rgb or #rrggbb, red green blue from 0 to 1.
Vec3 styleColor(const std::string& hex) {
  const std::size_t digits = hex.size() / 3;
  Vec3 color;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string part = hex.substr(i * digits, digits);
    color[static_cast<Eigen::Index>(i)] = std::stoi(digits == 1 ? part + part : part, nullptr, 16) / 255.0;
  }
  return color;
}

/// The contrast of two colours after WCAG 2.
double pageContrast(const Vec3& a, const Vec3& b) {
  const auto luminance = [](const Vec3& color) {
    const auto linear = [](double x) {
      return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.x()) + 0.7152 * linear(color.y()) + 0.0722 * linear(color.z());
  };
  return (std::max(luminance(a), luminance(b)) + 0.05) / (std::min(luminance(a), luminance(b)) + 0.05);
}

/// A language in which everything is called back to front.
class Backwards : public QTranslator {
public:
  QString translate(const char* context, const char* text, const char*, int) const override {
    if (qstrcmp(context, "Lesson") != 0)
      return {};
    const QString forwards = QString::fromUtf8(text);
    QString backwards;
    for (const QChar letter : forwards)
      backwards.prepend(letter);
    return backwards;
  }
  bool isEmpty() const override { return false; }
};

} // namespace

TEST(Page, AllowsItsOwnScriptAndStyleOnly) {
  BallScene scene;
  const std::string page = pageOf(scene.made(scene.source(scene.sway())));
  const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
  EXPECT_THAT(policy, HasSubstr("default-src 'none'"));
  EXPECT_THAT(policy, HasSubstr("script-src 'sha256-" +
                                hashOf(between(page, "<script type=\"module\">", "</script>")) + "'"));
  EXPECT_THAT(policy, HasSubstr("style-src 'sha256-" + hashOf(between(page, "<style>", "</style>")) + "'"));
  EXPECT_THAT(page, Not(HasSubstr("style=\"")));
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_FALSE(std::regex_search(page.substr(0, 6000), std::regex(" on[a-z]+=")));
}

/// A name's plate lets a part of what is behind it through, which may be anything from black to white.
TEST(Page, HasNamesThatCanBeReadOnAnythingInBothThemes) {
  constexpr double kReadable = 4.5, kPercent = 100;
  BallScene scene;
  const std::string style = between(pageOf(scene.made(scene.source(scene.sway()))), "<style>", "</style>");
  const double plate =
      std::stod(between(between(style, ".name{", "}"), "color-mix(in srgb,var(--bottom) ", "%")) / kPercent;
  for (const char* theme : {":root{", ":root.light{"}) {
    const std::string colors = between(style, theme, "}") + ";";
    const Vec3 text = styleColor(between(colors, "--text:#", ";"));
    const Vec3 ground = styleColor(between(colors, "--bottom:#", ";"));
    for (const double behind : {0.0, 0.25, 0.5, 0.75, 1.0})
      EXPECT_GE(pageContrast(text, plate * ground + (1 - plate) * Vec3::Constant(behind)), kReadable)
          << theme << ", " << behind;
  }
}

TEST(Page, KeepsHostileTextsAsText) {
  BallScene scene;
  const LessonSource source = scene.source(nullptr);
  const std::string hostile =
      "</script><script>window.hostile=1</script>'\"&<!-- \xE2\x80\xAE @SCRIPT@ @TITLE@ \xE2\x80\xA8" +
      std::string(10000, 'x');
  LessonPlan plan = planLesson(source, {});
  for (LessonText& text : textsOf(plan))
    *text.text = hostile;
  const Lesson lesson = makeLesson(plan, source, scene.live, scene.progress);
  const std::string page = pageOf(lesson);
  EXPECT_EQ(countOf(page, "</script>"), 3u);
  EXPECT_EQ(countOf(page, "window.hostile=1"),
            1u + countOf(between(page, "id=\"lesson\">", "</script>"), "window.hostile=1"))
      << "once as the escaped title";
  const auto json = nlohmann::json::parse(between(page, "id=\"lesson\">", "</script>"));
  EXPECT_EQ(json["title"], hostile);
  EXPECT_EQ(json["surfaces"][0]["title"], hostile);
  EXPECT_THAT(between(page, "<title>", "</title>"), HasSubstr("&lt;/script&gt;"));
}

TEST(Page, SurvivesBytesThatAreNoText) {
  BallScene scene;
  const LessonSource source = scene.source(nullptr);
  LessonPlan plan = planLesson(source, {});
  plan.title = "broken \xFF\xC3";
  const std::string page = pageOf(makeLesson(plan, source, scene.live, scene.progress));
  EXPECT_TRUE(nlohmann::json::accept(between(page, "id=\"lesson\">", "</script>")));
}

TEST(Page, HoldsWhatTheLessonHolds) {
  BallScene scene;
  const Lesson lesson = scene.made(scene.source(scene.sway()));
  const std::string page = pageOf(lesson);
  const auto json = nlohmann::json::parse(between(page, "id=\"lesson\">", "</script>"));
  const QByteArray packed =
      QByteArray::fromBase64(QByteArray::fromStdString(between(page, "id=\"arrays\">", "</script>")));
  const std::string bytes = inflated(packed.toStdString());
  const auto array = [&](const char* name) {
    const auto& where = json["arrays"][name];
    return unpacked({where["at"], where["count"], where["width"], where["stride"], where["step"]}, bytes);
  };
  const std::vector<double> rest = array("rest");
  ASSERT_EQ(rest.size(), static_cast<std::size_t>(lesson.rest.size()));
  for (Eigen::Index i = 0; i < lesson.rest.size(); ++i)
    ASSERT_NEAR(rest[static_cast<std::size_t>(i)], lesson.rest.data()[i], 1e-9);
  const std::vector<double> triangles = array("triangles");
  for (Eigen::Index i = 0; i < lesson.triangles.size(); ++i)
    ASSERT_EQ(triangles[static_cast<std::size_t>(i)], lesson.triangles.data()[i]);
  EXPECT_EQ(array("motion").size(), lesson.modes.size() * rest.size());
  EXPECT_EQ(array("course").size(), 2 * lesson.modes.size() * lesson.instants()) << "values and slopes";
  const auto overMesh = [&](const char* name, Eigen::Index vertices, int components) {
    std::vector<std::int32_t> steps;
    for (const double value : array(name))
      steps.push_back(
          static_cast<std::int32_t>(std::lround(value / json["arrays"][name]["step"].get<double>())));
    return MeshDifferences(lesson.triangles, vertices).undone(steps, components);
  };
  const std::vector<std::int32_t> weights = overMesh("weights", lesson.vertexCount(), 1);
  for (Eigen::Index i = 0; i < lesson.weights.size(); ++i)
    ASSERT_NEAR(weights[static_cast<std::size_t>(i)] * kWeightStep, lesson.weights.data()[i], kWeightStep);
  const std::vector<std::int32_t> modes = overMesh("motion", lesson.rest.rows(), 3);
  for (std::size_t i = 0; i < modes.size(); ++i)
    ASSERT_NEAR(modes[i] * kStepMm, lesson.modes[i / rest.size()].data()[i % rest.size()], kStepMm);
  EXPECT_THAT(page, Not(HasSubstr(VISCERA_SOURCE_DIR)));
  EXPECT_THAT(page, Not(HasSubstr("description")));
}

TEST(Page, AsksForStringsThatThereAre) {
  BallScene scene;
  const std::string page = pageOf(scene.made(scene.source(nullptr)));
  const auto json = nlohmann::json::parse(between(page, "id=\"lesson\">", "</script>"));
  const std::string own =
      page.substr(0, page.find("id=\"lesson\">")) + between(page, "<script type=\"module\">", "</script>");
  int asked = 0;
  const std::regex names(R"re(say\('(\w+)'|data-(?:say|tip|label)="(\w+)"|giveUp\('(\w+)'\))re");
  for (std::sregex_iterator found(own.begin(), own.end(), names); found != std::sregex_iterator(); ++found) {
    const std::string key = (*found)[1].str() + (*found)[2].str() + (*found)[3].str();
    EXPECT_TRUE(json["strings"].contains(key)) << key;
    ++asked;
  }
  EXPECT_GT(asked, 50);
}

TEST(Page, SpeaksTheLanguageOfTheWindow) {
  int count = 1;
  char name[] = "test";
  char* arguments[] = {name, nullptr};
  QCoreApplication application(count, arguments);
  Backwards language;
  QCoreApplication::installTranslator(&language);
  BallScene scene;
  const std::string page = pageOf(scene.made(scene.source(nullptr)));
  const auto json = nlohmann::json::parse(between(page, "id=\"lesson\">", "</script>"));
  EXPECT_EQ(json["strings"]["quiz"], "ziuQ");
  EXPECT_EQ(json["strings"]["next"], "txeN");
}

TEST(Page, SpeaksEachLanguageThatComesWithTheProgram) {
  const auto english = PageWords("en").pageStrings();
  EXPECT_EQ(english.at("quiz"), "Quiz");
  const std::vector<PageLanguage> languages = pageLanguages();
  ASSERT_EQ(languages.size(), 5u);
  for (const PageLanguage& language : languages) {
    if (language.code == "en")
      continue;
    QTranslator translation;
    ASSERT_TRUE(
        translation.load(QString::fromStdString(":/viscera/translations/viscera_" + language.code + ".qm")));
    for (const auto& [key, text] : english) {
      QString found = translation.translate("Lesson", text.c_str());
      if (found.isEmpty()) // A text of the modules has its translation there.
        found = translation.translate("viscera::presentation", text.c_str());
      const std::string translated = found.toStdString();
      EXPECT_FALSE(translated.empty()) << language.code << " does not say: " << text;
      for (const char* place : {"%1", "%2", "%3"})
        EXPECT_EQ(countOf(text, place), countOf(translated, place)) << language.code << ": " << translated;
    }
    EXPECT_EQ(PageWords(language.code).said(kLanguageCode), language.code);
  }
}

TEST(Page, WritesItsNumbersAsItsLanguageDoes) {
  BallScene scene;
  LessonSpec spec;
  spec.language = "fr";
  const std::string page = pageOf(scene.made(scene.source(nullptr), spec));
  EXPECT_THAT(page, HasSubstr("<html lang=\"fr\" dir=\"ltr\">"));
  const auto json = nlohmann::json::parse(between(page, "id=\"lesson\">", "</script>"));
  EXPECT_EQ(json["language"], "fr");
  EXPECT_EQ(json["strings"]["speed"], "Vitesse");
}

TEST(Page, IsShortEnoughToRead) {
  std::size_t lines = 0, heart = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(VISCERA_SOURCE_DIR) /
                                                               "modules/publish/lesson/page"))
    if (entry.path().extension() != ".qrc") {
      std::ifstream stream(entry.path());
      std::size_t& counted = entry.path().filename() == "heart.js" ? heart : lines;
      for (std::string line; std::getline(stream, line);)
        ++counted;
    }
  EXPECT_GT(lines, 300u);
  // The bull's eye of strain has 30, the places where an opened heart joins in 27, differences along the
  // mesh 10.
  EXPECT_LE(lines, 830u);
  EXPECT_GT(heart, 0u);
  EXPECT_LE(heart, 140u); // Only lessons of an opened heart have it.
}

TEST(Page, IsWrittenWholeOrNotAtAll) {
  BallScene scene;
  const Lesson lesson = scene.made(scene.source(nullptr));
  const viscera::tests::TemporaryFolder folder;
  writePage(folder.path() / "lesson.html", lesson);
  std::ifstream stream(folder.path() / "lesson.html", std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), pageOf(lesson));
}

} // namespace viscera::lesson

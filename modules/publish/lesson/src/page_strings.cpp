#include "page_strings.h"

#include <string_view>

#include <QCoreApplication>
#include <QTranslator>

#include "viscera/core/phrase.h"
#include "viscera/lesson/lesson_spec.h"

namespace viscera::lesson {
namespace {

struct Said {
  const char* key;
  const char* text;
};

// clang-format off
constexpr Said kSaid[] = {
    {"stage", QT_TRANSLATE_NOOP("Lesson", "The organs in three dimensions")},
    {"view", QT_TRANSLATE_NOOP("Lesson", "%1. Drag or use the arrow keys to turn, two fingers, the wheel or plus and minus to come nearer.")},
    {"tools", QT_TRANSLATE_NOOP("Lesson", "View")},
    {"panel", QT_TRANSLATE_NOOP("Lesson", "Numbers")},
    {"measurements", "Measurements"},
    {"slides", QT_TRANSLATE_NOOP("Lesson", "Slides")},
    {"quiz", QT_TRANSLATE_NOOP("Lesson", "Quiz")},
    {"theme", QT_TRANSLATE_NOOP("Lesson", "Light or dark (T)")},
    {"side", QT_TRANSLATE_NOOP("Lesson", "Seen from (1, 3, 7)")},
    {"anterior", QT_TRANSLATE_NOOP("Lesson", "Front")},
    {"posterior", QT_TRANSLATE_NOOP("Lesson", "Back")},
    {"left", QT_TRANSLATE_NOOP("Lesson", "Left")},
    {"right", QT_TRANSLATE_NOOP("Lesson", "Right")},
    {"superior", QT_TRANSLATE_NOOP("Lesson", "Above")},
    {"inferior", QT_TRANSLATE_NOOP("Lesson", "Below")},
    {"names", QT_TRANSLATE_NOOP("Lesson", "Names")},
    {"namesTip", QT_TRANSLATE_NOOP("Lesson", "Names of the parts (N)")},
    {"handles", "Handles"},
    {"handlesTip", QT_TRANSLATE_NOOP("Lesson", "Handles to drag (H)")},
    {"cut", QT_TRANSLATE_NOOP("Lesson", "Cut open")},
    {"cutTip", QT_TRANSLATE_NOOP("Lesson", "Open the heart and look into it (C)")},
    {"blood", QT_TRANSLATE_NOOP("Lesson", "Blood")},
    {"bloodTip", QT_TRANSLATE_NOOP("Lesson", "Blood in the opened chambers (F)")},
    {"conduction", QT_TRANSLATE_NOOP("Lesson", "Conduction")},
    {"conductionTip", QT_TRANSLATE_NOOP("Lesson", "Conduction system, lit with the electrocardiogram (E)")},
    {"ecg", QT_TRANSLATE_NOOP("Lesson", "ECG")},
    {"heartKeys", QT_TRANSLATE_NOOP("Lesson", "C: cut open, F: blood, E: conduction system")},
    {"reset", QT_TRANSLATE_NOOP("Lesson", "Reset")},
    {"resetTip", QT_TRANSLATE_NOOP("Lesson", "Back to the original shape (R)")},
    {"hint", QT_TRANSLATE_NOOP("Lesson", "Drag a handle.")},
    {"held", QT_TRANSLATE_NOOP("Lesson", "Handle %1: arrow keys, plus and minus move it.")},
    {"slideBefore", QT_TRANSLATE_NOOP("Lesson", "Previous slide (Page Up)")},
    {"slideAfter", QT_TRANSLATE_NOOP("Lesson", "Next slide (Page Down)")},
    {"slide", QT_TRANSLATE_NOOP("Lesson", "%1 of %2: %3")},
    {"eye", QT_TRANSLATE_NOOP("Lesson", "Show %1")},
    {"ml", QT_TRANSLATE_NOOP("Lesson", "%1 ml")},
    {"mm", QT_TRANSLATE_NOOP("Lesson", "%1 mm")},
    {"degrees", QT_TRANSLATE_NOOP("Lesson", "%1\xC2\xB0")},
    {"percent", QT_TRANSLATE_NOOP("Lesson", "%1 %")},
    {"litres", QT_TRANSLATE_NOOP("Lesson", "%1 l/min")},
    {"seconds", QT_TRANSLATE_NOOP("Lesson", "%1 s")},
    {"ofRest", QT_TRANSLATE_NOOP("Lesson", "%1 % of rest")},
    {"byHandles", QT_TRANSLATE_NOOP("Lesson", "%1 % from moved handles")},
    {"ejection", QT_TRANSLATE_NOOP("Lesson", "%1: ejection fraction")},
    {"stroke", "Stroke volume"},
    {"output", QT_TRANSLATE_NOOP("Lesson", "Cardiac output")},
    {"normal", QT_TRANSLATE_NOOP("Lesson", "normal %1")},
    {"healthy", QT_TRANSLATE_NOOP("Lesson", "%1 of healthy people")},
    {"was", QT_TRANSLATE_NOOP("Lesson", "without handles %1")},
    {"seeThrough", QT_TRANSLATE_NOOP("Lesson", "Wall")},
    {"speed", QT_TRANSLATE_NOOP("Lesson", "Speed")},
    {"play", QT_TRANSLATE_NOOP("Lesson", "Play")},
    {"stop", QT_TRANSLATE_NOOP("Lesson", "Stop")},
    {"time", QT_TRANSLATE_NOOP("Lesson", "Moment of the cycle")},
    {"timeText", QT_TRANSLATE_NOOP("Lesson", "%1 s, %2")},
    {"rate", "Rate"},
    {"aMinute", QT_TRANSLATE_NOOP("Lesson", "%1 a minute")},
    {"chart", QT_TRANSLATE_NOOP("Lesson", "Volumes over one cycle: %1")},
    {"keys", QT_TRANSLATE_NOOP("Lesson", "Keys")},
    {"keyText", QT_TRANSLATE_NOOP("Lesson", "Space: play or stop\nArrow keys: turn the picture when it has the focus, else go through the cycle\nPlus, minus: nearer, farther\nPage Down, Page Up: next and previous slide; B: dark screen\nJ, K: choose a handle; arrow keys, plus and minus move it; Escape lets it go\n1, 3, 7: front, left, above\nN: names, H: handles, X: wall, R: reset, T: light or dark, Home: beginning")},
    {"next", QT_TRANSLATE_NOOP("Lesson", "Next")},
    {"again", QT_TRANSLATE_NOOP("Lesson", "Again")},
    {"leave", QT_TRANSLATE_NOOP("Lesson", "Leave the quiz")},
    {"askName", QT_TRANSLATE_NOOP("Lesson", "What is marked?")},
    {"askPhase", QT_TRANSLATE_NOOP("Lesson", "Which phase is this?")},
    {"askShrinks", QT_TRANSLATE_NOOP("Lesson", "Which chamber shrinks now?")},
    {"all", QT_TRANSLATE_NOOP("Lesson", "Both")},
    {"none", QT_TRANSLATE_NOOP("Lesson", "None")},
    {"rightAnswer", QT_TRANSLATE_NOOP("Lesson", "Right.")},
    {"wrongAnswer", QT_TRANSLATE_NOOP("Lesson", "No. The answer is: %1.")},
    {"score", QT_TRANSLATE_NOOP("Lesson", "%1 of %2 right")},
    {"done", QT_TRANSLATE_NOOP("Lesson", "%1 of %2 right.")},
    {"tooOld", QT_TRANSLATE_NOOP("Lesson", "This lesson needs a browser of 2023 or later.")},
    {"noWebGl", QT_TRANSLATE_NOOP("Lesson", "This lesson needs WebGL 2. It may be switched off in this browser.")},
    {"lost", QT_TRANSLATE_NOOP("Lesson", "The graphics were lost. Load the page again.")},
    {"failure", QT_TRANSLATE_NOOP("Lesson", "This lesson needs a browser of 2023 or later, with JavaScript and WebGL 2.")}};

/// Texts that are used elsewhere in this module. Among them are names of sequences and phases that a lesson
/// calls otherwise than the window; all other names are in the context of the numerical modules.
[[maybe_unused]] constexpr const char* kElsewhere[] = {
    QT_TRANSLATE_NOOP("Lesson", "Title"), QT_TRANSLATE_NOOP("Lesson", "Notes"),
    QT_TRANSLATE_NOOP("Lesson", "Label in the view"), QT_TRANSLATE_NOOP("Lesson", "Normal range"),
    QT_TRANSLATE_NOOP("Lesson", "Measurement"), QT_TRANSLATE_NOOP("Lesson", "Phase"),
    QT_TRANSLATE_NOOP("Lesson", "Slide"), QT_TRANSLATE_NOOP("Lesson", "Text of the slide"),
    QT_TRANSLATE_NOOP("Lesson", "Handle"), QT_TRANSLATE_NOOP("Lesson", "volume after a meal"),
    //: The code of your language (BCP 47): numbers are written as it does.
    QT_TRANSLATE_NOOP("Lesson", "en"),
    QT_TRANSLATE_NOOP("Lesson", "For teaching. It is not a medical device."),
    QT_TRANSLATE_NOOP("Lesson", "Heartbeat"), QT_TRANSLATE_NOOP("Lesson", "Gastric peristalsis"),
    QT_TRANSLATE_NOOP("Lesson", "Wave in the body"),
    QT_TRANSLATE_NOOP("Lesson", "Terminal antral contraction"),
    QT_TRANSLATE_NOOP("Lesson", "Wave fades at the pylorus")};
// clang-format on

/// The context of the texts of the numerical modules in resources/translations/names_*.ts.
constexpr const char* kNames = "viscera::presentation";

} // namespace

std::string said(const char* text) {
  return PageWords().said(text);
}

PageWords::PageWords(const std::string& language) : language_(language) {
  if (language.empty() || language == kLanguageCode)
    return;
  translation_ = std::make_unique<QTranslator>();
  if (!translation_->load(
          QStringLiteral(":/viscera/translations/viscera_%1.qm").arg(QString::fromStdString(language))))
    translation_.reset();
}

PageWords::~PageWords() = default;

std::string PageWords::said(const char* text) const {
  const std::string own = translated("Lesson", text);
  return own == text ? named(text) : own;
}

std::string PageWords::named(const std::string& text) const {
  return inWords(viscera::named(text));
}

std::string PageWords::inWords(const Text& text) const {
  return viscera::inWords(text, {[this](const std::string& pattern, std::optional<int> number) {
                            return translated(kNames, pattern.c_str(), number.value_or(-1));
                          }});
}

std::string PageWords::translated(const char* context, const char* text, int number) const {
  if (language_.empty())
    return QCoreApplication::translate(context, text, nullptr, number).toStdString();
  const QString found = translation_ ? translation_->translate(context, text, nullptr, number) : QString();
  return found.isEmpty() ? text : found.toStdString();
}

std::map<std::string, std::string> PageWords::pageStrings() const {
  std::map<std::string, std::string> strings;
  for (const Said& item : kSaid)
    strings[item.key] = said(item.text);
  return strings;
}

std::vector<PageLanguage> pageLanguages() {
  return {{"en", "English"},
          {"de", "Deutsch"},
          {"es", "Espa\xC3\xB1ol"},
          {"fr", "Fran\xC3\xA7\x61is"},
          {"ca", "Catal\xC3\xA0"}};
}

} // namespace viscera::lesson

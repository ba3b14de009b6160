#include "window/style/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QTranslator>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string_view>

namespace viscera::app {
namespace {

constexpr const char* kEnglish = "en";
/// The contexts of resources/translations/names_*.ts: texts of the numerical modules, and those that several
/// classes of the window say.
constexpr const char* kNames = "viscera::presentation";
constexpr const char* kShared = "viscera::app";

/// Takes what a class of the window does not translate itself from the texts that are translated once for
/// all of them. Qt's own classes keep Qt's words.
class WindowTranslator final : public QTranslator {
public:
  QString translate(const char* context, const char* text, const char* comment, int number) const override {
    QString found = QTranslator::translate(context, text, comment, number);
    if (std::string_view(context).substr(0, std::strlen(kShared)) != kShared)
      return found;
    for (const char* common : {kShared, kNames})
      if (found.isEmpty())
        found = QTranslator::translate(common, text, comment, number);
    return found;
  }
};

} // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {{QLatin1String(kEnglish), QStringLiteral("English")},
                                            {QStringLiteral("ca"), QStringLiteral("Catal\u00e0")},
                                            {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                            {QStringLiteral("es"), QStringLiteral("Espa\u00f1ol")},
                                            {QStringLiteral("fr"), QStringLiteral("Fran\u00e7ais")}};
  return all;
}

QLocale localeOf(const QString& code) {
  QLocale locale(code == QLatin1String(kEnglish) ? QLocale(QLocale::English, QLocale::UnitedStates)
                                                 : QLocale(code));
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  return locale;
}

QString languageFor(const QString& chosen, const QLocale& system) {
  const auto known = [](const QString& code) {
    return std::any_of(languages().begin(), languages().end(),
                       [&](const Language& language) { return language.code == code; });
  };
  const QString ofSystem = system.name().section(QLatin1Char('_'), 0, 0);
  return known(chosen) ? chosen : known(ofSystem) ? ofSystem : QString::fromLatin1(kEnglish);
}

InstalledLanguage::InstalledLanguage(const QString& code) : code_(code) {
  QLocale::setDefault(localeOf(code));
  const auto install = [this](std::unique_ptr<QTranslator> translator, const QString& file,
                              const QString& folder) {
    if (translator->load(file, folder) && QCoreApplication::installTranslator(translator.get()))
      translators_.push_back(std::move(translator));
  };
  if (code == QLatin1String(kEnglish))
    return;
  // Add those of Qt's own dialogs, where Qt has them here; ours come first.
  install(std::make_unique<QTranslator>(), QStringLiteral("qtbase_") + code,
          QLibraryInfo::location(QLibraryInfo::TranslationsPath));
  const QString folder = QStringLiteral(":/viscera/translations");
  auto ours = std::make_unique<WindowTranslator>();
  ours_ = ours.get();
  install(std::move(ours), QStringLiteral("viscera_") + code, folder);
  if (translators_.empty() || translators_.back().get() != ours_)
    ours_ = nullptr; // It could not be loaded.
}

void InstalledLanguage::addTextsOf(const coordinates::Registry& systems) {
  std::set<QString> files;
  for (const coordinates::Registry::Entry& entry : systems.list())
    if (entry.source != coordinates::Registry::kBuiltIn) {
      const QFileInfo library(QString::fromStdString(entry.source));
      files.insert(library.dir().filePath(library.completeBaseName() + QLatin1Char('_') + code_ +
                                          QStringLiteral(".qm")));
    }
  for (const QString& file : files) {
    if (!ours_ || !QFileInfo::exists(file)) // QTranslator would look for files with shorter names, too.
      continue;
    auto texts = std::make_unique<QTranslator>();
    if (!texts->load(file))
      continue;
    // The one installed last is asked first: what the program has itself, no plugin can rename.
    QCoreApplication::removeTranslator(ours_);
    QCoreApplication::installTranslator(texts.get());
    QCoreApplication::installTranslator(ours_);
    translators_.push_back(std::move(texts));
  }
}

InstalledLanguage::~InstalledLanguage() {
  QLocale::setDefault(before_);
}

QString formatNumber(double value, int decimals) {
  const QString text = QLocale().toString(value, 'f', decimals);
  const bool zero =
      value <= 0 && std::isfinite(value) &&
      std::all_of(text.begin(), text.end(), [](QChar letter) { return letter.digitValue() <= 0; });
  return zero ? QLocale().toString(0.0, 'f', decimals) : text;
}

QString formatDigits(double value, int digits) {
  return QLocale().toString(value == 0 ? 0.0 : value, 'g', digits); // Minus zero is zero, too.
}

char decimalMark() {
  return QLocale().decimalPoint().toLatin1();
}

QString listSeparator() {
  return decimalMark() == ',' ? QStringLiteral("; ") : QStringLiteral(", ");
}

std::optional<double> numberIn(const QString& typed) {
  bool number = false;
  const double value = QLocale().toDouble(typed, &number);
  if (number)
    return value;
  const double plain = QLocale::c().toDouble(typed, &number);
  return number ? std::optional(plain) : std::nullopt;
}

Wording wording() {
  const auto translate = [](const std::string& pattern, std::optional<int> number) {
    return QCoreApplication::translate(kNames, pattern.c_str(), nullptr, number.value_or(-1)).toStdString();
  };
  return {translate, std::string(1, decimalMark())};
}

QString inWords(const Text& text) {
  return QString::fromStdString(viscera::inWords(text, wording()));
}

QString inWords(const std::string& name) {
  return inWords(named(name));
}

} // namespace viscera::app

#include "viscera/report/fonts_at_hand.h"

#include <clocale>

#include <QFontDatabase>
#include <QGuiApplication>

#include "viscera/core/error.h"

namespace viscera::report {
namespace {
constexpr int kServiceUnavailable = 69;
} // namespace

struct FontsAtHand::Application {
  char name[8] = "viscera", option[10] = "-platform", platform[10] = "offscreen";
  char* arguments[4] = {name, option, platform, nullptr};
  int count = 3;
  QGuiApplication application{count, arguments};
};

FontsAtHand::FontsAtHand() {
  if (!QCoreApplication::instance()) {
    // Qt's warning about XDG_RUNTIME_DIR says nothing to who has no desktop.
    const QtMessageHandler before =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    own_ = std::make_unique<Application>();
    qInstallMessageHandler(before);
    std::setlocale(LC_NUMERIC, "C"); // Qt has set the user's.
  }
  if (QFontDatabase().families().isEmpty())
    throw Error(kServiceUnavailable, "There is no font to write with", "fontconfig",
                "install one, such as the package fonts-dejavu-core");
}

FontsAtHand::~FontsAtHand() = default;

} // namespace viscera::report

#include "window/application.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include "window/english_plurals.h"

namespace viscera::app {

void prepareForApplication() {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
}

void setUpApplication(QApplication& application) {
  QApplication::setApplicationName(QStringLiteral("viscera"));
  QApplication::setApplicationDisplayName(QStringLiteral("Viscera"));
  QApplication::setApplicationVersion(QStringLiteral(VISCERA_VERSION));
  QApplication::installTranslator(new EnglishPlurals(&application));
}

} // namespace viscera::app

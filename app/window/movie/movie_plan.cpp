#include "window/movie/movie_plan.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace viscera::app {
namespace {

QString movieText(const char* text) {
  return QCoreApplication::translate("viscera::app::MoviePlan", text);
}

} // namespace

std::vector<MovieFormatInfo> movieFormats() {
  using Format = MovieFormat;
  return {{Format::ogg, movieText(QT_TRANSLATE_NOOP("viscera::app::MoviePlan", "Ogg movie (.ogv)")),
           QStringLiteral(".ogv"), false, true},
          {Format::mp4, movieText(QT_TRANSLATE_NOOP("viscera::app::MoviePlan", "MP4 movie (.mp4)")),
           QStringLiteral(".mp4"), true, true},
          {Format::gif, movieText(QT_TRANSLATE_NOOP("viscera::app::MoviePlan", "Animated GIF (.gif)")),
           QStringLiteral(".gif"), true, true},
          {Format::pictures, movieText(QT_TRANSLATE_NOOP("viscera::app::MoviePlan", "PNG pictures (folder)")),
           QString(), false, true},
          {Format::table, movieText(QT_TRANSLATE_NOOP("viscera::app::MoviePlan", "Table of volumes (.csv)")),
           QStringLiteral(".csv"), false, false}};
}

MovieFormatInfo infoOf(MovieFormat format) {
  for (const MovieFormatInfo& info : movieFormats())
    if (info.format == format)
      return info;
  return {};
}

QString MoviePlan::tableFile() const {
  const QFileInfo info(file);
  return info.path() + QLatin1Char('/') + info.completeBaseName() + QStringLiteral(".csv");
}

QString freeMovieFile(const QString& folder, const QString& name, MovieFormat format, bool table) {
  const QString ending = infoOf(format).ending;
  for (int number = 1;; ++number) {
    const QString suffix = number == 1 ? QString() : QStringLiteral("_%1").arg(number);
    MoviePlan plan;
    plan.file = folder + QLatin1Char('/') + name + suffix + ending;
    if (!QFileInfo::exists(plan.file) && !(table && QFileInfo::exists(plan.tableFile())))
      return plan.file;
  }
}

} // namespace viscera::app

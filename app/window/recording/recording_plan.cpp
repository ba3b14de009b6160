#include "window/recording/recording_plan.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace viscera::app {
namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("viscera::app::RecordingPlan", text);
}

} // namespace

std::vector<RecordingFormatInfo> recordingFormats() {
  using Format = RecordingFormat;
  return {{Format::ogg, translated("Ogg movie (.ogv)"), QStringLiteral(".ogv"), false, true},
          {Format::mp4, translated("MP4 movie (.mp4)"), QStringLiteral(".mp4"), true, true},
          {Format::gif, translated("Animated GIF (.gif)"), QStringLiteral(".gif"), true, true},
          {Format::pictures, translated("PNG pictures (folder)"), QString(), false, true},
          {Format::table, translated("Table of volumes (.csv)"), QStringLiteral(".csv"), false, false}};
}

RecordingFormatInfo infoOf(RecordingFormat format) {
  for (const RecordingFormatInfo& info : recordingFormats())
    if (info.format == format)
      return info;
  return {};
}

QString RecordingPlan::tableFile() const {
  const QFileInfo info(file);
  return info.path() + QLatin1Char('/') + info.completeBaseName() + QStringLiteral(".csv");
}

QString freeRecordingFile(const QString& folder, const QString& name, RecordingFormat format) {
  const QString ending = infoOf(format).ending;
  for (int number = 1;; ++number) {
    const QString suffix = number == 1 ? QString() : QStringLiteral("_%1").arg(number);
    const QString file = folder + QLatin1Char('/') + name + suffix + ending;
    if (!QFileInfo::exists(file))
      return file;
  }
}

} // namespace viscera::app

#include "window/stress/stress_look.h"

#include <QStringList>

#include <algorithm>

namespace viscera::app {
namespace {

constexpr double kShortestNormal = 1e-6;
constexpr int kAllDigits = 17; ///< Of a double.

Vec3 normalFrom(const QString& numbers) {
  const QStringList parts = numbers.split(QLatin1Char(' '));
  if (parts.size() != 3)
    return StressLook().normal;
  const Vec3 normal(parts[0].toDouble(), parts[1].toDouble(), parts[2].toDouble());
  return normal.allFinite() && normal.norm() > kShortestNormal ? Vec3(normal.normalized())
                                                               : StressLook().normal;
}

QString numbersOf(const Vec3& normal) {
  return QStringLiteral("%1 %2 %3")
      .arg(normal.x(), 0, 'g', kAllDigits)
      .arg(normal.y(), 0, 'g', kAllDigits)
      .arg(normal.z(), 0, 'g', kAllDigits);
}

} // namespace

StressLook loadStressLook(const Settings& settings) {
  StressLook look;
  look.quantity = live::stressQuantityFromId(settings.value("stress/quantity").toString().toStdString());
  look.onSurface = settings.value("stress/onSurface", look.onSurface).toBool();
  look.cut = settings.value("stress/cut", look.cut).toBool();
  look.style = settings.value("stress/cutStyle").toString() == QLatin1String("crinkle")
                   ? scene::CutStyle::crinkle
                   : scene::CutStyle::smooth;
  look.normal = normalFrom(settings.value("stress/normal", numbersOf(look.normal)).toString());
  look.offset = std::clamp(settings.value("stress/offset", look.offset).toDouble(), -1.0, 1.0);
  const QString glyphs = settings.value("stress/glyphs").toString();
  look.glyphs = glyphs == QLatin1String("ellipsoids") ? GlyphChoice::ellipsoids
                : glyphs == QLatin1String("crosses")  ? GlyphChoice::crosses
                                                      : GlyphChoice::none;
  look.handles = settings.value("stress/handles", look.handles).toBool();
  look.others = settings.value("stress/others", look.others).toBool();
  look.witnesses = std::clamp(settings.value("stress/witnesses", look.witnesses).toInt(),
                              live::WitnessOptions::kFewest, live::WitnessOptions::kMost);
  return look;
}

void saveStressLook(const StressLook& look, Settings& settings) {
  settings.setValue("stress/quantity", QString::fromStdString(live::describe(look.quantity).id));
  settings.setValue("stress/onSurface", look.onSurface);
  settings.setValue("stress/cut", look.cut);
  settings.setValue("stress/cutStyle", look.style == scene::CutStyle::crinkle ? QStringLiteral("crinkle")
                                                                              : QStringLiteral("smooth"));
  settings.setValue("stress/normal", numbersOf(look.normal));
  settings.setValue("stress/offset", look.offset);
  settings.setValue("stress/glyphs", look.glyphs == GlyphChoice::ellipsoids ? QStringLiteral("ellipsoids")
                                     : look.glyphs == GlyphChoice::crosses  ? QStringLiteral("crosses")
                                                                            : QStringLiteral("none"));
  settings.setValue("stress/handles", look.handles);
  settings.setValue("stress/others", look.others);
  settings.setValue("stress/witnesses", look.witnesses);
}

} // namespace viscera::app

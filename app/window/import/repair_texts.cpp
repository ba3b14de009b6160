#include "window/import/repair_texts.h"

#include <QCoreApplication>

#include <map>

#include "viscera/medical_io/organ_norms.h"
#include "viscera/medical_io/surface_repairs.h"
#include "window/workspace.h"

namespace viscera::app {
namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("viscera::app::Repairs", text);
}

} // namespace

QString repairName(const std::string& id) {
  static const std::map<std::string, const char*> kNames = {
      {"orient", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Face outward")},
      {"fill-holes", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Fill holes")},
      {"keep-largest", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Keep the largest piece")},
      {"remesh", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Make anew")},
      {"mirror", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Mirror left and right")},
      {"ras-to-lps", QT_TRANSLATE_NOOP("viscera::app::Repairs", "It is RAS: turn to LPS")}};
  const auto known = kNames.find(id);
  if (known != kNames.end())
    return translated(known->second);
  for (const medical_io::LengthUnit& unit : medical_io::lengthUnits())
    if (id == "unit-" + std::string(unit.id))
      return translated(QT_TRANSLATE_NOOP("viscera::app::Repairs", "It is in %1"))
          .arg(text(std::string(unit.name)));
  return text(id);
}

QString repairTip(const std::string& id) {
  return asSentence(medical_io::surfaceRepair(id).does);
}

} // namespace viscera::app

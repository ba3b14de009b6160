#include "stress_json.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace viscera::app {

nlohmann::ordered_json stressJson(const StressLook& look) {
  Settings kept{QVariantMap()};
  saveStressLook(look, kept);
  const QByteArray text = QJsonDocument(QJsonObject::fromVariantMap(kept.values())).toJson();
  return nlohmann::ordered_json::parse(text.toStdString());
}

StressLook stressLookOf(const nlohmann::ordered_json& item) {
  const auto object = QJsonDocument::fromJson(QByteArray::fromStdString(item.dump())).object();
  return loadStressLook(Settings(object.toVariantMap()));
}

} // namespace viscera::app

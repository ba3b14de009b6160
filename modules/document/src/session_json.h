#pragma once

#include <functional>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"
#include "viscera/document/document.h"

/// Converts the parts of a document to and from the JSON of a session file (docs/session_format.md). Organs'
/// surfaces are not written and read here.
namespace viscera::document {

/// All of an organ but its surface and where it came from.
nlohmann::ordered_json organJson(const Organ& organ);
nlohmann::ordered_json rigJson(const Rig& rig, const Points& pose);
nlohmann::ordered_json systemJson(const SystemChoice& system);
nlohmann::ordered_json keySequenceJson(const KeySequence& keySequence);
/// Points on an organ that `isKnown` does not know are written as places that stay.
nlohmann::ordered_json measurementsJson(const MeasurementList& measurements,
                                        const std::function<bool(OrganId)>& isKnown);
/// Probes in organs that `isKnown` does not know are left out, and the lines that end at them.
nlohmann::ordered_json stressMarksJson(const StressMarks& marks, const std::function<bool(OrganId)>& isKnown);
/// Parameters that are as at rest are left out.
nlohmann::ordered_json circulationJson(const CirculationChoice& choice);

/// Reads the parts of one session; keeps watch that no id comes twice.
class SessionReader : public JsonReader {
public:
  explicit SessionReader(const std::string& where);

  /// Reads the record of an organ; other members are as in a new one.
  Organ readOrganRecord(const nlohmann::ordered_json& item, const std::string& place);
  void readRig(const nlohmann::ordered_json& item, DocumentState& state);
  void readSystem(const nlohmann::ordered_json& item, DocumentState& state);
  void readKeySequence(const nlohmann::ordered_json& item, DocumentState& state);
  /// Does not check that the organs and triangles of points exist.
  void readMeasurements(const nlohmann::ordered_json& root, DocumentState& state);

  /// Does not check that the organs exist.
  void readStressMarks(const nlohmann::ordered_json& root, DocumentState& state);

  void readCirculation(const nlohmann::ordered_json& root, DocumentState& state);

  /// What `validate` throws, for this file.
  void requireValid(const DocumentState& state, const DocumentState& known) const;

  /// A text that may be empty or left out.
  std::string optionalText(const nlohmann::ordered_json& object, const char* key,
                           const std::string& place) const;

private:
  template <class AnyId>
  AnyId newId(const nlohmann::ordered_json& object, const std::string& place);
  Handle readHandle(const nlohmann::ordered_json& item, const std::string& place);
  Group readGroup(const nlohmann::ordered_json& item, const std::string& place);
  void readCage(const nlohmann::ordered_json& list, Rig& rig) const;
  SequenceKey readKey(const nlohmann::ordered_json& item, const std::string& place);
  circulation::Parameters readParameters(const nlohmann::ordered_json& item, const std::string& place) const;
  void readMeasurementKind(const nlohmann::ordered_json& item, const std::string& place,
                           Measurement& measurement) const;
  MeasuredPoint readMeasuredPoint(const nlohmann::ordered_json& item, const std::string& place);

  std::set<std::int64_t> ids_;
};

/// The format of session files.
inline constexpr const char* kSessionFormat = "viscera-session";
inline constexpr int kSessionVersion = 2;

} // namespace viscera::document

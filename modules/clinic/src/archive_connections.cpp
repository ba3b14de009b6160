#include <cstdlib>
#include <ostream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "viscera/clinic/archive.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"

// The list of archives: everything about them but the passwords.
namespace viscera::clinic {
namespace {

using nlohmann::ordered_json;

std::string textAt(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

int wholeAt(const nlohmann::json& object, const char* key, int otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number_integer() ? found->get<int>() : otherwise;
}

/// The user's folder for this program: below the one that the variable names, or the one in the home folder.
std::filesystem::path userFolder(const char* variable, const char* inHome) {
  const char* given = std::getenv(variable);
  const char* home = std::getenv("HOME");
  std::filesystem::path folder = given != nullptr ? given : "";
  if (!folder.is_absolute())
    folder = std::filesystem::path(home != nullptr ? home : ".") / inHome;
  return folder / "viscera";
}

} // namespace

std::filesystem::path archiveConnectionsFile() {
  return userFolder("XDG_CONFIG_HOME", ".config") / "archives.json";
}

std::filesystem::path archiveFolder() {
  return userFolder("XDG_CACHE_HOME", ".cache") / "archive";
}

std::vector<ArchiveConnection> readArchiveConnections(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    return {};
  const auto json = parseJson<nlohmann::json>(readText(file), file.string(), {});
  const auto list = json.is_object() ? json.find("connections") : json.end();
  if (!json.is_object() || list == json.end() || !list->is_array())
    throw DataError("It is no list of archives", file.string());
  std::vector<ArchiveConnection> connections;
  for (const nlohmann::json& row : *list) {
    if (!row.is_object() || textAt(row, "name").empty())
      throw DataError("It is no list of archives", file.string());
    ArchiveConnection& one = connections.emplace_back();
    one.name = textAt(row, "name");
    one.kind = textAt(row, "kind") == "dimse" ? ArchiveKind::dimse : ArchiveKind::dicomWeb;
    one.address = textAt(row, "address");
    one.port = wholeAt(row, "port", one.port);
    one.calledTitle = textAt(row, "calledTitle");
    if (row.contains("ownTitle"))
      one.ownTitle = textAt(row, "ownTitle");
    one.tls = row.contains("tls") && row["tls"] == true;
    one.certificates = textAt(row, "certificates");
    one.user = textAt(row, "user");
    one.patienceSeconds = wholeAt(row, "patienceSeconds", one.patienceSeconds);
  }
  return connections;
}

void writeArchiveConnections(const std::filesystem::path& file,
                             const std::vector<ArchiveConnection>& connections) {
  ordered_json list = ordered_json::array();
  for (const ArchiveConnection& one : connections) {
    ordered_json row = {{"name", one.name},
                        {"kind", one.kind == ArchiveKind::dimse ? "dimse" : "dicomweb"},
                        {"address", one.address}};
    if (one.kind == ArchiveKind::dimse)
      row.update({{"port", one.port},
                  {"calledTitle", one.calledTitle},
                  {"ownTitle", one.ownTitle},
                  {"tls", one.tls}});
    row["certificates"] = one.certificates;
    row["user"] = one.user;
    row["patienceSeconds"] = one.patienceSeconds;
    list.push_back(row);
  }
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  const std::string text =
      ordered_json{{"connections", list}}.dump(2, ' ', false, ordered_json::error_handler_t::replace);
  writeAtomically(file, [&](std::ostream& out) { out << text << "\n"; });
}

} // namespace viscera::clinic

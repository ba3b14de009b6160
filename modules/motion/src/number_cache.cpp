#include "number_cache.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"

namespace viscera::motion {
namespace {

using nlohmann::json;

std::string hex(std::uint64_t key) {
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << key;
  return text.str();
}

bool allFinite(const NumberTable& table) {
  for (const auto& [name, numbers] : table)
    for (const double number : numbers)
      if (!std::isfinite(number))
        return false;
  return true;
}

} // namespace

std::filesystem::path NumberCache::fileOf(const std::string& name, std::uint64_t key) const {
  return folder_ / (name + '-' + hex(key) + ".json");
}

std::optional<NumberTable> NumberCache::load(const std::string& name, std::uint64_t key) const {
  if (folder_.empty())
    return {};
  std::ifstream file(fileOf(name, key));
  try {
    const json contents = json::parse(file);
    if (contents.at("key") != hex(key))
      return {};
    NumberTable table = contents.at("numbers").get<NumberTable>();
    if (allFinite(table))
      return table;
  } catch (const json::exception&) {
    // Missing or damaged: whoever asked finds the numbers again.
  }
  return {};
}

void NumberCache::store(const std::string& name, std::uint64_t key, const NumberTable& table) const {
  if (folder_.empty())
    return;
  std::error_code ignored;
  std::filesystem::create_directories(folder_, ignored);
  try {
    writeAtomically(fileOf(name, key), [&](std::ostream& out) {
      out << json{{"key", hex(key)}, {"numbers", table}}.dump(1) << '\n';
    });
  } catch (const CannotCreateError&) {
    // A cache that cannot be written costs time, nothing else.
  }
}

} // namespace viscera::motion

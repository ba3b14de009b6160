#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "temporary_folder.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {

/// As long as this lives, the sample organs of this process, and of those that it starts, have at the medium
/// resolution, which the window shows, as few triangles as at the low one (a tenth): they load, are bound and
/// are drawn in a third of the time. Their parts, places and motions are the same. For tests that do not
/// depend on how fine a surface is. Changes the environment: before threads read it.
class CoarseSamples {
public:
  CoarseSamples() {
    for (const auto& entry :
         std::filesystem::directory_iterator(sample_organs::standardLibrary().definitions))
      if (entry.path().extension() == ".json")
        folder_.put(entry.path().filename().string(), coarse(contentsOf(entry.path())));
    if (const char* before = std::getenv(kVariable))
      before_ = before;
    setenv(kVariable, folder_.path().c_str(), 1);
  }
  ~CoarseSamples() {
    if (before_)
      setenv(kVariable, before_->c_str(), 1);
    else
      unsetenv(kVariable);
  }
  CoarseSamples(const CoarseSamples&) = delete;
  CoarseSamples& operator=(const CoarseSamples&) = delete;

private:
  static constexpr const char* kVariable = "VISCERA_SAMPLE_ORGANS";

  /// Always the same bytes, so that the cache of surfaces, which goes by them, has what a test before made.
  static std::string coarse(const std::string& definition) {
    auto content = nlohmann::ordered_json::parse(definition, nullptr, true, true);
    for (auto& surface : content["surfaces"]) {
      // What the heart's tissue is made of has the same rims with enough triangles only.
      if (surface.contains("triangles") && !surface.value("check_only", false))
        surface["triangles"]["medium"] = surface["triangles"]["low"];
      if (surface.contains("from") && surface["from"].is_array())
        surface["from"][1] = surface["from"][0]; // The finer outer surface.
    }
    return content.dump(1);
  }

  TemporaryFolder folder_;
  std::optional<std::string> before_;
};

} // namespace viscera::tests

#include "viscera/plugin/plugin_loader.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <system_error>
#include <utility>

#include <QJsonObject>
#include <QLibrary>
#include <QPluginLoader>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/plugin/coordinate_system_plugin.h"

namespace viscera::plugin {
namespace {

namespace fs = std::filesystem;

const QString kIid = QStringLiteral(VISCERA_COORDINATE_SYSTEM_PLUGIN_IID);
const QString kIidName = kIid.section('/', 0, 0);

/// Calls a function of a plugin's system: whatever it throws that is not one of our errors arrives as one,
/// with the plugin's name, so that a foreign mistake never ends the program.
template <class Call>
auto behindWall(const std::string& id, const std::string& file, const Call& call) -> decltype(call()) {
  try {
    return call();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    if (reportsShortMemory(error)) // No fault of the plugin.
      throw;
    throw Error(kInternalError, phrase("system \"%1\" failed: %2", id, explanationOf(error)), file,
                "choose another system");
  } catch (...) {
    throw Error(kInternalError, phrase("system \"%1\" failed", id), file, "choose another system");
  }
}

coordinates::SystemDescription describedBy(const coordinates::CoordinateSystem& system,
                                           const std::string& file) {
  const std::string id = behindWall("?", file, [&] { return system.id(); });
  return behindWall(id, file, [&] {
    return coordinates::SystemDescription{id, system.name(), system.summary(), system.traits(),
                                          system.parameters()};
  });
}

/// A plugin's system behind a wall. Its description is asked once, when it is loaded: one that says something
/// else later, or fails, confuses neither lists nor sessions nor the registry.
class GuardedSystem final : public coordinates::DescribedSystem {
public:
  GuardedSystem(std::shared_ptr<const coordinates::CoordinateSystem> system, std::string file)
      : DescribedSystem(describedBy(*system, file)), system_(std::move(system)), file_(std::move(file)) {}

  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet& handles, const Points& points,
                                             const coordinates::BindOptions& options,
                                             Progress& progress) const override {
    return behindWall(id(), file_, [&] {
      auto binding = system_->bind(handles, points, options, progress);
      if (!binding || binding->pointCount() != points.rows() ||
          binding->handleCount() != handles.positions.rows())
        throw Error(kInternalError, phrase("system \"%1\" returned no binding of the right size", id()),
                    file_);
      return binding;
    });
  }

  coordinates::CoordinateGradients gradients(const coordinates::HandleSet& handles, const Points& points,
                                             const coordinates::BindOptions& options,
                                             Progress& progress) const override {
    return behindWall(id(), file_, [&] { return system_->gradients(handles, points, options, progress); });
  }

  coordinates::SpaceLayout layout(const coordinates::HandleSet& handles,
                                  const coordinates::ParameterValues& parameters) const override {
    return behindWall(id(), file_, [&] { return system_->layout(handles, parameters); });
  }

private:
  std::shared_ptr<const coordinates::CoordinateSystem> system_;
  std::string file_;
};

PluginManifest manifestOf(const QJsonObject& metaData) {
  const QJsonObject own = metaData.value("MetaData").toObject();
  const auto text = [&](const char* key) { return own.value(QLatin1String(key)).toString().toStdString(); };
  return {text("id"), text("name"), text("version"), text("summary")};
}

/// Why a file with this metadata must not be loaded; empty when it may.
Text objection(const QJsonObject& metaData, const PluginManifest& manifest) {
  const QString iid = metaData.value("IID").toString();
  if (iid.isEmpty())
    return diagnostic("it is not a Viscera plugin, or it is damaged");
  if (iid.section('/', 0, 0) != kIidName)
    return diagnostic("it is a plugin for another program (%1)", iid.toStdString());
  if (iid != kIid)
    return phrase("it was made for version %1 of the plugin interface, this program has %2",
                  iid.section('/', 1).toStdString(), kIid.section('/', 1).toStdString());
  if (manifest.id.empty() || manifest.name.empty() || manifest.version.empty())
    return diagnostic("its manifest lacks id, name or version");
  return {};
}

/// Adds the systems of the plugin; if one is refused, the others are still added.
void addSystems(const CoordinateSystemPlugin& plugin, coordinates::Registry& registry, PluginReport& report) {
  for (const auto& system : plugin.systems()) {
    try {
      const std::string file = report.file.string();
      std::shared_ptr<const coordinates::CoordinateSystem> guarded;
      if (system)
        guarded = std::make_shared<const GuardedSystem>(system, file);
      registry.add(guarded, file);
      report.systems.push_back(guarded->id());
    } catch (const Error& error) {
      report.problem = error.explanation();
    }
  }
}

PluginReport loadOne(const fs::path& file, coordinates::Registry& registry) {
  PluginReport report;
  report.file = file;
  try {
    std::error_code unreachable;
    if (!fs::exists(file, unreachable)) {
      report.problem = "there is no such file";
      return report;
    }
    QPluginLoader loader(QString::fromStdString(file.string()));
    const QJsonObject metaData = loader.metaData();
    report.manifest = manifestOf(metaData);
    report.problem = objection(metaData, report.manifest);
    if (!report.problem.empty())
      return report;
    auto* plugin = qobject_cast<CoordinateSystemPlugin*>(loader.instance());
    if (plugin == nullptr) {
      report.problem = diagnostic("it cannot be loaded: %1", loader.errorString().toStdString());
      return report;
    }
    addSystems(*plugin, registry, report);
  } catch (const std::exception& error) {
    report.problem = diagnostic("it failed while loading: %1", explanationOf(error));
  } catch (...) {
    report.problem = diagnostic("it failed while loading");
  }
  return report;
}

std::vector<fs::path> librariesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (QLibrary::isLibrary(QString::fromStdString(entry->path().string())))
      files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

std::vector<fs::path> pluginSearchPath(const std::vector<fs::path>& given, const fs::path& installed) {
  std::vector<fs::path> path = given;
  if (const char* environment = std::getenv("VISCERA_PLUGIN_PATH")) {
    std::istringstream list(environment);
    for (std::string item; std::getline(list, item, ':');)
      if (!item.empty())
        path.emplace_back(item);
  }
  std::error_code ignored;
  if (!installed.empty() && fs::is_directory(installed, ignored))
    path.push_back(installed);
  return path;
}

std::vector<PluginReport> loadPlugins(const std::vector<fs::path>& searchPath,
                                      coordinates::Registry& registry) {
  std::vector<PluginReport> reports;
  for (const auto& place : searchPath) {
    std::error_code ignored;
    if (fs::is_directory(place, ignored))
      for (const auto& file : librariesIn(place))
        reports.push_back(loadOne(file, registry));
    else
      reports.push_back(loadOne(place, registry));
  }
  return reports;
}

} // namespace viscera::plugin

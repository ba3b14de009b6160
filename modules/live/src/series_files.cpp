#include "series_files.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/heart_labels.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::live {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestNumber = 18; ///< Digits that fit into 64 bits.

/// The name without its ending; ".nii.gz", ".seq.nrrd" and ".seg.nrrd" count as one.
std::string stemOf(const fs::path& file) {
  std::string stem = file.stem().string();
  for (const char* ending : {".nii", ".seq", ".seg", ".hdr", ".img"})
    if (stem.ends_with(ending))
      stem.resize(stem.size() - 4);
  return stem;
}

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool isSurface(const fs::path& file) {
  // The points of an openCARP mesh are read with its elements.
  return medical_io::fileKind(file) == medical_io::FileKind::surface && file.extension() != ".pts";
}

/// The files of a folder that are surfaces or label maps.
std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (std::error_code ignored; entry->is_regular_file(ignored) &&
                                 (isSurface(entry->path()) || medical_io::isLabelMap(entry->path())))
      files.push_back(entry->path());
  if (error)
    throw NoInputError(phrase("It cannot be opened: %1", error.message()), folder.string(),
                       "check that you may read it");
  if (files.empty())
    throw DataError("It holds neither surfaces nor label maps", folder.string(),
                    "name a folder with one file for each phase");
  return files;
}

/// Sorts by the last number in the name, then by the name: `_2` before `_10`.
bool earlier(const fs::path& a, const fs::path& b) {
  const auto one = seriesName(a.filename()), other = seriesName(b.filename());
  return std::pair(one.second.value_or(0), a.filename()) < std::pair(other.second.value_or(0), b.filename());
}

std::vector<fs::path> inputFiles(const SeriesRequest& request) {
  if (request.inputs.empty())
    throw UsageError(misuse("There is no series"), {},
                     "name its files, a folder, or a file with several phases");
  std::vector<fs::path> files;
  for (const fs::path& input : request.inputs) {
    std::error_code error;
    if (!fs::exists(input, error))
      throw NoInputError("there is no such file or folder", input.string(), "check the name and the folder");
    if (fs::is_directory(input, error)) {
      const std::vector<fs::path> inside = filesIn(input);
      files.insert(files.end(), inside.begin(), inside.end());
    } else {
      files.push_back(input);
    }
  }
  const bool numbered = std::all_of(files.begin(), files.end(), [](const fs::path& file) {
    return seriesName(file.filename()).second.has_value();
  });
  if (numbered)
    std::stable_sort(files.begin(), files.end(), earlier);
  return files;
}

/// Every surface has a file in every phase.
void requireComplete(const SeriesFiles& series) {
  std::set<std::uint64_t> numbers;
  for (const auto& [name, files] : series.files)
    for (const fs::path& file : files)
      numbers.insert(seriesName(file.filename()).second.value_or(0));
  for (const auto& [name, files] : series.files) {
    std::set<std::uint64_t> own;
    for (const fs::path& file : files)
      if (!own.insert(seriesName(file.filename()).second.value_or(0)).second && series.files.size() > 1)
        throw DataError(phrase("the surface \"%1\" has two files of one phase", name), file.string(),
                        "remove one of them");
    if (series.files.size() == 1)
      return;
    for (const std::uint64_t number : numbers)
      if (own.count(number) == 0)
        throw DataError(phrase("the surface \"%1\" is missing in phase number %2", name, number),
                        files.front().parent_path().string(),
                        "add its file, or remove those of the other surfaces in that phase");
  }
}

/// What the names of one surface's files have in common: "rv" for "rv_ed.obj" and "rv_es.obj".
std::string commonName(const std::vector<fs::path>& files) {
  std::string name = seriesName(files.front().filename()).first;
  bool alike = true;
  for (const fs::path& file : files) {
    const std::string other = seriesName(file.filename()).first;
    alike = alike && other == name;
    if (!alike)
      name.resize(static_cast<std::size_t>(
          std::mismatch(name.begin(), name.end(), other.begin(), other.end()).first - name.begin()));
  }
  if (!alike) {
    const std::size_t end = name.find_last_of("_-. ");
    name.resize(end == std::string::npos ? 0 : end);
  }
  return name.empty() ? "surface" : name;
}

/// The files of one phase; a folder of surfaces stands for what it holds.
std::vector<fs::path> filesOf(const PhaseLabels& phase) {
  std::vector<fs::path> files;
  for (const fs::path& file : phase.files) {
    std::error_code error;
    if (!fs::exists(file, error))
      throw NoInputError("there is no such file or folder", file.string(), "check the name and the folder");
    if (!fs::is_directory(file, error) || isHeartFolder({file})) {
      files.push_back(file);
      continue;
    }
    std::vector<fs::path> inside = filesIn(file);
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  if (files.empty())
    throw UsageError(phrase("Phase %1 has no labels", phase.phase), "--phase", "as in --phase 0=ed.nrrd");
  return files;
}

void requireSameNames(const SeriesFiles& series, const std::vector<PhaseLabels>& phases,
                      const std::vector<std::vector<fs::path>>& files) {
  for (const auto& [name, list] : series.files)
    for (std::size_t i = 0; i < files.size(); ++i) {
      const auto count = std::count_if(files[i].begin(), files[i].end(), [&](const fs::path& file) {
        return seriesName(file.filename()).first == name;
      });
      if (count != 1)
        throw DataError(
            count == 0 ? phrase("The surface \"%1\" is missing in phase %2", name, phases[i].phase)
                       : phrase("The surface \"%1\" has %2 files in phase %3", name, count, phases[i].phase),
            files[i].front().string(), "name a surface alike in all phases, as in ed/LV.obj and es/LV.obj");
    }
}

} // namespace

std::pair<std::string, std::optional<std::uint64_t>> seriesName(const fs::path& file) {
  const std::string stem = toUtf8(stemOf(file));
  const auto last = std::find_if(stem.rbegin(), stem.rend(), isDigit).base();
  const auto first = std::find_if_not(std::make_reverse_iterator(last), stem.rend(), isDigit).base();
  if (first == last)
    return {stem, std::nullopt};
  std::string name(stem.begin(), first);
  while (!name.empty() &&
         (name.back() == '_' || name.back() == '-' || name.back() == '.' || name.back() == ' '))
    name.pop_back();
  const std::string digits(last - std::min<std::ptrdiff_t>(last - first, kLongestNumber), last);
  return {name + std::string(last, stem.end()), std::stoull(digits)};
}

bool isHeartFolder(const std::vector<fs::path>& inputs) {
  std::error_code error;
  if (inputs.size() != 1 || !fs::is_directory(inputs.front(), error))
    return false;
  std::vector<std::string> names;
  for (const fs::path& file : filesIn(inputs.front())) {
    if (isSurface(file))
      return false;
    names.push_back(stemOf(file));
  }
  return medical_io::heartAmong(names).has_value();
}

SeriesFiles seriesFiles(const SeriesRequest& request) {
  const std::vector<fs::path> files = inputFiles(request);
  SeriesFiles series;
  const auto surfaces = static_cast<std::size_t>(std::count_if(files.begin(), files.end(), isSurface));
  if (surfaces != 0 && surfaces != files.size())
    throw DataError("It mixes surfaces and label maps", files.front().parent_path().string(),
                    "put those of one kind into a folder of their own");
  if (surfaces == 0) {
    series.kind = files.size() == 1 ? SeriesFiles::Kind::volumes : SeriesFiles::Kind::labelMaps;
    series.files[""] = files;
    series.phases = files.size() == 1 ? 0 : files.size();
    return series;
  }
  for (const fs::path& file : files)
    series.files[seriesName(file.filename()).first].push_back(file);
  requireComplete(series);
  series.phases = series.files.begin()->second.size();
  return series;
}

SeriesFiles labelledFiles(const std::vector<PhaseLabels>& phases,
                          const std::vector<LabelledSurface>& surfaces) {
  std::vector<std::vector<fs::path>> files;
  std::size_t all = 0, meshes = 0;
  for (const PhaseLabels& phase : phases) {
    const auto& own = files.emplace_back(filesOf(phase));
    all += own.size();
    meshes += static_cast<std::size_t>(std::count_if(own.begin(), own.end(), isSurface));
  }
  if (meshes != 0 && meshes != all)
    throw DataError("It mixes surfaces and label maps", files.front().front().string(),
                    "give labels of one kind for all phases");
  SeriesFiles series;
  series.phases = phases.size();
  std::vector<fs::path> firsts;
  bool single = true;
  for (const auto& own : files) {
    firsts.push_back(own.front());
    single = single && own.size() == 1;
  }
  if (meshes == 0) {
    if (!single)
      throw DataError("A phase has several label maps", files.front().front().string(),
                      "give one file for each phase");
    series.kind = SeriesFiles::Kind::labelMaps;
    series.files[""] = firsts;
    return series;
  }
  if (single) {
    series.files[surfaces.size() == 1 ? surfaces.front().name : commonName(firsts)] = firsts;
    return series;
  }
  for (const auto& own : files)
    for (const fs::path& file : own)
      series.files[seriesName(file.filename()).first].push_back(file);
  requireSameNames(series, phases, files);
  return series;
}

medical_io::SeriesTimes dicomTimes(const std::vector<fs::path>& files) {
  std::vector<medical_io::DicomPhase> phases;
  for (const fs::path& file : files) {
    const std::string extension = file.extension().string();
    if (extension == ".nii" || extension == ".gz" || extension.ends_with("nrrd") ||
        extension.starts_with(".mh"))
      return {};
    phases.push_back(medical_io::dicomPhase(file));
  }
  return medical_io::timesOf(phases);
}

} // namespace viscera::live

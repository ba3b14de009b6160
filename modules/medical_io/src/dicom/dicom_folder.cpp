#include "dicom/dicom_folder.h"

#include <algorithm>
#include <string>

#include "dicom/dicom_mark.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr int kDeepestFolder = 4;
constexpr std::size_t kMostFiles = 100'000;

/// "slice_2" before "slice_10".
bool beforeByName(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::string x = a.string(), y = b.string();
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < x.size() && j < y.size()) {
    if (!isDigit(x[i]) || !isDigit(y[j])) {
      if (x[i] != y[j])
        return x[i] < y[j];
      ++i;
      ++j;
      continue;
    }
    const auto number = [&](const std::string& text, std::size_t& at) {
      while (at + 1 < text.size() && text[at] == '0' && isDigit(text[at + 1]))
        ++at;
      const std::size_t begin = at;
      while (at < text.size() && isDigit(text[at]))
        ++at;
      return text.substr(begin, at - begin);
    };
    const std::string m = number(x, i), n = number(y, j);
    if (m != n)
      return m.size() != n.size() ? m.size() < n.size() : m < n;
  }
  return x.size() - i != y.size() - j ? x.size() - i < y.size() - j : x < y;
}

} // namespace

std::error_code visitFiles(const std::filesystem::path& folder,
                           const std::function<bool(const std::filesystem::path&)>& visit) {
  using Walk = std::filesystem::recursive_directory_iterator;
  std::error_code error;
  for (Walk entry(folder, std::filesystem::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry.depth() >= kDeepestFolder)
      entry.disable_recursion_pending();
    if (entry->is_regular_file(ignored) && !visit(entry->path()))
      return {};
  }
  return error;
}

std::vector<std::filesystem::path> dicomImages(const std::filesystem::path& fileOrFolder) {
  std::error_code error;
  if (!std::filesystem::exists(fileOrFolder, error))
    throw NoInputError("there is no such file", fileOrFolder.string(), "check the name and the folder");
  const bool isFolder = std::filesystem::is_directory(fileOrFolder, error);
  const std::filesystem::path folder = isFolder ? fileOrFolder : fileOrFolder.parent_path();
  const DicomKind kind = isFolder ? DicomKind::image : dicomKind(fileOrFolder);
  if (kind != DicomKind::image && kind != DicomKind::none)
    failAsDicomObject(FileBytes{fileOrFolder, {}}, dicomClass(fileOrFolder));
  std::vector<std::filesystem::path> list;
  std::filesystem::path other; // Of another kind.
  std::size_t seen = 0;
  const auto add = [&](const std::filesystem::path& file) {
    if (++seen > kMostFiles)
      throw DataError(phrase("It has more than %1 files", kMostFiles), folder.string(),
                      "name the folder of one patient");
    const DicomKind found = dicomKind(file);
    if (found == DicomKind::image)
      list.push_back(file);
    else if (found != DicomKind::none && other.empty())
      other = file;
    return true;
  };
  if (isFolder) {
    error = visitFiles(folder, add);
  } else {
    for (std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error), end;
         !error && entry != end; entry.increment(error))
      add(entry->path());
  }
  if (error)
    throw NoInputError(phrase("It cannot be opened: %1", error.message()), folder.string(),
                       "check that you may read it");
  if (list.empty() && !other.empty())
    failAsDicomObject(FileBytes{other, {}}, dicomClass(other));
  if (list.empty())
    throw DataError(isFolder ? "It has no DICOM files with images" : "It is a DICOM file without an image",
                    fileOrFolder.string(), "name the folder of a CT or MR series");
  std::sort(list.begin(), list.end(), beforeByName);
  return list;
}

} // namespace viscera::medical_io

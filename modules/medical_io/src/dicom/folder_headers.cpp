#include "dicom/folder_headers.h"

#include <utility>

#include "dicom/for_all.h"

namespace viscera::medical_io {

FolderHeaders readDicomHeaders(std::vector<std::filesystem::path> files, Progress& progress, double until) {
  FolderHeaders folder;
  folder.files = std::move(files);
  folder.headers.resize(folder.files.size());
  folder.errors.resize(folder.files.size());
  forAll(folder.files.size(), progress, 0, until, "headers", [&](std::size_t i) {
    try {
      folder.headers[i] = readDicomHeader(folder.files[i]);
    } catch (const DataError& error) {
      folder.headers[i].file = folder.files[i];
      folder.errors[i] = error;
    }
  });
  return folder;
}

} // namespace viscera::medical_io

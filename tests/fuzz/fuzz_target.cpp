#include "fuzz_target.h"

#include <fstream>
#include <iterator>

#include "temporary_folder.h"

namespace viscera::fuzz {
namespace {

const tests::TemporaryFolder& scratch() {
  static const tests::TemporaryFolder folder;
  return folder;
}

} // namespace

std::vector<Target> readerTargets() {
  std::vector<Target> all = {surfaceFileTarget(), handleFileTarget(), modelTarget(), surfaceSoupTarget()};
  for (const auto& some : {imageTargets(), documentTargets(), motionTargets()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

Choice choose(Bytes bytes, std::size_t kinds) {
  if (bytes.empty())
    return {0, bytes};
  return {bytes.front() % kinds, bytes.subspan(1)};
}

std::string chosen(std::size_t kind, const std::string& rest) {
  return static_cast<char>(kind) + rest;
}

std::string textOf(Bytes bytes) {
  return {bytes.begin(), bytes.end()};
}

std::filesystem::path scratchFile(const std::string& name, Bytes bytes) {
  return scratch().put(name, textOf(bytes));
}

const std::filesystem::path& scratchFolder() {
  return scratch().path();
}

} // namespace viscera::fuzz

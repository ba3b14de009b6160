#include "viscera/medical_io/handle_file.h"

#include <algorithm>
#include <array>
#include <new>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "file_bytes.h"
#include "file_signature.h"
#include "handle_formats.h"
#include "text_scanner.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::medical_io {
namespace {

/// Gives labels to handles that have none, or one that a handle at another place, or in the same list, has.
class LabelMender {
public:
  explicit LabelMender(HandleFile& file) : file_(file) {
    for (const HandleGroupRecord& group : file.groups)
      for (const HandleRecord& handle : group.handles)
        taken_.insert(handle.label);
  }

  void run() {
    for (HandleGroupRecord& group : file_.groups) {
      std::unordered_set<std::string> inGroup;
      for (std::size_t i = 0; i < group.handles.size(); ++i) {
        mend(group, i, inGroup);
        inGroup.insert(group.handles[i].label);
      }
    }
    if (named_ > 0)
      file_.warnings.push_back(phrase("%n {handle|handles} without a label got one", named_));
    if (renamed_ > 0)
      file_.warnings.push_back(
          phrase("%n {handle|handles} whose label another one has got a new one", renamed_));
  }

private:
  void mend(HandleGroupRecord& group, std::size_t number, const std::unordered_set<std::string>& inGroup) {
    HandleRecord& handle = group.handles[number];
    if (handle.label.empty()) {
      handle.label = freeLabel(group.name, number + 1);
      ++named_;
    } else {
      const auto [known, isNew] = places_.try_emplace(handle.label, handle.position);
      if (isNew || (known->second == handle.position && !inGroup.contains(handle.label)))
        return;
      handle.label = freeLabel(handle.label, 2);
      ++renamed_;
    }
    places_.emplace(handle.label, handle.position);
  }

  /// "base-2", or the next number that is free; remembers where it stopped, so that many equal labels stay
  /// cheap.
  std::string freeLabel(const std::string& base, std::size_t first) {
    std::size_t& next = next_.try_emplace(base, first).first->second;
    next = std::max(next, first);
    for (;;) {
      std::string label = base + "-" + std::to_string(next++);
      if (taken_.insert(label).second)
        return label;
    }
  }

  HandleFile& file_;
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, Vec3> places_;
  std::unordered_map<std::string, std::size_t> next_;
  std::size_t named_ = 0;
  std::size_t renamed_ = 0;
};

HandleFile readAny(const FileBytes& file) {
  const std::string extension = extensionOf(file.file);
  const Signature found = signatureOf(file);
  if (extension == ".fcsv" || found == Signature::fcsv)
    return readFcsv(file);
  const bool json = extension == ".json" || extension == ".mrk.json";
  if (!json && found != Signature::markups)
    refuse(file, FileKind::handles);
  return readMarkups(file);
}

constexpr std::size_t kMostNamedPoints = 8;

} // namespace

bool isPlaced(std::string_view status) {
  static constexpr std::array<std::string_view, 6> kUnplaced = {"0",         "1",       "3",
                                                                "undefined", "preview", "missing"};
  return std::find(kUnplaced.begin(), kUnplaced.end(), lowered(status)) == kUnplaced.end();
}

void reportUnplaced(HandleFile& read, const std::vector<std::string>& labels, const FileBytes& file) {
  if (labels.empty())
    return;
  std::vector<Text> some;
  for (std::size_t i = 0; i < std::min(labels.size(), kMostNamedPoints); ++i)
    some.push_back(inQuotes(labels[i]));
  Text list = listOf(std::move(some));
  if (labels.size() > kMostNamedPoints)
    list = phrase("%2 and %n more", labels.size() - kMostNamedPoints, list);
  if (read.count() == 0)
    file.fail(
        phrase("%n {point was|points were} never placed (%2), and there is no other", labels.size(), list),
        "place some points and save them again");
  read.warnings.push_back(
      phrase("%n {point that was never placed is|points that were never placed are} left out: %2",
             labels.size(), list));
}

Eigen::Index HandleFile::count() const {
  Eigen::Index total = 0;
  for (const HandleGroupRecord& group : groups)
    total += static_cast<Eigen::Index>(group.handles.size());
  return total;
}

Points HandleFile::positions() const {
  Points points(count(), 3);
  Eigen::Index row = 0;
  for (const HandleGroupRecord& group : groups)
    for (const HandleRecord& handle : group.handles)
      points.row(row++) = handle.position.transpose();
  return points;
}

std::vector<std::string> HandleFile::labels() const {
  std::vector<std::string> list;
  for (const HandleGroupRecord& group : groups)
    for (const HandleRecord& handle : group.handles)
      list.push_back(handle.label);
  return list;
}

HandleFile readHandles(const std::filesystem::path& file) {
  const FileBytes bytes = readWholeFile(file);
  try {
    HandleFile result = readAny(bytes);
    for (HandleGroupRecord& group : result.groups) {
      group.name = printableName(group.name);
      for (HandleRecord& handle : group.handles)
        handle.label = printableName(handle.label);
    }
    if (result.count() == 0)
      bytes.fail(diagnostic("It holds no points"), "place some points and save them again");
    LabelMender(result).run();
    return result;
  } catch (const std::bad_alloc&) {
    bytes.fail("it does not fit into memory");
  }
}

void writeHandles(const std::filesystem::path& file, const HandleFile& handles, const WriteHandles& options) {
  const std::string ending = lowered(file.extension().string());
  if (ending != ".json" && ending != ".fcsv")
    throw CannotCreateError(phrase("this cannot be written as %1", inQuotes(extensionOf(file))),
                            file.string(), phrase("let its name end in %1", ".mrk.json, .fcsv"));
  for (const HandleGroupRecord& group : handles.groups)
    for (const HandleRecord& handle : group.handles)
      if (!handle.position.allFinite())
        throw DataError(phrase("the position of the handle %1 in %2 is not finite", inQuotes(handle.label),
                               inQuotes(group.name)),
                        file.string(), "reset the pose");
  writeAtomically(file, [&](std::ostream& out) {
    (ending == ".fcsv" ? writeFcsv : writeMarkups)(out, handles, options.space);
  });
}

std::vector<Text> fcsvLoses(const HandleFile& handles) {
  if (handles.groups.size() < 2)
    return {};
  return {
      phrase("a .fcsv file is one list: the %1 groups and their colours are not kept (.mrk.json keeps them)",
             handles.groups.size())};
}

} // namespace viscera::medical_io

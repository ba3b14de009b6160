#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "surface_formats.h"
#include "surface_parts.h"
#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/file_kind.h"
#include "xml_tree.h"

// The blocks are in files beside it, in any format of a surface: ParaView writes one .vtp for each.
namespace viscera::medical_io {
namespace {

constexpr std::size_t kMostBlocks = 10'000;

class VtmReader {
public:
  explicit VtmReader(const FileBytes& file) : file_(file) {}

  RawSurface run() {
    const XmlTree tree = parseXml(file_.view());
    if (!tree.error.empty())
      file_.fail(diagnostic("It is not complete XML: %1", tree.error));
    const std::string_view type = tree.root.attribute("type");
    if (tree.root.name != "VTKFile" || !type.starts_with("vtkMultiBlock") || tree.root.child(type) == nullptr)
      file_.fail(phrase("It holds %1, not %2", inQuotes(type), inQuotes("vtkMultiBlockDataSet")),
                 "save the surfaces as .vtp");
    readBlocks(*tree.root.child(type), {});
    if (blocks_ == 0)
      file_.fail("It names no surface files", "save the surfaces as .vtp");
    if (parts_.allPlain())
      raw_.colors.clear();
    parts_.moveTo(raw_);
    if (empty_ > 0)
      raw_.warnings.push_back(phrase("%n {block|blocks} without a surface ignored", empty_));
    return std::move(raw_);
  }

private:
  /// `above` is the name of the block that these are in.
  void readBlocks(const XmlElement& element, const std::string& above) {
    for (const XmlElement& child : element.children) {
      std::string name(child.attribute("name"));
      if (name.empty() && element.children.size() == 1)
        name = above;
      if (child.name == "DataSet")
        readPiece(child, name);
      else // Block, Piece.
        readBlocks(child, name);
    }
  }

  void readPiece(const XmlElement& element, const std::string& name) {
    const std::string file(element.attribute("file"));
    if (file.empty()) { // A block that is empty, as ParaView writes it.
      ++empty_;
      return;
    }
    const std::filesystem::path relative = file;
    if (relative.is_absolute() || file.find("://") != file.npos)
      file_.fail(phrase("a block is at %1, but only files beside it are read", inQuotes(file)));
    const std::string ending = extensionOf(relative);
    const auto& endings = endingsOf(FileKind::surface);
    if (std::find(endings.begin(), endings.end(), ending) == endings.end()) {
      raw_.warnings.push_back(phrase("the block %1 is no surface and was left out", inQuotes(file)));
      return;
    }
    if (ending.starts_with(".vtm") || ++blocks_ > kMostBlocks)
      file_.fail(phrase("its block %1 holds blocks of its own in another file", inQuotes(file)),
                 "save the surfaces as .vtp");
    try {
      add(readRawSurface(file_.file.parent_path() / relative), name);
    } catch (const Error& error) {
      throw DataError(phrase("its block %1 cannot be read: %2", inQuotes(file), error.problem()),
                      file_.name(), error.tryThis());
    }
  }

  void add(RawSurface piece, const std::string& name) {
    if (piece.polygonCount() == 0) {
      ++empty_;
      return;
    }
    const Space space = piece.space.value_or(Space::lps);
    if (parts_.size() == 0)
      raw_.space = piece.space;
    const double side = space == raw_.space.value_or(Space::lps) ? 1 : -1;
    RawPart part;
    part.name = name.empty() ? piece.name : name;
    part.plain = piece.colors.size() != piece.coordinates.size();
    parts_.begin(parts_.add(std::move(part)), raw_.polygonCount());
    const auto before = static_cast<std::int64_t>(raw_.pointCount());
    const auto count = static_cast<std::int64_t>(piece.pointCount());
    for (std::size_t i = 0; i < piece.coordinates.size(); ++i)
      raw_.coordinates.push_back(i % 3 < 2 && side < 0 ? 0.0 - piece.coordinates[i] : piece.coordinates[i]);
    if (!parts_.at(static_cast<std::uint32_t>(parts_.size() - 1)).plain)
      raw_.colors.insert(raw_.colors.end(), piece.colors.begin(), piece.colors.end());
    raw_.colors.resize(raw_.coordinates.size(), 0);
    const std::size_t corners = raw_.corners.size();
    for (const std::int64_t corner : piece.corners) {
      if (corner < 0 || corner >= count)
        file_.fail(diagnostic("the block %1 refers to point %2, but there are %3 (counted from 0)",
                              inQuotes(name), corner, count));
      raw_.corners.push_back(before + corner);
    }
    for (const std::size_t end : piece.ends)
      raw_.ends.push_back(corners + end);
    raw_.warnings.insert(raw_.warnings.end(), piece.warnings.begin(), piece.warnings.end());
    raw_.ignoredCells += piece.ignoredCells;
  }

  const FileBytes& file_;
  RawSurface raw_;
  PartList parts_;
  std::size_t blocks_ = 0;
  std::uint64_t empty_ = 0;
};

} // namespace

RawSurface readVtm(const FileBytes& file) {
  return VtmReader(file).run();
}

} // namespace viscera::medical_io

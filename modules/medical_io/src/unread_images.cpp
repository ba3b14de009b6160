#include "unread_images.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "file_signature.h"
#include "image_formats/unpack.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

using namespace std::string_view_literals;

/// A kind of file: by bytes at a place in it, by endings, or by either.
struct UnreadKind {
  std::string_view mark;                     ///< Empty: only endings tell.
  std::size_t place = 0;                     ///< Of the mark.
  std::array<std::string_view, 3> endings{}; ///< In lower case; with a mark, all of them need both.
  std::string_view name;
  std::string_view tool; ///< What saves it as a format that Viscera reads, which has this ending.
  std::string_view ending;
};

constexpr std::string_view kHdf5 = "\x89HDF\r\n\x1a\n"sv;

/// The first that fits counts.
const std::array<UnreadKind, 35> kUnreadKinds = {{
    {kHdf5, 0, {".mnc"}, "MINC", "mnc2nii", ".nii"},
    {"CDF\x01"sv, 0, {".mnc"}, "MINC", "mnc2nii", ".nii"},
    {"CDF\x02"sv, 0, {".mnc"}, "MINC", "mnc2nii", ".nii"},
    {"", 0, {".mnc", ".mnc.gz"}, "MINC", "mnc2nii", ".nii"},
    {kHdf5, 0, {".mat"}, "MATLAB", "niftiwrite", ".nii"},
    {kHdf5, 0, {".ims"}, "Imaris", "Fiji", ".nrrd"},
    {kHdf5, 0, {}, "HDF5", "3D Slicer", ".nrrd"},
    {"CDF\x01"sv, 0, {}, "NetCDF", "3D Slicer", ".nrrd"},
    {"CDF\x02"sv, 0, {}, "NetCDF", "3D Slicer", ".nrrd"},
    {"MATLAB", 0, {".mat"}, "MATLAB", "niftiwrite", ".nii"},
    {"\x93NUMPY", 0, {}, "NumPy", "nibabel", ".nii.gz"},
    {"PK\x03\x04", 0, {".npz"}, "NumPy", "nibabel", ".nii.gz"},
    {"II*\0"sv, 0, {}, "TIFF", "3D Slicer", ".nrrd"},
    {"MM\0*"sv, 0, {}, "TIFF", "3D Slicer", ".nrrd"},
    {"II+\0"sv, 0, {}, "TIFF", "3D Slicer", ".nrrd"},
    {"MM\0+"sv, 0, {}, "TIFF", "3D Slicer", ".nrrd"},
    {"# AmiraMesh", 0, {}, "AmiraMesh", "Amira", ".nrrd"},
    {"# Avizo", 0, {}, "AmiraMesh", "Amira", ".nrrd"},
    {"# HyperSurface", 0, {}, "HyperSurface", "Amira", ".stl"},
    {"!INTERFILE", 0, {}, "Interfile", "3D Slicer", ".nrrd"},
    {"MATRIX7", 0, {}, "ECAT", "nibabel", ".nii.gz"},
    {"mrtrix", 0, {}, "MRtrix", "mrconvert", ".nii.gz"},
    {"CTDATA-HEADER_V1", 0, {}, "Scanco", "3D Slicer", ".nrrd"},
    {"ZISRAWFILE", 0, {}, "Zeiss CZI", "Fiji", ".nrrd"},
    {"MAP "sv, 208, {}, "MRC", "3D Slicer", ".nrrd"},
    {"", 0, {".brik", ".head", ".brik.gz"}, "AFNI", "3dAFNItoNIFTI", ".nii"},
    {"", 0, {".par", ".rec"}, "Philips PAR/REC", "dcm2niix", ".nii.gz"},
    {"", 0, {".mif", ".mif.gz", ".mih"}, "MRtrix", "mrconvert", ".nii.gz"},
    {"", 0, {".am", ".amiramesh"}, "AmiraMesh", "Amira", ".nrrd"},
    {"", 0, {".h5", ".hdf5", ".hdf"}, "HDF5", "3D Slicer", ".nrrd"},
    {"", 0, {".npy", ".npz"}, "NumPy", "nibabel", ".nii.gz"},
    {"", 0, {".mat"}, "MATLAB", "niftiwrite", ".nii"},
    {"", 0, {".tif", ".tiff"}, "TIFF", "3D Slicer", ".nrrd"},
    {"", 0, {".vmr", ".v16"}, "BrainVoyager", "BrainVoyager", ".nii"},
    {"", 0, {".raw", ".vol"}, "RAW", {}, {}},
}};

/// Numbers alone, without their size, need a header in place of a tool.
Text wayOutOf(const UnreadKind& kind) {
  if (kind.tool.empty())
    return "write a .nhdr or .mhd header for it, which says its size";
  return phrase("save it as %1 with %2", std::string(kind.ending), std::string(kind.tool));
}

bool fits(const UnreadKind& kind, std::string_view bytes, std::string_view name, bool byEnding) {
  if (kind.mark.empty() && !byEnding)
    return false;
  const bool anyEnding = kind.endings[0].empty();
  const bool ends = anyEnding || std::any_of(kind.endings.begin(), kind.endings.end(), [&](auto ending) {
                      return !ending.empty() && name.ends_with(ending);
                    });
  return ends && (kind.mark.empty() ||
                  (bytes.size() > kind.place && bytes.substr(kind.place).starts_with(kind.mark)));
}

/// `byEnding`: the bytes are of no other kind that is known.
const UnreadKind* unreadKindOf(std::string_view bytes, std::string_view name, bool byEnding) {
  const auto found = std::find_if(kUnreadKinds.begin(), kUnreadKinds.end(),
                                  [&](const UnreadKind& kind) { return fits(kind, bytes, name, byEnding); });
  return found == kUnreadKinds.end() ? nullptr : &*found;
}

} // namespace

std::optional<UnreadImage> unreadImage(const FileBytes& file) {
  const std::string name = lowered(file.file.filename().string());
  const std::string_view plainName =
      std::string_view(name).substr(0, name.size() - (name.ends_with(".gz") ? 3 : 0));
  if (name.ends_with(".img") || name.ends_with(".img.gz"))
    return std::nullopt; // Voxels alone may look like anything.
  const Signature found = signatureUnpacked(file);
  const bool byEnding = found == Signature::unknown || found == Signature::gzip;
  const UnreadKind* kind = unreadKindOf(file.view(), name, byEnding);
  if (kind == nullptr && found == Signature::unknown && file.view().starts_with("\x1f\x8b")) {
    constexpr std::uint64_t kEnough = 4096;
    kind = unreadKindOf(unpacked(file, file.view(), Packing::zlib, kEnough), plainName, byEnding);
  }
  return kind == nullptr ? std::nullopt
                         : std::optional(UnreadImage{std::string(kind->name), wayOutOf(*kind)});
}

} // namespace viscera::medical_io

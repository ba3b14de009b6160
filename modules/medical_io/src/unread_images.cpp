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

constexpr const char* kConvert = "convert it to .nrrd or .nii.gz with 3D Slicer";
constexpr const char* kPython = "save the array as .nii.gz with nibabel, together with its position";

/// A kind of file: by bytes at a place in it, by endings, or by either.
struct UnreadKind {
  std::string_view mark;                     ///< Empty: only endings tell.
  std::size_t place = 0;                     ///< Of the mark.
  std::array<std::string_view, 3> endings{}; ///< In lower case; with a mark, all of them need both.
  std::string_view description;
  const char* wayOut;
};

constexpr std::string_view kHdf5 = "\x89HDF\r\n\x1a\n"sv;

/// The first that fits counts.
const std::array<UnreadKind, 35> kUnreadKinds = {{
    {kHdf5, 0, {".mnc"}, "a MINC image", "convert it with mnc2nii, and open the .nii"},
    {"CDF\x01"sv, 0, {".mnc"}, "a MINC image", "convert it with mnc2nii, and open the .nii"},
    {"CDF\x02"sv, 0, {".mnc"}, "a MINC image", "convert it with mnc2nii, and open the .nii"},
    {"", 0, {".mnc", ".mnc.gz"}, "a MINC image", "convert it with mnc2nii, and open the .nii"},
    {kHdf5, 0, {".mat"}, "a MATLAB file", "write its volume with niftiwrite, and open the .nii"},
    {kHdf5, 0, {".ims"}, "an Imaris image", "export it from Imaris or Fiji, as .nrrd"},
    {kHdf5, 0, {}, "an HDF5 file", kConvert},
    {"CDF\x01"sv, 0, {}, "a NetCDF file", kConvert},
    {"CDF\x02"sv, 0, {}, "a NetCDF file", kConvert},
    {"MATLAB", 0, {".mat"}, "a MATLAB file", "write its volume with niftiwrite, and open the .nii"},
    {"\x93NUMPY", 0, {}, "a NumPy array", kPython},
    {"PK\x03\x04", 0, {".npz"}, "a NumPy archive", kPython},
    {"II*\0"sv,
     0,
     {},
     "a TIFF image",
     "convert it to .nrrd with 3D Slicer or Fiji, with the size of its voxels"},
    {"MM\0*"sv,
     0,
     {},
     "a TIFF image",
     "convert it to .nrrd with 3D Slicer or Fiji, with the size of its voxels"},
    {"II+\0"sv,
     0,
     {},
     "a TIFF image",
     "convert it to .nrrd with 3D Slicer or Fiji, with the size of its voxels"},
    {"MM\0+"sv,
     0,
     {},
     "a TIFF image",
     "convert it to .nrrd with 3D Slicer or Fiji, with the size of its voxels"},
    {"# AmiraMesh", 0, {}, "an AmiraMesh file", "export it from Amira as .nrrd, or as DICOM"},
    {"# Avizo", 0, {}, "an AmiraMesh file", "export it from Amira as .nrrd, or as DICOM"},
    {"# HyperSurface", 0, {}, "an Amira surface", "export it from Amira as .stl or .ply"},
    {"!INTERFILE", 0, {}, "an Interfile image", kConvert},
    {"MATRIX7", 0, {}, "an ECAT image", "convert it to .nii.gz with nibabel or dcm2niix"},
    {"mrtrix", 0, {}, "an MRtrix image", "convert it with mrconvert, and open the .nii.gz"},
    {"CTDATA-HEADER_V1", 0, {}, "a Scanco image", kConvert},
    {"ZISRAWFILE", 0, {}, "a Zeiss image", "export it from Fiji, as .nrrd"},
    {"MAP "sv, 208, {}, "an MRC image", kConvert},
    {"",
     0,
     {".brik", ".head", ".brik.gz"},
     "an AFNI image",
     "convert it with 3dAFNItoNIFTI, and open the .nii"},
    {"", 0, {".par", ".rec"}, "a Philips PAR/REC image", "convert it with dcm2niix, and open the .nii.gz"},
    {"",
     0,
     {".mif", ".mif.gz", ".mih"},
     "an MRtrix image",
     "convert it with mrconvert, and open the .nii.gz"},
    {"", 0, {".am", ".amiramesh"}, "an AmiraMesh file", "export it from Amira as .nrrd, or as DICOM"},
    {"", 0, {".h5", ".hdf5", ".hdf"}, "an HDF5 file", kConvert},
    {"", 0, {".npy", ".npz"}, "a NumPy array", kPython},
    {"", 0, {".mat"}, "a MATLAB file", "write its volume with niftiwrite, and open the .nii"},
    {"",
     0,
     {".tif", ".tiff"},
     "a TIFF image",
     "convert it to .nrrd with 3D Slicer or Fiji, with the size of its voxels"},
    {"", 0, {".vmr", ".v16"}, "a BrainVoyager image", "export it from BrainVoyager as .nii"},
    {"",
     0,
     {".raw", ".vol"},
     "a file of plain numbers",
     "write a .nhdr or .mhd header for it, which says its size"},
}};

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
  return kind == nullptr ? std::nullopt : std::optional(UnreadImage{kind->description, kind->wayOut});
}

} // namespace viscera::medical_io

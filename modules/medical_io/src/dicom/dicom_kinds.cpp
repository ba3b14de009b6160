#include "dicom/dicom_kinds.h"

#include <algorithm>
#include <array>
#include <string>

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcuid.h>

namespace viscera::medical_io {
namespace {

constexpr std::string_view kStorageClasses = "1.2.840.10008.5.1.4.1.1.";
constexpr std::string_view kDirectoryClass = "1.2.840.10008.1.3.10";

constexpr const char* kOpenItsImages =
    "open the images or the segmentation of the same patient, which are other files";
constexpr const char* kAsSegmentation =
    "load it in 3D Slicer with its images, convert it to a segmentation there, and save that as .seg.nrrd";
constexpr const char* kExportTheSurface = "export it as STL, OBJ, PLY or GLB";

/// Classes of storage, by the end of their UID; a point at its end stands for all below. Their names are
/// DICOM's terms, the same in every language.
struct ObjectClass {
  std::string_view uid;
  DicomKind kind;
  std::string_view name;
  const char* wayOut = kOpenItsImages;
};

/// The first that fits counts.
constexpr auto kClasses = std::to_array<ObjectClass>({
    {"66.4", DicomKind::segmentation, "Segmentation (SEG)"},
    {"66.7", DicomKind::segmentation, "Label Map Segmentation (SEG)"},
    {"104.3", DicomKind::surface, "Encapsulated STL"},
    {"104.4", DicomKind::surface, "Encapsulated OBJ"},
    {"104.1", DicomKind::other, "Encapsulated PDF"},
    {"104.2", DicomKind::other, "Encapsulated CDA"},
    {"104.5", DicomKind::other, "Encapsulated MTL, the materials of an OBJ"},
    {"104.", DicomKind::other, "Encapsulated Document"},
    {"481.3", DicomKind::segmentation, "RT Structure Set (RTSTRUCT), contours"},
    {"481.1", DicomKind::image, "RT Image"},
    {"481.2", DicomKind::image, "RT Dose"},
    {"481.5", DicomKind::other, "RT Plan (RTPLAN)"},
    {"481.8", DicomKind::other, "RT Ion Plan"},
    {"481.", DicomKind::other, "RT Record"},
    {"88.59", DicomKind::other, "Key Object Selection (KO)"},
    {"88.67", DicomKind::other, "Radiation Dose Report (SR)"},
    {"88.", DicomKind::other, "Structured Report (SR)"},
    {"11.", DicomKind::other, "Presentation State (PR)"},
    {"9.1.", DicomKind::other, "ECG Waveform"},
    {"9.4.", DicomKind::other, "Audio Waveform"},
    {"9.", DicomKind::other, "Waveform"},
    {"66.1", DicomKind::other, "Spatial Registration (REG)"},
    {"66.2", DicomKind::other, "Spatial Fiducials"},
    {"66.3", DicomKind::other, "Deformable Spatial Registration (REG)"},
    {"66.5", DicomKind::other, "Surface Segmentation", kAsSegmentation},
    {"66.6", DicomKind::other, "Tractography Results"},
    {"66", DicomKind::other, "Raw Data"},
    {"67", DicomKind::other, "Real World Value Mapping"},
    {"68.1", DicomKind::other, "Surface Scan Mesh", kExportTheSurface},
    {"68.2", DicomKind::other, "Surface Scan Point Cloud", kExportTheSurface},
    {"77.1.5.3", DicomKind::other, "Stereometric Relationship"},
    {"77.1.5.4", DicomKind::image, "Ophthalmic Tomography"},
    {"77.1.6", DicomKind::other, "VL Whole Slide Microscopy"},
    {"77.1.1", DicomKind::image, "VL Endoscopic Image"},
    {"77.1.", DicomKind::image, "VL Photographic Image"},
    {"78.", DicomKind::other, "Ophthalmic Measurements"},
    {"79.", DicomKind::other, "Ophthalmic Measurements"},
    {"80.", DicomKind::other, "Ophthalmic Measurements"},
    {"4.2", DicomKind::other, "MR Spectroscopy"},
    {"7", DicomKind::image, "Secondary Capture"},
    {"6.1", DicomKind::image, "Ultrasound Image"},
    {"3.1", DicomKind::image, "Ultrasound Multi-frame Image"},
    {"6.2", DicomKind::image, "Enhanced US Volume"},
    {"12.", DicomKind::image, "X-Ray Angiographic Image"},
    {"1.1", DicomKind::image, "Digital X-Ray Image"},
    {"1.2", DicomKind::image, "Digital Mammography X-Ray Image"},
    {"1.3", DicomKind::image, "Digital Intra-Oral X-Ray Image"},
    {"13.", DicomKind::image, "X-Ray 3D Image"},
    {"20", DicomKind::image, "Nuclear Medicine Image"},
    {"200.", DicomKind::other, "Protocol"},
    {"201.", DicomKind::other, "Protocol"},
});

const ObjectClass* classOf(std::string_view classUid) {
  if (!classUid.starts_with(kStorageClasses))
    return nullptr;
  const std::string_view own = classUid.substr(kStorageClasses.size());
  const auto fits = [&](const ObjectClass& one) {
    return one.uid == own ||
           (one.uid.ends_with('.') ? own.starts_with(one.uid)
                                   : own.starts_with(one.uid) && own.substr(one.uid.size()).starts_with('.'));
  };
  const auto found = std::find_if(kClasses.begin(), kClasses.end(), fits);
  return found == kClasses.end() ? nullptr : &*found;
}

} // namespace

DicomKind kindOfDicomClass(std::string_view classUid) {
  if (const ObjectClass* known = classOf(classUid))
    return known->kind;
  return classUid.empty() || classUid.starts_with(kStorageClasses) ? DicomKind::image : DicomKind::other;
}

bool isSegmentationClass(std::string_view classUid) {
  return kindOfDicomClass(classUid) == DicomKind::segmentation && !isStructureSetClass(classUid);
}

bool isStructureSetClass(std::string_view classUid) {
  return classUid == "1.2.840.10008.5.1.4.1.1.481.3";
}

std::string nameOfDicomClass(std::string_view classUid) {
  const ObjectClass* known = classOf(classUid);
  return known == nullptr ? std::string() : std::string(known->name);
}

void failAsDicomObject(const FileBytes& file, std::string_view classUid) {
  if (classUid == kDirectoryClass) {
    const std::filesystem::path folder = file.file.parent_path();
    file.fail(
        "It is the table of contents of a DICOM medium (DICOMDIR)",
        phrase("open the folder that it lists, %1", folder.empty() ? std::string(".") : folder.string()));
  }
  const ObjectClass* known = classOf(classUid);
  const DicomKind kind = known == nullptr ? DicomKind::other : known->kind;
  const char* term = dcmFindNameOfUID(std::string(classUid).c_str(), nullptr);
  const std::string name = known != nullptr ? std::string(known->name) : term != nullptr ? term : "";
  if (kind == DicomKind::segmentation || kind == DicomKind::surface)
    file.fail(phrase("%1; it looks like %2", Text("It is not a scan in a known format"), name),
              kind == DicomKind::surface ? "open it as a surface" : "open it as a label map");
  file.fail(phrase("It is a DICOM file that holds no scan, label map or surface: %1",
                   name.empty() ? Text("an object of an unknown kind") : Text(name)),
            known == nullptr ? kOpenItsImages : known->wayOut);
}

} // namespace viscera::medical_io

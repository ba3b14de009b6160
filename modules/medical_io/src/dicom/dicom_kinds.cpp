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
    "open it in 3D Slicer, convert it to a segmentation there, and save that as .seg.nrrd";

/// Classes of storage, by the end of their UID; a point at its end stands for all below.
struct ObjectClass {
  std::string_view uid;
  DicomKind kind;
  const char* name;
  const char* wayOut = kOpenItsImages;
};

/// The first that fits counts.
constexpr auto kClasses = std::to_array<ObjectClass>({
    {"66.4", DicomKind::segmentation, "a segmentation"},
    {"66.7", DicomKind::segmentation, "a label map segmentation"},
    {"104.3", DicomKind::surface, "an STL surface in a DICOM file"},
    {"104.4", DicomKind::surface, "an OBJ surface in a DICOM file"},
    {"104.1", DicomKind::other, "a PDF document in a DICOM file"},
    {"104.2", DicomKind::other, "a text document (CDA) in a DICOM file"},
    {"104.5", DicomKind::other, "the materials of an OBJ surface in a DICOM file",
     "open the DICOM file with the OBJ surface itself"},
    {"104.", DicomKind::other, "a document in a DICOM file"},
    {"481.3", DicomKind::other,
     "a structure set of radiotherapy (RTSTRUCT): contours, without voxels or surfaces",
     "load it in 3D Slicer with its CT, convert it to a segmentation there, and save that as .seg.nrrd"},
    {"481.1", DicomKind::image, "a projection image of radiotherapy"},
    {"481.2", DicomKind::image, "a dose of radiotherapy"},
    {"481.5", DicomKind::other, "a plan of radiotherapy (RTPLAN)"},
    {"481.8", DicomKind::other, "a plan of radiotherapy with ions"},
    {"481.", DicomKind::other, "a record of radiotherapy"},
    {"88.59", DicomKind::other, "a list of selected images (Key Object Selection)"},
    {"88.67", DicomKind::other, "a report of the radiation dose"},
    {"88.", DicomKind::other, "a structured report (SR)"},
    {"11.", DicomKind::other, "a presentation state, which says how to display images"},
    {"9.1.", DicomKind::other, "an electrocardiogram (waveform)"},
    {"9.4.", DicomKind::other, "a sound recording (waveform)"},
    {"9.", DicomKind::other, "a recorded signal (waveform)"},
    {"66.1", DicomKind::other, "a spatial registration, which only says how images lie to each other"},
    {"66.2", DicomKind::other, "a list of reference points of images (spatial fiducials)",
     "load it in 3D Slicer, and save its points as .mrk.json"},
    {"66.3", DicomKind::other, "a deformable registration, which only says how images lie to each other"},
    {"66.5", DicomKind::other, "a surface segmentation", kAsSegmentation},
    {"66.6", DicomKind::other, "tracts of nerve fibres (tractography)",
     "load it in 3D Slicer, and save its fibre bundles as .vtk"},
    {"66", DicomKind::other, "raw data of a scanner"},
    {"67", DicomKind::other, "a mapping of image values to units"},
    {"68.1", DicomKind::other, "a mesh of a surface scanner", "export the surface as STL, OBJ or PLY"},
    {"68.2", DicomKind::other, "a point cloud of a surface scanner", "export the surface as STL, OBJ or PLY"},
    {"77.1.5.3", DicomKind::other, "measurements of the eye"},
    {"77.1.5.4", DicomKind::image, "a tomogram of the eye"},
    {"77.1.6", DicomKind::other, "a whole-slide image of microscopy",
     "open it in a viewer for microscopy, such as QuPath"},
    {"77.1.1", DicomKind::image, "a picture of endoscopy"},
    {"77.1.", DicomKind::image, "a photograph"},
    {"78.", DicomKind::other, "measurements of the eye"},
    {"79.", DicomKind::other, "measurements of the eye"},
    {"80.", DicomKind::other, "measurements of the eye"},
    {"4.2", DicomKind::other, "a spectrum of magnetic resonance"},
    {"7", DicomKind::image, "a secondary capture (a picture of a screen or a page)"},
    {"6.1", DicomKind::image, "an ultrasound image"},
    {"3.1", DicomKind::image, "an ultrasound film"},
    {"6.2", DicomKind::image, "an ultrasound volume"},
    {"12.", DicomKind::image, "a projection image of X-rays"},
    {"1.1", DicomKind::image, "a projection image of X-rays"},
    {"1.2", DicomKind::image, "a mammogram"},
    {"1.3", DicomKind::image, "a dental X-ray image"},
    {"13.", DicomKind::image, "a tomogram of X-rays"},
    {"20", DicomKind::image, "an image of nuclear medicine"},
    {"200.", DicomKind::other, "a protocol of a scanner"},
    {"201.", DicomKind::other, "settings of a device or a protocol of storage"},
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
  return kindOfDicomClass(classUid) == DicomKind::segmentation;
}

Text nameOfDicomClass(std::string_view classUid) {
  const ObjectClass* known = classOf(classUid);
  return known == nullptr ? Text() : Text(known->name);
}

void failAsDicomObject(const FileBytes& file, std::string_view classUid) {
  if (classUid == kDirectoryClass) {
    const std::filesystem::path folder = file.file.parent_path();
    file.fail(
        "It is the table of contents of a DICOM medium (DICOMDIR)",
        phrase("open the folder that it lists, %1", folder.empty() ? std::string(".") : folder.string()));
  }
  const ObjectClass* known = classOf(classUid);
  if (known != nullptr && known->kind == DicomKind::segmentation)
    file.fail(phrase("It is %1, not a scan", Text(known->name)), "open it as a label map");
  if (known != nullptr && known->kind == DicomKind::surface)
    file.fail(phrase("It is %1, not a scan", Text(known->name)), "open it as a surface");
  if (known != nullptr)
    file.fail(phrase("It is a DICOM file that holds no scan, label map or surface: %1", Text(known->name)),
              known->wayOut);
  const char* name = dcmFindNameOfUID(std::string(classUid).c_str(), nullptr);
  file.fail(phrase("It is a DICOM file that holds no scan, label map or surface: %1",
                   name != nullptr ? Text(std::string(name)) : Text("an object of an unknown kind")),
            kOpenItsImages);
}

} // namespace viscera::medical_io

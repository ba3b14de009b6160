#include "good_files.h"

#include <cstdlib>
#include <utility>

#include <vtkNew.h>
#include <vtkPolyDataWriter.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#include <vtkXMLPolyDataWriter.h>

#include "bzipped.h"
#include "dicom_files.h"
#include "label_files.h"
#include "mesh_files.h"
#include "packed_bytes.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::tests {
namespace {

GoodFile written(const std::string& extension) {
  const TemporaryFolder folder;
  geometry::TriangleMesh mesh = sphere(1, 50);
  mesh.colors.resize(mesh.points.rows(), 3);
  mesh.colors.setConstant(128);
  medical_io::writeSurface(folder / ("a" + extension), mesh, {medical_io::Space::ras, "organ"});
  return {"viscera" + extension, contentsOf(folder / ("a" + extension)), FileUse::surface,
          extension == ".obj"};
}

GoodFile legacyVtk(const std::string& name, bool binary, int version, bool strips) {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(50);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputConnection(strips ? stripper->GetOutputPort() : source->GetOutputPort());
  writer->SetFileType(binary ? VTK_BINARY : VTK_ASCII);
  writer->SetFileVersion(version);
  writer->WriteToOutputStringOn();
  writer->Write();
  return {name,
          std::string(writer->GetOutputString(), static_cast<std::size_t>(writer->GetOutputStringLength()))};
}

GoodFile vtp(const std::string& name, int mode, bool encoded, bool compressed) {
  const TemporaryFolder folder;
  vtkNew<vtkSphereSource> source;
  source->SetRadius(50);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetDataMode(mode);
  writer->SetEncodeAppendedData(encoded);
  writer->SetCompressorType(compressed ? vtkXMLWriter::ZLIB : vtkXMLWriter::NONE);
  writer->SetFileName((folder / "a.vtp").c_str());
  writer->Write();
  return {name, contentsOf(folder / "a.vtp")};
}

GoodFile textStl() {
  const geometry::TriangleMesh mesh = box(30, 40, 50);
  std::string text = "solid organ SPACE=LPS\n";
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (int k = 0; k < 3; ++k) {
      text += "  vertex";
      for (int axis = 0; axis < 3; ++axis)
        text += " " + std::to_string(mesh.points(mesh.triangles(t, k), axis));
      text += "\n";
    }
    text += " endloop\nendfacet\n";
  }
  return {"text.stl", text + "endsolid organ\n"};
}

GoodFile textPly() {
  const geometry::TriangleMesh mesh = box(30, 40, 50);
  std::string text =
      "ply\nformat ascii 1.0\ncomment SPACE=RAS\nelement vertex 8\nproperty float x\nproperty float y\n"
      "property float z\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n";
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      text += std::to_string(mesh.points(v, axis)) + (axis == 2 ? "\n" : " ");
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    text += "3";
    for (int k = 0; k < 3; ++k)
      text += " " + std::to_string(mesh.triangles(t, k));
    text += "\n";
  }
  return {"text.ply", text};
}

/// Two organs, one of which has a face with a keyhole.
GoodFile groups() {
  std::string text = "g liver\nusemtl m\n";
  const auto addPoints = [&](const Points& points, double beside) {
    for (Eigen::Index v = 0; v < points.rows(); ++v)
      text += "v " + std::to_string(points(v, 0) + beside) + " " + std::to_string(points(v, 1)) + " " +
              std::to_string(points(v, 2)) + "\n";
  };
  const geometry::TriangleMesh mesh = box(30, 40, 50);
  addPoints(mesh.points, 0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    text += "f";
    for (int k = 0; k < 3; ++k)
      text += " " + std::to_string(mesh.triangles(t, k) + 1);
    text += "\n";
  }
  Points plate(8, 3);
  plate << 0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0, 4, 4, 0, 4, 6, 0, 6, 6, 0, 6, 4, 0;
  text += "g plate\n";
  addPoints(plate, 90);
  return {"groups.obj", text + "f -8 -7 -6 -5 -8 -4 -3 -2 -1 -4\n", FileUse::surface, true};
}

/// Blocks of two names that are one file.
GoodFile blocks() {
  GoodFile block = vtp("block.vtp", vtkXMLWriter::Ascii, true, false);
  return {"blocks.vtm",
          "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>"
          "<DataSet index=\"0\" name=\"liver\" file=\"block.vtp\"/><Block index=\"1\" name=\"b\">"
          "<DataSet index=\"0\" file=\"block.vtp\"/></Block></vtkMultiBlockDataSet></VTKFile>",
          FileUse::surface,
          false,
          "block.vtp",
          std::move(block.bytes)};
}

/// Its buffer within the file: one triangle, 36 bytes in base64.
GoodFile gltf() {
  return {
      "scene.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[2,2,2]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
      R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
      R"(AAAAAAAAAAAAAAAAAADIQgAAAAAAAAAAAAAAAAAAyEIAAAAA"}]})"};
}

GoodFile markups() {
  const TemporaryFolder folder;
  medical_io::HandleFile rig;
  for (const char* name : {"A", "B"}) {
    medical_io::HandleGroupRecord group{name, {1, 0.5, 0}, {}};
    for (int i = 0; i < 5; ++i)
      group.handles.push_back(
          {std::string(name) + "-" + std::to_string(i), {i + 0.1, 2.0 * i, -i / 3.0}, "", i == 1});
    rig.groups.push_back(group);
  }
  medical_io::writeHandles(folder / "a.mrk.json", rig);
  return {"rig.mrk.json", contentsOf(folder / "a.mrk.json"), FileUse::handles};
}

GoodFile fcsv() {
  std::string text = "# Markups fiducial file version = 4.11\n# CoordinateSystem = RAS\n"
                     "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
  for (int i = 0; i < 6; ++i)
    text += "n," + std::to_string(10 * i) + ",2.5,3,0,0,0,1,1,1,0,F-" + std::to_string(i) + ",\"a, b\",\n";
  return {"tips.fcsv", text, FileUse::handles, true};
}

/// Slicer 5's, with points that were never placed, and Slicer 3's.
GoodFile unplacedFcsv() {
  return {"unplaced.fcsv",
          "# Markups fiducial file version = 5.6\n# CoordinateSystem = LPS\n"
          "1,12,-9,7,0,0,0,1,1,1,0,F-1,,,2,0\n2,0,0,0,0,0,0,1,1,1,0,F-2,,,0,0\n",
          FileUse::handles, true};
}

GoodFile oldFcsv() {
  return {"old.fcsv",
          "# Fiducial List file f\n# name = tips\n# selectedColor = 1,0.5,0\n# locked = 1\n"
          "# columns = label,x,y,z,sel,vis\nP,50,100,200,1,1\nQ,1,2,3,1,0\n",
          FileUse::handles, true};
}

void addMeshes(std::vector<GoodFile>& list) {
  const CellsOfTest cells = hollowBox(Split::tetrahedra);
  const CellsOfTest boxes = hollowBox(Split::hexahedra);
  const geometry::TriangleMesh mesh = box(30, 40, 50);
  list.push_back({"grid.vtk", gridText(boxes)});
  list.push_back({"grid.vtu", gridXml(boxes)});
  list.push_back({"text.msh", GmshFile(cells, 2.2, false).text()});
  list.push_back({"binary.msh", GmshFile(cells, 2.2, true).text()});
  list.push_back({"version4.msh", GmshFile(boxes, 4.0, true).text()});
  list.push_back({"version41.msh", GmshFile(boxes, 4.1, false).text()});
  list.push_back({"medit.mesh", meditText(boxes), FileUse::surface, true});
  list.push_back({"medit.meshb", meditBinary(boxes, 3, std::endian::little)});
  list.push_back({"carto.mesh", cartoText(mesh)});
  list.push_back(
      {"heart.elem", carpElements(boxes, true), FileUse::surface, true, "heart.pts", carpPoints(boxes)});
  list.push_back({"organ.gii", giftiFile(mesh, GiftiForm(), zlibPacked)});
  list.push_back({"text.gii", giftiFile(mesh, GiftiForm{.encoding = "ASCII"}, zlibPacked)});
  list.push_back({"lh.white", freeSurferFile(mesh)});
  list.push_back({"lh.asc", freeSurferText(mesh)});
}

LabelImage labels() {
  LabelImage image = emptyLabels({11, 9, 8});
  image.indexToLps.linear() = Vec3(-1.5, 2, 3).asDiagonal();
  image.fill({2, 2, 2}, {4, 5, 5}, 1);
  image.fill({6, 3, 1}, {8, 6, 6}, 2);
  return image;
}

/// Header and voxels of a file in which only these are packed.
std::string withPackedVoxels(std::string bytes, const std::string& from, const std::string& to,
                             const std::string& packed) {
  bytes.resize(bytes.size() - voxelBytes(labels().voxels).size());
  bytes.replace(bytes.find(from), from.size(), to);
  return bytes + packed;
}

void addLabelMaps(std::vector<GoodFile>& list) {
  const LabelImage image = labels();
  const std::string voxels = voxelBytes(image.voxels);
  const std::string names =
      "Segment0_ID:=S1\nSegment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Color:=1 0.5 0\n"
      "Segment1_ID:=S2\nSegment1_Name:=kidney\nSegment1_LabelValue:=2\n";
  LabelImage layered = image;
  layered.voxels.clear();
  for (const std::int16_t voxel : image.voxels)
    layered.voxels.insert(layered.voxels.end(), {voxel, std::int16_t(voxel == 1 ? 3 : 0)});
  std::string text;
  for (const std::int16_t voxel : image.voxels)
    text += std::to_string(voxel) + "\n";
  const std::string table =
      "<CaretExtension><VolumeInformation><LabelTable><Label Key=\"1\">liver</Label></LabelTable>"
      "</VolumeInformation></CaretExtension>";
  const std::string nifti = niftiFile(image, NiftiForm::both, table);
  const auto add = [&](const std::string& name, const std::string& bytes) {
    list.push_back({name, bytes, FileUse::labels});
  };
  add("labels.nii", nifti);
  add("labels.nii.gz", gzipped(nifti));
  add("labels.nrrd", nrrdFile(image));
  add("layers.seg.nrrd", nrrdFile(layered, "right-anterior-superior", names, 2));
  add("packed.nrrd", withPackedVoxels(nrrdFile(image), "encoding: raw", "encoding: gzip", gzipped(voxels)));
  add("text.nrrd", withPackedVoxels(nrrdFile(image), "encoding: raw", "encoding: text", text));
  add("bzip2.nrrd", withPackedVoxels(nrrdFile(image), "encoding: raw", "encoding: bzip2", bzipped(voxels)));
  add("labels.mha", metaImageFile(image));
  add("packed.mha", withPackedVoxels(metaImageFile(image), "CompressedData = False", "CompressedData = True",
                                     zlibPacked(voxels)));
  const NiftiHalves halves = niftiHalves(image, NiftiForm::both, table);
  list.push_back({"header.hdr", halves.header, FileUse::labels, false, "header.img", halves.voxels});
  list.push_back({"voxels.img", halves.voxels, FileUse::labels, false, "voxels.hdr", halves.header});
  list.push_back({"packed.img.gz", gzipped(voxels), FileUse::labels, false, "packed.hdr", halves.header});
  add("binary.dcm", dicomFile(image, {.names = {"liver", "kidney"}}));
  add("fractions.dcm", dicomFile(image, {.fractional = true, .names = {"liver", "kidney"}}));
}

} // namespace

std::vector<GoodFile> goodFiles() {
  std::vector<GoodFile> list;
  for (const char* extension : {".stl", ".obj", ".ply", ".off", ".vtk", ".vtp", ".glb", ".3mf"})
    list.push_back(written(extension));
  list.push_back(textStl());
  list.push_back(textPly());
  list.push_back(gltf());
  list.push_back(groups());
  list.push_back(blocks());
  list.push_back(legacyVtk("text.vtk", false, 42, false));
  list.push_back(legacyVtk("strips.vtk", true, 42, true));
  list.push_back(legacyVtk("offsets.vtk", true, 51, true));
  list.push_back(vtp("text.vtp", vtkXMLWriter::Ascii, true, false));
  list.push_back(vtp("inline.vtp", vtkXMLWriter::Binary, true, true));
  list.push_back(vtp("raw.vtp", vtkXMLWriter::Appended, false, false));
  list.push_back(vtp("raw_packed.vtp", vtkXMLWriter::Appended, false, true));
  addMeshes(list);
  list.push_back(markups());
  list.push_back(fcsv());
  list.push_back(unplacedFcsv());
  list.push_back(oldFcsv());
  addLabelMaps(list);
  return list;
}

} // namespace viscera::tests

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkGLTFReader.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/medical_io/surface_file.h"

/// What Viscera writes is read by somebody else's reader; VTK's stand for the programs that are built on
/// them.
namespace viscera::medical_io {
namespace {

using test::organ;
using tests::TemporaryFolder;

template <typename Reader>
vtkSmartPointer<vtkPolyData> readBy(const std::filesystem::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(reader->GetOutput());
  return data;
}

void expectOrgan(vtkPolyData* read, const std::string& format) {
  const geometry::TriangleMesh mesh = organ();
  EXPECT_EQ(read->GetNumberOfPoints(), mesh.points.rows()) << format;
  EXPECT_EQ(read->GetNumberOfPolys(), mesh.triangles.rows()) << format;
  const Bounds bounds = boundsOf(mesh.points);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_FLOAT_EQ(static_cast<float>(read->GetBounds()[2 * axis]), static_cast<float>(bounds.low[axis]))
        << format;
    EXPECT_FLOAT_EQ(static_cast<float>(read->GetBounds()[2 * axis + 1]),
                    static_cast<float>(bounds.high[axis]))
        << format;
  }
}

TEST(OtherPrograms, ReadWhatVisceraWrites) {
  const TemporaryFolder folder;
  for (const char* extension : {".stl", ".obj", ".ply", ".vtk", ".vtp"})
    writeSurface(folder / (std::string("a") + extension), organ(), {Space::lps, "organ"});
  expectOrgan(readBy<vtkSTLReader>(folder / "a.stl"), "STL");
  expectOrgan(readBy<vtkOBJReader>(folder / "a.obj"), "OBJ");
  expectOrgan(readBy<vtkPLYReader>(folder / "a.ply"), "PLY");
  expectOrgan(readBy<vtkPolyDataReader>(folder / "a.vtk"), "VTK");
  expectOrgan(readBy<vtkXMLPolyDataReader>(folder / "a.vtp"), "VTP");
}

TEST(OtherPrograms, SeeTheColours) {
  const TemporaryFolder folder;
  for (const char* extension : {".ply", ".vtk", ".vtp"})
    writeSurface(folder / (std::string("a") + extension), organ());
  for (const auto& read :
       {readBy<vtkPLYReader>(folder / "a.ply"), readBy<vtkPolyDataReader>(folder / "a.vtk"),
        readBy<vtkXMLPolyDataReader>(folder / "a.vtp")}) {
    vtkDataArray* colors = read->GetPointData()->GetScalars();
    ASSERT_NE(colors, nullptr);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(colors->GetComponent(9, k), organ().colors(9, k));
  }
}

TEST(OtherPrograms, SeeTheSceneUprightInMetres) {
  const TemporaryFolder folder;
  writeSurface(folder / "a.glb", organ());
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName((folder / "a.glb").c_str());
  vtkNew<vtkCompositeDataGeometryFilter> surface;
  surface->SetInputConnection(reader->GetOutputPort());
  surface->Update();
  vtkPolyData* read = surface->GetOutput();
  EXPECT_EQ(read->GetNumberOfPolys(), organ().triangles.rows());
  const Bounds bounds = boundsOf(organ().points);
  EXPECT_NEAR(read->GetBounds()[0], bounds.low.x() / 1000, 1e-6) << "x: the patient's left";
  EXPECT_NEAR(read->GetBounds()[3], bounds.high.z() / 1000, 1e-6) << "y: the head";
  EXPECT_NEAR(read->GetBounds()[5], -bounds.low.y() / 1000, 1e-6) << "z: the face";
}

} // namespace
} // namespace viscera::medical_io

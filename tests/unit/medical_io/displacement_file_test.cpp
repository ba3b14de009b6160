#include "viscera/medical_io/displacement_file.h"

#include <cstring>
#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

using tests::TemporaryFolder;

/// Every vector another one, none with a short decimal form.
deformation::DisplacementGrid grid() {
  deformation::DisplacementGrid grid;
  grid.size = {3, 4, 5};
  grid.origin = {-10.1, 20.0 / 3.0, 1e-3};
  grid.spacing = 2.5;
  grid.vectors.resize(60, 3);
  for (Eigen::Index row = 0; row < 60; ++row)
    grid.vectors.row(row) = Eigen::RowVector3d(0.1, -0.2, 1.0 / 3.0) * static_cast<double>(row);
  return grid;
}

/// A header as lines "key: value" or "key = value", and the numbers after it.
struct Image {
  std::map<std::string, std::string> header;
  std::vector<double> values;
};

Image readImage(const std::filesystem::path& file, const std::string& separator, const std::string& end) {
  const std::string bytes = tests::contentsOf(file);
  const std::size_t begin = bytes.find(end) + end.size();
  Image image;
  std::istringstream lines(bytes.substr(0, begin));
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t at = line.find(separator); at != line.npos)
      image.header[line.substr(0, at)] = line.substr(at + separator.size());
  image.values.resize((bytes.size() - begin) / sizeof(double));
  std::memcpy(image.values.data(), bytes.data() + begin, bytes.size() - begin);
  return image;
}

/// The numbers in a text, whatever stands between them.
std::vector<double> numbersIn(std::string text) {
  for (char& c : text)
    if (c == '(' || c == ')' || c == ',')
      c = ' ';
  std::istringstream words(text);
  std::vector<double> list;
  for (std::string word; words >> word;)
    if (word != "none")
      list.push_back(std::stod(word));
  return list;
}

TEST(TransformFile, NrrdHasAVectorAtEveryPointOfAnLpsGrid) {
  const TemporaryFolder folder;
  writeTransform(folder / "field.nrrd", grid());
  const Image image = readImage(folder / "field.nrrd", ": ", "\n\n");
  EXPECT_EQ(image.header.at("space"), "left-posterior-superior");
  EXPECT_EQ(image.header.at("kinds"), "vector domain domain domain");
  EXPECT_EQ(image.header.at("type"), "double");
  EXPECT_EQ(numbersIn(image.header.at("sizes")), (std::vector<double>{3, 3, 4, 5}));
  EXPECT_EQ(numbersIn(image.header.at("space directions")),
            (std::vector<double>{2.5, 0, 0, 0, 2.5, 0, 0, 0, 2.5}));
  EXPECT_EQ(numbersIn(image.header.at("space origin")), (std::vector<double>{-10.1, 20.0 / 3.0, 1e-3}));
  ASSERT_EQ(image.values.size(), 180u);
  const deformation::DisplacementGrid written = grid();
  EXPECT_EQ(Eigen::Map<const Points>(image.values.data(), 60, 3), written.vectors);
  // The vector that a reader finds at index (2, 1, 3), by the point that it computes from the header.
  EXPECT_EQ(written.point(2 + 3 * (1 + 4 * 3)), written.origin + Vec3(5, 2.5, 7.5));
}

TEST(TransformFile, MetaImageHasTheSame) {
  const TemporaryFolder folder;
  writeTransform(folder / "field.mha", grid());
  const Image image = readImage(folder / "field.mha", " = ", "ElementDataFile = LOCAL\n");
  EXPECT_EQ(numbersIn(image.header.at("DimSize")), (std::vector<double>{3, 4, 5}));
  EXPECT_EQ(numbersIn(image.header.at("Offset")), (std::vector<double>{-10.1, 20.0 / 3.0, 1e-3}));
  EXPECT_EQ(numbersIn(image.header.at("ElementSpacing")), (std::vector<double>{2.5, 2.5, 2.5}));
  EXPECT_EQ(image.header.at("ElementNumberOfChannels"), "3");
  ASSERT_EQ(image.values.size(), 180u);
  EXPECT_EQ(Eigen::Map<const Points>(image.values.data(), 60, 3), grid().vectors);
}

TEST(TransformFile, OtherEndingsAreRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(writeTransform(folder / "field.tif", grid()), CannotCreateError);
}

TEST(TransformFile, NiftiHasTheComponentsInTheFifthDimension) {
  const TemporaryFolder folder;
  writeTransform(folder / "field.nii", grid());
  const std::string bytes = tests::contentsOf(folder / "field.nii");
  ASSERT_EQ(bytes.size(), 352U + 180 * sizeof(double));
  const auto shortAt = [&](std::size_t offset) {
    std::int16_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
  };
  const std::int16_t sizes[] = {5, 3, 4, 5, 1, 3};
  for (std::size_t d = 0; d < 6; ++d)
    EXPECT_EQ(shortAt(40 + 2 * d), sizes[d]) << d;
  EXPECT_EQ(shortAt(68), 1007) << "vectors";
  EXPECT_EQ(shortAt(70), 64) << "doubles";
  std::vector<double> values(180);
  std::memcpy(values.data(), bytes.data() + 352, 180 * sizeof(double));
  const deformation::DisplacementGrid written = grid();
  for (Eigen::Index component = 0; component < 3; ++component)
    for (Eigen::Index row = 0; row < 60; ++row)
      ASSERT_EQ(values[static_cast<std::size_t>(60 * component + row)], written.vectors(row, component));
}

TEST(DisplacementFile, HoldsTheRestSurfaceAndWhereItWent) {
  const TemporaryFolder folder;
  const geometry::TriangleMesh rest = test::organ();
  const Points moved = rest.points.rowwise() + Eigen::RowVector3d(1, 2, -3);
  writeDisplacements(folder / "moved.vtp", rest, moved, "organ");
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder / "moved.vtp").c_str());
  reader->Update();
  vtkDataArray* vectors = reader->GetOutput()->GetPointData()->GetArray("displacement");
  ASSERT_NE(vectors, nullptr);
  ASSERT_EQ(vectors->GetNumberOfTuples(), rest.points.rows());
  for (vtkIdType v = 0; v < vectors->GetNumberOfTuples(); ++v) {
    double place[3];
    reader->GetOutput()->GetPoint(v, place);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(place[axis], rest.points(v, axis));
      EXPECT_EQ(vectors->GetComponent(v, axis), moved(v, axis) - rest.points(v, axis));
    }
  }
  EXPECT_EQ(readSurface(folder / "moved.vtp").mesh.colors, rest.colors) << "colours are not disturbed";
  EXPECT_THROW(writeDisplacements(folder / "m.stl", rest, moved, ""), CannotCreateError);
  EXPECT_THROW(writeDisplacements(folder / "m.vtp", rest, moved.topRows(3), ""), DataError);
}

} // namespace
} // namespace viscera::medical_io

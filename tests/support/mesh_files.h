#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <vtkBase64Utilities.h>

#include "viscera/geometry/triangle_mesh.h"

/// Meshes of cells, and files of the formats that only other programs write.
namespace viscera::tests {

/// How the boxes of a mesh are divided.
enum class Split { hexahedra, tetrahedra, wedges, pyramids };

struct CellsOfTest {
  struct Cell {
    int type; ///< VTK's number.
    std::vector<int> points;
    int region;
  };
  std::vector<Vec3> points;
  std::vector<Cell> cells;
};

/// A box of 3 x 3 x 3 boxes of 10 mm without the one in the middle: 26 ml around a cavity of 1 ml. The lowest
/// boxes are region 1, the others 2.
inline CellsOfTest hollowBox(Split split) {
  CellsOfTest mesh;
  const auto corner = [](int i, int j, int k) { return i + 4 * j + 16 * k; };
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        mesh.points.emplace_back(10 * i, 10 * j, 10 * k);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        if (i == 1 && j == 1 && k == 1)
          continue;
        const std::vector<int> c = {corner(i, j, k),
                                    corner(i + 1, j, k),
                                    corner(i + 1, j + 1, k),
                                    corner(i, j + 1, k),
                                    corner(i, j, k + 1),
                                    corner(i + 1, j, k + 1),
                                    corner(i + 1, j + 1, k + 1),
                                    corner(i, j + 1, k + 1)};
        const auto add = [&](int type, const std::vector<int>& local) {
          CellsOfTest::Cell cell{type, {}, k == 0 ? 1 : 2};
          for (const int one : local)
            cell.points.push_back(one < 8 ? c[static_cast<std::size_t>(one)]
                                          : static_cast<int>(mesh.points.size()) - 1);
          mesh.cells.push_back(cell);
        };
        if (split == Split::hexahedra) {
          add(12, {0, 1, 2, 3, 4, 5, 6, 7});
        } else if (split == Split::tetrahedra) {
          for (const auto& tetrahedron : std::vector<std::vector<int>>{
                   {0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}})
            add(10, tetrahedron);
        } else if (split == Split::wedges) {
          add(13, {0, 1, 2, 4, 5, 6});
          add(13, {0, 2, 3, 4, 6, 7});
        } else {
          mesh.points.emplace_back(10 * i + 5, 10 * j + 5, 10 * k + 5);
          for (const auto& base : std::vector<std::vector<int>>{
                   {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
            add(14, {base[3], base[2], base[1], base[0], 8});
        }
      }
  return mesh;
}

/// VTK's older text format.
inline std::string gridText(const CellsOfTest& mesh) {
  std::string points, cells, types;
  std::size_t size = 0;
  for (const Vec3& p : mesh.points)
    points += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
  for (const CellsOfTest::Cell& cell : mesh.cells) {
    cells += std::to_string(cell.points.size());
    for (const int point : cell.points)
      cells += " " + std::to_string(point);
    cells += "\n";
    types += std::to_string(cell.type) + "\n";
    size += cell.points.size() + 1;
  }
  const std::string count = std::to_string(mesh.cells.size());
  return "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
         std::to_string(mesh.points.size()) + " float\n" + points + "CELLS " + count + " " +
         std::to_string(size) + "\n" + cells + "CELL_TYPES " + count + "\n" + types;
}

/// VTK's XML with its arrays as text.
inline std::string gridXml(const CellsOfTest& mesh) {
  std::string points, corners, ends, types, regions;
  std::size_t end = 0;
  for (const Vec3& p : mesh.points)
    points += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + " ";
  for (const CellsOfTest::Cell& cell : mesh.cells) {
    for (const int point : cell.points)
      corners += std::to_string(point) + " ";
    ends += std::to_string(end += cell.points.size()) + " ";
    types += std::to_string(cell.type) + " ";
    regions += std::to_string(cell.region) + " ";
  }
  const auto array = [](const std::string& type, const std::string& name, const std::string& values) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           (name == "Points" ? "3" : "1") + "\" format=\"ascii\">" + values + "</DataArray>";
  };
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\"><UnstructuredGrid><Piece NumberOfPoints=\"" +
         std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" + std::to_string(mesh.cells.size()) +
         "\"><Points>" + array("Float64", "Points", points) + "</Points><Cells>" +
         array("Int64", "connectivity", corners) + array("Int64", "offsets", ends) +
         array("UInt8", "types", types) + "</Cells><CellData>" + array("Int32", "Material", regions) +
         "</CellData></Piece></UnstructuredGrid></VTKFile>\n";
}

/// One value in that order of bytes.
template <typename Number>
std::string valueBytes(Number value, std::endian order = std::endian::little) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  std::string bytes(raw, sizeof raw);
  return order == std::endian::native ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

inline int gmshTypeOf(int vtkType) {
  return std::map<int, int>{{5, 2}, {10, 4}, {12, 5}, {13, 6}, {14, 7}}.at(vtkType);
}

/// gmsh's format in version 2.2, 4.0 or 4.1. Nodes are numbered 3, 6, 9, ...; the regions are the physical
/// groups "muscle" (1) and "blood pool" (2), which are the entities 11 and 12.
class GmshFile {
public:
  GmshFile(const CellsOfTest& mesh, double version, bool binary, std::endian order = std::endian::little)
      : mesh_(mesh), version_(version), binary_(binary), order_(order) {}

  std::string text() {
    const char* name = version_ < 3 ? "2.2" : version_ < 4.05 ? "4" : "4.1";
    out_ = "$MeshFormat\n" + std::string(name) + (binary_ ? " 1 8\n" : " 0 8\n");
    if (binary_)
      out_ += valueBytes(std::int32_t{1}, order_) + "\n";
    out_ += "$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"muscle\"\n3 2 \"blood pool\"\n$EndPhysicalNames\n";
    if (version_ < 3) {
      old();
    } else {
      entities();
      nodes();
      elements();
    }
    return out_ + "$Periodic\n0\n$EndPeriodic\n";
  }

private:
  void integer(std::int64_t value) { put(static_cast<std::int32_t>(value), std::to_string(value)); }
  void whole(std::int64_t value) { put(value, std::to_string(value)); }
  void number(double value) { put(value, std::to_string(value)); }
  template <typename Number>
  void put(Number value, const std::string& word) {
    out_ += binary_ ? valueBytes(value, order_) : word + " ";
  }
  void endLine() { out_ += binary_ ? "" : "\n"; }
  void endSection(const std::string& name) { out_ += (binary_ ? "\n" : "") + ("$End" + name) + "\n"; }
  static std::int64_t tagOf(std::size_t point) { return 3 * (static_cast<std::int64_t>(point) + 1); }

  void old() {
    out_ += "$Nodes\n" + std::to_string(mesh_.points.size()) + "\n";
    for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
      integer(tagOf(i));
      for (int axis = 0; axis < 3; ++axis)
        number(mesh_.points[i][axis]);
      endLine();
    }
    endSection("Nodes");
    out_ += "$Elements\n" + std::to_string(mesh_.cells.size()) + "\n";
    for (std::size_t i = 0; i < mesh_.cells.size(); ++i) {
      const auto& cell = mesh_.cells[i];
      if (binary_) {
        integer(gmshTypeOf(cell.type));
        integer(1);
        integer(2);
        integer(static_cast<std::int64_t>(i) + 1);
      } else {
        integer(static_cast<std::int64_t>(i) + 1);
        integer(gmshTypeOf(cell.type));
        integer(2);
      }
      integer(cell.region);
      integer(10 + cell.region);
      for (const int point : cell.points)
        integer(tagOf(static_cast<std::size_t>(point)));
      endLine();
    }
    endSection("Elements");
  }

  void entities() {
    out_ += "$Entities\n";
    for (const int count : {1, 0, 0, 2})
      whole(count);
    endLine();
    integer(1); // A point without a group.
    for (int k = 0; k < (version_ < 4.05 ? 6 : 3); ++k)
      number(0);
    whole(0);
    endLine();
    for (const int region : {1, 2}) {
      integer(10 + region);
      for (int k = 0; k < 6; ++k)
        number(k);
      whole(1);
      integer(region);
      whole(0);
      endLine();
    }
    endSection("Entities");
  }

  void nodes() {
    const auto count = static_cast<std::int64_t>(mesh_.points.size());
    out_ += "$Nodes\n";
    whole(1);
    whole(count);
    if (version_ > 4.05) {
      whole(tagOf(0));
      whole(3 * count);
    }
    endLine();
    integer(version_ > 4.05 ? 3 : 11);
    integer(version_ > 4.05 ? 11 : 3);
    integer(0);
    whole(count);
    endLine();
    for (std::size_t i = 0; i < mesh_.points.size() && version_ > 4.05; ++i)
      whole(tagOf(i));
    for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
      if (version_ < 4.05)
        integer(tagOf(i));
      for (int axis = 0; axis < 3; ++axis)
        number(mesh_.points[i][axis]);
      endLine();
    }
    endSection("Nodes");
  }

  void elements() {
    std::map<std::pair<int, int>, std::vector<const CellsOfTest::Cell*>> blocks;
    for (const auto& cell : mesh_.cells)
      blocks[{cell.region, cell.type}].push_back(&cell);
    out_ += "$Elements\n";
    whole(static_cast<std::int64_t>(blocks.size()));
    whole(static_cast<std::int64_t>(mesh_.cells.size()));
    if (version_ > 4.05) {
      whole(1);
      whole(static_cast<std::int64_t>(mesh_.cells.size()));
    }
    endLine();
    std::int64_t next = 1;
    for (const auto& [key, cells] : blocks) {
      integer(version_ > 4.05 ? 3 : 10 + key.first);
      integer(version_ > 4.05 ? 10 + key.first : 3);
      integer(gmshTypeOf(key.second));
      whole(static_cast<std::int64_t>(cells.size()));
      endLine();
      for (const auto* cell : cells) {
        tag(next++);
        for (const int point : cell->points)
          tag(tagOf(static_cast<std::size_t>(point)));
        endLine();
      }
    }
    endSection("Elements");
  }

  void tag(std::int64_t value) { version_ > 4.05 ? whole(value) : integer(value); }

  const CellsOfTest& mesh_;
  double version_;
  bool binary_;
  std::endian order_;
  std::string out_;
};

struct MeditList {
  int type; ///< VTK's.
  const char* keyword;
  std::int32_t code;
};

inline const std::vector<MeditList>& meditLists() {
  static const std::vector<MeditList> kLists = {{5, "Triangles", 6},
                                                {10, "Tetrahedra", 8},
                                                {13, "Prisms", 9},
                                                {12, "Hexahedra", 10},
                                                {14, "Pyramids", 49}};
  return kLists;
}

inline std::string meditText(const CellsOfTest& mesh) {
  std::string text = "MeshVersionFormatted 2\n# by hand\nDimension\n3\nVertices\n" +
                     std::to_string(mesh.points.size()) + "\n";
  for (const Vec3& p : mesh.points)
    text += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + " 7\n";
  text += "Corners\n2\n1\n2\nEdges 1\n1 2 0\n";
  for (const MeditList& list : meditLists()) {
    std::string lines;
    int count = 0;
    for (const auto& cell : mesh.cells)
      if (cell.type == list.type) {
        ++count;
        for (const int point : cell.points)
          lines += std::to_string(point + 1) + " ";
        lines += std::to_string(cell.region) + "\n";
      }
    if (count > 0)
      text += std::string(list.keyword) + "\n" + std::to_string(count) + "\n" + lines;
  }
  return text + "NormalAtVertices\n1\n1 1\nNormals\n1\n0 0 1e0\nEnd\n";
}

/// Version 1: single precision; 2: double; 3: long places; 4: long numbers.
inline std::string meditBinary(const CellsOfTest& mesh, int version, std::endian order) {
  std::string out = valueBytes(std::int32_t{1}, order) + valueBytes(std::int32_t{version}, order);
  const auto integer = [&](std::int64_t value) {
    return version < 4 ? valueBytes(static_cast<std::int32_t>(value), order) : valueBytes(value, order);
  };
  const auto section = [&](std::int32_t code, const std::string& content) {
    const std::size_t place = version < 3 ? 4 : 8;
    const auto next = static_cast<std::int64_t>(out.size() + 4 + place + content.size());
    out += valueBytes(code, order) +
           (version < 3 ? valueBytes(static_cast<std::int32_t>(next), order) : valueBytes(next, order)) +
           content;
  };
  section(3, valueBytes(std::int32_t{3}, order));
  std::string points = integer(static_cast<std::int64_t>(mesh.points.size()));
  for (const Vec3& p : mesh.points) {
    for (int axis = 0; axis < 3; ++axis)
      points += version == 1 ? valueBytes(static_cast<float>(p[axis]), order) : valueBytes(p[axis], order);
    points += integer(0);
  }
  section(4, points);
  section(13, integer(1) + integer(1)); // Corners.
  for (const MeditList& list : meditLists()) {
    std::string lines;
    int count = 0;
    for (const auto& cell : mesh.cells)
      if (cell.type == list.type) {
        ++count;
        for (const int point : cell.points)
          lines += integer(point + 1);
        lines += integer(cell.region);
      }
    if (count > 0)
      section(list.code, integer(count) + lines);
  }
  return out + valueBytes(std::int32_t{54}, order) + std::string(version < 3 ? 4 : 8, '\0');
}

/// openCARP's points, in micrometres.
inline std::string carpPoints(const CellsOfTest& mesh) {
  std::string text = std::to_string(mesh.points.size()) + "\n";
  for (const Vec3& p : mesh.points)
    text += std::to_string(1000 * p.x()) + " " + std::to_string(1000 * p.y()) + " " +
            std::to_string(1000 * p.z()) + "\n";
  return text;
}

/// openCARP's elements; `ownOrder`: the upper corners of hexahedra and prisms run backwards, as it has them.
inline std::string carpElements(const CellsOfTest& mesh, bool ownOrder) {
  const std::map<int, std::string> names = {{5, "Tr"}, {10, "Tt"}, {12, "Hx"}, {13, "Pr"}, {14, "Py"}};
  std::string text = std::to_string(mesh.cells.size()) + "\n";
  for (const auto& cell : mesh.cells) {
    std::vector<int> points = cell.points;
    if (ownOrder && (cell.type == 12 || cell.type == 13))
      std::reverse(points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2 + 1), points.end());
    text += names.at(cell.type);
    for (const int point : points)
      text += " " + std::to_string(point);
    text += " " + std::to_string(cell.region) + "\n";
  }
  return text;
}

/// A map of CARTO; `cutAway` triangles more are marked as cut away.
inline std::string cartoText(const geometry::TriangleMesh& mesh, int cutAway = 0) {
  std::string text = "#TriangulatedMeshVersion2.0\n; Biosense Webster Triangulated Mesh file format\n\n"
                     "[GeneralAttributes]\nMeshID                 = 7\nMeshName               = 1-LA\n"
                     "NumVertex              = " +
                     std::to_string(mesh.points.rows()) +
                     "\nNumTriangle            = " + std::to_string(mesh.triangles.rows() + cutAway) +
                     "\nMeshColor              = 0.0   1.0   0.0   1.0\n\n[VerticesSection]\n"
                     ";                   X             Y             Z        NormalX   NormalY   NormalZ  "
                     "GroupID\n\n";
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    text += "       " + std::to_string(v) + " =";
    for (int axis = 0; axis < 3; ++axis)
      text += " " + std::to_string(mesh.points(v, axis));
    text += " 0.0 0.0 1.0 0\n";
  }
  text += "\n[TrianglesSection]\n;   Vertex0 Vertex1 Vertex2 NormalX NormalY NormalZ GroupID\n\n";
  for (Eigen::Index t = 0; t < mesh.triangles.rows() + cutAway; ++t) {
    const bool away = t >= mesh.triangles.rows();
    text += std::to_string(t) + " =";
    for (int k = 0; k < 3; ++k)
      text += " " + std::to_string(mesh.triangles(away ? 0 : t, k));
    text += std::string(" 0.0 0.0 1.0 ") + (away ? "-1000000" : "0") + "\n";
  }
  return text + "\n[VerticesColorsSection]\n;         Unipolar  Bipolar  LAT\n0 = -10000 -10000 -10000\n";
}

inline std::string base64(const std::string& bytes) {
  std::string out(bytes.size() * 2 + 8, '\0');
  const auto length = vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
                                                 static_cast<unsigned long>(bytes.size()),
                                                 reinterpret_cast<unsigned char*>(out.data()));
  out.resize(length);
  return out;
}

/// FreeSurfer's triangles, with `footer` behind them.
inline std::string freeSurferFile(const geometry::TriangleMesh& mesh, const std::string& footer = {}) {
  const auto big = std::endian::big;
  std::string out = "\xff\xff\xfe" + std::string("created by a test on Sunday\n\n") +
                    valueBytes(static_cast<std::int32_t>(mesh.points.rows()), big) +
                    valueBytes(static_cast<std::int32_t>(mesh.triangles.rows()), big);
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      out += valueBytes(static_cast<float>(mesh.points(v, axis)), big);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      out += valueBytes(std::int32_t{mesh.triangles(t, k)}, big);
  return out + footer;
}

inline std::string freeSurferText(const geometry::TriangleMesh& mesh) {
  std::string text = "#!ascii version of lh.white\n" + std::to_string(mesh.points.rows()) + " " +
                     std::to_string(mesh.triangles.rows()) + "\n";
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    for (int axis = 0; axis < 3; ++axis)
      text += std::to_string(mesh.points(v, axis)) + "  ";
    text += "0\n";
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k)
      text += std::to_string(mesh.triangles(t, k)) + " ";
    text += "0\n";
  }
  return text;
}

/// How a GIFTI file keeps its arrays.
struct GiftiForm {
  std::string encoding = "GZipBase64Binary"; ///< Or "ASCII", "Base64Binary".
  std::endian order = std::endian::little;
  bool columns = false;       ///< Column after column.
  bool doubles = false;       ///< Of the points.
  std::string transform = {}; ///< An element within the points.
};

/// A DataArray of n x 3 values; `pack` packs them for GZipBase64Binary.
template <typename Number, class Rows, class Pack>
std::string giftiArray(const std::string& intent, const std::string& type, const Rows& rows,
                       const GiftiForm& form, const std::string& inside, const Pack& pack) {
  std::string words, bytes;
  const auto add = [&](Number value) {
    words += std::to_string(value) + " ";
    bytes += valueBytes(value, form.order);
  };
  for (Eigen::Index i = 0; i < rows.rows() * 3; ++i)
    add(static_cast<Number>(form.columns ? rows(i % rows.rows(), i / rows.rows()) : rows(i / 3, i % 3)));
  const std::string data = form.encoding == "ASCII"          ? words
                           : form.encoding == "Base64Binary" ? base64(bytes)
                                                             : base64(pack(bytes));
  return "<DataArray Intent=\"" + intent + "\" DataType=\"" + type + "\" ArrayIndexingOrder=\"" +
         (form.columns ? "ColumnMajorOrder" : "RowMajorOrder") + "\" Dimensionality=\"2\" Dim0=\"" +
         std::to_string(rows.rows()) + "\" Dim1=\"3\" Encoding=\"" + form.encoding + "\" Endian=\"" +
         (form.order == std::endian::little ? "LittleEndian" : "BigEndian") +
         "\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n<MetaData/>\n" + inside + "<Data>" + data +
         "</Data></DataArray>\n";
}

template <class Pack>
std::string giftiFile(const geometry::TriangleMesh& mesh, const GiftiForm& form, const Pack& pack) {
  const std::string points = form.doubles ? giftiArray<double>("NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT64",
                                                               mesh.points, form, form.transform, pack)
                                          : giftiArray<float>("NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT32",
                                                              mesh.points, form, form.transform, pack);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM "
         "\"http://gifti.projects.nitrc.org/gifti.dtd\">\n<GIFTI Version=\"1.0\" "
         "NumberOfDataArrays=\"2\">\n" +
         points +
         giftiArray<std::int32_t>("NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", mesh.triangles, form, "",
                                  pack) +
         "</GIFTI>\n";
}

} // namespace viscera::tests

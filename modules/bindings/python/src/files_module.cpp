#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "array_memory.h"
#include "long_jobs.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/cine_study.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"
#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/medical_io/surface_repairs.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::python {
namespace {

namespace py = pybind11;
using geometry::TriangleMesh;
using std::filesystem::path;

/// A surface with where it came from.
struct Surface {
  std::shared_ptr<const TriangleMesh> mesh;
  std::string name;
  std::vector<std::string> warnings;
};

medical_io::Space spaceNamed(const std::string& name) {
  if (name == "LPS")
    return medical_io::Space::lps;
  if (name == "RAS")
    return medical_io::Space::ras;
  throw UsageError("there are no axes '" + name + "'", "space", "LPS or RAS");
}

Surface readSurface(const path& file, const std::string& part) {
  return unlocked([&] {
    auto read =
        part.empty() ? medical_io::readSurface(file) : medical_io::readSurfacePart(file, part).surface;
    return Surface{std::make_shared<const TriangleMesh>(std::move(read.mesh)), read.name,
                   inEnglish(read.warnings)};
  });
}

void writeSurface(const path& file, const py::object& points, const py::object& triangles,
                  const std::string& space, const std::string& name) {
  const TriangleMesh mesh{*pointsFrom(points, "points"), *trianglesFrom(triangles, "triangles"), {}};
  const medical_io::WriteSurface options{spaceNamed(space), name};
  unlocked([&] { medical_io::writeSurface(file, mesh, options); });
}

py::dict groupsOf(const medical_io::HandleFile& file) {
  py::dict groups;
  int next = 0;
  for (const auto& group : file.groups) {
    py::list rows;
    for (std::size_t i = 0; i < group.handles.size(); ++i)
      rows.append(next++);
    groups[py::str(group.name)] = rows;
  }
  return groups;
}

void writeHandles(const path& file, const py::object& positions, const std::vector<std::string>& labels,
                  const std::string& space) {
  const auto points = pointsFrom(positions, "positions");
  if (!labels.empty() && Eigen::Index(labels.size()) != points->rows())
    throw DataError("there are " + std::to_string(labels.size()) + " labels", "labels",
                    "one a handle is wanted: " + std::to_string(points->rows()));
  medical_io::HandleGroupRecord group;
  group.name = "Handles";
  for (Eigen::Index i = 0; i < points->rows(); ++i)
    group.handles.push_back({labels.empty() ? "H-" + std::to_string(i + 1) : labels[std::size_t(i)],
                             points->row(i).transpose(),
                             {},
                             false,
                             true});
  medical_io::writeHandles(file, {{std::move(group)}, {}}, {spaceNamed(space)});
}

std::shared_ptr<medical_io::LabelMap> readLabelMap(const path& file, const py::object& listener) {
  return resultOfLong(listener, [&](Progress& progress) {
    return std::make_shared<medical_io::LabelMap>(medical_io::readLabelMap(file, progress));
  });
}

Surface repairSurface(const py::object& points, const py::object& triangles,
                      const std::vector<std::string>& repairs, const py::object& listener) {
  TriangleMesh mesh{*pointsFrom(points, "points"), *trianglesFrom(triangles, "triangles"), {}};
  geometry::requireValid(mesh, "the surface");
  std::vector<medical_io::SurfaceRepair> steps;
  for (const std::string& id : repairs)
    steps.push_back(medical_io::surfaceRepair(id));
  Surface repaired;
  repaired.mesh = resultOfLong(listener, [&](Progress& progress) {
    for (const medical_io::SurfaceRepair& step : steps) {
      TriangleMesh next = step.apply(mesh, progress, {});
      const auto lost =
          step.remakes ? medical_io::doubtAbout(medical_io::surfaceChange(mesh, next)) : std::nullopt;
      if (lost)
        repaired.warnings.push_back(lost->english());
      mesh = std::move(next);
    }
    return std::make_shared<const TriangleMesh>(std::move(mesh));
  });
  return repaired;
}

/// The layers as arrays k x j x i of numbers of segments.
py::list layers(const std::shared_ptr<medical_io::LabelMap>& map) {
  py::list all;
  for (const auto& layer : map->layers) {
    py::array_t<std::uint16_t> array({map->size[2], map->size[1], map->size[0]});
    layer.visit([&](const auto& voxels) { std::copy(voxels.begin(), voxels.end(), array.mutable_data()); });
    array.attr("flags").attr("writeable") = false;
    all.append(array);
  }
  return all;
}

py::dict labelSurfaces(const medical_io::LabelMap& map, const std::vector<std::string>& names, int triangles,
                       double smoothing, bool largestPieceOnly, const py::object& listener) {
  medical_io::LabelSurfaceOptions options;
  options.segments = medical_io::segmentsNamed(map, names, "the label map");
  options.triangles = triangles;
  options.smoothing = smoothing;
  options.largestPieceOnly = largestPieceOnly;
  auto found = resultOfLong(
      listener, [&](Progress& progress) { return medical_io::labelSurfaces(map, options, progress); });
  py::dict all;
  for (auto& each : found) {
    const std::string& name = map.segments[each.segment].name;
    all[py::str(name)] =
        Surface{std::make_shared<const TriangleMesh>(std::move(each.mesh)), name, inEnglish(each.warnings)};
  }
  return all;
}

py::dict sampleOrgan(const std::string& name, const std::string& resolution, const py::object& listener) {
  const auto organ = resultOfLong(listener, [&](Progress& progress) {
    return sample_organs::sampleOrgan(sample_organs::standardLibrary(), name,
                                      sample_organs::resolutionFromName(resolution), progress);
  });
  py::dict all;
  for (const auto& surface : organ.surfaces)
    all[py::str(surface.name)] = Surface{surface.mesh, surface.name, {}};
  return all;
}

py::object colors(const Surface& surface) {
  if (surface.mesh->colors.rows() == 0)
    return py::none();
  return share<Colors>(std::shared_ptr<const Colors>(surface.mesh, &surface.mesh->colors));
}

void addSurface(py::module_& module) {
  py::class_<Surface>(module, "Surface",
                      "A triangle surface from a file, a label map or a sample organ: mm, LPS.")
      .def_property_readonly(
          "points",
          [](const Surface& s) {
            return share<Points>(std::shared_ptr<const Points>(s.mesh, &s.mesh->points));
          },
          "n x 3, mm; no copy, read only.")
      .def_property_readonly(
          "triangles",
          [](const Surface& s) {
            return share<Triangles>(std::shared_ptr<const Triangles>(s.mesh, &s.mesh->triangles));
          },
          "m x 3 rows of `points`, counter-clockwise seen from outside; no copy, read only.")
      .def_property_readonly("colors", &colors, "n x 3, 0 to 255, or None.")
      .def_readonly("name", &Surface::name)
      .def_readonly("warnings", &Surface::warnings, "What was mended or looks odd, one sentence each.")
      .def(
          "__iter__",
          [](const py::object& surface) {
            return py::iter(py::make_tuple(surface.attr("points"), surface.attr("triangles")));
          },
          "points, triangles = surface")
      .def("__repr__", [](const Surface& s) {
        return "<Surface " + s.name + ": " + std::to_string(s.mesh->points.rows()) + " points, " +
               std::to_string(s.mesh->triangles.rows()) + " triangles>";
      });
  module.def("read_surface", &readSurface, py::arg("path"), py::arg("part") = "",
             "Reads STL, OBJ, PLY, OFF, VTK, VTP, VTM, GLB or GLTF by its extension, as mm in LPS. A file of "
             "several organs needs the name of one of them (`part`); the error lists them.");
  module.def("write_surface", &writeSurface, py::arg("path"), py::arg("points"), py::arg("triangles"),
             py::arg("space") = "LPS", py::arg("name") = "",
             "Writes points (n x 3, mm, LPS) and triangles (m x 3) by extension: STL, OBJ, PLY, OFF, VTK, "
             "VTP, GLB.");
}

void addRepairs(py::module_& module) {
  module.def("repair_surface", &repairSurface, py::arg("points"), py::arg("triangles"), py::arg("repairs"),
             py::arg("progress") = py::none(),
             "Repairs a surface, in the order of `repairs`: ids as \"fill-holes\", \"remove-fragments=5mm\", "
             "\"remesh=1.5\", \"scale=0.1\". `warnings` of the result says when remeshing lost a detail.");
  module.def(
      "surface_repairs",
      [] {
        std::vector<std::string> ids;
        for (const medical_io::SurfaceRepair& repair : medical_io::surfaceRepairs())
          ids.push_back(repair.id);
        return ids;
      },
      "The repairs that there are.");
  module.def("life_size_factor", &medical_io::lifeSizeFactor, py::arg("name"), py::arg("volume_ml"),
             "The factor that gives an organ of that name its usual volume, or None.");
}

void addHandles(py::module_& module) {
  py::class_<medical_io::HandleFile>(module, "Handles", "A rig of handles from a file.")
      .def_property_readonly(
          "positions", [](const medical_io::HandleFile& file) { return handOver(file.positions()); },
          "h x 3, mm, LPS.")
      .def_property_readonly("labels", &medical_io::HandleFile::labels)
      .def_property_readonly("groups", &groupsOf, "Name and rows of each markup list.")
      .def_property_readonly("warnings",
                             [](const medical_io::HandleFile& file) { return inEnglish(file.warnings); });
  module.def("read_handles", &medical_io::readHandles, py::arg("path"),
             "Reads 3D Slicer's .mrk.json or .fcsv, as mm in LPS.");
  module.def("write_handles", &writeHandles, py::arg("path"), py::arg("positions"),
             py::arg("labels") = std::vector<std::string>(), py::arg("space") = "LPS",
             "Writes positions (h x 3, mm, LPS) as .mrk.json or .fcsv; unlabelled ones become H-1, H-2, ...");
}

void addLabelMaps(py::module_& module) {
  using medical_io::LabelMap;
  using medical_io::Segment;
  py::class_<Segment>(module, "Segment", "One organ of a label map.")
      .def_readonly("label", &Segment::label, "The value that its voxels have in the file.")
      .def_readonly("layer", &Segment::layer)
      .def_readonly("name", &Segment::name)
      .def_readonly("voxels", &Segment::voxels)
      .def("__repr__", [](const Segment& segment) { return "<Segment " + segment.name + ">"; });
  py::class_<LabelMap, std::shared_ptr<LabelMap>>(module, "LabelMap",
                                                  "An image whose voxels say which organ they belong to.")
      .def_readonly("size", &LabelMap::size, "Voxels along i, j and k.")
      .def_property_readonly("spacing", &LabelMap::spacing, "mm along i, j and k.")
      .def_property_readonly(
          "index_to_lps", [](const LabelMap& map) { return Eigen::Matrix4d(map.indexToLps.matrix()); },
          "4 x 4, from (i, j, k, 1) to mm in LPS.")
      .def_property_readonly(
          "layers", &layers,
          "Arrays k x j x i of uint16: 0 for none, s + 1 for segments[s]; no copies, read only.")
      .def_readonly("segments", &LabelMap::segments)
      .def_property_readonly("warnings", [](const LabelMap& map) { return inEnglish(map.warnings); })
      .def("volume_ml", &LabelMap::volumeMl, py::arg("segment"), "Of a segment's voxels.")
      .def("surfaces", &labelSurfaces, py::arg("names") = std::vector<std::string>(),
           py::arg("triangles") = 20'000, py::arg("smoothing") = 1.0, py::arg("largest_piece_only") = false,
           py::arg("progress") = py::none(),
           "Closed surfaces around segments (none named: all): name and Surface, whose volume is the voxels' "
           "to 1 %.");
  module.def("read_label_map", &readLabelMap, py::arg("path"), py::arg("progress") = py::none(),
             "Reads NIfTI, NRRD, MetaImage or DICOM-SEG.");
}

medical_io::CineStudy cine(const path& place, const py::object& listener) {
  return resultOfLong(listener,
                      [&](Progress& progress) { return medical_io::readCineStudy(place, progress); });
}

/// Maps (column, row, 0, 1) to mm; the third column is the slice's thickness along its normal.
Eigen::Matrix4d indexToLps(const medical_io::CineSlice& slice) {
  const medical_io::CineGeometry& place = slice.geometry;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.block<3, 1>(0, 0) = place.betweenColumns * place.row;
  matrix.block<3, 1>(0, 1) = place.betweenRows * place.column;
  matrix.block<3, 1>(0, 2) = (place.thickness > 0 ? place.thickness : 1) * place.normal();
  matrix.block<3, 1>(0, 3) = place.origin;
  return matrix;
}

py::array cineImage(const medical_io::CineSlice& slice, std::size_t phase) {
  if (phase >= slice.fractions.size())
    throw UsageError("there is no phase " + std::to_string(phase), "phase",
                     "there are " + std::to_string(slice.fractions.size()));
  return share<medical_io::CineImage>(unlocked([&] { return slice.image(phase); }));
}

py::array_t<float> cineImages(const medical_io::CineSlice& slice) {
  const std::size_t phases = slice.fractions.size();
  py::array_t<float> array(
      {py::ssize_t(phases), py::ssize_t(slice.geometry.rows), py::ssize_t(slice.geometry.columns)});
  float* out = array.mutable_data();
  unlocked([&] {
    for (std::size_t phase = 0; phase < phases; ++phase) {
      const auto image = slice.image(phase);
      out = std::copy_n(image->data(), image->size(), out);
    }
    return 0;
  });
  return array;
}

void addCine(py::module_& module) {
  using medical_io::CineSlice;
  using medical_io::CineStack;
  using medical_io::CineStudy;
  py::class_<CineSlice>(module, "CineSlice", "One plane through the heart, in many phases of its cycle.")
      .def_readonly("number", &CineSlice::number, "Of its series.")
      .def_readonly("series", &CineSlice::series, "UID of its series.")
      .def_readonly("description", &CineSlice::description)
      .def_property_readonly("plane", [](const CineSlice& slice) { return nameOf(slice.plane); })
      .def_readonly("fractions", &CineSlice::fractions, "Of each phase, the part of the cycle gone by.")
      .def_readonly("missing", &CineSlice::missing, "The same of phases that have no image.")
      .def_readonly("interval", &CineSlice::interval, "Of its cycle, s; 0: not known.")
      .def_property_readonly(
          "thickness", [](const CineSlice& slice) { return slice.geometry.thickness; }, "mm.")
      .def_property_readonly("index_to_lps", &indexToLps, "4 x 4, from (column, row, 0, 1) to mm in LPS.")
      .def_property_readonly("images", &cineImages, "phases x rows x columns, float32; decoded now.")
      .def("image", &cineImage, py::arg("phase"), "rows x columns, float32; no copy, read only.")
      .def("phase_at", &CineSlice::phaseAt, py::arg("fraction"), "The phase nearest to it.")
      .def("__repr__", [](const CineSlice& slice) {
        return "<CineSlice " + std::to_string(slice.number) + ": " + nameOf(slice.plane) + ">";
      });
  py::class_<CineStack>(module, "CineStack", "Parallel slices of one geometry.")
      .def_readonly("slices", &CineStack::slices, "Their places in `slices` of the study.")
      .def_readonly("distances", &CineStack::distances, "mm from each to the next.")
      .def_readonly("gaps", &CineStack::gaps, "mm between them that no slice covers.");
  py::class_<CineStudy>(module, "CineStudy", "The cine images of one study of one patient.")
      .def_readonly("date", &CineStudy::date)
      .def_readonly("modality", &CineStudy::modality)
      .def_readonly("slices", &CineStudy::slices)
      .def_readonly("stacks", &CineStudy::stacks)
      .def_property_readonly("findings", [](const CineStudy& study) { return inEnglish(study.findings); });
  module.def("cine", &cine, py::arg("path"), py::arg("progress") = py::none(),
             "Reads a folder with a cine study, or a file with volumes over time.");
}

} // namespace
} // namespace viscera::python

/// Files and sample organs: what takes VTK.
PYBIND11_MODULE(_files, module) {
  namespace py = pybind11;
  py::module_::import("viscera._core"); // defines the errors
  module.doc() = "Surfaces, handles, label maps and sample organs.";
  viscera::python::addSurface(module);
  viscera::python::addRepairs(module);
  viscera::python::addHandles(module);
  viscera::python::addLabelMaps(module);
  viscera::python::addCine(module);
  module.def(
      "sample_names",
      [] { return viscera::sample_organs::sampleNames(viscera::sample_organs::standardLibrary()); },
      "The organs that come with Viscera.");
  module.def(
      "sample_organ", &viscera::python::sampleOrgan, py::arg("name"), py::arg("resolution") = "medium",
      py::arg("progress") = py::none(),
      "A sample organ: name and Surface, the outer one first. Made once (seconds), then kept on disk.");
}

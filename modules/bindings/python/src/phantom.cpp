#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "long_jobs.h"
#include "parts.h"
#include "viscera/phantom/write_phantom.h"

namespace viscera::python {
namespace {

namespace py = pybind11;

constexpr double kMsOfSecond = 1000;

py::dict dictOf(const phantom::PhantomReport& report, const phantom::PhantomOptions& options) {
  py::list phases;
  for (const phantom::PhantomPhase& phase : report.phases) {
    py::dict one;
    one["time_ms"] = kMsOfSecond * phase.seconds;
    one["beat_fraction"] = phase.beatFraction;
    one["inspiration"] = phase.inspiration;
    one["volumes_ml"] = phase.volumesMl;
    phases.append(one);
  }
  py::dict found;
  found["phases"] = phases;
  found["files"] = report.files;
  if (options.motion.heartbeat)
    found["ejection_fraction"] = report.ejectionFraction;
  found["folded_ml"] = report.foldedMl;
  return found;
}

} // namespace

void addPhantom(py::module_& module) {
  module.def(
      "write_phantom",
      [](const std::filesystem::path& folder, const std::string& modality, bool heartbeat, bool breathing,
         double ejectionFraction, double rate, const std::string& spacing,
         const std::vector<std::string>& slices, const std::string& noise, double shiftSlices, int phases,
         double fields, bool overTime, const std::string& format, std::uint64_t seed, int threads,
         const py::object& listener) {
        phantom::PhantomOptions options;
        options.motion.heartbeat = heartbeat;
        options.motion.breathing = breathing;
        options.motion.ejectionFraction = ejectionFraction;
        options.motion.beatsPerMinute = rate;
        options.modality = phantom::modalityFrom(modality);
        options.spacing = phantom::spacingFrom(spacing);
        if (!slices.empty())
          options.slices = phantom::slicesFrom(slices);
        if (!noise.empty())
          phantom::setNoise(noise, options);
        options.shiftSlicesMm = shiftSlices;
        options.phases = phases;
        options.fieldSpacingMm = fields;
        options.overTime = overTime;
        options.format = format == "nifti" ? ".nii.gz" : '.' + format;
        options.seed = seed;
        const phantom::PhantomReport report = resultOfLong(listener, [&](Progress& progress) {
          return phantom::writePhantom(folder, options, sample_organs::standardLibrary(), progress,
                                       {threads});
        });
        return dictOf(report, options);
      },
      py::arg("folder"), py::arg("modality"), py::arg("heartbeat"), py::arg("breathing"),
      py::arg("ejection_fraction"), py::arg("rate"), py::arg("spacing"), py::arg("slices"), py::arg("noise"),
      py::arg("shift_slices"), py::arg("phases"), py::arg("fields"), py::arg("over_time"), py::arg("format"),
      py::arg("seed"), py::arg("threads"), py::arg("progress"), "What `viscera.phantom` calls.");
}

} // namespace viscera::python

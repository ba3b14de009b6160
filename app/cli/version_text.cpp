#include "cli/version_text.h"

#include <Eigen/Core>
#include <QtGlobal>
#include <curl/curlver.h>
#include <expat.h>
#include <lz4.h>
#include <lzma.h>
#include <nlohmann/json.hpp>
#include <openssl/opensslv.h>
#include <vtkVersion.h>

#include <CLI/CLI.hpp>

namespace viscera::app::cli {
namespace {

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

} // namespace

std::string versionText() {
  std::string text = "viscera " VISCERA_VERSION "\n";
  const auto add = [&text](const std::string& name, const std::string& version) {
    text += "  " + name + ' ' + version + '\n';
  };
  add("VTK", vtkVersion::GetVTKVersion());
  add("Qt", qVersion());
  add("Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
  add("DCMTK", VISCERA_DCMTK_VERSION);
  add("OpenJPEG", VISCERA_OPENJPEG_VERSION);
  add("Qhull", VISCERA_QHULL_VERSION);
  add("Boost", VISCERA_BOOST_VERSION " (headers only)");
  add("zlib", VISCERA_ZLIB_VERSION);
  add("bzip2", VISCERA_BZIP2_VERSION);
  add("LZ4", LZ4_VERSION_STRING);
  add("XZ", LZMA_VERSION_STRING);
  add("Expat", dotted(XML_MAJOR_VERSION, XML_MINOR_VERSION, XML_MICRO_VERSION));
  add("OpenSSL", OPENSSL_VERSION_STR);
  add("curl", LIBCURL_VERSION);
  add("Fontconfig", VISCERA_FONTCONFIG_VERSION);
  add("GLEW", VISCERA_GLEW_VERSION);
  add("nlohmann JSON",
      dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH));
  add("CLI11", CLI11_VERSION);
  add("OpenMP", VISCERA_OPENMP_VERSION);
  add("TetGen", VISCERA_TETGEN_VERSION " (in viscera_tetgen_worker, a program of its own)");
  return text + "  compiled by " VISCERA_COMPILER;
}

} // namespace viscera::app::cli

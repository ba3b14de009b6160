#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "beating_labels.h"
#include "build_paths.h"
#include "cli_test.h"
#include "dicom_slices.h"
#include "packed_bytes.h"
#include "phantom_scan.h"
#include "shapes.h"

namespace viscera::app::cli {
namespace {

constexpr int kNoWindow = 69;
constexpr int kNotFoundByShell = 127; ///< The shell's code for a command that it does not find.

/// One block of commands of a page: between ```sh and ```, as a reader copies it.
struct PageBlock {
  std::string page; ///< As seen from the project's top.
  int line = 0;
  std::string commands;
  std::string notRun; ///< The reason in the mark before the block; empty: it is run.

  std::string name() const { return page + ":" + std::to_string(line); }
};

std::string wholeFile(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// README.md and every page of docs.
std::vector<std::string> allPages() {
  std::vector<std::string> pages;
  for (const auto& entry : std::filesystem::directory_iterator(VISCERA_SOURCE_DIR "/docs"))
    if (entry.path().extension() == ".md")
      pages.push_back("docs/" + entry.path().filename().string());
  std::sort(pages.begin(), pages.end());
  pages.insert(pages.begin(), "README.md");
  return pages;
}

/// The blocks of a page in these languages ("sh|bash"; empty: those without one).
std::vector<PageBlock> blocksOf(const std::string& page, const std::string& languages) {
  const std::regex mark("<!-- not run: (.+) -->"), fence("```(" + languages + ")"), anyFence("```.*");
  std::vector<PageBlock> blocks;
  std::istringstream lines(wholeFile(std::filesystem::path(VISCERA_SOURCE_DIR) / page));
  std::string line, before;
  bool inside = false, kept = false;
  for (int number = 1; std::getline(lines, line); before = line, ++number) {
    if (std::regex_match(line, anyFence)) {
      inside = !inside;
      kept = inside && std::regex_match(line, fence);
      std::smatch why;
      if (kept)
        blocks.push_back({page, number, {}, std::regex_match(before, why, mark) ? why[1].str() : ""});
    } else if (kept) {
      blocks.back().commands += line + "\n";
    }
  }
  return blocks;
}

std::vector<PageBlock> shellBlocksOf(const std::string& page) {
  return blocksOf(page, "sh|bash");
}

std::vector<std::string> pagesToRun() {
  std::vector<std::string> pages;
  for (const std::string& page : allPages()) {
    const auto blocks = shellBlocksOf(page);
    if (std::any_of(blocks.begin(), blocks.end(), [](const auto& block) { return block.notRun.empty(); }))
      pages.push_back(page);
  }
  return pages;
}

/// The commands of a block, each on one line.
std::vector<std::string> commandsOf(const PageBlock& block) {
  std::vector<std::string> commands;
  std::istringstream lines(std::regex_replace(block.commands, std::regex("\\\\\n *"), ""));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line.front() != '#')
      commands.push_back(line);
  return commands;
}

std::string offFile(const geometry::TriangleMesh& mesh, double factor) {
  std::ostringstream out;
  out << "OFF\n" << mesh.points.rows() << ' ' << mesh.triangles.rows() << " 0\n";
  out << factor * mesh.points << '\n';
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i)
    out << "3 " << mesh.triangles.row(i) << '\n';
  return out.str();
}

std::string labelTable(const std::vector<std::string>& labels) {
  std::string xml = "<CaretExtension><VolumeInformation Index=\"0\"><LabelTable>";
  for (std::size_t i = 0; i < labels.size(); ++i)
    xml += "<Label Key=\"" + std::to_string(i + 1) + "\">" + labels[i] + "</Label>";
  return xml + "</LabelTable></VolumeInformation></CaretExtension>";
}

/// Runs the blocks of one page, in their order, in a folder that has the files which the page's reader has.
class PageBlocks : public CliTest, public testing::WithParamInterface<std::string> {
protected:
  void SetUp() override {
    CliTest::SetUp();
    const std::string folder = std::filesystem::path(VISCERA_PROGRAM).parent_path().string();
    const char* present = std::getenv("PATH");
    options_.environment["PATH"] = folder + ":" + (present ? present : "/usr/bin:/bin");
    for (const char* command : {"viscera sample liver -o liver.stl", "viscera sample heart -o patient.stl",
                                "viscera sample liver@low -o patient_liver.vtk"})
      ASSERT_EQ(shell(command).exitCode, kOk) << command;
    put("tumour.off", offFile(tests::sphere(2, 12), 1));
    ASSERT_EQ(shell("viscera convert tumour.off tumour.stl").exitCode, kOk);
    putPose();
    putOrgans();
    putScan();
    putCine();
  }

  test::ProcessResult shell(const std::string& command) const {
    return test::runProcess({"/bin/sh", "-c", "cd '" + folder_.string() + "' && " + command}, options_);
  }

  /// Whether a command opens the window, for which there is no display here.
  static bool opensWindow(const std::string& command) {
    std::istringstream words(command);
    std::string program, first;
    words >> program >> first;
    return program == "viscera" && first.find('.') != std::string::npos;
  }

private:
  /// What 3D Slicer saves after one handle of the liver was dragged.
  void putPose() const {
    ASSERT_EQ(shell("viscera handles liver.stl -o h.mrk.json --count 30").exitCode, kOk);
    json rig = json::parse(contents(path("h.mrk.json")));
    json& x = rig.at("markups").back().at("controlPoints").at(2).at("position").at(0);
    x = x.get<double>() + 12;
    put("pose.mrk.json", rig.dump());
    std::filesystem::remove(path("h.mrk.json"));
  }

  /// Label maps of an abdomen.
  void putOrgans() const {
    tests::LabelImage abdomen = tests::emptyLabels();
    abdomen.indexToLps.linear() *= 6;
    abdomen.fill({2, 2, 2}, {8, 9, 9}, 1);
    abdomen.fill({11, 2, 2}, {14, 9, 9}, 2);
    abdomen.fill({17, 2, 2}, {20, 9, 9}, 3);
    const std::string names = labelTable({"liver", "kidney_left", "kidney_right"});
    put("patient.nrrd", tests::nrrdFile(abdomen));
    put("total.nii.gz", tests::gzipped(tests::niftiFile(abdomen, tests::NiftiForm::sform, names)));
  }

  /// A CT as a file and as a DICOM folder, its label map, and the handles around both, at rest and moved.
  void putScan() const {
    tests::LabelImage ct = tests::orientedPhantomGrid(0, {0, 1, 2});
    tests::fillPhantom(ct);
    put("ct.nii.gz", tests::gzipped(tests::niftiFile(ct)));
    std::filesystem::create_directories(path("ct_folder"));
    for (int k = 0; k < ct.size[2]; ++k)
      put("ct_folder/" + std::to_string(k), tests::dicomBytes(tests::dicomSlice(ct, k)));
    ct.voxels.assign(ct.voxels.size(), 0);
    ct.fill({4, 4, 4}, {12, 12, 12}, 1);
    put("organs.seg.nrrd",
        tests::nrrdFile(ct, "right-anterior-superior",
                        "Segment0_ID:=S1\nSegment0_Name:=liver\nSegment0_LabelValue:=1\n"));
    auto handles = corners(40);
    put("rig.mrk.json", markups(handles));
    handles.front()[2] += 8;
    put("breathing.mrk.json", markups(handles));
  }

  /// Cine studies: a cavity as surfaces, a heart as labels, and one phase of it with named chambers.
  void putCine() const {
    constexpr int kPhases = 6;
    std::filesystem::create_directories(path("cine"));
    std::vector<tests::LabelImage> labels;
    for (int phase = 0; phase < kPhases; ++phase) {
      const double part = double(phase) / kPhases;
      put("cine/cavity_" + std::to_string(phase) + ".off",
          offFile(tests::sphere(3, 25), 0.9 + 0.1 * std::cos(2 * std::numbers::pi * part)));
      labels.push_back(tests::beatingLabels(part, Vec3(4, 4, 8)));
    }
    put("cine.nii.gz", tests::gzipped(tests::nifti4d(labels, 150, 16)));
    put("images.nii.gz", tests::gzipped(tests::nifti4d(labels, 150, 16))); // Their numbers as grey values.
    put("ed.nrrd", tests::nrrdFile(labels[0]));
    put("es.nrrd", tests::nrrdFile(labels[3]));
    put("heart.nii.gz",
        tests::gzipped(tests::niftiFile(
            tests::beatingLabels(0, Vec3(4, 4, 4)), tests::NiftiForm::sform,
            labelTable({"heart_ventricle_left", "heart_ventricle_right", "heart_myocardium"}))));
  }
};

} // namespace

TEST_P(PageBlocks, RunAsWritten) {
  for (const PageBlock& block : shellBlocksOf(GetParam()))
    for (const std::string& command : block.notRun.empty() ? commandsOf(block) : std::vector<std::string>{}) {
      const test::ProcessResult result = shell(command);
      EXPECT_NE(result.exitCode, kNotFoundByShell) << block.name() << ": " << command << "\n" << result.err;
      EXPECT_EQ(result.exitCode, opensWindow(command) ? kNoWindow : kOk)
          << block.name() << ": " << command << "\n"
          << result.err;
    }
}

INSTANTIATE_TEST_SUITE_P(All, PageBlocks, testing::ValuesIn(pagesToRun()), [](const auto& each) {
  std::string name = each.param.substr(each.param.find('/') + 1);
  name.resize(name.find('.'));
  return name;
});

/// The developer guide counts the blocks that no test runs, so that none is marked in passing.
TEST(PageBlocksAreMarked, AndCounted) {
  std::size_t all = 0, notRun = 0;
  for (const std::string& page : allPages())
    for (const PageBlock& block : blocksOf(page, "sh|bash|python")) {
      ++all;
      notRun += block.notRun.empty() ? 0 : 1;
    }
  EXPECT_GT(all, 20U);
  const std::string said = "Of the " + std::to_string(all) + " blocks of shell and Python on these pages " +
                           std::to_string(notRun) + " are marked";
  EXPECT_NE(wholeFile(VISCERA_SOURCE_DIR "/docs/developer_guide.md").find(said), std::string::npos)
      << "docs/developer_guide.md should say: " << said;
}

TEST(PageBlocksAreMarked, NoCommandStandsInABlockWithoutALanguage) {
  for (const std::string& page : allPages())
    for (const PageBlock& block : blocksOf(page, ""))
      for (const std::string& command : commandsOf(block))
        for (const char* program : {"viscera ", "cmake ", "./", "python3 "})
          EXPECT_FALSE(command.starts_with(program)) << block.name() << ": " << command;
}

} // namespace viscera::app::cli

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cine_pictures.h"
#include "packed_dicom.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/live/cine_motion.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::live {
namespace {

using tests::CinePicture;
using tests::DicomElements;
using Chance = std::mt19937;

constexpr int kSeries = 4, kStudyPhases = 6;
const Vec3 kBallMiddle(-9, 18, 39); ///< The middle of what is labelled.

std::size_t anyUpTo(Chance& chance, std::size_t last) {
  return std::uniform_int_distribution<std::size_t>(0, last)(chance);
}

/// Three slices 5 mm apart and a long-axis plane, all through the labelled ball.
CinePicture pictureOf(int series, int phase) {
  CinePicture picture = series < kSeries ? tests::shortAxisPicture(series, 0, 780.0 + 10 * series)
                                         : tests::longAxisPicture(4, 60, 850);
  picture.description = "cine_" + std::to_string(series);
  picture.spacing = 3;
  picture.thickness = 4;
  picture.phases = kStudyPhases;
  picture.phase = phase;
  picture.corner = kBallMiddle - 3 * (3.5 * picture.row + 2.5 * picture.column);
  if (series < kSeries)
    picture.corner += 5.0 * (series - 2) * picture.row.cross(picture.column);
  return picture;
}

/// The files of a study, of which some are changed.
class StudyFiles {
public:
  StudyFiles() {
    for (int series = 1; series <= kSeries; ++series)
      for (int phase = 0; phase < kStudyPhases; ++phase)
        files[nameOf(series, phase)] = tests::dicomBytes(tests::cineElements(pictureOf(series, phase)));
  }
  static std::string nameOf(int series, int phase) { return tests::cineFileName(pictureOf(series, phase)); }
  /// Writes other elements.
  void change(int series, int phase, const std::function<void(DicomElements&)>& how) {
    DicomElements elements = tests::cineElements(pictureOf(series, phase));
    how(elements);
    files[nameOf(series, phase)] = tests::dicomBytes(elements);
  }
  void changeAll(int series, const std::function<void(DicomElements&)>& how) {
    for (int phase = 0; phase < kStudyPhases; ++phase)
      change(series, phase, how);
  }
  std::map<std::string, std::string> files;
};

/// What is done to one of the first two series.
struct StudyDamage {
  std::function<void(StudyFiles&, int series, int phase, Chance&)> act;
  /// Whether the study is refused as a whole; bytes that chance has changed may say anything.
  enum class Answer { read, refused, either } answer = Answer::read;
  bool truthful = true;               ///< Whether what is left of the series has to be what was written.
  std::vector<std::string> says = {}; ///< Parts of findings.
};

StudyDamage bytesOfOne(const std::function<void(std::string&, Chance&)>& how,
                       StudyDamage::Answer answer = StudyDamage::Answer::read) {
  return {[how](StudyFiles& study, int series, int phase, Chance& chance) {
            how(study.files[StudyFiles::nameOf(series, phase)], chance);
          },
          answer, answer == StudyDamage::Answer::read};
}

StudyDamage elementOfOne(std::uint32_t tag, const std::string& value = {}) {
  return {[tag, value](StudyFiles& study, int series, int phase, Chance&) {
    study.change(series, phase, [&](DicomElements& list) {
      list.erase(tag);
      if (!value.empty())
        list[tag] = value;
    });
  }};
}

StudyDamage elementOfSeries(std::uint32_t tag, const std::string& value = {}) {
  return {[tag, value](StudyFiles& study, int series, int, Chance&) {
    study.changeAll(series, [&](DicomElements& list) {
      list.erase(tag);
      if (!value.empty())
        list[tag] = value;
    });
  }};
}

/// Pixels packed as a scanner packs them, with bytes or whole fragments lost.
StudyDamage packed(const std::string& packing, bool wholeFragment) {
  return {[packing, wholeFragment](StudyFiles& study, int series, int phase, Chance& chance) {
    std::string& bytes = study.files[StudyFiles::nameOf(series, phase)];
    bytes = tests::packedDicom(bytes, packing);
    const std::size_t pixels = bytes.find(std::string("\xE0\x7F\x10\x00", 4));
    bytes.resize(wholeFragment ? pixels + 20 : bytes.size() - 12 - anyUpTo(chance, 20));
  }};
}

StudyDamage saying(StudyDamage damage, std::vector<std::string> words) {
  damage.says = std::move(words);
  return damage;
}

std::vector<StudyDamage> fileDamages() {
  using Answer = StudyDamage::Answer;
  return {
      bytesOfOne([](std::string& bytes, Chance& chance) { bytes.resize(anyUpTo(chance, bytes.size() - 1)); }),
      saying(bytesOfOne([](std::string& bytes, Chance& chance) {
               bytes.resize(bytes.size() - 1 - anyUpTo(chance, 90));
             }),
             {"is damaged and left out"}),
      bytesOfOne([](std::string& bytes, Chance&) { bytes.clear(); }),
      bytesOfOne([](std::string& bytes, Chance&) { bytes = "This was a picture.\n"; }),
      bytesOfOne(
          [](std::string& bytes, Chance& chance) {
            for (int i = 0; i < 20; ++i)
              bytes[132 + anyUpTo(chance, bytes.size() - 133)] = char(anyUpTo(chance, 255));
          },
          Answer::either),
      bytesOfOne([](std::string& bytes, Chance& chance) { bytes.erase(132 + anyUpTo(chance, 500), 7); },
                 Answer::either),
      packed("rle", true),
      packed("rle", false),
      packed("jpeg-lossless", true),
      packed("jpeg-lossless", false),
      {[](StudyFiles& study, int series, int phase, Chance&) {
        study.files.erase(StudyFiles::nameOf(series, phase));
      }},
      {[](StudyFiles& study, int, int, Chance& chance) {
        study.files["notes.txt"] = "Breath-holds were short.\n";
        study.files["DICOMDIR"] = std::string(128, '\0') + "DICM" + std::string(anyUpTo(chance, 300), 'x');
        study.files["picture.png"] = "\x89PNG\r\n\x1a\n";
      }},
      {[](StudyFiles& study, int series, int, Chance& chance) {
        for (int phase = 0; phase < kStudyPhases; ++phase) {
          std::string& bytes = study.files[StudyFiles::nameOf(series, phase)];
          bytes.resize(bytes.size() - 1 - anyUpTo(chance, 90));
        }
      }},
  };
}

std::vector<StudyDamage> tagDamages() {
  return {
      saying(elementOfOne(0x00200032), {"does not say where in the patient it lies"}),
      saying(elementOfSeries(0x00200032), {"does not say where in the patient it lies"}),
      elementOfOne(0x00200032, "DS400\\0\\0"),
      elementOfOne(0x00200032, "DSnan\\0\\0"),
      elementOfSeries(0x00200032, "DS1e999\\0\\0"),
      elementOfOne(0x00200037),
      elementOfOne(0x00200037, "DS1\\0\\0\\1\\0\\0"),
      elementOfSeries(0x00200037),
      elementOfOne(0x00181060),
      elementOfSeries(0x00181060),
      elementOfOne(0x00280030),
      saying(elementOfSeries(0x00280030), {"does not say how large its pixels are"}),
      elementOfOne(0x00280030, "DS9\\9"),
      elementOfSeries(0x00280030, "DS0\\3"),
      elementOfOne(0x00200011),
      elementOfSeries(0x00200011),
      elementOfOne(0x0020000E),
      elementOfOne(0x00280010, tests::us(60)),
      elementOfSeries(0x00280010, tests::us(0)),
      elementOfOne(0x00280011),
      elementOfOne(0x7FE00010),
      saying(elementOfSeries(0x7FE00010), {"has no pixels"}),
      elementOfOne(0x7FE00010, "OW"),
      elementOfOne(0x00280100, tests::us(12)),
      saying(elementOfSeries(0x00181090, "IS12"), {"states 12 phases and has 6"}),
      saying(elementOfSeries(0x00181090, "IS3"), {"states 3 phases and has 6"}),
      elementOfSeries(0x00181090),
      elementOfSeries(0x00181062),
      saying(elementOfSeries(0x00181062, "IS200"), {"states a cycle of 200 ms"}),
  };
}

std::vector<StudyDamage> mixtures() {
  using Answer = StudyDamage::Answer;
  const auto stranger = [](const std::function<void(CinePicture&)>& how) {
    return [how](StudyFiles& study, int series, int, Chance&) {
      for (int phase = 0; phase < kStudyPhases; ++phase) {
        CinePicture other = pictureOf(series, phase);
        other.series = 9;
        how(other);
        study.files["other" + std::to_string(phase)] = tests::dicomBytes(tests::cineElements(other));
      }
    };
  };
  StudyDamage patients{stranger([](CinePicture& other) { other.patient = "P2"; }), Answer::refused};
  StudyDamage onePatient = elementOfOne(0x00100020, "LOP2");
  onePatient.answer = Answer::refused;
  return {
      patients,
      onePatient,
      {stranger([](CinePicture& other) { other.study = "1.2.9"; }),
       Answer::read,
       true,
       {"another study", "9"}},
      {stranger([](CinePicture& other) { other.frame = "1.2.9"; }),
       Answer::read,
       true,
       {"in another frame of reference", "9"}},
      {[](StudyFiles& study, int series, int phase, Chance&) {
         CinePicture still = pictureOf(series, phase);
         still.series = 9;
         still.phase = 0;
         still.phases = 1;
         study.files["still.dcm"] = tests::dicomBytes(tests::cineElements(still));
       },
       Answer::read,
       true,
       {"1 series without the phases of a heart's cycle left out: 9"}},
      saying(elementOfSeries(0x00200052, "UI1.2.3.99"), {"in another frame of reference"}),
      saying(elementOfSeries(0x0020000D, "UI1.2.9"), {"another study"}),
      {[](StudyFiles& study, int series, int phase, Chance&) {
         study.files["copy.dcm"] = study.files[StudyFiles::nameOf(series, phase)];
       },
       Answer::read,
       true,
       {"1 file is a copy of another one"}},
      {[](StudyFiles& study, int series, int phase, Chance&) {
         CinePicture again = pictureOf(series, phase);
         DicomElements elements = tests::cineElements(again);
         elements[0x00080018] += "7";
         study.files["again.dcm"] = tests::dicomBytes(elements);
       },
       Answer::read,
       true,
       {"has the time of another one"}},
  };
}

/// A study that was changed and read again.
class DamagedStudies : public testing::Test {
protected:
  DamagedStudies() {
    std::filesystem::create_directories(images());
    for (const auto& [name, bytes] : whole_.files)
      folder_.put("images/" + name, bytes);
    geometry::TriangleMesh ball = tests::sphere(2, 7);
    for (const int phase : {0, 3}) {
      geometry::TriangleMesh moved = ball;
      moved.points = (ball.points * (phase == 0 ? 1 : 0.8)).rowwise() + kBallMiddle.transpose();
      labels_.push_back({std::size_t(phase), {folder_ / ("LV_" + std::to_string(phase) + ".obj")}});
      medical_io::writeSurface(labels_.back().files[0], moved, {});
    }
  }

  void tryAll(const std::vector<StudyDamage>& kinds, unsigned first, unsigned last) {
    for (unsigned seed = first; seed < last; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", kind " + std::to_string(seed % kinds.size()));
      const StudyDamage& kind = kinds[seed % kinds.size()];
      Chance chance(seed);
      const int series = 1 + int(anyUpTo(chance, 1)), phase = int(anyUpTo(chance, kStudyPhases - 1));
      StudyFiles study;
      kind.act(study, series, phase, chance);
      replace(whole_.files, study.files);
      tryOne(kind, series);
      replace(study.files, whole_.files);
      if (HasFatalFailure())
        return;
    }
  }

private:
  std::filesystem::path images() const { return folder_ / "images"; }
  void replace(const std::map<std::string, std::string>& before,
               const std::map<std::string, std::string>& after) const {
    for (const auto& [name, bytes] : before)
      if (!after.contains(name))
        std::filesystem::remove(images() / name);
    for (const auto& [name, bytes] : after)
      if (!before.contains(name) || before.at(name) != bytes)
        folder_.put("images/" + name, bytes);
  }

  void tryOne(const StudyDamage& kind, int series) {
    using Answer = StudyDamage::Answer;
    try {
      Progress progress;
      const medical_io::CineStudy study = medical_io::readCineStudy(images(), progress);
      EXPECT_NE(kind.answer, Answer::refused);
      std::string said;
      for (const Text& finding : study.findings)
        said += finding.english() + '\n';
      for (const std::string& words : kind.says)
        EXPECT_NE(said.find(words), std::string::npos) << words << " in\n" << said;
      for (int each = 1; each <= kSeries; ++each)
        expectTrue(study, each, each == series && !kind.truthful, each == series, said);
      CineRequest request;
      request.labels = labels_;
      expectJoined(joinStudy(study, request, progress), series, kind.truthful);
    } catch (const Error& error) {
      EXPECT_NE(kind.answer, Answer::read) << error.what();
      EXPECT_NE(error.problem().english(), "");
    }
  }

  static bool isNamed(const std::string& said, int series) {
    const std::string number = std::to_string(series);
    for (std::size_t at = said.find("eries"); at != std::string::npos; at = said.find("eries", at + 1)) {
      const std::size_t end = std::min(said.find('\n', at), said.find(" is missing", at));
      for (std::size_t i = at + 5; i < end; ++i)
        if (said[i] == number[0] && std::isdigit(static_cast<unsigned char>(said[i - 1])) == 0 &&
            std::isdigit(static_cast<unsigned char>(said[i + 1])) == 0)
          return true;
    }
    return false;
  }

  /// What is read of a series is what was written, at its place and in its phase; what is not is said.
  static void expectTrue(const medical_io::CineStudy& study, int series, bool anything, bool changed,
                         const std::string& said) {
    const CinePicture written = pictureOf(series, 0);
    std::set<int> there;
    int slices = 0;
    for (const medical_io::CineSlice& slice : study.slices) {
      if (slice.series != "1.2.3." + std::to_string(series))
        continue;
      ++slices;
      EXPECT_TRUE(changed || slice.fractions.size() == std::size_t{kStudyPhases}) << series;
      if (anything)
        continue;
      EXPECT_LT((slice.geometry.origin - written.corner).norm(), 1e-6);
      EXPECT_LT((slice.geometry.row - written.row).norm(), 1e-6);
      EXPECT_LT((slice.geometry.column - written.column).norm(), 1e-6);
      EXPECT_EQ(slice.geometry.betweenRows, written.spacing);
      for (std::size_t i = 0; i < slice.fractions.size(); ++i) {
        const int phase = int(std::lround(slice.fractions[i] * kStudyPhases));
        EXPECT_NEAR(slice.fractions[i] * kStudyPhases, phase, 0.01);
        EXPECT_EQ((*slice.image(i))(3, 2), float(pictureOf(series, phase).value(2, 3)));
        there.insert(phase);
      }
      for (int phase = 0; phase < kStudyPhases; ++phase)
        EXPECT_TRUE(
            there.contains(phase) ||
            std::any_of(slice.missing.begin(), slice.missing.end(),
                        [&](double fraction) { return std::abs(fraction * kStudyPhases - phase) < 0.1; }))
            << "phase " << phase << " of series " << series;
    }
    EXPECT_TRUE(changed || slices == 1) << "series " << series << '\n' << said;
    const bool named = isNamed(said, series) ||
                       said.find("\"" + StudyFiles::nameOf(series, 0)) != std::string::npos ||
                       said.find("cine_" + std::to_string(series)) != std::string::npos;
    EXPECT_TRUE(anything || named || there.size() == std::size_t{kStudyPhases})
        << "series " << series << " has " << there.size() << " phases, and it says\n"
        << said;
  }

  static void expectJoined(const LabelledStudy& joined, int series, bool truthful) {
    EXPECT_TRUE(joined.times.count() == std::size_t{kStudyPhases} || !truthful);
    EXPECT_NO_THROW(tracking::requireValid(joined.planes));
    ASSERT_EQ(joined.planes.size(), joined.sources.size());
    int untouched = 0;
    for (std::size_t plane = 0; plane < joined.planes.size(); ++plane)
      if (const int number = joined.sources[plane].series;
          number != series && number >= 1 && number <= kSeries) {
        ++untouched;
        EXPECT_EQ(joined.planes[plane].images.size(), std::size_t{kStudyPhases});
      }
    EXPECT_TRUE(untouched == kSeries - 1 || !truthful);
  }

  tests::TemporaryFolder folder_;
  StudyFiles whole_;
  std::vector<PhaseLabels> labels_;
};

// Together 300 studies.
TEST_F(DamagedStudies, OfFilesThatAreDamagedSayWhatIsMissing) {
  tryAll(fileDamages(), 0, 130);
}

TEST_F(DamagedStudies, OfHeadersThatAreDamagedSayWhatIsMissing) {
  tryAll(tagDamages(), 0, 116);
}

TEST_F(DamagedStudies, OfMixedImagesSayWhatIsLeftOut) {
  tryAll(mixtures(), 0, 54);
}

TEST_F(DamagedStudies, WholeOnesHaveNothingToSay) {
  tryAll({{[](StudyFiles&, int, int, Chance&) {}}}, 0, 1);
}

} // namespace
} // namespace viscera::live

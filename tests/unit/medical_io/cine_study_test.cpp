#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beating_labels.h"
#include "build_paths.h"
#include "cine_pictures.h"
#include "packed_dicom.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/cine_study.h"

namespace viscera::medical_io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using tests::CinePicture;
using tests::DicomElements;
using ChangeOfPicture = std::function<void(DicomElements&, const CinePicture&)>;

class CineStudies : public testing::Test {
protected:
  void write(CinePicture picture, const ChangeOfPicture& change = {}) {
    for (picture.phase = 0; picture.phase < picture.phases; ++picture.phase) {
      DicomElements elements = tests::cineElements(picture);
      if (change)
        change(elements, picture);
      folder_.put(tests::cineFileName(picture), tests::dicomBytes(elements));
    }
  }
  /// Three breath-holds of the short axis, 17.7 mm apart, and planes with four and two chambers.
  void writeHeart() {
    write(tests::shortAxisPicture(1, 0, 860));
    write(tests::shortAxisPicture(2, 17.7, 829));
    write(tests::shortAxisPicture(3, 35.4, 776));
    write(tests::longAxisPicture(6, 122, 876));
    write(tests::longAxisPicture(8, 3, 975));
  }
  CineStudy read(const CineOptions& options = {}) {
    return readCineStudy(folder_.path(), progress_, options);
  }
  static std::string sentences(const CineStudy& study) {
    std::string all;
    for (const Text& finding : study.findings)
      all += finding.english() + '\n';
    return all;
  }
  std::string nameOfPhase(CinePicture picture, int phase) const {
    picture.phase = phase;
    return tests::cineFileName(picture);
  }
  static std::vector<double> rounded(std::vector<double> values) {
    for (double& value : values)
      value = std::round(1e6 * value) / 1e6;
    return values;
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

TEST_F(CineStudies, StackTheShortAxisOverBreathHoldsWithTheirGaps) {
  writeHeart();
  const CineStudy study = read();
  EXPECT_EQ(study.patientName, "Doe, Jane");
  EXPECT_EQ(study.patientId, "P1");
  EXPECT_EQ(study.date, "20240301");
  EXPECT_EQ(study.modality, "MR");
  ASSERT_EQ(study.slices.size(), 5U);
  EXPECT_EQ(study.slices[1].number, 2);
  EXPECT_EQ(study.slices[1].series, "1.2.3.2");
  EXPECT_EQ(study.slices[1].date, "20240301");
  ASSERT_EQ(study.stacks.size(), 1U);
  const CineStack& stack = study.stacks[0];
  EXPECT_THAT(stack.slices, ElementsAre(0U, 1U, 2U));
  ASSERT_EQ(stack.distances.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(stack.distances[i], 17.7, 1e-6);
    EXPECT_NEAR(stack.gaps[i], 11.7, 1e-6);
  }
  EXPECT_EQ(sentences(study), "The 3 slices of a stack (short axis) have gaps of 11.7 mm between them, "
                              "in which nothing was seen\n");
}

TEST_F(CineStudies, HaveHeightAndWeightWhereTheFilesStateThoseOfAPerson) {
  const auto sized = [](const char* height, const char* weight) {
    return [height, weight](DicomElements& elements, const CinePicture&) {
      elements[0x00101020] = std::string("DS") + height;
      elements[0x00101030] = std::string("DS") + weight;
    };
  };
  write(tests::shortAxisPicture(1, 0, 860), sized("0", "0"));
  write(tests::shortAxisPicture(2, 17.7, 829), sized("1.78", "76.5"));
  EXPECT_DOUBLE_EQ(read().heightCm, 178);
  EXPECT_DOUBLE_EQ(read().weightKg, 76.5);
  write(tests::shortAxisPicture(1, 0, 860), sized("165", "60"));
  EXPECT_DOUBLE_EQ(read().heightCm, 165) << "a scanner that writes cm";
  write(tests::shortAxisPicture(1, 0, 860), sized("17.8", "0"));
  write(tests::shortAxisPicture(2, 17.7, 829));
  EXPECT_EQ(read().heightCm, 0) << "no person";
  EXPECT_EQ(read().weightKg, 0);
}

TEST_F(CineStudies, NamePlanesByTheirDirectionAroundTheAxis) {
  writeHeart();
  write(tests::longAxisPicture(9, 60, 900));
  write(tests::longAxisPicture(10, 90, 900));
  CinePicture named = tests::longAxisPicture(11, 91, 900);
  named.description = "CINE 3 CH";
  write(named);
  std::vector<std::string> planes;
  for (const CineSlice& slice : read().slices)
    planes.push_back(nameOf(slice.plane));
  EXPECT_THAT(planes, ElementsAre("short axis", "short axis", "short axis", "4-chamber", "2-chamber",
                                  "3-chamber", "long axis", "3-chamber"));
}

TEST_F(CineStudies, AreMatchedByFractionAndNotByTime) {
  writeHeart();
  const CineStudy study = read();
  for (const CineSlice& slice : study.slices) {
    ASSERT_EQ(slice.fractions.size(), 12U);
    EXPECT_TRUE(slice.missing.empty());
    for (std::size_t phase = 0; phase < 12; ++phase)
      EXPECT_NEAR(slice.fractions[phase], double(phase) / 12, 1e-9);
    EXPECT_EQ(slice.phaseAt(0.35), 4U);
    EXPECT_EQ(slice.phaseAt(0.98), 0U) << "around the end of the cycle";
  }
  EXPECT_NEAR(study.slices[0].interval, 0.860, 1e-12);
  EXPECT_NEAR(study.slices[4].interval, 0.975, 1e-12);
}

TEST_F(CineStudies, HavePicturesAndPixelsAtTheirPlaces) {
  writeHeart();
  const CineStudy study = read();
  const CineSlice& slice = study.slices[2];
  CinePicture written = tests::shortAxisPicture(3, 35.4, 776);
  written.phase = 7;
  const auto image = slice.image(7);
  ASSERT_EQ(image->rows(), 6);
  ASSERT_EQ(image->cols(), 8);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 8; ++i)
      EXPECT_EQ((*image)(j, i), float(written.value(i, j)));
  const Vec3 place = written.corner + 2.0 * 5 * written.row + 2.0 * 3 * written.column;
  EXPECT_LT((slice.geometry.at(5, 3) - place).norm(), 1e-6);
  EXPECT_LT((slice.geometry.pixelOf(place + 4 * slice.geometry.normal()) - Eigen::Vector2d(5, 3)).norm(),
            1e-6);
}

TEST_F(CineStudies, StackSlicesOfOneSeries) {
  for (int k = 0; k < 4; ++k) {
    CinePicture picture = tests::shortAxisPicture(1, 6.0 * k, 900);
    picture.slice = k;
    write(picture);
  }
  const CineStudy study = read();
  ASSERT_EQ(study.slices.size(), 4U);
  ASSERT_EQ(study.stacks.size(), 1U);
  EXPECT_THAT(study.stacks[0].gaps, ElementsAre(0, 0, 0)) << "they touch";
  EXPECT_EQ(sentences(study), "");
}

TEST_F(CineStudies, LeaveOutATruncatedFileAndNameItsPhase) {
  writeHeart();
  const std::string name = nameOfPhase(tests::shortAxisPicture(2, 17.7, 829), 4);
  const std::string bytes = tests::contentsOf(folder_ / name);
  folder_.put(name, bytes.substr(0, bytes.size() - 20));
  const CineStudy study = read();
  ASSERT_EQ(study.slices.size(), 5U);
  EXPECT_EQ(study.slices[1].fractions.size(), 11U);
  EXPECT_THAT(rounded(study.slices[1].missing), ElementsAre(0.333333));
  EXPECT_EQ(study.slices[1].phasesInCycle(), 12U);
  EXPECT_EQ((*study.slices[1].image(4))(0, 0), 5200) << "of the next phase, not of one that is made up";
  EXPECT_THAT(sentences(study), HasSubstr("1 phase of series 2 is missing: 4 of 12 (the first is 0)"));
  EXPECT_THAT(sentences(study), HasSubstr("\"" + name + "\" is damaged and left out, phase 4 of series 2 ("));
  EXPECT_EQ(study.stacks.size(), 1U);
}

TEST_F(CineStudies, NamePhasesWhoseFilesAreGone) {
  writeHeart();
  const CinePicture picture = tests::longAxisPicture(6, 122, 876);
  for (const int phase : {0, 5, 6, 11})
    std::filesystem::remove(folder_ / nameOfPhase(picture, phase));
  const CineStudy study = read();
  ASSERT_EQ(study.slices.size(), 5U);
  EXPECT_THAT(rounded(study.slices[3].missing), ElementsAre(0, 0.416667, 0.5, 0.916667));
  EXPECT_THAT(sentences(study), HasSubstr("4 phases of series 6 are missing: 0, 5, 6, 11 of 12"));
}

TEST_F(CineStudies, TakeThePlaceInTheCycleFromWhateverStatesIt) {
  const auto fractionsWith = [&](const ChangeOfPicture& change) {
    write(tests::shortAxisPicture(1, 0, 900), change);
    const CineStudy study = read();
    EXPECT_EQ(study.slices.size(), 1U);
    return study.slices[0].fractions;
  };
  const auto expectEven = [](const std::vector<double>& fractions) {
    ASSERT_EQ(fractions.size(), 12U);
    for (std::size_t phase = 0; phase < 12; ++phase)
      EXPECT_NEAR(fractions[phase], double(phase) / 12, 1e-3);
  };
  expectEven(fractionsWith([](DicomElements& elements, const CinePicture& picture) {
    elements.erase(0x00181060);
    elements[0x00209241] = "FD" + std::string(8, '\0');
    const double percent = 100.0 * picture.phase / picture.phases;
    std::memcpy(elements[0x00209241].data() + 2, &percent, sizeof percent);
  }));
  expectEven(fractionsWith([](DicomElements& elements, const CinePicture& picture) {
    elements.erase(0x00181060);
    elements[0x00200100] = "IS" + std::to_string(picture.phase + 1); // Temporal position.
  }));
  expectEven(fractionsWith([](DicomElements& elements, const CinePicture&) { elements.erase(0x00181060); }));
  expectEven(fractionsWith([](DicomElements& elements, const CinePicture&) { elements.erase(0x00181062); }));
}

TEST_F(CineStudies, DoNotBelieveAnIntervalShorterThanThePhases) {
  write(tests::shortAxisPicture(1, 0, 900),
        [](DicomElements& elements, const CinePicture&) { elements[0x00181062] = "IS300"; });
  const CineStudy study = read();
  EXPECT_NEAR(study.slices[0].interval, 0.9, 1e-6);
  EXPECT_NEAR(study.slices[0].fractions.back(), 11.0 / 12, 1e-6);
  EXPECT_THAT(sentences(study), HasSubstr("Series 1 states a cycle of 300 ms"));
}

TEST_F(CineStudies, AreNotMadeFromImagesOfOneInstant) {
  CinePicture still = tests::shortAxisPicture(1, 0, 900);
  still.phases = 1;
  write(still);
  write(tests::shortAxisPicture(2, 0, 900), [](DicomElements& elements, const CinePicture& picture) {
    elements[0x00181060] = "DS" + tests::decimal(650 + picture.phase); // A map of relaxation times.
    elements.erase(0x00181090);
  });
  EXPECT_FALSE(findCineStudy(folder_.path(), progress_).has_value());
  EXPECT_THROW(read(), DataError);
  write(tests::shortAxisPicture(3, 10, 900));
  const CineStudy study = read();
  ASSERT_EQ(study.slices.size(), 1U);
  EXPECT_EQ(study.slices[0].number, 3);
  EXPECT_THAT(sentences(study), HasSubstr("2 series without the phases of a heart's cycle left out: 1, 2"));
}

TEST_F(CineStudies, AreOfOnePatient) {
  writeHeart();
  CinePicture other = tests::longAxisPicture(9, 60, 900);
  other.patient = "P2";
  write(other);
  try {
    read();
    FAIL() << "two patients in one study";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("It has the images of 2 patients"));
    EXPECT_THAT(error.what(), HasSubstr("_9_0_"));
    EXPECT_THAT(error.what(), Not(HasSubstr("P2"))) << "who it is stays in the files";
  }
}

TEST_F(CineStudies, AreOfOneStudyAndOneFrameOfReference) {
  writeHeart();
  CinePicture moved = tests::longAxisPicture(9, 60, 900), earlier = tests::shortAxisPicture(12, 0, 900);
  moved.frame = "1.2.3.78";
  earlier.study = "1.2.2";
  write(moved);
  write(earlier);
  const CineStudy study = read();
  EXPECT_EQ(study.slices.size(), 5U);
  EXPECT_EQ(study.studyUid, "1.2.3");
  EXPECT_THAT(sentences(study), HasSubstr("1 slice of another study left out (series 12)"));
  EXPECT_THAT(sentences(study), HasSubstr("in another frame of reference left out (series 9)"));
}

TEST_F(CineStudies, TakeTheLaterOfTwoBreathHoldsAtOnePlace) {
  writeHeart();
  write(tests::shortAxisPicture(4, 17.7, 900));
  const CineStudy study = read();
  EXPECT_EQ(study.slices.size(), 6U);
  ASSERT_EQ(study.stacks.size(), 1U);
  EXPECT_THAT(study.stacks[0].slices, ElementsAre(0U, 3U, 2U));
  EXPECT_THAT(sentences(study), HasSubstr("Series 4 shows the same place as series 2"));
}

TEST_F(CineStudies, SayWhereASliceOfAStackMayBeMissing) {
  for (const int k : {0, 1, 2, 4, 5})
    write(tests::shortAxisPicture(k + 1, 8.0 * k, 900));
  EXPECT_THAT(sentences(read()), HasSubstr("Series 3 and 5 are 16 mm apart, other slices of the stack 8 mm"));
}

TEST_F(CineStudies, LeaveOutCopies) {
  writeHeart();
  std::filesystem::create_directories(folder_ / "copy");
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    if (entry.is_regular_file())
      std::filesystem::copy(entry.path(), folder_ / "copy" / entry.path().filename());
  EXPECT_EQ(read().slices.size(), 5U);
  EXPECT_EQ(read().slices[0].fractions.size(), 12U);
}

TEST_F(CineStudies, KeepDecodedPicturesWithinTheirBytes) {
  writeHeart();
  const CineStudy study = read();
  EXPECT_EQ(study.slices[0].image(0), study.slices[0].image(0)) << "decoded once";
  CineOptions few;
  few.keptBytes = 2 * 8 * 6 * sizeof(float);
  const CineStudy small = read(few);
  const auto first = small.slices[0].image(0);
  small.slices[1].image(0);
  EXPECT_EQ(small.slices[0].image(0), first) << "the two used last are kept";
  small.slices[2].image(0);
  small.slices[3].image(0);
  EXPECT_NE(small.slices[0].image(0), first);
  EXPECT_EQ(*small.slices[0].image(0), *first);
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    std::filesystem::remove(entry.path());
  EXPECT_THROW(small.slices[4].image(3), Error) << "its file is gone";
}

TEST_F(CineStudies, FindDamageInPackedPictures) {
  write(tests::shortAxisPicture(1, 0, 900));
  CinePicture picture = tests::shortAxisPicture(2, 10, 900);
  for (picture.phase = 0; picture.phase < 12; ++picture.phase) {
    std::string bytes = tests::packedDicom(tests::dicomBytes(tests::cineElements(picture)), "jpeg-lossless");
    if (picture.phase == 3) { // The frame header of its stream is lost.
      const std::size_t stream = bytes.rfind("\xFF\xD8");
      ASSERT_NE(stream, std::string::npos);
      std::fill_n(bytes.begin() + std::ptrdiff_t(stream), 30, '\0');
    }
    folder_.put(tests::cineFileName(picture), bytes);
  }
  const CineStudy study = read();
  ASSERT_EQ(study.slices.size(), 2U);
  EXPECT_EQ(study.slices[1].fractions.size(), 11U);
  EXPECT_THAT(sentences(study), HasSubstr("1 phase of series 2 is missing: 3 of 12"));
  EXPECT_THAT(sentences(study), HasSubstr("phase 3 of series 2 ("));
  EXPECT_EQ((*study.slices[1].image(3))(0, 0), 4200);
}

TEST_F(CineStudies, AreReadFromChosenFilesToo) {
  writeHeart();
  std::vector<std::filesystem::path> files;
  for (int phase = 0; phase < 12; ++phase)
    files.push_back(folder_ / nameOfPhase(tests::shortAxisPicture(2, 17.7, 829), phase));
  const CineStudy study = readCineStudy(files, progress_);
  ASSERT_EQ(study.slices.size(), 1U);
  EXPECT_EQ(study.slices[0].number, 2);
  EXPECT_THROW(readCineStudy(std::vector<std::filesystem::path>{}, progress_), UsageError);
}

TEST_F(CineStudies, StopWhenCancelled) {
  writeHeart();
  progress_.cancel();
  EXPECT_THROW(read(), Cancelled);
}

TEST_F(CineStudies, MakeAStackOfVolumesOverTime) {
  std::vector<tests::LabelImage> phases;
  for (int phase = 0; phase < 8; ++phase)
    phases.push_back(tests::beatingLabels(phase / 8.0, Vec3(5, 5, 8)));
  const auto expectStack = [&](const std::filesystem::path& file) {
    const CineStudy study = readCineStudy(file, progress_);
    ASSERT_EQ(study.slices.size(), std::size_t(phases[0].size[2]));
    ASSERT_EQ(study.stacks.size(), 1U);
    EXPECT_EQ(study.stacks[0].slices.size(), study.slices.size());
    const std::size_t middle = study.slices.size() / 2;
    const CineSlice& slice = study.slices[middle];
    EXPECT_NEAR(slice.interval, 0.8, 1e-5);
    ASSERT_EQ(slice.fractions.size(), 8U);
    EXPECT_NEAR(slice.fractions[3], 3.0 / 8, 1e-6);
    const auto image = slice.image(3);
    for (int j = 0; j < phases[0].size[1]; ++j)
      for (int i = 0; i < phases[0].size[0]; ++i)
        ASSERT_EQ((*image)(j, i), float(phases[3].at(i, j, int(middle))));
    EXPECT_LT((slice.geometry.at(1, 2) - phases[0].indexToLps * Vec3(1, 2, double(middle))).norm(), 1e-4);
  };
  expectStack(folder_.put("cine.nii", tests::nifti4d(phases, 100, 16)));
  expectStack(folder_.put(
      "cine.seq.nrrd",
      tests::sequenceNrrd(phases,
                          "axis 0 index type:=numeric\naxis 0 index values:=0 100 200 300 400 500 600 "
                          "700\naxis 0 index unit:=ms\n")));
  EXPECT_FALSE(findCineStudy(folder_.put("one.nii", tests::niftiFile(phases[0])), progress_).has_value());
}

TEST_F(CineStudies, OfARealPersonAreFiveSeriesAndOneStack) {
  const std::filesystem::path folder = std::filesystem::path(VISCERA_SHARED_ORGANS) / "cine_mr";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "cine_mr is not there; it is not part of the project";
  const CineStudy study = readCineStudy(folder, progress_);
  ASSERT_EQ(study.slices.size(), 5U);
  const std::vector<int> numbers = {8001, 9001, 10001, 14001, 17001};
  const std::vector<double> intervals = {0.860, 0.829, 0.776, 0.876, 0.975};
  const std::vector<std::string> planes = {"short axis", "short axis", "short axis", "4-chamber",
                                           "2-chamber"};
  for (std::size_t s = 0; s < 5; ++s) {
    const CineSlice& slice = study.slices[s];
    EXPECT_EQ(slice.number, numbers[s]);
    EXPECT_EQ(nameOf(slice.plane), planes[s]);
    EXPECT_NEAR(slice.interval, intervals[s], 1e-9);
    ASSERT_EQ(slice.fractions.size(), 25U);
    for (std::size_t phase = 0; phase < 25; ++phase)
      EXPECT_NEAR(slice.fractions[phase], double(phase) / 25, 2e-3);
    EXPECT_EQ(slice.image(9)->rows(), slice.geometry.rows);
    EXPECT_GT(slice.image(9)->maxCoeff(), 100);
  }
  ASSERT_EQ(study.stacks.size(), 1U);
  EXPECT_THAT(study.stacks[0].slices, testing::UnorderedElementsAre(0U, 1U, 2U));
  for (const double gap : study.stacks[0].gaps)
    EXPECT_NEAR(gap, 11.7, 0.01);
}

} // namespace
} // namespace viscera::medical_io

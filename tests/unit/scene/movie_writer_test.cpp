#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "viscera/core/error.h"
#include "viscera/scene/movie_writer.h"
#include "viscera/scene/picture.h"

namespace viscera::scene {
namespace {

namespace fs = std::filesystem;

/// A grey ramp from the lower left to the upper right that gets lighter with `step`.
vtkSmartPointer<vtkImageData> frame(int step, int width = 96, int height = 64) {
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (int i = 0; i < width * height; ++i)
    for (int c = 0; c < 3; ++c)
      *pixels++ = static_cast<unsigned char>(i % width + i / width + 4 * step);
  return picture;
}

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int bigEndian(const std::string& bytes, std::size_t at, int count) {
  int value = 0;
  for (int i = 0; i < count; ++i)
    value = 256 * value + static_cast<unsigned char>(bytes[at + std::size_t(i)]);
  return value;
}

std::string output(const std::string& command) {
  std::string text;
  if (FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r")) {
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
      text += static_cast<char>(c);
    pclose(pipe);
  }
  return text;
}

/// What the pages of an Ogg Theora file hold (RFC 3533 and the Theora specification, 6.2 and A.2.3).
struct TheoraPages {
  int headers = 0;
  int frames = 0;
  std::vector<int> keyFrames; ///< From 1 on.
  /// Pages on which a frame ends: the place that the page gives it, and the one that its frames have.
  std::vector<std::pair<std::int64_t, std::int64_t>> granules;
};

TheoraPages theoraPages(const std::string& bytes) {
  TheoraPages found;
  std::string packet;
  int shift = 0;
  const auto byteAt = [&bytes](std::size_t at) { return static_cast<unsigned char>(bytes.at(at)); };
  for (std::size_t page = 0; page < bytes.size();) {
    EXPECT_EQ(bytes.substr(page, 4), "OggS") << "at byte " << page;
    std::uint64_t granule = 0;
    for (std::size_t i = 8; i-- > 0;)
      granule = (granule << 8) | byteAt(page + 6 + i);
    const std::size_t segments = byteAt(page + 26);
    std::size_t at = page + 27 + segments;
    bool frameEnds = false;
    for (std::size_t i = 0; i < segments; ++i) {
      const std::size_t size = byteAt(page + 27 + i);
      packet += bytes.substr(at, size);
      at += size;
      if (size == 255)
        continue; // The packet goes on.
      const int first = packet.empty() ? 0x40 : static_cast<unsigned char>(packet.front());
      if (first == 0x80)
        shift = bigEndian(packet, 40, 2) >> 5 & 31;
      if (first & 0x80) {
        ++found.headers;
      } else {
        ++found.frames;
        frameEnds = true;
        if (!(first & 0x40)) // An empty packet repeats the frame before.
          found.keyFrames.push_back(found.frames);
      }
      packet.clear();
    }
    if (frameEnds && !found.keyFrames.empty()) {
      const std::int64_t key = found.keyFrames.back();
      found.granules.emplace_back(static_cast<std::int64_t>(granule), (key << shift) + found.frames - key);
    }
    page = at;
  }
  return found;
}

class Movie : public testing::Test {
protected:
  Movie() {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~Movie() override { fs::remove_all(folder); }
  long filesLeft() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); }
  void write(const fs::path& file, int frames, const MovieOptions& options = {}) {
    MovieWriter writer(file, options);
    for (int i = 0; i < frames; ++i)
      writer.add(frame(i));
    Progress progress;
    writer.finish(progress);
  }
  // One a test: ctest runs several at a time.
  fs::path folder =
      fs::path(testing::TempDir()) /
      ("viscera_movie_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(Movie, FolderGetsOnePictureAFrameInOrder) {
  write(folder / "frames", 12);
  for (int i = 0; i < 12; ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%05d.png", i);
    EXPECT_EQ(comparePictures(readPng(folder / "frames" / name), frame(i), 0).mean, 0) << name;
  }
}

TEST_F(Movie, OggTheoraSaysItsSizeRateAndSubsamplingAndEndsProperly) {
  write(folder / "beat.ogv", 20, {30, 2});
  const std::string bytes = contents(folder / "beat.ogv");
  ASSERT_EQ(bytes.substr(0, 4), "OggS");
  const auto header = bytes.find("\x80theora");
  ASSERT_NE(header, std::string::npos);
  // Theora specification 6.2: version, frame size in macro blocks, picture size, offsets, rate, aspect, ...
  EXPECT_EQ(bigEndian(bytes, header + 14, 3), 96);
  EXPECT_EQ(bigEndian(bytes, header + 17, 3), 64);
  EXPECT_EQ(double(bigEndian(bytes, header + 22, 4)) / bigEndian(bytes, header + 26, 4), 30);
  const int last = bigEndian(bytes, header + 40, 2);
  EXPECT_EQ(last >> 3 & 3, 0) << "players want 4:2:0";
  const auto page = bytes.rfind("OggS");
  EXPECT_TRUE(bytes[page + 5] & 4) << "the last page is marked as the last";
  EXPECT_EQ(filesLeft(), 1);
}

/// By the granule positions players find the key frame before an instant.
TEST_F(Movie, OggTheoraMarksItsKeyFramesWhereTheyAre) {
  constexpr int kFrames = 150;
  write(folder / "beat.ogv", kFrames, {30, 2});
  const TheoraPages pages = theoraPages(contents(folder / "beat.ogv"));
  EXPECT_EQ(pages.headers, 3);
  EXPECT_EQ(pages.frames, kFrames);
  ASSERT_GE(pages.keyFrames.size(), 2u) << "too few to go to an instant";
  EXPECT_EQ(pages.keyFrames.front(), 1);
  ASSERT_FALSE(pages.granules.empty());
  for (const auto& [said, is] : pages.granules)
    EXPECT_EQ(said, is);
}

TEST_F(Movie, PlayersCountEveryFrameOfEveryFormat) {
  if (!ffmpegInstalled() || output("ffprobe -version").empty())
    GTEST_SKIP() << "ffmpeg and ffprobe are not installed";
  for (const std::string name : {"a.ogv", "a.mp4", "a.gif"}) {
    write(folder / name, 15, {25, 2});
    const std::string said =
        output("ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width,height "
               "-of csv=p=0 " +
               (folder / name).string());
    EXPECT_EQ(said, "96,64,15\n") << name;
  }
  EXPECT_EQ(filesLeft(), 3);
}

TEST_F(Movie, PlayersShowTheFramesTheRightWayUp) {
  if (!ffmpegInstalled())
    GTEST_SKIP() << "ffmpeg is not installed";
  for (const std::string name : {"a.ogv", "a.mp4", "a.gif"}) {
    write(folder / name, 3);
    const fs::path seen = folder / (name + ".png");
    output("ffmpeg -v error -i " + (folder / name).string() + " -frames:v 1 -pix_fmt rgb24 " + seen.string());
    EXPECT_LT(comparePictures(readPng(seen), frame(0)).mean, 4) << name;
  }
}

TEST_F(Movie, WithoutFfmpegItSaysWhatToDoInstead) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.c_str(), 1);
  EXPECT_FALSE(ffmpegInstalled());
  try {
    MovieWriter writer(folder / "a.mp4");
    ADD_FAILURE() << "no error";
  } catch (const CannotCreateError& error) {
    EXPECT_NE(error.tryThis().english().find(".ogv"), std::string::npos);
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(filesLeft(), 0);
}

TEST_F(Movie, FailingFfmpegIsAnErrorThatRepeatsWhatItSaid) {
  const std::string path = std::getenv("PATH");
  const fs::path tools = folder / "tools";
  fs::create_directories(tools);
  std::ofstream(tools / "ffmpeg") << "#!/bin/sh\necho 'no such encoder' >&2\nexit 1\n";
  fs::permissions(tools / "ffmpeg", fs::perms::owner_all);
  setenv("PATH", (tools.string() + ":" + path).c_str(), 1);
  try {
    write(folder / "a.mp4", 40);
    ADD_FAILURE() << "no error";
  } catch (const CannotCreateError& error) {
    EXPECT_NE(error.problem().english().find("no such encoder"), std::string::npos) << error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(filesLeft(), 1) << "only the folder of tools";
}

TEST_F(Movie, NothingIsLeftWhenCancelledOrForgotten) {
  for (const std::string name : {"a.ogv", "frames"}) {
    {
      MovieWriter writer(folder / name);
      for (int i = 0; i < 5; ++i)
        writer.add(frame(i));
      writer.cancel();
      Progress progress;
      EXPECT_THROW(writer.finish(progress), Cancelled);
    }
    EXPECT_EQ(filesLeft(), 0) << name;
    {
      MovieWriter forgotten(folder / name);
      forgotten.add(frame(0));
    }
    EXPECT_EQ(filesLeft(), 0) << name;
  }
}

TEST_F(Movie, FinishingCanBeCancelled) {
  MovieWriter writer(folder / "a.ogv");
  for (int i = 0; i < 5; ++i)
    writer.add(frame(i));
  Progress progress;
  progress.cancel();
  EXPECT_THROW(writer.finish(progress), Cancelled);
  EXPECT_EQ(filesLeft(), 0);
}

TEST_F(Movie, WhatWasThereStaysWhenTheNewMovieFails) {
  std::ofstream(folder / "a.ogv") << "old";
  {
    MovieWriter writer(folder / "a.ogv");
    writer.add(frame(0));
    writer.cancel();
  }
  EXPECT_EQ(contents(folder / "a.ogv"), "old");
}

TEST_F(Movie, FailureOfTheWorkerReachesTheCaller) {
  const fs::path frames = folder / "frames";
  MovieWriter writer(frames);
  fs::remove_all(frames);
  Progress progress;
  EXPECT_THROW(
      {
        for (int i = 0; i < 100; ++i)
          writer.add(frame(i));
        writer.finish(progress);
      },
      CannotCreateError);
}

TEST_F(Movie, MistakesAreNamedBeforeAnythingIsWritten) {
  EXPECT_THROW(MovieWriter(folder / "a.avi"), UsageError);
  EXPECT_THROW(MovieWriter(folder / "a.ogv", {0, 2}), UsageError);
  EXPECT_THROW(MovieWriter(folder / "missing" / "a.ogv"), CannotCreateError);
  EXPECT_EQ(filesLeft(), 0);
  MovieWriter writer(folder / "b.ogv");
  writer.add(frame(0));
  EXPECT_THROW(writer.add(frame(0, 32, 32)), UsageError);
  MovieWriter empty(folder / "c.ogv");
  Progress progress;
  EXPECT_THROW(empty.finish(progress), CannotCreateError);
}

TEST_F(Movie, ProgressGoesUpToOne) {
  MovieWriter writer(folder / "a.ogv");
  for (int i = 0; i < 5; ++i)
    writer.add(frame(i));
  double last = 0;
  Progress progress([&](double fraction, const Text&) {
    EXPECT_GE(fraction, last);
    last = fraction;
  });
  writer.finish(progress);
  EXPECT_EQ(last, 1);
}

} // namespace
} // namespace viscera::scene

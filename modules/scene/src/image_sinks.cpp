#include "image_sinks.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <unistd.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include "viscera/core/atomic_file.h"
#include "viscera/core/child_process.h"
#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/core/phrase.h"
#include "viscera/scene/picture.h"

namespace viscera::scene {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void cannotWrite(const fs::path& file) {
  throw CannotCreateError("the movie cannot be written", file.string(),
                          "check that there is room on the disk");
}

/// Numbered PNG files. A folder that was not there is removed again on failure; one that was keeps its other
/// files.
class PngFolder : public ImageSink {
public:
  explicit PngFolder(fs::path folder) : folder_(std::move(folder)) {
    std::error_code failure;
    madeFolder_ = fs::create_directories(folder_, failure);
    if (failure || !fs::is_directory(folder_, failure) || access(folder_.c_str(), W_OK) != 0)
      throw CannotCreateError("the folder for the frames cannot be written", folder_.string());
  }
  void write(vtkImageData* frame) override {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%05zu.png", files_.size());
    files_.push_back(folder_ / name);
    writePng(files_.back(), frame);
  }
  void close() override {}
  void discard() noexcept override {
    std::error_code ignored;
    for (const auto& file : files_)
      fs::remove(file, ignored);
    if (madeFolder_)
      fs::remove(folder_, ignored); // Only succeeds when it is empty.
  }

private:
  fs::path folder_;
  bool madeFolder_ = false;
  std::vector<fs::path> files_;
};

/// Whether a movie ends with its last page complete. VTK's writer says nothing of a disk that was full.
bool endsWithWholeOggPage(const fs::path& file) {
  constexpr std::streamoff kLongestPage = 27 + 255 + 255 * 255;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : 0;
  std::string tail(static_cast<std::size_t>(std::min(size, kLongestPage)), '\0');
  stream.seekg(size - static_cast<std::streamoff>(tail.size()));
  stream.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  // The letters may also be among the data: one beginning that fits the end is enough.
  for (std::size_t at = tail.rfind("OggS"); at != std::string::npos;
       at = at == 0 ? std::string::npos : tail.rfind("OggS", at - 1)) {
    if (at + 27 > tail.size())
      continue;
    const std::size_t segments = static_cast<unsigned char>(tail[at + 26]);
    std::size_t end = at + 27 + segments;
    for (std::size_t i = 0; i < segments && at + 27 + i < tail.size(); ++i)
      end += static_cast<unsigned char>(tail[at + 27 + i]);
    if (end == tail.size())
      return true;
  }
  return false;
}

class OggTheora : public ImageSink {
public:
  OggTheora(const fs::path& file, const MovieOptions& options)
      : movie_(file), file_(std::make_unique<AtomicFile>(file)) {
    writer_->SetFileName(file_->temporary().c_str());
    writer_->SetRate(std::max(1, static_cast<int>(std::lround(options.framesPerSecond))));
    writer_->SetQuality(options.quality);
    writer_->SetSubsampling(1); // 4:2:0: players refuse the writer's default.
    writer_->GlobalWarningDisplayOff();
  }
  void write(vtkImageData* frame) override {
    writer_->SetInputData(frame);
    if (!started_)
      writer_->Start();
    started_ = true;
    writer_->Write();
    if (writer_->GetError())
      cannotWrite(movie_);
  }
  void close() override {
    end();
    if (!endsWithWholeOggPage(file_->temporary()))
      cannotWrite(movie_);
    file_->commit();
  }
  void discard() noexcept override {
    end();
    file_.reset();
  }

private:
  void end() {
    if (started_)
      writer_->End();
    started_ = false;
  }
  fs::path movie_;
  std::unique_ptr<AtomicFile> file_;
  vtkNew<vtkOggTheoraWriter> writer_;
  bool started_ = false;
};

constexpr std::size_t kMostMessages = 1 << 16; ///< Bytes.

/// While it lives, writing to a closed pipe is an error of `write` instead of the end of the program.
class BrokenPipeBlocked {
public:
  BrokenPipeBlocked() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~BrokenPipeBlocked() {
    if (!sigismember(&before_, SIGPIPE)) { // Take back one that may be waiting.
      const timespec now{0, 0};
      while (sigtimedwait(&pipe_, nullptr, &now) > 0) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

private:
  sigset_t pipe_;
  sigset_t before_;
};

/// A running ffmpeg that is fed through a pipe. What it says goes into the error when it fails.
class FfmpegProcess {
public:
  /// Starts it. `movie` is named in errors. Throws `CannotCreateError`.
  FfmpegProcess(const std::vector<std::string>& arguments, fs::path movie);
  /// Kills it when it was not finished.
  ~FfmpegProcess();
  FfmpegProcess(const FfmpegProcess&) = delete;
  FfmpegProcess& operator=(const FfmpegProcess&) = delete;

  /// Throws `CannotCreateError` when it has gone.
  void write(const void* data, std::size_t size);
  /// Closes its input and waits. Throws `CannotCreateError` when it failed.
  void finish();

private:
  [[noreturn]] void fail();
  void closeInput();

  fs::path movie_;
  std::optional<ChildProcess> process_;
  int input_ = -1;
};

FfmpegProcess::FfmpegProcess(const std::vector<std::string>& arguments, fs::path movie)
    : movie_(std::move(movie)) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    fail();
  process_.emplace(arguments, ends[0], -1);
  ::close(ends[0]);
  input_ = ends[1];
  if (process_->startError() != 0)
    fail();
}

FfmpegProcess::~FfmpegProcess() {
  closeInput();
}

void FfmpegProcess::write(const void* data, std::size_t size) {
  const BrokenPipeBlocked blocked;
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(input_, bytes, size);
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      fail();
    bytes += written;
    size -= std::size_t(written);
  }
}

void FfmpegProcess::finish() {
  closeInput();
  ChildResult result;
  process_->ended(result, true);
  if (result.end != ChildResult::End::exited || result.code != 0)
    fail();
}

void FfmpegProcess::closeInput() {
  if (input_ >= 0)
    ::close(input_);
  input_ = -1;
}

void FfmpegProcess::fail() {
  closeInput();
  std::string said;
  if (process_ && process_->startError() == 0) {
    ChildResult ignored;
    process_->ended(ignored, true);
    std::istringstream lines(process_->messages(kMostMessages));
    for (std::string line; std::getline(lines, line);) // The last line says why.
      said = line.find_first_not_of(" \t\r") == std::string::npos ? said : line;
  }
  throw CannotCreateError(said.empty() ? "The program ffmpeg could not write the movie"
                                       : phrase("The program ffmpeg could not write the movie: %1", said),
                          movie_.string(), "write an .ogv instead");
}

/// MP4 and GIF by the program ffmpeg, which reads raw frames from its standard input.
class Ffmpeg : public ImageSink {
public:
  Ffmpeg(const fs::path& file, const MovieOptions& options, bool gif)
      : movie_(file), file_(std::make_unique<AtomicFile>(file)), options_(options), gif_(gif) {
    if (!ffmpegInstalled())
      throw CannotCreateError("the program ffmpeg is needed for this kind of movie and is not installed",
                              file.string(), "install ffmpeg, or write an .ogv");
  }
  void write(vtkImageData* frame) override {
    const int* size = frame->GetDimensions();
    if (!process_)
      process_ = std::make_unique<FfmpegProcess>(arguments(size[0], size[1]), movie_);
    process_->write(frame->GetScalarPointer(), std::size_t(size[0]) * std::size_t(size[1]) * 3);
  }
  void close() override {
    if (process_)
      process_->finish();
    file_->commit();
  }
  void discard() noexcept override {
    process_.reset();
    file_.reset();
  }

private:
  std::vector<std::string> arguments(int width, int height) const {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    std::vector<std::string> list = {"ffmpeg",
                                     "-nostdin",
                                     "-loglevel",
                                     "error",
                                     "-y",
                                     "-f",
                                     "rawvideo",
                                     "-pixel_format",
                                     "rgb24",
                                     "-video_size",
                                     size,
                                     "-framerate",
                                     std::to_string(options_.framesPerSecond),
                                     "-i",
                                     "pipe:0"};
    // VTK's first row is the lowest. H.264 with 4:2:0 needs even sizes.
    const std::vector<std::string> coding =
        gif_ ? std::vector<std::string>{"-vf", "vflip,split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f",
                                        "gif"}
             : std::vector<std::string>{
                   "-vf",       "vflip,pad=ceil(iw/2)*2:ceil(ih/2)*2",
                   "-pix_fmt",  "yuv420p",
                   "-crf",      std::to_string(28 - 5 * std::clamp(options_.quality, 0, 2)),
                   "-movflags", "+faststart",
                   "-f",        "mp4"};
    list.insert(list.end(), coding.begin(), coding.end());
    list.push_back("file:" + absolutePath(file_->temporary()).string());
    return list;
  }

  fs::path movie_;
  std::unique_ptr<AtomicFile> file_;
  MovieOptions options_;
  bool gif_;
  std::unique_ptr<FfmpegProcess> process_;
};

} // namespace

bool ffmpegInstalled() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/ffmpeg").c_str(), X_OK) == 0)
      return true;
  return false;
}

std::unique_ptr<ImageSink> imageSink(const fs::path& file, const MovieOptions& options) {
  if (!(options.framesPerSecond > 0) || !std::isfinite(options.framesPerSecond))
    throw UsageError(misuse("the frame rate has to be positive"), std::to_string(options.framesPerSecond));
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension.empty())
    return std::make_unique<PngFolder>(file);
  if (extension == ".ogv")
    return std::make_unique<OggTheora>(file, options);
  if (extension == ".mp4" || extension == ".gif")
    return std::make_unique<Ffmpeg>(file, options, extension == ".gif");
  throw UsageError("movies of this kind cannot be written", file.string(),
                   "use .ogv, .mp4, .gif, or a folder for PNG frames");
}

} // namespace viscera::scene

#include <cstring>
#include <filesystem>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

extern "C" {
#include <libavcodec/avcodec.h>
}

#include "build_paths.h"
#include "temporary_folder.h"
#include "viscera/medical_io/scan.h"

/// The CT beside the project, packed as JPEG 2000, against the decoder of libavcodec, which shares nothing
/// with OpenJPEG.
namespace viscera::medical_io {
namespace {

const std::filesystem::path kSeries = std::filesystem::path(VISCERA_SHARED_ORGANS) / "ct" / "dicom";

/// Pixels of a DICOM file with one JPEG 2000 code stream, found by its markers, as libavcodec's own decoder
/// unpacks it; none when it cannot.
std::vector<int> decoded(const std::filesystem::path& file) {
  const std::string bytes = tests::contentsOf(file);
  const std::size_t begin = bytes.find("\xff\x4f\xff\x51");
  av_log_set_level(AV_LOG_QUIET);
  AVCodecContext* context = avcodec_alloc_context3(avcodec_find_decoder_by_name("jpeg2000"));
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  std::vector<int> pixels;
  if (begin != bytes.npos && avcodec_open2(context, nullptr, nullptr) == 0 &&
      av_new_packet(packet, static_cast<int>(bytes.size() - begin)) == 0) {
    bytes.copy(reinterpret_cast<char*>(packet->data), bytes.size() - begin, begin);
    if (avcodec_send_packet(context, packet) == 0 && avcodec_receive_frame(context, frame) == 0 &&
        frame->format == AV_PIX_FMT_GRAY16)
      for (int y = 0; y < frame->height; ++y)
        for (int x = 0; x < frame->width; ++x) {
          std::uint16_t pixel = 0;
          std::memcpy(&pixel, frame->data[0] + std::ptrdiff_t(y) * frame->linesize[0] + 2 * x, 2);
          pixels.push_back(pixel >> (16 - context->bits_per_raw_sample)); // It fills the lower bits up.
        }
  }
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&context);
  return pixels;
}

TEST(DicomJpeg2000, EqualsAnIndependentDecoderOnTheSharedCt) {
  if (!std::filesystem::exists(kSeries / "slice_20.dcm"))
    GTEST_SKIP() << kSeries << " is not there; it is not part of the project";
  Progress progress;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const Scan scan = readScan(kSeries, {}, progress);
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  ASSERT_EQ(scan.size, (std::array<int, 3>{512, 512, 20}));
  EXPECT_EQ(scan.slope, 1);
  EXPECT_EQ(scan.intercept, -1024);
  EXPECT_EQ(scan.modality, "CT");
  EXPECT_NE(scan.transferSyntax.find("JPEG 2000"), std::string::npos) << scan.transferSyntax;
  double total = 0;
  std::set<int> layers;
  for (int number = 1; number <= 20; ++number) {
    const std::vector<int> pixels =
        decoded(kSeries / ("slice_" + std::string(number < 10 ? "0" : "") + std::to_string(number) + ".dcm"));
    ASSERT_EQ(pixels.size(), 512U * 512U);
    // Which layer it is, by one of its rows.
    int found = -1;
    for (int k = 0; k < 20 && found < 0; ++k) {
      bool same = true;
      for (int i = 0; i < 512 && same; ++i)
        same = scan.value(i, 256, k) == pixels[256 * 512 + std::size_t(i)] - 1024;
      found = same ? k : -1;
    }
    ASSERT_GE(found, 0) << "slice " << number;
    EXPECT_TRUE(layers.insert(found).second) << "slice " << number;
    for (int j = 0; j < 512; ++j)
      for (int i = 0; i < 512; ++i)
        ASSERT_EQ(scan.value(i, j, found), pixels[std::size_t(j) * 512 + std::size_t(i)] - 1024);
    total += std::accumulate(pixels.begin(), pixels.end(), 0.0);
  }
  EXPECT_GT(total, 0);
}

TEST(DicomJpeg2000, NiftiOfTheSharedCtHasValuesAndAWindowOfACt) {
  if (!std::filesystem::exists(kSeries.parent_path() / "example_ct_sm.nii.gz"))
    GTEST_SKIP() << kSeries.parent_path() << " is not there; it is not part of the project";
  Progress progress;
  const Scan scan = readScan(kSeries.parent_path() / "example_ct_sm.nii.gz", {}, progress);
  const std::array<double, 2> range = scan.range();
  EXPECT_GE(range[0], -3100);
  EXPECT_GT(range[1], 300);
  EXPECT_EQ(scan.firstWindow().width, 400) << "values like Hounsfield's are shown as soft tissue";
}

} // namespace
} // namespace viscera::medical_io

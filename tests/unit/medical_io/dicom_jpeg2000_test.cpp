#include <cstring>
#include <filesystem>
#include <memory>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <openjpeg.h>

#include "temporary_folder.h"
#include "viscera/medical_io/scan.h"

/// The CT beside the project, packed as JPEG 2000, against OpenJPEG on the code stream alone.
namespace viscera::medical_io {
namespace {

const std::filesystem::path kSeries = std::filesystem::path(VISCERA_SHARED_ORGANS) / "ct" / "dicom";

/// Bytes as OpenJPEG reads them.
struct Stream {
  std::string_view bytes;
  std::size_t at = 0;

  static OPJ_SIZE_T read(void* out, OPJ_SIZE_T count, void* self) {
    auto& s = *static_cast<Stream*>(self);
    const std::size_t there = s.bytes.substr(s.at).copy(static_cast<char*>(out), count);
    s.at += there;
    return there > 0 ? there : static_cast<OPJ_SIZE_T>(-1);
  }
  static OPJ_OFF_T skip(OPJ_OFF_T count, void* self) {
    static_cast<Stream*>(self)->at += static_cast<std::size_t>(count);
    return count;
  }
  static OPJ_BOOL seek(OPJ_OFF_T to, void* self) {
    static_cast<Stream*>(self)->at = static_cast<std::size_t>(to);
    return OPJ_TRUE;
  }
};

/// Pixels of a DICOM file with one JPEG 2000 code stream, found by its markers.
std::vector<int> decoded(const std::filesystem::path& file) {
  const std::string bytes = tests::contentsOf(file);
  Stream source{std::string_view(bytes).substr(bytes.find("\xff\x4f\xff\x51"))};
  const std::unique_ptr<opj_codec_t, void (*)(opj_codec_t*)> codec(opj_create_decompress(OPJ_CODEC_J2K),
                                                                   opj_destroy_codec);
  opj_dparameters_t parameters;
  opj_set_default_decoder_parameters(&parameters);
  opj_setup_decoder(codec.get(), &parameters);
  const std::unique_ptr<opj_stream_t, void (*)(opj_stream_t*)> stream(opj_stream_create(1 << 16, OPJ_TRUE),
                                                                      opj_stream_destroy);
  opj_stream_set_user_data(stream.get(), &source, nullptr);
  opj_stream_set_user_data_length(stream.get(), source.bytes.size());
  opj_stream_set_read_function(stream.get(), Stream::read);
  opj_stream_set_skip_function(stream.get(), Stream::skip);
  opj_stream_set_seek_function(stream.get(), Stream::seek);
  opj_image_t* image = nullptr;
  std::vector<int> pixels;
  if (opj_read_header(stream.get(), codec.get(), &image) != 0 &&
      opj_decode(codec.get(), stream.get(), image) != 0)
    pixels.assign(image->comps[0].data,
                  image->comps[0].data + std::size_t(image->comps[0].w) * image->comps[0].h);
  opj_image_destroy(image);
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

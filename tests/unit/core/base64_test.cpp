#include "viscera/core/base64.h"

#include <array>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace viscera {
namespace {

/// The vectors of RFC 4648.
const std::array<std::pair<std::string, std::string>, 7> kBase64Vectors = {{{"", ""},
                                                                            {"f", "Zg=="},
                                                                            {"fo", "Zm8="},
                                                                            {"foo", "Zm9v"},
                                                                            {"foob", "Zm9vYg=="},
                                                                            {"fooba", "Zm9vYmE="},
                                                                            {"foobar", "Zm9vYmFy"}}};

TEST(Base64, IsThatOfTheStandard) {
  for (const auto& [bytes, text] : kBase64Vectors) {
    EXPECT_EQ(base64Of(bytes), text);
    EXPECT_EQ(bytesOfBase64(text), bytes);
  }
}

TEST(Base64, GivesEveryByteBackOfTextsOfEveryLength) {
  std::string bytes;
  for (int i = 0; i < 600; ++i) {
    const std::string text = base64Of(bytes);
    EXPECT_EQ(text.size(), (bytes.size() + 2) / 3 * 4);
    EXPECT_EQ(bytesOfBase64(text), bytes) << bytes.size();
    bytes += static_cast<char>(i * 7);
  }
}

TEST(Base64, RefusesWhatIsNone) {
  for (const char* text :
       {"Zg", "Zg=", "Zg===", "Z===", "====", "Zm9v\n", "Zm 9", "Zm9-", "Zg==Zg==", "=g==", "Zm=v"})
    EXPECT_FALSE(bytesOfBase64(text).has_value()) << text;
  EXPECT_FALSE(bytesOfBase64(std::string("Zm9\0", 4)).has_value());
  EXPECT_FALSE(bytesOfBase64("Zm9\xe9").has_value());
}

} // namespace
} // namespace viscera

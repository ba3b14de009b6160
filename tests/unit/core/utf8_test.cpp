#include "viscera/core/text.h"

#include <gtest/gtest.h>

namespace viscera {
namespace {

TEST(Utf8, KnowsWhatIsNone) {
  for (const char* text : {"", "Leber", "\xC3\xBC", "\xE2\x82\xAC", "\xF0\x9F\xAB\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_TRUE(isUtf8(text)) << text;
  for (const char* text : {"N\xE4hte", "\xC3", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                           "\xF0\x80\x80\x80", "\xFF", "\x80"})
    EXPECT_FALSE(isUtf8(text)) << text;
}

TEST(Utf8, TakesOtherBytesAsLatin1SoThatTextsThatDifferStillDo) {
  EXPECT_EQ(toUtf8("N\xE4hte"), "N\xC3\xA4hte");
  EXPECT_EQ(toUtf8("\xC3\xBC and \xFC"), "\xC3\xBC and \xC3\xBC");
  EXPECT_NE(toUtf8("H-\xE4"), toUtf8("H-\xE5"));
  for (int byte = 1; byte < 256; ++byte)
    EXPECT_TRUE(isUtf8(toUtf8(std::string(1, static_cast<char>(byte)) + "x"))) << byte;
}

} // namespace
} // namespace viscera

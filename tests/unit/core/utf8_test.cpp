#include "viscera/core/text.h"

#include <gtest/gtest.h>

#include "viscera/core/phrase.h"

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

/// So that no text of a file commands a terminal.
TEST(Text, HasNoControlCharacters) {
  EXPECT_EQ(withoutControls("a\x1B[31mb\x07\x7F\r c\n\td"), "a[31mb c\n\td");
  EXPECT_EQ(withoutControls("\xC2\x9B"
                            "31m \xC2\xA0\xC3\xA9"),
            "31m \xC2\xA0\xC3\xA9")
      << "C1";
  EXPECT_EQ(printableName(" Left\n\x1B kidney\t"), "Left  kidney");
  EXPECT_EQ(printableName("N\xE4hte"), "N\xC3\xA4hte");
  EXPECT_EQ(phrase("Open %1", std::string("a\x1B"
                                          "b"))
                .english(),
            "Open ab");
  EXPECT_EQ(named("a\x1B"
                  "b")
                .english(),
            "ab");
}

} // namespace
} // namespace viscera

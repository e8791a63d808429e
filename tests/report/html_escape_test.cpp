#include <gtest/gtest.h>

#include "report/html/escape.h"

namespace rad::report::html {
namespace {

TEST(Escaped, MarkupBecomesText) {
  EXPECT_EQ(escaped("<b class='x'>\"&amp;\"</b>"), "&lt;b class=&#39;x&#39;&gt;&quot;&amp;amp;&quot;&lt;/b&gt;");
  EXPECT_EQ(escaped("Küche\tA\n"), "Küche A ");
}

TEST(Escaped, BytesThatAreNoTextBecomeReplacements) {
  EXPECT_EQ(escaped("a\xff"
                    "b"),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(escaped(std::string_view("a\0b\x1b[31m", 8)),
            "a\xEF\xBF\xBD"
            "b\xEF\xBF\xBD[31m");
}

TEST(ScriptJson, NothingEndsTheElementOrALine) {
  const Json hostile = {{"</script><!--", "\u2028\u2029 & > \x7f \xff"}};
  const std::string text = script_json(hostile);
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos) << text;
  for (const char c : text) EXPECT_LT(static_cast<unsigned char>(c), 0x7F) << text;
  EXPECT_EQ(Json::parse(text).begin().key(), "</script><!--");
}

TEST(Base64, KnownAnswers) {  // RFC 4648, 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace rad::report::html

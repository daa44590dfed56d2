#include <gmock/gmock.h>

#include "aisle/report/report_page.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ReportPage, SaysEverythingThatItIsGiven) {
  const std::string page = html({.title = "two-loops",
                                 .summary = "explored, home",
                                 .warnings = {"one door was closed"},
                                 .figures = {{"distance", "120.5 m"}},
                                 .pictures = {{"map", "<svg/>", "walls and path"}}});
  for (const char* said : {"<title>two-loops</title>", "explored, home", "one door was closed", "120.5 m",
                           "walls and path", "alt=\"map\""})
    EXPECT_THAT(page, HasSubstr(said));
}

TEST(ReportPage, TextCannotBecomeMarkup) {
  const std::string page = html({.title = "<script>alert(\"&\")</script>", .pictures = {{"\"><b>", "", ""}}});
  EXPECT_THAT(page, Not(HasSubstr("<script>")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&quot;&amp;&quot;)&lt;/script&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
}

TEST(ReportPage, NeedsNoOtherFile) {
  const std::string page = html({.title = "run", .pictures = {{"map", "<svg/>", ""}}});
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
}

TEST(ReportPage, PicturesAreCodedAsRfc4648SaysIt) {
  const auto coded = [](const std::string& bytes) { return html({.pictures = {{"p", bytes, ""}}}); };
  EXPECT_THAT(coded("f"), HasSubstr("base64,Zg==\""));
  EXPECT_THAT(coded("fo"), HasSubstr("base64,Zm8=\""));
  EXPECT_THAT(coded("foobar"), HasSubstr("base64,Zm9vYmFy\""));
  EXPECT_THAT(coded("\xff\xfe"), HasSubstr("base64,//4=\""));
}

}  // namespace
}  // namespace aisle

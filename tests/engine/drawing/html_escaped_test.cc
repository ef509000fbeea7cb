#include <gable/engine/drawing/html_escaped.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

TEST(HtmlEscaped, ReplacesTheFiveReservedCharactersAndNoOther) {
  EXPECT_EQ(html_escaped("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(html_escaped("dach 12 %, \xc3\xbc"), "dach 12 %, \xc3\xbc");
  EXPECT_EQ(html_escaped(""), "");
}

}  // namespace
}  // namespace gable

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <regex>
#include <string>
#include <type_traits>

#include "reports/markup/escaped.h"
#include "reports/markup/html.h"
#include "reports/markup/html_table.h"
#include "reports/markup/markup_defects.h"
#include "reports/markup/parts.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;

/// Text reaches a page through text() alone.
template <typename Text>
constexpr bool never_markup = !std::is_convertible_v<Text, Html> && !std::is_constructible_v<Html, Text> &&
                              !std::is_assignable_v<Html&, Text> && !std::is_convertible_v<Text, Cell> &&
                              !std::is_constructible_v<Cell, Text> && !std::is_constructible_v<Column, Text>;
static_assert(never_markup<std::string>);
static_assert(never_markup<std::string_view>);
static_assert(never_markup<const char*>);
static_assert(never_markup<const char (&)[2]>);

template <typename Left, typename Right>
concept Addable = requires(Left left, Right right) {
  left + right;
};
static_assert(Addable<Html, Html>);
static_assert(!Addable<Html, std::string> && !Addable<std::string, Html>);
static_assert(!Addable<Html, const char*> && !Addable<const char*, Html>);

constexpr const char* hostile = "<b title=\"x\">'&'</b>";
constexpr const char* harmless = "&lt;b title=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/b&gt;";

TEST(HtmlText, IsEscapedAndMarkupIsNot) {
  EXPECT_EQ(text(hostile).markup(), harmless);
  EXPECT_EQ("<i>a</i> &amp; b"_html.markup(), "<i>a</i> &amp; b");
  EXPECT_EQ(Html::trusted(hostile).markup(), hostile);
  EXPECT_EQ((text("<") + "<hr/>"_html).markup(), "&lt;<hr/>");
}

TEST(HtmlText, ControlCharactersAreReplacedAndLinesStay) {
  EXPECT_EQ(text(std::string("a\0b\x01\r\n\tc", 8)).markup(), "a\uFFFDb\uFFFD\uFFFD\n\tc");
}

TEST(HtmlElement, AttributesAreEscaped) {
  EXPECT_EQ(element("p", {{"class", "n"}, {"title", hostile}}, text(hostile)).markup(),
            std::string("<p class=\"n\" title=\"") + harmless + "\">" + harmless + "</p>\n");
  EXPECT_EQ(inline_element("code", {{"class", "\"> <script>"}}, "x"_html).markup(),
            "<code class=\"&quot;&gt; &lt;script&gt;\">x</code>");
  EXPECT_EQ(empty_element("img", {{"alt", "'"}}).markup(), "<img alt=\"&#39;\"/>");
  EXPECT_EQ(element("p", "x"_html).markup(), "<p>x</p>\n");
  EXPECT_EQ(element("p", {}, {}).markup(), "<p></p>\n");
}

TEST(HtmlElement, ItemsOfAListAreSeparated) {
  Html list;
  for (const char* item : {"a", "<", "c"}) add_item(list, text(item));
  EXPECT_EQ(list.markup(), "a, &lt;, c");
}

TEST(HtmlTable, CaptionCellsAndStatesAreText) {
  HtmlTable table(hostile, "sortable", {{"Case"_html, false}, {text("< 1")}});
  table.add_row({text(hostile), {"2"_html, 2.0}}, RowState{"fail", hostile});
  const std::string html = table.html().markup();
  EXPECT_EQ(test::markup_defects(html), "");
  EXPECT_THAT(html, HasSubstr(std::string("aria-label=\"") + harmless + "\""));
  EXPECT_THAT(html, HasSubstr(std::string("<caption>") + harmless + "</caption>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"col\">Case</th><th scope=\"col\" class=\"n\">&lt; 1</th>"));
  EXPECT_THAT(html, HasSubstr(std::string("<tr class=\"fail\" data-status=\"") + harmless + "\"><th scope=\"row\">" +
                              harmless + "</th><td class=\"n\" data-order=\"2\">2</td></tr>"));
}

TEST(HtmlParts, FactsWithoutAValueAreLeftOut) {
  EXPECT_TRUE(fact("Seed", {}).empty());
  EXPECT_TRUE(fact("Seed", absent_html()).empty());
  EXPECT_EQ(fact("a < b", text("<1>")).markup(), "<div><dt>a &lt; b</dt>\n<dd>&lt;1&gt;</dd>\n</div>\n");
  EXPECT_EQ(text_or_dash("").markup(), "–");
  EXPECT_EQ(code_html("<").markup(), "<code>&lt;</code>");
}

TEST(HtmlParts, LinksAreFilesAndNothingElse) {
  EXPECT_EQ(file_link("images/a_b-1.exr").markup(), "<a href=\"./images/a_b-1.exr\">images/a_b-1.exr</a>");
  EXPECT_THAT(file_link("javascript:alert(1)").markup(), HasSubstr("href=\"./javascript%3Aalert%281%29\""));
  EXPECT_THAT(file_link("a?b#c\"d").markup(), HasSubstr("href=\"./a%3Fb%23c%22d\""));
}

TEST(Escaped, XmlKeepsLinesInAttributes) {
  EXPECT_EQ(escaped("a'\t\n\r\x02<&", Dialect::Xml), "a&apos;&#9;&#10;&#13;\uFFFD&lt;&amp;");
}

RC_GTEST_PROP(Escaped, TextHasNoMarkup, (const std::string& any)) {
  const std::string safe = escaped(any);
  RC_ASSERT(safe.find_first_of("<>\"'") == std::string::npos);
  RC_ASSERT(!std::regex_search(safe, std::regex("&(?!(amp|lt|gt|quot|#39);)")));
}

}  // namespace
}  // namespace sturm

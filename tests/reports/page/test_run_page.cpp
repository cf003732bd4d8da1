#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "io/files/error.h"
#include "io/images/exr.h"
#include "io/json/schema.h"
#include "reports/fixture_report.h"
#include "reports/markup/escaped.h"
#include "reports/markup/markup_defects.h"
#include "reports/page/run_page.h"
#include "reports/plots/gnuplot.h"

namespace sturm {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// What a reader sees: no tags, no script, no style.
std::string visible_text(const std::string& page) {
  std::string text;
  std::size_t at = page.find("<body");
  while (at != std::string::npos) {
    if (page.compare(at, 7, "<script") == 0) at = page.find("</script>", at);
    const std::size_t end = page.find('>', at), next = page.find('<', end);
    if (next == std::string::npos) break;
    text += page.substr(end + 1, next - end - 1) + " ";
    at = next;
  }
  return text;
}

class ReportHtml : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::path(::testing::TempDir()) / ("sturm_report_html_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    report_ = new Json(test::synthetic_report(true));
    test::write_synthetic_pictures(*report_, folder_);
    page_ = new std::string(render_report_html(*report_, folder_));
  }
  static void TearDownTestSuite() {
    fs::remove_all(folder_);
    delete report_;
    delete page_;
  }

  static fs::path folder_;
  static Json* report_;
  static std::string* page_;
};

fs::path ReportHtml::folder_;
Json* ReportHtml::report_ = nullptr;
std::string* ReportHtml::page_ = nullptr;

TEST_F(ReportHtml, IsDrawnFromAReportThatFollowsTheSchema) {
  for (const bool failing : {false, true})
    EXPECT_NO_THROW(validate(test::synthetic_report(failing), "report", "synthetic"));
}

TEST_F(ReportHtml, IsWellFormed) {
  EXPECT_EQ(test::markup_defects(*page_), "");
}

TEST(MarkupDefects, AreFound) {  // the checker above can fail
  EXPECT_EQ(test::markup_defects("<p><b>x</b></p><br/>"), "");
  EXPECT_NE(test::markup_defects("<p><b>x</p></b>"), "");
  EXPECT_NE(test::markup_defects("<p>"), "");
  EXPECT_NE(test::markup_defects("<p class=x></p>"), "");
  EXPECT_EQ(test::markup_defects("<p><![CDATA[ a < b </p> ]]></p>"), "");
  EXPECT_NE(test::markup_defects("<p><![CDATA[ a </p>"), "");
  EXPECT_NE(test::markup_defects("<p id=\"a\"></p><p id=\"a\"></p>"), "");
}

TEST_F(ReportHtml, LoadsNothingFromOutside) {
  EXPECT_THAT(*page_, Not(HasSubstr("http:")));
  EXPECT_THAT(*page_, Not(HasSubstr("https:")));
  EXPECT_THAT(*page_, Not(HasSubstr("@import")));
  static const std::regex reference(R"re((?:href|src)\s*=\s*["'](.{0,12}))re");
  int references = 0;
  for (std::sregex_iterator i(page_->begin(), page_->end(), reference), end; i != end; ++i, ++references) {
    const std::string target = (*i)[1];
    // Inside the page, or a file of the run that the reader may open.
    EXPECT_TRUE(target.rfind("#", 0) == 0 || target.rfind("data:image/", 0) == 0 || target.rfind("./images/", 0) == 0 ||
                target.rfind("./psf/", 0) == 0)
        << target;
  }
  EXPECT_GT(references, 10);
}

TEST_F(ReportHtml, ShowsEveryGateFailuresFirst) {
  std::size_t failed = page_->find("<code>matrix_equals_conoid</code>"),
              passed = page_->find("<code>conoid_reference</code>"),
              must_fail = page_->find("<code>mirrored_axis_fails</code>");
  ASSERT_NE(failed, std::string::npos);
  EXPECT_LT(failed, passed);
  EXPECT_LT(passed, must_fail);
  for (const Json& gate : (*report_)["gates"])
    EXPECT_THAT(*page_, HasSubstr("<code>" + gate["id"].get<std::string>() + "</code>"));
}

TEST_F(ReportHtml, ComesInReadingOrder) {
  std::size_t last = 0;
  for (const char* id : {"verdict", "gates", "sin2", "psfs", "images", "ellipses", "provenance"}) {
    const std::size_t at = page_->find(std::string("id=\"") + id + "\"");
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_GT(at, last) << id;
    last = at;
  }
}

TEST_F(ReportHtml, DrawsBothEllipsesOverEachPointSpreadFunction) {
  // AXIS 30 in the examiner's frame is the meridian 150° of the wearer; the larger error lies across it, at +60°, and y
  // is down here.
  EXPECT_THAT(*page_,
              HasSubstr("<ellipse class=\"predicted\" cx=\"48\" cy=\"48\" rx=\"30\" "));  // 96 px are 3.2 semi-axes
  EXPECT_THAT(*page_, HasSubstr("transform=\"rotate(-60 48 48)\""));
  EXPECT_THAT(*page_, HasSubstr("<ellipse class=\"measured\""));
}

TEST_F(ReportHtml, HoldsPicturesAndPlots) {
  const auto count = [&](const std::string& what) {
    int n = 0;
    for (std::size_t at = page_->find(what); at != std::string::npos; at = page_->find(what, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("data:image/png;base64,iVBOR"), 4 + 2 * 3);  // PNG's signature
  EXPECT_EQ(count("<svg class=\"plot\""), 3);
  EXPECT_EQ(count("<details"), 1 + 5 + 1 + 7);  // the last: gates that say why their bound is where it is
}

TEST_F(ReportHtml, WorstCaseComesFirst) {
  Json report = *report_;
  report["ellipses"]["cases"][17]["rays"][4]["against_conoid"]["z_max"] = 98765.0;
  report["psfs"] = report["images"] = nullptr;
  const std::string page = render_report_html(report, folder_);
  const std::size_t table = page.find("Ellipses of power_matrix rays against the conoid");
  const std::size_t row = page.find("<tbody>", table);
  EXPECT_THAT(page.substr(row, 200), HasSubstr(report["ellipses"]["cases"][17]["id"].get<std::string>()));
}

TEST_F(ReportHtml, NeverShowsANumberThatIsNone) {
  Json report = *report_;
  report.erase("spec");  // JSON text, where "inf" and null are in their place
  const double nan = std::numeric_limits<double>::quiet_NaN();
  report["gates"][0]["value"] = nan;
  report["gates"][1]["uncertainty"] = nan;
  report["sin2"]["table"][0]["ratio_major"] = nan;
  report["ellipses"]["cases"][0]["rays"][4]["against_conoid"]["relative_frobenius"] = nan;
  report["psfs"][0]["measured"]["semi_axes_arcmin"] = {nan, nan};
  report["images"][0]["metrics"]["ssim_display"]["value"] = std::numeric_limits<double>::infinity();
  const std::string page = render_report_html(report, folder_);
  EXPECT_EQ(test::markup_defects(page), "");
  EXPECT_FALSE(std::regex_search(
      visible_text(page), std::regex(R"(\b(nan|inf|null)\b(?!\|))", std::regex::icase)));  // "|inf|" is part of an id
}

TEST_F(ReportHtml, EscapesHostileTexts) {
  Json report = *report_;
  const std::string script = "<script>alert(1)</script>", attribute = "\" onload='x' ><img src=x>";
  report["title"] = script;
  report["verdict"]["sentence"] = script;
  report["gates"][0]["id"] = script;
  report["gates"][1]["worst_case"] = attribute;
  report["psfs"][0]["id"] = script;
  report["psfs"][0]["ray_model"] = attribute;
  report["images"][0]["id"] = attribute;
  report["images"][0]["files"]["predicted"] = script + ".exr";
  report["ellipses"]["cases"][0]["id"] = script;
  report["ellipses"]["cases"][0]["rays"][0]["ray_model"] = attribute;
  report["provenance"]["flags"] = script;
  report["provenance"][script] = attribute;
  report["spec"][script] = attribute;
  report["reference"]["max_relative_error"][script] = 1.0;
  const std::string page = render_report_html(report, folder_);
  EXPECT_EQ(test::markup_defects(page), "");
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(page, HasSubstr("<code>&lt;script&gt;alert(1)&lt;/script&gt;</code>"));
}

TEST_F(ReportHtml, SectionsAreOptional) {
  EXPECT_EQ(test::markup_defects(render_report_html(Json::object(), folder_)), "");
  Json small = *report_;  // few cases and pictures, and plots only where they matter: the page is drawn 50 times
  for (Json* list : {&small["ellipses"]["cases"], &small["sin2"]["table"], &small["psfs"], &small["images"]})
    list->erase(list->begin() + 1, list->end());
  for (const auto& [key, value] : small.items()) {
    Json report = small;
    const bool plotted = key == "ellipses" || key == "sin2";
    if (!plotted) report["ellipses"] = report["sin2"] = nullptr;
    if (key != "images") report["images"] = nullptr;  // whose maps take longest
    report.erase(key);
    EXPECT_EQ(test::markup_defects(render_report_html(report, folder_)), "") << key;
    for (const Json& foreign : {Json("text"), Json(3), Json::array({1, "x", nullptr}), Json{{"cases", {1, 2}}}}) {
      report[key] = foreign;
      EXPECT_EQ(test::markup_defects(render_report_html(report, folder_)), "") << key << " = " << foreign;
    }
  }
}

TEST_F(ReportHtml, MissingAndBrokenPicturesLeaveANote) {
  Json report = *report_;
  report["psfs"][0]["file"] = "psf/gone.exr";
  std::ofstream(folder_ / "broken.exr") << "not an EXR";
  report["images"][0]["files"]["path_traced"] = "broken.exr";
  const std::string page = render_report_html(report, folder_);
  EXPECT_EQ(test::markup_defects(page), "");
  EXPECT_THAT(page, HasSubstr("No picture: "));
  EXPECT_THAT(page, HasSubstr("gone.exr"));
  EXPECT_THAT(page, HasSubstr("No pictures: "));
}

TEST_F(ReportHtml, SlowStaysSmallWithLargeNoisyImages) {
  Image noise(700, 700, 3);
  unsigned state = 1;
  for (float& value : noise.pixels)
    value = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0f;
  LayeredImage file;
  file.layers[""] = noise;
  write_exr(folder_ / "noise.exr", file);
  Json report = {{"images", Json::array()}};
  for (int i = 0; i < 3; ++i)
    report["images"].push_back({{"id", "n"}, {"files", {{"path_traced", "noise.exr"}, {"predicted", "noise.exr"}}}});
  const std::string page = render_report_html(report, folder_);
  // Stills: see below. Viewer: 3 × (2 × 3 + 7) numbers of 2 bytes in base64 for 700² pixels are 51 MB, over 9 after
  // shrinking to a third 5.7.
  EXPECT_LT(page.size(), 12'000'000u);
  EXPECT_THAT(
      page, HasSubstr("shown at 1/2 of its size"));  // 9 pictures of 700² px at 4 bytes: 17.6 MB, 4.4 MB after halving
}

TEST_F(ReportHtml, AllCasesStandInOneTableFailuresFirst) {
  const std::size_t table = page_->find("All cases, failures first");
  ASSERT_NE(table, std::string::npos);
  const std::string rows =
      page_->substr(page_->find("<tbody>", table), page_->find("</tbody>", table) - page_->find("<tbody>", table));
  std::size_t rays = 0, count = 0;
  for (const Json& item : (*report_)["ellipses"]["cases"]) rays += item["rays"].size();
  for (std::size_t at = rows.find("<tr"); at != std::string::npos; at = rows.find("<tr", at + 1)) ++count;
  EXPECT_EQ(count, rays + (*report_)["psfs"].size() + (*report_)["images"].size());
  // The failing report's gate matrix_equals_conoid names the case that decided.
  std::string worst;
  for (const Json& gate : (*report_)["gates"])
    if (gate["id"] == "matrix_equals_conoid") worst = gate["worst_case"];
  EXPECT_EQ(rows.find("data-status=\"failed\""), rows.find("data-status="));
  EXPECT_THAT(rows.substr(0, rows.find("</tr>")), HasSubstr(escaped(worst)));
}

TEST(Gnuplot, ComplaintsAreFailures) {
  EXPECT_THROW(gnuplot_svg("plot no_such_function(x)", {.id = "a", .label = "b"}), RuntimeFailure);
}

TEST(Gnuplot, MissingProgramIsAClearFailure) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  std::string message;
  try {
    gnuplot_svg("plot x", {.id = "a", .label = "b"});
  } catch (const RuntimeFailure& failure) {
    message = failure.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(message, HasSubstr("gnuplot"));
  EXPECT_THAT(message, HasSubstr("cannot be started"));
}

}  // namespace
}  // namespace sturm

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "compare/findings/gate_statistics.h"
#include "compare/findings/judged_report.h"
#include "compare/studies/lens/lens_study_errors.h"
#include "compare/studies/lens/synthetic_lens_study.h"
#include "io/json/schema.h"
#include "io/specs/experiment/gate_spec.h"
#include "reports/fixture_report.h"
#include "reports/markup/markup_defects.h"
#include "reports/page/run_page.h"
#include "reports/plots/figure.h"
#include "reports/plots/lens_study_figures.h"
#include "reports/text/lens_study_csv.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

Json mutation(const char* id) {
  const Json caught = {{"gate", "order_of_absolute_error"}, {"value", 1.9}, {"bound", 0.05}};
  return {{"id", id}, {"what", "by hand"}, {"caught_by", Json::array({caught})}};
}

Json healthy() {
  return {{"lens_study", test::synthetic_lens_study()},
          {"gate_power", {{"mutations", Json::array({mutation("published_as_exact"), mutation("mirrored_gaze")})}}}};
}

std::vector<std::string> failures_of(const Json& report) {
  static const std::string file = STURM_SOURCE_DIR "/configs/gates/conoid_accuracy.json";
  std::vector<std::string> failed;
  for (const GateResult& gate : evaluate_gates(read_gates(load_json(file), file), report, nullptr))
    if (!gate.has_passed()) failed.push_back(gate.id);
  return failed;
}

TEST(LensStudyStatistics, ByHand) {
  const auto s = statistics_of(healthy());
  EXPECT_NEAR(*s.at("lens_order_max_deviation").value, 0.01, 1e-12);
  EXPECT_EQ(s.at("lens_order_max_deviation").cases, 2u);  // the oblique views
  EXPECT_EQ(s.at("lens_order_max_deviation").worst_case, "toric|20° 0°|0.5 m");
  EXPECT_NEAR(*s.at("lens_relative_order_max_deviation").value, 0.01, 1e-12);
  EXPECT_EQ(s.at("lens_limit_max_relative").cases, 4u);  // of analytic surfaces
  EXPECT_EQ(s.at("lens_spline_relative_order_min").value, 1.1);
  EXPECT_EQ(s.at("lens_published_revolution_max_D").value, 2e-14);
  EXPECT_EQ(s.at("lens_published_min_of_largest_D").value, 0.2);  // the toric lens alone
  EXPECT_EQ(s.at("lens_published_min_of_largest_D").cases, 1u);
  EXPECT_EQ(s.at("lens_previous_min_of_largest_D").value, 0.4);
  EXPECT_EQ(s.at("lens_previous_unscaled_max").value, 2e-14);
}

TEST(LensStudyGates, PassAHealthyStudy) {
  EXPECT_THAT(failures_of(healthy()), ::testing::IsEmpty());
}

struct Spoilt {
  const char *pointer, *gate;
  Json value;
};

class EachLensGate : public ::testing::TestWithParam<Spoilt> {};

TEST_P(EachLensGate, RejectsTheStudyThatItIsMadeFor) {
  Json report = healthy();
  report.at(Json::json_pointer(GetParam().pointer)) = GetParam().value;
  EXPECT_THAT(failures_of(report), ::testing::ElementsAre(GetParam().gate));
}

INSTANTIATE_TEST_SUITE_P(
    LensStudy, EachLensGate,
    ::testing::Values(
        Spoilt{"/lens_study/views/1/order", "order_of_absolute_error", 3.94},
        Spoilt{"/lens_study/views/1/order", "order_of_absolute_error", nullptr},
        Spoilt{"/lens_study/views/3/relative_order", "order_of_relative_error", 2.06},
        Spoilt{"/lens_study/views/0/limit_relative", "real_rays_tend_to_first_order", 1e-4},
        Spoilt{"/lens_study/views/1/first_order/published/defocus_D", "published_is_told_apart", 0.01},
        Spoilt{"/lens_study/views/3/first_order/published/defocus_D", "published_is_exact_without_cylinder", 1e-6},
        Spoilt{"/lens_study/views/2/first_order/published", "published_is_exact_without_cylinder", nullptr},
        Spoilt{"/lens_study/views/0/previous_unscaled_error", "previous_is_exact_inside", 1e-6},
        Spoilt{"/gate_power/mutations/0/caught_by", "every_mutation_is_noticed", Json::array()},
        Spoilt{"/gate_power/mutations/1/caught_by", "every_mutation_is_noticed", Json::array()}),
    [](const auto& each) { return std::string(each.param.gate) + "_" + std::to_string(each.index); });

TEST(LensStudyGates, PreviousMustDifferThroughEveryLens) {
  Json report = healthy();
  for (const int view : {2, 3}) report["lens_study"]["views"][view]["first_order"]["previous"]["defocus_D"] = 0.001;
  EXPECT_THAT(failures_of(report), ::testing::ElementsAre("previous_is_told_apart"));
}

TEST(LensStudyGates, AMutantStudyOfOrderTwoFails) {
  // As if the footprints had a wrong first order: everything that looks at orders must say so.
  Json report = healthy();
  for (Json& view : report["lens_study"]["views"]) {
    view["order"] = 2.0;
    view["relative_order"] = 0.0;
    view["limit_relative"] = 0.02;
  }
  EXPECT_THAT(failures_of(report),
              ::testing::ElementsAre("order_of_absolute_error", "order_of_relative_error",
                                     "real_rays_tend_to_first_order", "real_rays_tend_to_first_order_through_splines"));
}

TEST(LensStudyErrors, TakesTheWorstOfDirectionsAndDistances) {
  Json section = test::synthetic_lens_study();
  Json other = test::study_view("toric", 20.0, 0.7);
  other["direction_deg"] = 90.0;
  section["views"].push_back(other);
  const LensStudyErrors errors(*lens_findings({{"lens_study", section}}));
  EXPECT_THAT(errors.eccentricities_deg(), ::testing::ElementsAre(0.0, 20.0));
  EXPECT_THAT(errors.pupils_mm(), ::testing::ElementsAre(1.0, 6.0));
  const WorstError worst = errors.at("toric", "published", 20.0, 6.0);
  EXPECT_EQ(worst.defocus_D, 0.7);
  EXPECT_EQ(worst.defocus_view, "toric|20° 90°|0.5 m");
  EXPECT_NEAR(*worst.half_width_arcmin, 0.7 * 3.0 * 3.4377467707849396, 1e-12);
  EXPECT_EQ(errors.at("toric", "published", 0.0, 6.0).without, 1);
  EXPECT_FALSE(errors.at("toric", "published", 0.0, 6.0).defocus_D);
  EXPECT_EQ(errors.over_gazes("toric", "published", 6.0).without, 1);
  EXPECT_NEAR(*errors.over_gazes("round", "ray_transfer", 6.0).defocus_D, 0.036, 1e-12);
}

class LensStudyReport : public ::testing::Test {
 protected:
  LensStudyReport() : folder_(fs::path(::testing::TempDir()) / ("sturm_lens_study_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_ / "figures");
    report_ = test::synthetic_report();
    for (const char* part : {"ellipses", "sin2", "psfs", "images"}) report_.erase(part);
    report_["lens_study"] = test::synthetic_lens_study();
    report_["verdict"]["lens_sentence"] = "Ray transfer is exact first order.";
    for (const Figure& figure : lens_study_figures(*lens_findings(report_))) add(figure);
  }
  ~LensStudyReport() override { fs::remove_all(folder_); }

  void add(const Figure& figure) {
    std::ofstream(folder_ / figure_file(figure.id)) << figure.svg;
    report_["figures"].push_back(figure_json(figure));
  }
  std::string page() const { return render_report_html(report_, folder_); }

  fs::path folder_;
  Json report_;
};

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST_F(LensStudyReport, FollowsTheSchemaAndIsWellFormed) {
  EXPECT_NO_THROW(validate(report_, "report", "synthetic"));
  EXPECT_EQ(test::markup_defects(page()), "");
  EXPECT_THAT(page(), Not(HasSubstr("http:")));
}

TEST_F(LensStudyReport, SaysFromWhichGazeOnAnErrorMatters) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("Ray transfer is exact first order."));
  // toric, published: 0.2 D at 20° with both pupils; ray transfer: 0.001 D at 1 mm, 0.036 D at 6 mm.
  const std::size_t table = html.find("Smallest gaze angle at which the error is above 0.05 D, by pupil");
  ASSERT_NE(table, std::string::npos);
  const std::string rows = html.substr(table, html.find("</table>", table) - table);
  static const std::regex published(
      R"(toric</th><td>as published \(eq\. 11\)</td><td class="n" data-order="20">20°</td><td class="n" data-order="20">20°</td>)");
  static const std::regex transfer(
      R"(toric</th><td>ray transfer</td><td class="n" data-order="999">never</td><td class="n" data-order="999">never</td>)");
  EXPECT_TRUE(std::regex_search(rows, published)) << rows;
  EXPECT_TRUE(std::regex_search(rows, transfer)) << rows;
}

TEST_F(LensStudyReport, CountsTheFailuresOfEquation11) {
  const std::string html = page();
  const std::size_t table = html.find("<caption>Where conoid tracing as published has no ellipse");
  const std::string rows = html.substr(html.find("<tbody>", table), 1200);
  static const std::regex ahead(
      R"(>0°</th><td class="n">2</td><td class="n">0</td><td class="n">1</td><td class="n">0</td><td class="n">0</td><td class="n">0</td><td class="n">1</td>)");
  static const std::regex aside(
      R"(>20°</th><td class="n">3</td><td class="n">0</td>(<td class="n">0</td>){4}<td class="n">0</td><td class="n">0</td><td class="n">1</td><td class="n">0</td>)");
  EXPECT_TRUE(std::regex_search(rows, ahead)) << rows;
  EXPECT_TRUE(std::regex_search(rows, aside)) << rows;
}

TEST_F(LensStudyReport, HoldsEveryFigureAndNamesItsFile) {
  const std::string html = page();
  for (const char* id : {"lens_study_convergence", "lens_study_field", "lens_study_field_ellipses",
                         "lens_study_heat_toric", "lens_study_heat_round"})
    EXPECT_THAT(html, HasSubstr(figure_file(id)));
  EXPECT_EQ(count(html, "src=\"data:image/svg+xml;base64,"), 6);
  EXPECT_THAT(html, Not(HasSubstr("<section id=\"figures\"")));  // all belong to the study
}

TEST_F(LensStudyReport, DrawsEllipsesTheRightWayUp) {
  const auto figures = lens_study_figures(*lens_findings(report_));
  EXPECT_THAT(figures[2].svg, HasSubstr("rotate(-30 "));  // +30° of the wearer frame with y down
  EXPECT_EQ(count(figures[2].svg, "<ellipse"),
            3 * 3 + 11);  // real rays behind three methods; 12 outlines but for one that is missing
  EXPECT_THAT(figures[3].svg, HasSubstr(">0.20<"));  // the heat map's number
}

TEST_F(LensStudyReport, ASectionWithoutNumbersIsDrawnToo) {
  report_["lens_study"]["views"] = Json::array();
  report_["lens_study"]["field"] = nullptr;
  EXPECT_EQ(test::markup_defects(page()), "");
  EXPECT_NO_THROW(lens_study_figures(*lens_findings(report_)));
}

TEST_F(LensStudyReport, CsvHasOneLinePerViewPupilAndMethod) {
  Json section = report_["lens_study"];
  Json lost = test::study_gaze("round", 45.0, "ok", "ok");
  lost["status"] = "missed_lens";
  lost["eq11"] = nullptr;
  section["gazes"].push_back(lost);
  const std::string csv = lens_study_csv(*lens_findings({{"lens_study", section}}));
  EXPECT_EQ(count(csv, "\r\n"), 1 + 5 * 2 * 3 + 1);
  const std::size_t columns = count(csv.substr(0, csv.find("\r\n")), ",");
  for (std::size_t at = 0; at < csv.size(); at = csv.find("\r\n", at) + 2)
    EXPECT_EQ(count(csv.substr(at, csv.find("\r\n", at) - at), ","), static_cast<int>(columns));
  EXPECT_THAT(csv, HasSubstr("toric,20,0,0.5,2,1,4.01,1.99,1e-06,2e-14,ok,6,0,20.4,10.2,published,0.1,0.2,0.1,"));
  EXPECT_THAT(
      csv,
      HasSubstr(
          "toric,0,,0.5,2,1,4.01,1.99,1e-06,2e-14,ok,6,0,20.4,10.2,published,,,,,,,\r\n"));  // no ellipse, no numbers
  EXPECT_THAT(csv, HasSubstr("round,45,0,,,,,,,,missed_lens,,"));
}

class GivenFigures : public LensStudyReport {};

TEST_F(GivenFigures, StandInTheirOwnSection) {
  add({.id = "map",
       .section = "",
       .title = "Power map",
       .caption = "As worn.",
       .command = "sturm map lens.json",
       .svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\"><script>alert(1)</script></svg>"});
  const std::string html = page();
  const std::size_t section = html.find("<section id=\"figures\"");
  ASSERT_NE(section, std::string::npos);
  const std::string figures = html.substr(section, html.find("</section>", section) - section);
  EXPECT_THAT(figures, HasSubstr("Power map"));
  EXPECT_THAT(figures, HasSubstr("<code>sturm map lens.json</code>"));
  EXPECT_THAT(figures, HasSubstr("<code>figures/map.svg</code>"));
  EXPECT_THAT(html, Not(HasSubstr("alert(1)")));  // what a file contains stays in the picture
  EXPECT_EQ(test::markup_defects(html), "");
}

TEST_F(GivenFigures, ALostFileLeavesANote) {
  add({.id = "gone", .section = "", .title = "Gone", .caption = "", .command = "", .svg = "no picture"});
  EXPECT_THAT(page(), HasSubstr("figures/gone.svg is not an SVG file"));
  fs::remove(folder_ / "figures/gone.svg");
  EXPECT_THAT(page(), HasSubstr("figures/gone.svg is not there"));
}

TEST(SvgFile, NeedsItsNamespace) {
  EXPECT_TRUE(is_svg_file("<?xml version='1.0'?><svg width='1' xmlns='http://www.w3.org/2000/svg'></svg>"));
  EXPECT_FALSE(is_svg_file("<svg width='1'></svg>"));
  EXPECT_FALSE(is_svg_file("<svg xmlns='http://www.w3.org/2000/svg'>"));
  EXPECT_FALSE(is_svg_file("<html xmlns='http://www.w3.org/2000/svg'></html>"));
  EXPECT_FALSE(is_svg_file(""));
}

}  // namespace
}  // namespace sturm

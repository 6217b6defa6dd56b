#include "report.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "report_axis.hpp"
#include "report_page.hpp"
#include "space/tests/temporary_file.hpp"
#include "thinning.hpp"

namespace vectrix::cli::report_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t without_data = 1'500'000, with_a_million = 5'000'000;  // bytes

Report::Plot plot(std::vector<double> values) {
  Report::Plot plot{"P", "deg", "Body", {}, {{"x", std::move(values)}}};
  for (std::size_t i = 0; i < plot.curves[0].values.size(); ++i)
    plot.seconds.push_back(0.5 * static_cast<double>(i));
  return plot;
}
Report::Scene scene(std::size_t count) {
  Report::Scene scene{.body = "Body", .reference = "GCRF", .seconds = {}, .reference_from_body = {}};
  for (std::size_t i = 0; i < count; ++i) {
    scene.seconds.push_back(static_cast<double>(i));
    scene.reference_from_body.push_back(Eigen::Quaterniond::Identity());
  }
  return scene;
}
Report report(std::vector<Report::Plot> plots = {}) {
  Report report{.title = "T", .start = Epoch::from_utc("2026-11-29T00:00:00"), .version = "0"};
  report.plots = std::move(plots);
  return report;
}
Report report(Report::Scene scene) {
  Report all = report();
  all.scene = std::move(scene);
  return all;
}
// A page is too long to be shown.
::testing::AssertionResult holds(const std::string& page, const std::string& words) {
  if (page.find(words) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << words << "' is not in the page";
}
std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

RC_GTEST_PROP(Report, HoldsTheNumbersThatItWasGiven, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 50);
  const double middle = 1e-3 * *rc::gen::inRange(-10'000'000, 10'000'000);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(middle + 1e-6 * *rc::gen::inRange(-1'000'000, 1'000'000));
  const auto given = plot(values);
  const std::string page = html(report({given}));
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  // Half a unit of the last of 24 bits, of a number that is less than 16 ranges from its offset; and of 53.
  const double size = std::max(std::abs(*smallest), std::abs(*largest));
  const double rounding =
      std::ldexp(std::min(size, 16.0 * (*largest - *smallest)), -24) + std::ldexp(size, -52);
  const auto held = page_values(page, "x");
  RC_ASSERT(page_times(page, "P") == given.seconds);
  RC_ASSERT(held.size() == count);
  for (std::size_t i = 0; i < count; ++i) RC_ASSERT(std::abs(held[i] - values[i]) <= rounding);
}

TEST(Report, HoldsGapsAsGaps) {
  const std::string page = html(report({plot({1.0, nan, 3.0, 4.0})}));
  const auto held = page_values(page, "x");
  EXPECT_EQ(held[0], 1.0);
  EXPECT_TRUE(std::isnan(held[1]));
  EXPECT_EQ(held[3], 4.0);
  EXPECT_EQ(count_of(page, "<polyline class=\"curve c0\""), 2U);  // of the drawing
}

TEST(Report, HoldsTheSceneInTheOrderOfItsCoordinates) {
  Report::Scene given = scene(2);
  given.reference_from_body[1] = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
  given.directions = {{"Sun", {{1.0, 0.0, 0.0}, {nan, nan, nan}}}};
  given.views = {{"LVLH", {Eigen::Quaterniond(0.0, 0.0, 0.6, 0.8), Eigen::Quaterniond::Identity()}}};
  given.positions = {{0.0, 0.0, 2.0 * 6378137.0}, {6378137.0, 0.0, 0.0}};
  const std::string page = html(report(given));
  const auto floats = [&](const std::string& after, const std::string& key) {
    return numbers_of<float>(text_between(page, after, "\"" + key + "\":\"", "\""));
  };
  EXPECT_EQ(floats("\"body\"", "attitude"), (std::vector<float>{0, 0, 0, 1, -0.5F, 0.5F, -0.5F, 0.5F}));
  EXPECT_EQ(floats("\"views\"", "quaternions"), (std::vector<float>{0, 0.6F, 0.8F, 0, 0, 0, 0, 1}));
  const auto sun = floats("\"directions\"", "vectors");
  EXPECT_EQ(sun[0], 1.0F);
  EXPECT_TRUE(std::isnan(sun[3]));
  const auto limb = floats("\"body\"", "limb");  // asin(a / r)
  EXPECT_EQ(limb[2], -1.0F);
  EXPECT_NEAR(limb[3], std::numbers::pi / 6.0, 1e-7);
  EXPECT_NEAR(limb[7], std::numbers::pi / 2.0, 1e-7);
}

TEST(Report, KeepsTheExtremesOfManySamplesWithTheirTimes) {
  constexpr std::size_t count = 200'000, high = 123'457, low = 199'998;
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = std::sin(1.7 * static_cast<double>(i));
  values[low] = -3.0;
  values[high] = 5.0;
  const auto given = plot(values);
  const std::string page = html(report({given}));
  const auto times = page_times(page, "P"), held = page_values(page, "x");
  EXPECT_LT(held.size(), count);
  const auto top = std::max_element(held.begin(), held.end()),
             bottom = std::min_element(held.begin(), held.end());
  EXPECT_EQ(*top, 5.0);
  EXPECT_EQ(*bottom, -3.0);
  EXPECT_EQ(times[static_cast<std::size_t>(top - held.begin())], given.seconds[high]);
  EXPECT_EQ(times[static_cast<std::size_t>(bottom - held.begin())], given.seconds[low]);
  for (std::size_t k = 0; k < held.size(); ++k)  // what is kept are samples
    EXPECT_EQ(held[k],
              static_cast<double>(static_cast<float>(values[static_cast<std::size_t>(2.0 * times[k])])));
  EXPECT_TRUE(holds(page, detail::text(held.size()) + " of 200000 samples are kept"));
}

RC_GTEST_PROP(Thinning, KeepsTheExtremesOfEveryPartAndItsGaps, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 400), most = *rc::gen::inRange<std::size_t>(2, 200);
  std::vector<Report::Curve> curves(*rc::gen::inRange<std::size_t>(1, 4));
  for (auto& curve : curves)
    for (std::size_t i = 0; i < count; ++i) {
      const int value = *rc::gen::inRange(-10, 10);
      curve.values.push_back(value == -10 ? nan : value);
    }
  const auto kept = kept_samples(curves, most);
  RC_ASSERT(std::is_sorted(kept.begin(), kept.end(), std::less_equal<>()) || kept.size() == 1);
  RC_ASSERT(kept.front() == 0U);
  RC_ASSERT(kept.back() == count - 1);
  if (count <= most) {
    RC_ASSERT(kept.size() == count);
    return;
  }
  const std::size_t parts = std::max<std::size_t>(1, most / (2 * curves.size()));
  RC_ASSERT(kept.size() <= 2 + parts * 3 * curves.size());
  for (const auto& curve : curves)
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t from = part * count / parts, until = (part + 1) * count / parts;
      const auto summary = [&](const auto& places) {
        double low = infinity, high = -infinity;
        bool gap = false;
        for (const std::size_t i : places) {
          if (i < from || i >= until) continue;
          low = std::fmin(low, curve.values[i]);
          high = std::fmax(high, curve.values[i]);
          gap = gap || std::isnan(curve.values[i]);
        }
        return std::tuple(low, high, gap);
      };
      std::vector<std::size_t> all(count);
      std::iota(all.begin(), all.end(), std::size_t{0});
      RC_ASSERT(summary(kept) == summary(all));
    }
}

RC_GTEST_PROP(Thinning, PassesOverNoGap, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 400), most = *rc::gen::inRange<std::size_t>(4, 200);
  const auto gaps_of_100 = *rc::gen::inRange(0, 100);
  std::vector<bool> are_gaps;
  for (std::size_t i = 0; i < count; ++i) are_gaps.push_back(*rc::gen::inRange(0, 100) < gaps_of_100);
  const auto kept = even_samples(are_gaps, most);
  RC_ASSERT(kept.size() <= most);
  RC_ASSERT(kept.front() == 0U);
  RC_ASSERT(kept.back() == count - 1);
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    RC_ASSERT(kept[k] < kept[k + 1]);
    if (are_gaps[kept[k]] || are_gaps[kept[k + 1]]) continue;
    for (std::size_t i = kept[k]; i < kept[k + 1]; ++i) RC_ASSERT(!are_gaps[i]);
  }
}

TEST(Report, IsSmall) {
  EXPECT_LT(html(report()).size(), without_data);
  Report::Plot curves = plot(std::vector<double>(1'000'000, 1.0));
  for (std::size_t i = 0; i < curves.seconds.size(); ++i)
    curves.curves[0].values[i] = std::sin(static_cast<double>(i));
  curves.curves.push_back(curves.curves[0]);
  curves.curves[1].values[123'456] = nan;
  Report::Scene many = scene(1'000'000);
  many.directions = {{"Sun", std::vector<Eigen::Vector3d>(1'000'000, Eigen::Vector3d::UnitX())}};
  Report all = report(many);
  all.plots = {curves};
  const std::string page = html(all);
  EXPECT_LT(page.size(), with_a_million);
  EXPECT_GT(page.size(), with_a_million / 2);  // the room is used
}

TEST(Report, EscapesWhatFilesSay) {
  const std::string hostile = "</script><script>alert(\"1\")</script><!-- & \\ \x1b";
  Report all = report(scene(1));
  all.title = all.version = hostile;
  all.facts = {{hostile, hostile}};
  all.verdicts = {{hostile, hostile, hostile, hostile, false}};
  all.plots = {{hostile, hostile, hostile, {0.0}, {{hostile, {1.0}}}, {{1.0, hostile}}}};
  all.tables = {{hostile, {hostile}, {{hostile}}}};
  all.scene->body = all.scene->reference = hostile;
  all.scene->frames = {{hostile, Eigen::Quaterniond::Identity()}};
  all.scene->axes = {{hostile, Eigen::Vector3d::UnitX()}};
  all.scene->directions = {{hostile, {Eigen::Vector3d::UnitX()}}};
  all.scene->views = {{hostile, {Eigen::Quaterniond::Identity()}}};
  all.inputs = {{hostile, 1, hostile}};
  all.choices = {{hostile, hostile, hostile}};
  const std::string page = html(all);
  EXPECT_EQ(count_of(page, "<script"), 2U);  // the data and the program
  EXPECT_EQ(count_of(page, "</script"), 2U);
  EXPECT_EQ(count_of(page, "<!--"), 0U);
  EXPECT_EQ(count_of(page, "\x1b"), 0U);
  EXPECT_TRUE(holds(
      page,
      "<h1>&lt;/script&gt;&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&lt;!-- &amp; \\ \\x1b</h1>"));
  EXPECT_TRUE(
      holds(page, R"("title":"\u003c/script>\u003cscript>alert(\"1\")\u003c/script>\u003c!-- & \\ \\x1b")"));
}

TEST(Report, CanBeReadWithoutAScript) {
  Report all = report({plot({1.0, 2.0})});
  all.verdicts = {{"angle", "at most 1 deg", "0.5 deg", "0.5 deg", true},
                  {"rate", "at most 1 deg/s", "2 deg/s", "-1 deg/s", false}};
  all.tables = {{"Figures", {"what", "deg"}, {{"largest", "2"}}}};
  all.inputs = {{"a.csv", 12, "abc"}};
  all.choices = {{"scalar", "first", "--scalar"}};
  std::string page = html(all);
  page.resize(page.find("<script"));
  for (const char* words :
       {"1 of 2 requirements fulfilled", "<td class=\"good\">\u2713 fulfilled</td><td>angle</td>",
        "<td class=\"bad\">\u2717 not fulfilled</td><td>rate</td>", "<td>largest</td><td>2</td>",
        "<td>a.csv</td><td>12</td><td>abc</td>", "<td>scalar</td><td>first</td><td>--scalar</td>",
        "<b>P, in the axes of Body, deg</b>", "s since 2026-11-29T00:00:00.000000 UTC",
        "<polyline class=\"curve c0\"", "Copyright (c) 2022 Leon Sorokin"})
    EXPECT_TRUE(holds(page, words));
}

TEST(Report, DrawsWhatStandsOut) {
  std::vector<double> values(100'000, 0.0);
  values[50'000] = 1.0;
  auto given = plot(values);
  given.limits = {{-1.0, "least"}};
  const std::string page = html(report({given}));
  const auto line = text_between(page, "class=\"still\"", "<polyline class=\"curve c0\" points=\"", "\"");
  // From -1 to 1 with a margin of 5 %, on 168 pixels below 10.
  EXPECT_TRUE(holds(line, ",17.6 "));
  EXPECT_TRUE(holds(line, ",94.0 "));
  EXPECT_TRUE(holds(page, "<line class=\"limit\" x1=\"72.0\" y1=\"170.4\""));
}

TEST(Report, DrawsTheSceneAsItIsSeenFromTheReference) {
  Report::Scene given = scene(1);
  given.reference_from_body = {
      Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ()))};
  const std::string page = html(report(given));
  // From the azimuth -55 deg and the elevation 22 deg: x is 170 sin 55 deg to the right and 170 sin 22 deg
  // cos 55 deg below the middle of 480. The y of the body, 0.8 as long, is opposite.
  EXPECT_TRUE(
      holds(page, "<line class=\"arrow reference x\" x1=\"240.0\" y1=\"240.0\" x2=\"379.3\" y2=\"276.5\">"));
  EXPECT_TRUE(
      holds(page, "<line class=\"arrow body y\" x1=\"240.0\" y1=\"240.0\" x2=\"128.6\" y2=\"210.8\">"));
}

TEST(Report, SaysWhenItsTimesAre) {
  Report::Plot early = plot({1.0, 2.0});
  EXPECT_TRUE(holds(html(report({early})),
                    "<p>From 2026-11-29T00:00:00.000000 UTC to 2026-11-29T00:00:00.500000 UTC, 0.5 s</p>"));
  early.seconds = {-60.0, 0.0};
  Report all = report(scene(2));
  all.plots = {early};
  all.scene->seconds = {1.0, 2.0};
  const std::string page = html(all);
  EXPECT_TRUE(holds(page,
                    "<p>Time 0 is 2026-11-29T00:00:00.000000 UTC. From 2026-11-28T23:59:00.000000 UTC to "
                    "2026-11-29T00:00:02.000000 UTC, 62 s</p>"));
  EXPECT_TRUE(holds(page, "the drawing is of the first time, 2026-11-29T00:00:01.000000 UTC."));
}

TEST(Report, WritesDifferentNumbersAtDifferentTicks) {
  const std::string page = html(report({plot({6838121.0, 6838125.0})}));
  for (const char* tick : {">6838121</text>", ">6838122</text>", ">6838125</text>"})
    EXPECT_TRUE(holds(page, tick));
  EXPECT_TRUE(holds(html(report({plot({1e-9, 4e-9})})), ">3e-09</text>"));
}

TEST(Report, DrawsASampleBetweenGaps) {
  const std::string page = html(report({plot({nan, 1.0, nan})}));
  const auto points = text_between(page, "class=\"still\"", "<polyline class=\"curve c0\" points=\"", "\"");
  EXPECT_EQ(points, "389.0,94.0 389.0,94.0");  // a line of no length: its round ends are a dot
}

RC_GTEST_PROP(Ticks, AreEvenAndWithinTheAxis, ()) {
  const double from = *rc::gen::inRange(-1'000'000, 1'000'000) * 1e3;
  const double span = std::pow(10.0, 0.1 * *rc::gen::inRange(-70, 100));
  const int most = *rc::gen::inRange(2, 12);
  const auto found = ticks(from, from + span, most);
  const double rounding = 1e-9 * span + 4e-16 * std::abs(from);
  RC_ASSERT(!found.values.empty() || most < 3);
  RC_ASSERT(found.values.size() <= static_cast<std::size_t>(most) + 1);
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    RC_ASSERT(found.values[i] >= from - rounding);
    RC_ASSERT(found.values[i] <= from + span + rounding);
    if (i < 2) continue;
    const double step = found.values[1] - found.values[0];
    RC_ASSERT(std::abs(found.values[i] - found.values[i - 1] - step) <= 4.0 * rounding);
  }
}

RC_GTEST_PROP(TextPlaces, DoNotCoverEachOtherAndKeepTheOrderOfTheirLines, ()) {
  std::vector<double> lines(*rc::gen::inRange<std::size_t>(1, 8));
  for (double& line : lines) line = *rc::gen::inRange(10, 178);
  std::sort(lines.rbegin(), lines.rend());
  const auto places = text_places(lines, 10.0);
  RC_ASSERT(places.size() == lines.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    RC_ASSERT(places[i] >= 21.0);  // the text is 11 pixels high
    RC_ASSERT(i == 0 || places[i] <= places[i - 1] - 14.0);
    const double from_top = 21.0 + 14.0 * static_cast<double>(lines.size() - 1 - i);
    RC_ASSERT(places[i] <= std::max(lines[i] - 4.0, from_top));  // above its line, if there is room
    if (lines.size() == 1) RC_ASSERT(places[i] == std::max(lines[i] - 4.0, 21.0));
  }
}

TEST(Report, CutsTheGroundTrackAtTheDateLine) {
  Report::Scene given = scene(4);
  given.ground_track = {{0.0, 170.0}, {10.0, 179.0}, {20.0, -172.0}, {30.0, -163.0}};
  const std::string page = html(report(given));
  EXPECT_EQ(count_of(text_between(page, "class=\"track\"", ">", "</svg>"), "<polyline"), 2U);
}

TEST(Report, SaysUtcWhereItRunsEvenly) {
  const auto utc = [](const char* start) {
    Report all = report({plot({1.0, 2.0, 3.0})});
    all.start = Epoch::from(start);
    return text_between(html(all), "\"first\"", "\"utc\":", ",");
  };
  EXPECT_EQ(utc("2016-12-31T23:59:57.5 UTC"), "\"2016-12-31T23:59:57.500Z\"");
  EXPECT_EQ(utc("2016-12-31T23:59:59.5 UTC"), "null");  // ends in the leap second
  EXPECT_EQ(utc("2016-12-31T23:59:60.5 UTC"), "null");
  EXPECT_EQ(utc("2017-01-01T00:00:00 UTC"), "\"2017-01-01T00:00:00.000Z\"");
  EXPECT_EQ(utc("1950-01-01T00:00:00 TT"), "null");
}

TEST(Report, RefusesWhatItCannotShow) {
  const auto refusal = [](const std::function<void(Report&)>& change) {
    Report all = report({plot({1.0, 2.0})});
    all.scene = scene(2);
    all.scene->directions = {{"Sun", {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitX()}}};
    all.scene->views = {{"LVLH", {Eigen::Quaterniond::Identity(), Eigen::Quaterniond::Identity()}}};
    all.tables = {{"Figures", {"what", "deg"}, {{"largest", "2"}}}};
    EXPECT_NO_THROW((void)html(all));
    change(all);
    return complaint([&] { (void)html(all); });
  };
  EXPECT_EQ(refusal([](Report& r) { r.plots[0].seconds = {0.0}; }),
            "plot 'P', curve 'x' has 2 values for 1 times");
  EXPECT_EQ(refusal([](Report& r) {
              r.plots[0].seconds = {1.0, 1.0};
            }),
            "plot 'P': number 2 of the times is 1 s after 1 s; times have to increase");
  EXPECT_EQ(refusal([](Report& r) { r.plots[0].seconds[1] = nan; }),
            "plot 'P': number 2 of the times is nan");
  EXPECT_EQ(refusal([](Report& r) { r.plots[0].seconds.clear(); }), "plot 'P' has no times");
  EXPECT_EQ(refusal([](Report& r) { r.plots[0].curves.clear(); }), "plot 'P' has no curve");
  EXPECT_EQ(refusal([](Report& r) { r.plots[0].curves[0].values[1] = infinity; }),
            "plot 'P', curve 'x': number 2 is inf; at most 1e+37 can be shown");
  EXPECT_EQ(refusal([](Report& r) { r.plots[0].limits = {{nan, "most"}}; }), "plot 'P', limit 'most' is nan");
  EXPECT_EQ(refusal([](Report& r) { r.tables[0].rows[0].pop_back(); }),
            "table 'Figures': row 1 has 1 texts for 2 headings");
  EXPECT_EQ(refusal([](Report& r) { r.scene->reference_from_body.pop_back(); }),
            "attitude of Body has 1 values for 2 times");
  EXPECT_EQ(refusal([](Report& r) { r.scene->reference_from_body[1].w() = 2.0; }),
            "attitude of Body: number 2 has the norm 2, not 1");
  EXPECT_EQ(refusal([](Report& r) {
              r.scene->seconds = {1.0, 0.0};
            }),
            "the scene: number 2 of the times is 0 s after 1 s; times have to increase");
  EXPECT_EQ(refusal([](Report& r) {
              r.scene->frames = {{"Camera", Eigen::Quaterniond(nan, nan, nan, nan)}};
            }),
            "frame 'Camera' of the body has the norm nan, not 1");
  EXPECT_EQ(refusal([](Report& r) {
              r.scene->axes = {{"boresight", Eigen::Vector3d::Zero()}};
            }),
            "axis 'boresight' of the body has the norm 0, not 1");
  EXPECT_EQ(refusal([](Report& r) {
              r.scene->directions[0].vectors[1] = {0.0, nan, 1.0};
            }),
            "direction 'Sun': number 2 has the norm nan, not 1");
  EXPECT_EQ(refusal([](Report& r) { r.scene->directions[0].vectors.pop_back(); }),
            "direction 'Sun' has 1 values for 2 times");
  EXPECT_EQ(refusal([](Report& r) { r.scene->views[0].from_reference.pop_back(); }),
            "view 'LVLH' has 1 values for 2 times");
  EXPECT_EQ(refusal([](Report& r) { r.scene->positions = {Eigen::Vector3d::UnitX()}; }),
            "positions has 1 values for 2 times");
  EXPECT_EQ(refusal([](Report& r) {
              r.scene->ground_track = {{0.0, 0.0}, {0.0, 190.0}};
            }),
            "ground track: number 2 has latitude 0 and longitude 190 deg; they are within 90 and 180");
}

}  // namespace
}  // namespace vectrix::cli::report_test

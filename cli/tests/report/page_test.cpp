#include "report/report.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "page.hpp"
#include "small_report.hpp"

namespace vectrix::cli::page_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t without_data = 1'500'000, with_a_million = 5'000'000;  // bytes

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

}  // namespace
}  // namespace vectrix::cli::page_test

#include "report/axis.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "page.hpp"
#include "small_report.hpp"

namespace vectrix::cli::drawing_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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
    RC_ASSERT(places[i] >= 21.0);                             // the text is 11 pixels high
    if (i > 0) RC_ASSERT(places[i] <= places[i - 1] - 14.0);  // RC_ASSERT evaluates both sides of ||
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

}  // namespace
}  // namespace vectrix::cli::drawing_test

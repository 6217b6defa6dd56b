#include "report/report.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "small_report.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::refusals_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

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
}  // namespace vectrix::cli::refusals_test

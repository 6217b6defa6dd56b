#include "scenario/budget.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <random>
#include <sstream>

#include "angle_figures.hpp"
#include "figures.hpp"
#include "replayed.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::budget_test {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

constexpr const char* mounting = R"(
[[contribution]]
name = "mounting"
measures = ["off-Sun"]
in = "camera"
kind = "constant"
standard_deviations = "[3, 0.2, 0.1] deg"
)";
constexpr const char* camera = R"(
[[frame]]
name = "camera"
[frame.euler]
axes = [3, 1, 2]
angles = "[50, 60, 0] deg"
of = "camera"
relative_to = "body"
)";

class Contributions : public ::testing::Test, protected ScenarioFolder {
 protected:
  // Of the contribution with one part replaced, after the plain scenario of 18 lines and the camera.
  [[nodiscard]] std::string refused(const std::string& part, const std::string& other,
                                    const std::string& scenario = plain) const {
    return refusal(scenario + camera + with(mounting, part, other));
  }
};

TEST_F(Contributions, AreReadInTheirUnits) {
  const Scenario scenario = read(std::string(plain) + mounting + R"(
[[contribution]]
name = "noise"
measures = ["off-Sun"]
in = "body"
kind = "random"
correlation_time = "2 min"
[contribution.covariance]
rows = [[4, 1, 0], [1, 9, 0], [0, 0, 1]]
unit = "arcsec"
[[contribution]]
name = "gyro"
measures = ["off-Sun"]
in = "body"
kind = "drift"
known_rate = "[1, 2, 3] deg/h"
since_update = "1 h"
)");
  const auto source = [&](std::size_t i) { return scenario.contributions.at(i).error.sources().at(0); };
  constexpr double degree = 1.0 / degrees, arcsecond = degree / 3600.0, rounding = 1e-18;
  EXPECT_NEAR(source(0).covariance(1, 1), std::pow(0.2 * degree, 2), rounding);
  EXPECT_NEAR(source(1).covariance(0, 1), arcsecond * arcsecond, rounding);
  EXPECT_EQ(source(1).seconds, 120.0);
  EXPECT_NEAR((source(2).mean - Vector3d(1.0, 2.0, 3.0) * degree / 3600.0).norm(), 0.0, rounding);
  EXPECT_EQ(source(2).seconds, 3600.0);
  EXPECT_EQ(scenario.choices.back().value, "drift, in body, known_rate [1, 2, 3] deg/h, since_update 1 h");
}

TEST_F(Contributions, AreRefusedWhereTheyAreWrong) {
  EXPECT_EQ(refused("[\"off-Sun\"]", "[\"off-Sum\"]"),
            "FILE:30:12: there is no measure 'off-Sum'; the nearest is 'off-Sun'");
  EXPECT_EQ(refused("[\"off-Sun\"]", "[\"off-Sun\", \"off-Sun\"]"),
            "FILE:30:12: 'contribution.measures' names 'off-Sun' twice");
  EXPECT_EQ(refused("kind = \"constant\"", "kind = \"constnt\""),
            "FILE:32:8: 'contribution.kind' is 'constnt'; the nearest is 'constant'; needed: one of "
            "\"constant\", \"random\", \"drift\"");
  EXPECT_EQ(refused("[3, 0.2, 0.1] deg", "[3, 0.2] deg"),
            "FILE:33:24: 'contribution.standard_deviations' is '[3, 0.2] deg': 3 numbers in brackets are "
            "needed, as [1, 2, 3]");
  EXPECT_EQ(refused("0.2, 0.1] deg", "-0.2, 0.1] deg"),
            "FILE:33:23: 'contribution.standard_deviations' is [3, -0.2, 0.1] deg; each must be 0, or "
            "positive with a square that a number can hold");
  EXPECT_EQ(refused("0.1] deg", "0.1] deg/h"),
            "FILE:33:38: 'contribution.standard_deviations' is '[3, 0.2, 0.1] deg/h': 'deg/h' is a unit of a "
            "rate of turn; an angle takes: deg, rad, mrad, arcmin, arcsec, mas");
  EXPECT_EQ(refused("kind = \"constant\"", "kind = \"random\""),
            "FILE:28:1: 'contribution.correlation_time' is missing: a random error needs it");
  EXPECT_EQ(refused("kind = \"constant\"", "kind = \"constant\"\ncorrelation_time = \"1 s\""),
            "FILE:33:20: 'contribution.correlation_time' is not of a constant error");
  EXPECT_EQ(refused("kind = \"constant\"", "kind = \"drift\""),
            "FILE:33:23: 'contribution.standard_deviations' is not of a drift");
  EXPECT_EQ(refused("standard_deviations = \"[3, 0.2, 0.1] deg\"",
                    "covariance = { rows = [[1, 2, 0], [2, 1, 0], [0, 0, 1]], unit = \"deg\" }")
                .substr(0, 71),
            "FILE:33:23: 'contribution.covariance.rows': the principal variances (-0");
  EXPECT_EQ(refused("kind", "known = \"[1, 1, 1] deg\"\nkind"),
            "FILE:34:23: 'contribution.standard_deviations' and 'contribution.known' are both given; one is "
            "needed");
  EXPECT_EQ(refusal(std::string(plain) + mounting + mounting),
            "FILE:28:8: there are two contributions 'mounting'");
}

// A figure needs a percentage below 100, and a requirement that states it.
TEST_F(Contributions, AreRefusedIfTheirBudgetHasNoFigure) {
  const std::string whole = with(plain, "95 %", "100 %"), text = plain;
  EXPECT_EQ(refusal(whole + mounting),
            "FILE:15:1: a budget has no figure for 100 %: a normal distribution has no bound; at most "
            "99.999999 %");
  EXPECT_EQ(refusal(text.substr(0, text.find("[[require]]")) + mounting),
            "FILE:18:12: nothing is required of 'off-Sun'; missing: a [[require]] that says for how many "
            "percent the figures of its budget are");
  EXPECT_EQ(refusal("absolute = \"0.5 deg\"", "budget = \"absolute\""),
            "FILE:15:1: 'off-Sun' has no budget; missing: a [[contribution]] to it");
  const std::string drift =
      with(with(mounting, "constant", "drift\"\nsince_update = \"50 s"),
           "standard_deviations = \"[3, 0.2, 0.1] deg\"", "known_rate = \"[1, 1, 1] deg/h\"");
  EXPECT_EQ(
      refusal(with(plain, "absolute = \"0.5 deg\"", "relative = \"0.5 deg\"\nwindow = \"1 min\"") + drift),
      "FILE:26:16: 'contribution.since_update' is 50 s, shorter than the window of a requirement, 60 s, "
      "at " +
          file().string() + ":15:1");
}

TEST_F(Contributions, NameAFrameThatIsFixedInTheBody) {
  const auto said = [&](const std::string& text) {
    return complaint([&] { (void)read_flown_attitude(read(text)); }, file());
  };
  EXPECT_EQ(said(std::string(plain) + camera + mounting), "nothing was thrown");
  EXPECT_EQ(said(std::string(plain) + camera + with(mounting, "camera", "camra")),
            "FILE:31:6: there is no frame 'camra' fixed in the body; the nearest is 'camera'");
  EXPECT_EQ(said(std::string(plain) + mounting),
            "FILE:23:6: there is no frame 'camera' fixed in the body; there are: body");
}

// Turns of the camera about its x, which is across the axis of the radiometer, are large.
TEST(Budget, IsCarriedFromTheFrameInWhichAContributionArises) {
  const std::string text =
      with(example("ctim.toml"), "percent = \"99.7 %\"\nwhen", "percent = \"50 %\"\nwhen");
  const auto found = replayed(text + camera + mounting).budgets();
  ASSERT_EQ(found.size(), 3U);  // absolute; mean and relative
  const Replayed flown = replayed(text);
  const Vector3d n = flown.flight.flown.frames.in_body(flown.scenario.measures[0].axis);
  const Matrix3d R = (Eigen::AngleAxisd(50.0 / degrees, Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(60.0 / degrees, Vector3d::UnitX()))
                         .toRotationMatrix();
  // The quantile of drawn turns.
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  constexpr int draws = 100000;
  int within = 0;
  for (int i = 0; i < draws; ++i) {
    const Vector3d theta = R * Vector3d(3.0 * normal(random), 0.2 * normal(random), 0.1 * normal(random));
    within += n.cross(theta).norm() <= found[0].budget ? 1 : 0;
  }
  EXPECT_NEAR(1.0 * within / draws, 0.5, 4.0 * 0.5 / std::sqrt(1.0 * draws));
  EXPECT_EQ(found[0].what, "absolute error (APE), 50 % in sunlight");
  EXPECT_EQ(found[0].parts.at(0).alone, found[0].budget);
  EXPECT_EQ(found[0].parts.at(0).share, 1.0);
  EXPECT_EQ(found[2].budget, 0.0);  // in a window it does not change
  EXPECT_TRUE(says(found[2].remark, "the data exceed the budget by 0.0"));
}

// A flight that is drawn from its budget: the z axis of a body should look at the Sun, and is off by a
// constant turn about x and by Gauss-Markov processes about x and y.
struct DrawnFlight {
  static constexpr double deviation = 40.0, T = 30.0, off = 50.0;  // arcsec, s, arcsec
  static std::string table(int samples) {                          // 1 s apart
    std::vector<Epoch> times;
    for (int i = 0; i < samples; ++i)
      times.push_back(Epoch::from_utc("2026-11-29T00:00:00") + static_cast<double>(i) * si::second);
    const auto lines = lines_to(Target::sun, times, motions_at(times, nullptr, [] {}), geometric);
    std::mt19937_64 random(29);
    std::normal_distribution<double> normal;
    const double kept = std::exp(-1.0 / T), added = std::sqrt(1.0 - kept * kept);
    Vector3d e(deviation * normal(random), deviation * normal(random), 0.0);
    std::ostringstream out;
    out << "t,a,b,c,d\n" << std::setprecision(17);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Vector3d theta = (e + Vector3d(off, 0.0, 0.0)) / (3600.0 * degrees);
      const Eigen::Quaterniond q = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), lines[i]) *
                                   Eigen::AngleAxisd(theta.norm(), theta.normalized());
      out << times[i].utc(3) << ',' << q.x() << ',' << q.y() << ',' << q.z() << ',' << q.w() << '\n';
      e = kept * e + added * Vector3d(deviation * normal(random), deviation * normal(random), 0.0);
    }
    return out.str();
  }
  static std::string scenario() {
    return with(with(ScenarioFolder::plain, "a.csv", "drawn.csv"),
                "absolute = \"0.5 deg\"\npercent = \"95 %\"\n",
                "absolute = \"2 arcmin\"\npercent = \"90 %\"\n") +
           R"([[require]]
measure = "off-Sun"
relative = "2 arcmin"
window = "60 s"
percent = "90 %"
[[contribution]]
name = "shift"
measures = ["off-Sun"]
in = "body"
kind = "constant"
known = "[50, 0, 0] arcsec"
[[contribution]]
name = "control"
measures = ["off-Sun"]
in = "body"
kind = "random"
standard_deviations = "[40, 40, 0] arcsec"
correlation_time = "30 s"
)";
  }
};

class OfADrawnFlight : public ::testing::Test {
 protected:
  ~OfADrawnFlight() override { std::filesystem::remove(table_); }
  [[nodiscard]] Replayed flown(const std::string& text, int samples = 3000) const {
    std::ofstream(table_) << DrawnFlight::table(samples);
    return replayed(with(text, "drawn.csv", table_.string()));
  }

 private:
  std::filesystem::path table_ = temporary_path("_drawn.csv");
};

// 667 correlation times, and 327 windows: of each half as many are taken as independent.
TEST_F(OfADrawnFlight, TheDataAreAsTheBudgetSays) {
  const Replayed found = flown(DrawnFlight::scenario(), 20000);
  const auto budgets = found.budgets();
  ASSERT_EQ(budgets.size(), 3U);
  const double four_deviations = 4.0 * std::sqrt(0.9 * 0.1 / 160.0);
  const auto share_within = [](const std::vector<double>& errors, double figure) {
    const AngleFigures figures(errors);
    return static_cast<double>(figures.judge(figure, 90.0).within) / static_cast<double>(figures.size());
  };
  EXPECT_EQ(budgets[0].what, "absolute error (APE), 90 %");
  EXPECT_EQ(budgets[1].what, "mean error (MPE) in 60 s, 90 %");
  EXPECT_EQ(budgets[2].what, "relative error (RPE) in 60 s, 90 %");
  const auto& required = found.scenario.requirements;
  const auto windows = errors_in_windows(required[1], found.scenario, found.flight, found.measures[0]);
  EXPECT_EQ(windows.of_means.size(), 327U);
  EXPECT_NEAR(share_within(found.measures[0].angles, budgets[0].budget), 0.9, four_deviations);
  EXPECT_NEAR(share_within(windows.of_means, budgets[1].budget), 0.9, four_deviations);
  EXPECT_NEAR(share_within(windows.from_means, budgets[2].budget), 0.9, four_deviations);
  // The known one and the other explain the whole of the mean square.
  EXPECT_NEAR(budgets[0].parts[0].share + budgets[0].parts[1].share, 1.0, 1e-12);
  EXPECT_NEAR(budgets[0].parts[0].alone, 50.0 / 3600.0, 1e-9);
  const Report::Table table = found.report().tables.at(2);
  EXPECT_EQ(table.title, "Budget of off-Sun: absolute error (APE), 90 %, deg");
  EXPECT_EQ(table.rows.at(0), (std::vector<std::string>{"shift", "body", "constant", "0.013889", "43.86 %"}));
  EXPECT_EQ(table.rows.at(2).at(3), decimals(budgets[0].budget));
  EXPECT_EQ(table.rows.at(3).at(3), decimals(budgets[0].data));
}

// If it is asked for, a budget is the limit of a requirement: here one that was too small, and one that was
// not.
TEST_F(OfADrawnFlight, ABudgetMayBeRequired) {
  const std::string small = with(DrawnFlight::scenario(), "[40, 40, 0]", "[20, 20, 0]");
  const auto required = [&](const std::string& text) {
    return flown(with(with(text, "absolute = \"2 arcmin\"", "budget = \"absolute\""),
                      "relative = \"2 arcmin\"", "budget = \"relative\""));
  };
  const Replayed too_small = required(small), large = required(with(small, "[20, 20, 0]", "[60, 60, 0]"));
  EXPECT_FALSE(too_small.fulfilled(0));
  EXPECT_FALSE(too_small.fulfilled(1));
  EXPECT_TRUE(large.fulfilled(0));
  EXPECT_TRUE(large.fulfilled(1));
  EXPECT_EQ(large.judged[1].required,
            "relative error in 60 s at most that of the budget in 90 % of the samples");
  EXPECT_EQ(large.judged[1].reached.substr(0, 8), decimals(large.budgets()[2].data));
  const auto remarks = too_small.budgets();
  EXPECT_EQ(remarks[0].remark,
            "the data exceed the budget by " + decimals(remarks[0].data - remarks[0].budget) + " deg");
  EXPECT_EQ(large.budgets()[0].remark, "within the budget");
  const auto limits = large.report().plots.at(0).limits;  // of the absolute error alone
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_EQ(limits[0].value, large.budgets()[0].budget);
}

// One that is only shown leaves the verdict as it is.
TEST_F(OfADrawnFlight, ABudgetAloneIsNoRequirement) {
  const Replayed found = flown(with(DrawnFlight::scenario(), "[40, 40, 0]", "[1, 1, 0]"));
  EXPECT_TRUE(found.fulfilled(0));
  EXPECT_TRUE(says(found.budgets()[0].remark, "the data exceed the budget"));
  const Replayed large = flown(with(DrawnFlight::scenario(), "[40, 40, 0]", "[90, 90, 0]"));
  EXPECT_EQ(large.budgets()[0].remark, "within the budget; the budget exceeds what is required");
}

TEST_F(OfADrawnFlight, ABudgetThatIsNoSmallTurnIsRefused) {
  const Replayed found = flown(with(DrawnFlight::scenario(), "[40, 40, 0] arcsec", "[20, 20, 0] deg"));
  EXPECT_EQ(complaint([&] { (void)found.budgets(); }, found.folder->file("s.toml")),
            "FILE:15:1: the budget of this requirement: the half-angle is above 0.5 rad; the law "
            "is of small turns");
}

}  // namespace
}  // namespace vectrix::cli::budget_test

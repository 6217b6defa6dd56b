#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

#include "attitude_motion.hpp"
#include "circular_orbit.hpp"
#include "evidence.hpp"

namespace vectrix::cli::evidence_test {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;
using Eigen::Vector3d;

double any_angle(double largest) {
  return largest * 1e-3 * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1001));
}
// Neither along an axis nor slow: its rate differs in the axes of both frames, and turned to other axes.
AttitudeMotion any_motion() {
  const Vector3d axis =
      AttitudeMotion::turned({0.3 + any_angle(5.0), 1.0 + any_angle(2.0), 0.5}) * Vector3d::UnitX();
  const Vector3d other = AttitudeMotion::turned(any_angle(1.0) * axis) *
                         (Eigen::AngleAxisd(0.5 + any_angle(2.0), axis.unitOrthogonal()) * axis);
  return {0.03 * axis, 0.05 * other};
}
Convention any_convention() {
  return {*rc::gen::element(Scalar::first, Scalar::last),
          *rc::gen::element(Maps::to_body, Maps::to_reference)};
}
RateAxes any_axes() {
  return *rc::gen::element(RateAxes::body, RateAxes::reference);
}
std::size_t smallest(const std::vector<double>& values) {
  return static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
}

// The mean rate of both ends instead of the true turn, over 1 s: h^2/12 of d2w/dt2, a b^2 at most, and of
// w x dw/dt; a tenth for what follows.
constexpr double of_the_mean = 1.1 / 12.0 * (0.03 * 0.05 * 0.05 + 0.08 * 0.03 * 0.05);

RC_GTEST_PROP(Rates, TellTheReadingByWhichTheFileWasWritten, ()) {
  const Convention written = any_convention(), stated = any_convention();
  const RateAxes written_axes = any_axes(), stated_axes = any_axes();
  const auto record = any_motion().record(120, written, stated, written_axes, stated_axes);
  const auto found = compare_rates(record);
  const auto& right = written_axes == stated_axes ? found.stated_axes : found.other_axes;
  const auto& wrong = written_axes == stated_axes ? found.other_axes : found.stated_axes;
  const Reading& best = all_readings[smallest(right)];
  RC_ASSERT(best.transposed == (written.maps != stated.maps));
  RC_ASSERT(best.other_order == (written.scalar != stated.scalar));
  RC_ASSERT(right[smallest(right)] <= of_the_mean);
  RC_ASSERT(wrong[smallest(wrong)] > 3.0 * of_the_mean);
  auto all = found.stated_axes;
  all.insert(all.end(), found.other_axes.begin(), found.other_axes.end());
  const bool is_as_stated = !best.transposed && !best.other_order && written_axes == stated_axes;
  const std::size_t right_one = smallest(right) + (written_axes == stated_axes ? 0 : right.size());
  RC_ASSERT(fitting(all, 0.1 * found.rms_rate) == std::vector<std::size_t>{right_one});
  RC_ASSERT(is_as_stated == (right_one == 0));
}

// A spinner turns by more than half a turn from one sample to the next: the shortest way is the wrong one.
TEST(Rates, DecideForASpinnerSampledTooSeldom) {
  const AttitudeMotion spinner{{0.0, 0.0, 0.002}, {4.0, 0.0, 0.0}};
  const Convention written{Scalar::last, Maps::to_reference};
  const auto record = spinner.record(50, written, written, RateAxes::body, RateAxes::body);
  const auto found = compare_rates(record);
  // Of the part across, 0.002 rad/s, that turns by 4 rad in a step, neither the mean of both ends tells nor
  // the turn: twice that.
  EXPECT_LE(found.stated_axes[0], 0.004);
  EXPECT_GT(found.stated_axes[1], 1.0);
}

// Over a gap the mean of both ends is no rate.
TEST(Rates, AreNotComparedOverAGap) {
  const Convention written{Scalar::last, Maps::to_reference};
  const AttitudeMotion motion{{0.0, 0.03, 0.0}, {0.05, 0.0, 0.0}};
  AttitudeRecord record = motion.record(120, written, written, RateAxes::body, RateAxes::body);
  const auto cut = [&](auto& values) { values.erase(values.begin() + 20, values.begin() + 60); };
  cut(record.times);
  cut(record.numbers);
  cut(record.rates);
  EXPECT_LE(compare_rates(record).stated_axes[0], of_the_mean);
}

// Within a step a rate may be anything between what it is at both ends.
TEST(Rates, MayDifferFromTheTurnsByHalfTheirChange) {
  const Convention written{Scalar::last, Maps::to_reference};
  const AttitudeMotion motion{{0.0, 0.003, 0.0}, {0.05, 0.0, 0.0}};
  AttitudeRecord record = motion.record(120, written, written, RateAxes::body, RateAxes::body);
  const auto right = record.rates;
  constexpr double change = 0.04;
  for (std::size_t i = 0; i < right.size(); i += 2) record.rates[i].x() += change;
  const auto changing = compare_rates(record);
  EXPECT_NEAR(changing.stated_axes[0], 0.5 * change, of_the_mean);
  EXPECT_LE(changing.least_beyond_change, of_the_mean);
  record.rates = right;
  for (Vector3d& w : record.rates) w.x() += 0.5 * change;
  const auto wrong = compare_rates(record);
  EXPECT_NEAR(wrong.stated_axes[0], 0.5 * change, of_the_mean);
  EXPECT_GT(wrong.least_beyond_change, 0.4 * change);
}

// A left-handed one, too: the sign of one rate.
RC_GTEST_PROP(Rates, InOtherAxesAreFound, ()) {
  const Convention written = any_convention();
  Convention stated = written;
  stated.maps = any_convention().maps;
  AttitudeRecord record = any_motion().record(120, written, stated, RateAxes::body, RateAxes::body);
  const auto axes = *rc::gen::element(SignedAxes{-2, -1, -3}, SignedAxes{2, 3, 1}, SignedAxes{1, -3, 2},
                                      SignedAxes{-1, 2, 3}, SignedAxes{2, 1, 3});
  for (Vector3d& w : record.rates) {
    const Vector3d in_body = w;
    for (std::size_t i = 0; i < 3; ++i)
      w[static_cast<Eigen::Index>(i)] = (axes[i] < 0 ? -1.0 : 1.0) * in_body[std::abs(axes[i]) - 1];
  }
  const auto found = rates_in_other_axes(record);
  RC_ASSERT(found.size() == 96U);
  RC_ASSERT(found[0].axes == axes);
  RC_ASSERT(found[0].reading.transposed == (written.maps != stated.maps));
  RC_ASSERT(found[0].difference <= of_the_mean);
  RC_ASSERT(found[1].difference > 3.0 * of_the_mean);
}

// z is one axis in both frames, and the others are not seen.
TEST(Rates, AboutOneAxisDoNotTellTheOthers) {
  const AttitudeMotion motion{{0.0, 0.0, 0.02}, {0.0, 0.0, 0.03}};
  const Convention written{Scalar::last, Maps::to_reference};
  const auto record = motion.record(50, written, written, RateAxes::body, RateAxes::body);
  const auto found = compare_rates(record);
  EXPECT_EQ(fitting(found.stated_axes, 0.1 * found.rms_rate), (std::vector<std::size_t>{0}));
  auto all = found.stated_axes;
  all.insert(all.end(), found.other_axes.begin(), found.other_axes.end());
  EXPECT_EQ(fitting(all, 0.1 * found.rms_rate), (std::vector<std::size_t>{0, 4}));
  EXPECT_LE(rates_in_other_axes(record)[3].difference, of_the_mean);
  EXPECT_NEAR(found.rms_rate, 0.05, 1e-15);
  EXPECT_NEAR(found.rms_turn, 0.05, 1e-9);  // rad/s: the times are rounded to 1e-11 s
}

TEST(Fitting, NeedsAFactorOfThreeAndASmallOne) {
  using Fit = std::vector<std::size_t>;
  EXPECT_EQ(fitting({1.0, 3.1, 4.0}, 2.0), Fit{0});
  EXPECT_EQ(fitting({1.0, 3.0, 4.0}, 2.0), (Fit{0, 1}));
  EXPECT_EQ(fitting({3.1, 9.0, 1.0}, 2.0), Fit{2});
  EXPECT_EQ(fitting({9.0, 2.9, 1.0}, 2.0), (Fit{1, 2}));  // none of them alone
  EXPECT_EQ(fitting({1.0, 3.1, 4.0}, 0.9), Fit{});        // even the best does not fit
  EXPECT_EQ(fitting({0.0, 0.0, 4.0}, 2.0), (Fit{0, 1}));
  EXPECT_EQ(fitting({1e-9, 1e-3, 4.0}, 2.0), (Fit{0, 1}));  // nobody knows attitudes so well
}

// A body at rest relative to LVLH.
class NadirPointer : public ::testing::Test {
 protected:
  // Turned by 0.3 rad about the body's x axis from LVLH.
  [[nodiscard]] AttitudeRecord record(const Convention& written, const Convention& stated) const {
    struct Lvlh : moving_frame {};
    AttitudeRecord record;
    record.reference = "GCRF";
    record.stated = stated;
    for (int i = 0; i < 60; ++i) {
      const auto t = Epoch::from_utc("2026-11-29T00:00:00") + 60.0 * i * si::second;
      const auto [r, v] = orbit(t);
      const Eigen::Quaterniond to(
          Eigen::Matrix3d(lvlh(from<Lvlh>, r, v).matrix() * Eigen::AngleAxisd(0.3, Vector3d::UnitX())));
      const Eigen::Quaterniond q = written.maps == Maps::to_reference ? to : to.conjugate();
      record.times.push_back(t);
      record.numbers.push_back(written.scalar == Scalar::first ? std::array{q.w(), q.x(), q.y(), q.z()}
                                                               : std::array{q.x(), q.y(), q.z(), q.w()});
    }
    return record;
  }

  static PointMotion<earth::Gcrf, Satellite, earth::Gcrf> orbit(const Epoch& t) {
    return circular_orbit<earth::Gcrf>((t - Epoch::from_utc("2026-11-29T00:00:00")).value());
  }
};

TEST_F(NadirPointer, IsSteadyInTheReadingByWhichItWasWritten) {
  for (const Scalar written_scalar : {Scalar::first, Scalar::last})
    for (const Maps written_maps : {Maps::to_body, Maps::to_reference})
      for (const Scalar scalar : {Scalar::first, Scalar::last})
        for (const Maps maps : {Maps::to_body, Maps::to_reference}) {
          const auto found = steadiness(record({written_scalar, written_maps}, {scalar, maps}), orbit);
          const Reading& best = all_readings[smallest(found)];
          EXPECT_EQ(best.transposed, written_maps != maps);
          EXPECT_EQ(best.other_order, written_scalar != scalar);
          constexpr double rounding =
              1e-15 / 60.0 * 10.0;  // rad/s: of a few products of rotations, over 60 s
          EXPECT_LE(found[smallest(found)], rounding);
        }
}

TEST_F(NadirPointer, IsSteadyWhateverItsReferenceIs) {
  const Convention written{Scalar::last, Maps::to_reference};
  AttitudeRecord turned = record(written, written);
  turned.reference = "EME2000";
  const Eigen::Quaterniond eme_from_gcrf(Eigen::Matrix3d(eme2000_from_gcrf().matrix()));
  for (auto& n : turned.numbers) {
    const Eigen::Quaterniond q = eme_from_gcrf * Eigen::Quaterniond(n[3], n[0], n[1], n[2]);
    n = {q.x(), q.y(), q.z(), q.w()};
  }
  constexpr double rounding = 1e-15 / 60.0 * 10.0;  // rad/s: of a few products of rotations, over 60 s
  EXPECT_LE(steadiness(turned, orbit)[0], rounding);
}

TEST_F(NadirPointer, SeesTheCentreOfTheEarthByAnAxisThatIsTurnedBack) {
  const Convention written{Scalar::last, Maps::to_reference};
  const Vector3d nadir_in_body(0.0, std::sin(0.3), std::cos(0.3));
  const auto found = off_target(record(written, written), 5.0 * nadir_in_body, Target::earth, orbit);
  EXPECT_LE(found[0], 1e-14);  // rad, of a few products of rotations
  const auto off = off_target(record(written, written), Vector3d::UnitZ(), Target::earth, orbit);
  EXPECT_NEAR(off[0], 0.3, 1e-14);
  for (const std::size_t wrong : {1U, 2U, 3U}) EXPECT_GT(found[wrong], 0.3);
}

}  // namespace
}  // namespace vectrix::cli::evidence_test

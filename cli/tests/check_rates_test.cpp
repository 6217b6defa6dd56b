#include <gtest/gtest.h>

#include <sstream>

#include "attitude_motion.hpp"
#include "checked.hpp"
#include "figures.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::check_rates_test {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;

// A body that turns evenly by w and begins with an axis on the Sun, as a file whose rates are `factor` times
// w.
class OnTheSun {
 public:
  explicit OnTheSun(double factor = 1.0) : file_(rows(factor)) {
    options_.attitude.file = file_.path();
    options_.attitude.columns = {
        "t",    scale::utc,        {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference},
        "GCRF", {"wx", "wy", "wz"}};
    options_.target = Target::sun;
  }

  /// The axis looks at the Sun if the file is as it is stated, or if it is transposed.
  [[nodiscard]] Checked as_stated(RateAxes axes = RateAxes::body) const {
    return looking(start_.conjugate() * sun(), axes);
  }
  [[nodiscard]] Checked transposed() const { return looking(start_ * sun(), RateAxes::body); }

 private:
  [[nodiscard]] static Epoch time(int i) {
    return Epoch::from_utc("2026-03-01T00:00:00") + 4.0 * i * si::second;
  }
  [[nodiscard]] static Eigen::Vector3d sun() {
    AttitudeRecord record;
    record.reference = "GCRF";
    record.times = {time(0)};
    return directions(record, Target::sun, geometric, nullptr)[0];
  }
  [[nodiscard]] static std::string rows(double factor) {
    const Eigen::Vector3d w(1e-3, -2e-3, 1.5e-3), written = factor * w;
    std::ostringstream rows;
    rows.precision(17);
    rows << "t,w,x,y,z,wx,wy,wz\n";
    for (int i = 0; i < 3; ++i) {
      const Eigen::Quaterniond q = start_ * AttitudeMotion::turned((4.0 * i + 1e-9) * w);
      rows << time(i).utc(9) << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ','
           << written.x() << ',' << written.y() << ',' << written.z() << '\n';
    }
    return rows.str();
  }
  [[nodiscard]] Checked looking(const Eigen::Vector3d& axis, RateAxes axes) const {
    CheckOptions options = options_;
    options.axis = axis;
    options.attitude.columns->rate_axes = axes;
    return checked(options);
  }

  inline static const Eigen::Quaterniond start_ = Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized();
  TemporaryFile file_;
  CheckOptions options_;
};

// The rates fit as stated only if they are in other axes than stated, and the axis looks at the Sun as
// stated.
TEST(CheckRates, SaysWhichReadingFitsAllComparisons) {
  const auto found = OnTheSun().as_stated(RateAxes::reference);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(
      found.text,
      "\nThe file as stated does not fit. One reading fits all comparisons: as stated, rates in the axes "
      "of the body.\n"));
}

// The rates are those of the file as stated; the axis looks at the Sun if the file is transposed.
TEST(CheckRates, SaysThatTheComparisonsContradictEachOther) {
  const auto found = OnTheSun().transposed();
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "three times better than as stated: transposed.\n"));
  EXPECT_TRUE(
      says(found.text,
           "\nThe comparisons contradict each other: one confirms the file as stated, one does not.\n"));
}

// In degrees, and the axis looks at the Sun: what is right of the file does not excuse its rates.
TEST(CheckRates, ConfirmNoFileThatTheyContradict) {
  EXPECT_TRUE(OnTheSun(1.0).as_stated().fits);
  const auto found = OnTheSun(degrees).as_stated();
  EXPECT_FALSE(found.fits) << found.text;
  EXPECT_TRUE(says(found.text, "degrees for radians?"));
  EXPECT_TRUE(says(found.text, "\nThe file as stated does not fit: the rates contradict it.\n"));
  EXPECT_FALSE(OnTheSun(1.15).as_stated().fits);  // what is left is above a tenth
  EXPECT_TRUE(OnTheSun(1.05).as_stated().fits);
}

// 25 s of Sentinel-1A with its gyros, whose axes are not those of the quaternions.
CheckOptions sentinel() {
  CheckOptions options;
  options.attitude.file =
      std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data/S1A_IW_20220414T102211_attitude.csv";
  options.attitude.columns = {
      "time_utc", scale::utc,        {"q0", "q1", "q2", "q3"}, {Scalar::last, Maps::to_reference},
      "GCRF",     {"wx", "wy", "wz"}};
  return options;
}

TEST(CheckRates, FindsTheAxesOfSentinelsGyros) {
  const auto found = checked(sentinel());
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "as stated, with x, y, z of the rates along -y, -x, -z of the body"));
  CheckOptions transposed = sentinel();
  transposed.attitude.columns->stated.maps = Maps::to_body;
  EXPECT_TRUE(
      says(checked(transposed).text, "transposed, with x, y, z of the rates along -y, -x, -z of the body"));
}

// A body with a motion of its own, as a table whose rates are changed.
template <class Change>
Checked of_motion(const AttitudeMotion& motion, const Change& change, std::size_t count = 60) {
  const Convention stated{Scalar::last, Maps::to_reference};
  AttitudeRecord record = motion.record(count, stated, stated, RateAxes::body, RateAxes::body);
  std::ostringstream rows;
  rows.precision(17);
  rows << "t,x,y,z,w,wx,wy,wz\n";
  for (std::size_t i = 0; i < count; ++i) {
    const auto& q = record.numbers[i];
    const Eigen::Vector3d w = change(Eigen::Vector3d(record.rates[i]));
    rows << record.times[i].utc(9) << ',' << q[0] << ',' << q[1] << ',' << q[2] << ',' << q[3] << ',' << w.x()
         << ',' << w.y() << ',' << w.z() << '\n';
  }
  TemporaryFile file(rows.str());
  CheckOptions options;
  options.attitude.file = file.path();
  options.attitude.columns = {"t", scale::utc, {"x", "y", "z", "w"}, stated, "GCRF", {"wx", "wy", "wz"}};
  return checked(options);
}
const AttitudeMotion tumble{{0.02, 0.01, -0.03}, {0.05, -0.02, 0.01}};
const AttitudeMotion spinner{{1e-4, 2e-4, 0.0}, {0.0102, -0.0204, 0.102}};  // about an axis near z

TEST(CheckRates, ConfirmsRatesAndSaysWhatRatesDoNotSee) {
  const auto found = of_motion(tumble, [](const Eigen::Vector3d& w) { return w; });
  EXPECT_TRUE(found.fits) << found.text;
  EXPECT_TRUE(
      says(found.text, "Rates alone do not see a transposed file whose rates are those of the reference"));
}

// About one axis that is none of the body's: its rates are the same in both frames, from identity on.
TEST(CheckRates, DoesNotRefuteASlewAboutOneAxis) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, 3.0).normalized();
  const auto found = of_motion(
      {0.004 * axis, 0.006 * axis}, [](const Eigen::Vector3d& w) { return w; }, 5);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(
      says(found.text,
           "The file as stated fits, but this does not tell it from: as stated, rates in the axes of GCRF."));
  EXPECT_TRUE(says(found.text, "Not decided."));
}

// What is left of a wrong sign of a small rate is a fifth of the rates: three times less than any other
// reading.
TEST(CheckRates, FindsTheWrongSignOfASmallRate) {
  const auto found =
      of_motion(spinner, [](const Eigen::Vector3d& w) { return Eigen::Vector3d(w.x(), -w.y(), w.z()); });
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text,
                   "Another reading fits: as stated, with x, y, z of the rates along x, -y, z of the body"));
}

TEST(CheckRates, SuspectsDegreesForRadians) {
  const auto found =
      of_motion(tumble, [&](const Eigen::Vector3d& w) { return Eigen::Vector3d(degrees * w); });
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "times the rates: degrees for radians?"));
  const auto zero = of_motion(tumble, [](const Eigen::Vector3d& w) { return Eigen::Vector3d(0.0 * w); });
  EXPECT_TRUE(says(zero.text, "No reading fits. The rates are zero, and the body turns."));
}

// Relative to LVLH, which turns by 0.06 deg/s, and the rates are relative to GCRF.
TEST(CheckRates, FindsRatesRelativeToGcrfOfAnAttitudeThatIsNot) {
  struct Lvlh : moving_frame {};
  const AttitudeMotion motion{{1e-3, 0.0, 5e-4}, {0.0, -7e-4, 1e-3}};  // relative to GCRF
  const auto start = Epoch::from_utc("2023-04-20T05:20:00");
  const FlownOrbit orbit = read_orbit(cubesat_orbit(), from_until(start, start + 60.0 * si::second));
  std::ostringstream rows;
  rows.precision(17);
  rows << "t,w,x,y,z,wx,wy,wz\n";
  for (int i = 0; i < 60; ++i) {
    const Epoch t = start + i * si::second;
    const auto [r, v] = orbit(t);
    const Eigen::Quaterniond lvlh_from_gcrf(Eigen::Matrix3d(lvlh(from<Lvlh>, r, v).matrix().transpose()));
    const Eigen::Quaterniond q = lvlh_from_gcrf * motion.to_reference(i + 1e-9);
    const Eigen::Vector3d w = motion.rate_in_body(i + 1e-9);
    rows << t.utc(9) << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ',' << w.x() << ','
         << w.y() << ',' << w.z() << '\n';
  }
  const TemporaryFile file(rows.str());
  CheckOptions options;
  options.attitude.file = file.path();
  options.attitude.columns = {
      "t", scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference}, "LVLH", {"wx", "wy", "wz"}};
  options.orbit = cubesat_orbit();
  const auto found = checked(options);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(
      says(found.text,
           "Another reading fits, three times better than as stated: as stated, rates relative to GCRF "
           "in the axes of the body.\n"));
  EXPECT_TRUE(says(found.text, "The file as stated does not fit."));
}

TEST(CheckRates, RefusesRatesWhoseSizeOverflows) {
  const auto huge = [](const Eigen::Vector3d& w) { return Eigen::Vector3d(1e200 * w); };
  EXPECT_TRUE(
      says(complaint([&] { (void)of_motion(tumble, huge); }), ": the rates are too large, inf rad/s rms"));
}

TEST(CheckRates, DecidesNothingForABodyAtRestWithoutRates) {
  const auto found =
      of_motion({{1e-300, 0.0, 0.0}, {0.0, 1e-300, 0.0}}, [](const Eigen::Vector3d& w) { return w; });
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "Not decided."));
}

}  // namespace
}  // namespace vectrix::cli::check_rates_test

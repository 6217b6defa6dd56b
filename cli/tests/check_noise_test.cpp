#include <gtest/gtest.h>

#include <random>

#include "attitude_motion.hpp"
#include "checked.hpp"
#include "evidence.hpp"
#include "says.hpp"
#include "table_text.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::check_noise_test {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

// Attitudes each second with errors of 1e-3 rad about each axis, from sample to sample others, and a gyro
// with errors of 1e-6 rad/s.
class Noisy {
 public:
  explicit Noisy(std::size_t count) : count_(count) {}

  /// What check says if the body turns at w in its axes and the file has other rates.
  [[nodiscard]] Checked checked(const Vector3d& w, const Vector3d& recorded) {
    std::string text = "t,w,x,y,z,wx,wy,wz\n";
    for (std::size_t i = 0; i < count_; ++i) {
      const double t = static_cast<double>(i);
      const Quaterniond q = start_ * Quaterniond(Eigen::AngleAxisd(w.norm() * t, w.normalized())) *
                            AttitudeMotion::turned(errors(1e-3));
      text += exact_text(Epoch::from_utc("2026-11-29T00:00:00") + t * si::second, scale::utc);
      add_fields(text, std::array{q.w(), q.x(), q.y(), q.z()});
      add_fields(text, Vector3d(recorded + errors(1e-6)));
      text += "\n";
    }
    CheckOptions options;
    options.attitude.file = folder_.written("noisy.csv", text);
    options.attitude.columns = {"t",
                                scale::utc,
                                {"w", "x", "y", "z"},
                                {Convention::Scalar::first, Convention::Maps::to_reference},
                                "GCRF",
                                {"wx", "wy", "wz"}};
    return cli::checked(options);
  }

 private:
  Vector3d errors(double sigma) {
    return sigma * Vector3d(normal_(generator_), normal_(generator_), normal_(generator_));
  }

  std::size_t count_;
  TemporaryFolder folder_;
  std::mt19937_64 generator_{7};
  std::normal_distribution<double> normal_;
  Quaterniond start_ = Quaterniond(0.3, 0.5, -0.7, 0.2).normalized();
};

constexpr const char *contradicted = "The file as stated does not fit: the rates contradict it.",
                     *as_errors = "errors of the attitudes do that, and no reading.";

const Vector3d at_rest(0.0, 0.0, 1e-12), x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0);

TEST(CheckNoise, DoesNotContradictABodyAtRest) {
  for (const std::size_t count : {50U, 500U}) {
    const auto made = Noisy(count).checked(at_rest, Vector3d::Zero());
    EXPECT_FALSE(made.fits);
    EXPECT_TRUE(says(made.text, as_errors)) << count;
    EXPECT_TRUE(says(made.text, "Not decided.")) << count;
  }
}

// Nor one that turns by less than the errors.
TEST(CheckNoise, DoesNotContradictASlowBody) {
  EXPECT_TRUE(says(Noisy(500).checked(1e-4 * x, 1e-4 * x).text, as_errors));
}

// Rates that the attitude does not have, of about the errors of a step.
TEST(CheckNoise, DoesNotHideAContradiction) {
  EXPECT_TRUE(says(Noisy(500).checked(at_rest, 2e-3 * x).text, contradicted));
  EXPECT_TRUE(says(Noisy(2000).checked(at_rest, 8e-4 * x).text, contradicted));
  EXPECT_TRUE(says(Noisy(500).checked(0.02 * x, 0.06 * x).text, contradicted));
}

// Where the difference turns with the body, by a third, a quarter or a half of a turn in each step.
TEST(CheckNoise, DoesNotHideAContradictionOfATumblingBody) {
  for (const double turn : {1.0 / 3.0, 0.25, 0.45})
    EXPECT_TRUE(says(Noisy(500).checked(2.0 * std::numbers::pi * turn * x, 0.3 * y).text, contradicted))
        << turn;
}

// Which is of errors cannot be told of a few samples.
TEST(CheckNoise, TakesFewSamplesAsTheyAre) {
  EXPECT_TRUE(says(Noisy(20).checked(at_rest, Vector3d::Zero()).text, contradicted));
}

}  // namespace
}  // namespace vectrix::cli::check_noise_test

#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <string>

#include <vectrix/space.hpp>

#include "files/replaced.hpp"
#include "temporary_file.hpp"

namespace vectrix::quaternion_derivative_test {
namespace {

struct Lvlh : moving_frame {};
struct Imu : moving_frame {};

using Message = AttitudeEphemerisMessage;

const auto lvlh = called<Lvlh>("LVLH");
const auto imu = called<Imu>("IMU_FRAME_1");

// Two lines of a file of CS-SI/Orekit (at fe4aee84, Apache-2.0), which is XML there.
const std::string orekit = R"(CCSDS_AEM_VERS = 1.0
CREATION_DATE = 2021-04-15T13:31:24.0
ORIGINATOR = CS GROUP
META_START
OBJECT_NAME = OREKIT SAT
OBJECT_ID = 2020-012A
REF_FRAME_A = LVLH
REF_FRAME_B = IMU_FRAME_1
ATTITUDE_DIR = B2A
TIME_SYSTEM = TAI
START_TIME = 2021-04-15T13:31:20.0
STOP_TIME = 2021-04-15T13:31:23.0
ATTITUDE_TYPE = QUATERNION/DERIVATIVE
QUATERNION_TYPE = FIRST
INTERPOLATION_DEGREE = 1
META_STOP
DATA_START
2021-04-15T13:31:20.0 0.4886148886986714 -0.40215690839288926 0.5816278675112939 0.5111108835743206 3.0077619996648645E-4 2.5945771992435184E-4 -2.8362061580605415E-4 2.393622263168597E-4
2021-04-15T13:31:20.5 0.4887649908329683 -0.40202699245978285 0.5814859890939396 0.5112309904116072 3.0071481809516165E-4 2.5950414011706777E-4 -2.837152043818123E-4 2.3927581114550022E-4
DATA_STOP
)";

TEST(QuaternionDerivative, TheRateOfAPublishedFile) {
  const auto message = Message::parse(orekit);
  const auto segment = message.segments().front();
  const auto rates = segment.angular_velocities<Lvlh, Imu>(in<Imu>, lvlh, imu);
  constexpr double published = 0.062294, digits = 1e-6;  // deg/s
  for (const auto& w : rates)
    EXPECT_NEAR(w.coordinates().norm() * 180.0 / std::numbers::pi, published, digits);
  EXPECT_EQ(Message::parse(message.text()).text(), message.text());

  // The turn from one line to the next has this rate, to 0.2 percent in this file; the wrong way round it
  // would be off by 200.
  const auto samples = segment.nearest_samples<Lvlh, Imu>(lvlh, imu).samples;
  const auto turn = log(inverse(samples[0].q_a_from_b) * samples[1].q_a_from_b);
  constexpr double percent = 0.01;
  EXPECT_LT((turn.coordinates() / 0.5 - rates[0].coordinates()).norm(),
            percent * rates[0].coordinates().norm());
}

// q_a^b = exp(t w/2), dq/dt = q w_b/2, in every way that a file can have it.
TEST(QuaternionDerivative, TheSameRateInBothDirectionsFramesAndOrders) {
  const Eigen::Vector3d w_b(0.01, -0.02, 0.03), w_start(0.3, 0.1, -0.2);
  const Eigen::Quaterniond q(Eigen::AngleAxisd(1.1, w_start.normalized()));
  const Eigen::Quaterniond half(0.0, w_b.x() / 2, w_b.y() / 2, w_b.z() / 2);
  const Eigen::Quaterniond qdot = q * half;
  constexpr double rounding = 1e-15;
  for (const bool is_b_to_a : {false, true}) {
    for (const bool is_first : {false, true}) {
      std::ostringstream line;
      line << std::setprecision(17) << "2021-04-15T13:31:20";
      for (const Eigen::Quaterniond& x : {q, qdot}) {
        const Eigen::Quaterniond y = is_b_to_a ? x.conjugate() : x;
        if (is_first) line << ' ' << y.w();
        line << ' ' << y.x() << ' ' << y.y() << ' ' << y.z();
        if (!is_first) line << ' ' << y.w();
      }
      std::string text =
          orekit.substr(0, orekit.find("2021-04-15T13:31:20.0 0.48")) + line.str() + "\nDATA_STOP\n";
      if (!is_b_to_a) text = replaced(text, "B2A", "A2B");
      if (!is_first) text = replaced(text, "FIRST", "LAST");
      const auto segment = Message::parse(text).segments().front();
      const auto in_b = segment.angular_velocities<Lvlh, Imu>(in<Imu>, lvlh, imu).front().coordinates();
      const auto in_a = segment.angular_velocities<Lvlh, Imu>(in<Lvlh>, lvlh, imu).front().coordinates();
      const auto back = segment.angular_velocities<Imu, Lvlh>(in<Imu>, imu, lvlh).front().coordinates();
      EXPECT_LT((in_b - w_b).norm(), rounding) << text;
      EXPECT_LT((in_a - q * w_b).norm(), rounding) << text;
      EXPECT_LT((back + w_b).norm(), rounding) << text;
    }
  }
}

TEST(QuaternionDerivative, ThatDoesNotTurnIsRefused) {
  const auto text = replaced(orekit, "3.0077619996648645E-4", "3.0077619996648645E-3");
  EXPECT_NE(complaint([&] {
              static_cast<void>(
                  Message::parse(text).segments().front().angular_velocities<Lvlh, Imu>(in<Imu>, lvlh, imu));
            }).find("the derivative of the quaternion at 2021-04-15T13:31:20.000 has 0.00132"),
            std::string::npos);
  EXPECT_EQ(complaint([&] { Message::parse(replaced(orekit, " 2.393622263168597E-4", "")); }),
            "attitude ephemeris message, line 18, column 1: '2021-04-15T13:31:20.0 0.4886148886986714 "
            "-0.4021569083928892...': 8 fields; a line of QUATERNION/DERIVATIVE has an epoch and 8 numbers");
}

TEST(QuaternionDerivative, AsAParameterMessage) {
  const auto text = replaced(
      replaced(replaced(orekit.substr(0, orekit.find("2021-04-15T13:31:20.5")) + "DATA_STOP\n", "1.0", "2.0"),
               "ATTITUDE_DIR = B2A\n", ""),
      "QUATERNION_TYPE = FIRST\n", "");
  const AttitudeParameterMessage parameters({"2.0", "", ""}, Message::parse(text).segments());
  EXPECT_EQ(parameters.blocks("quaternion").front().number("QC_DOT"), 2.393622263168597E-4);
}

}  // namespace
}  // namespace vectrix::quaternion_derivative_test

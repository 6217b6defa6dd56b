#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include <vectrix/space/files/attitude_ephemeris_message.hpp>
#include <vectrix/space/files/attitude_parameter_message.hpp>

#include "temporary_file.hpp"

namespace vectrix::spin_and_angles_test {
namespace {

struct A : inertial_frame {};
struct B : moving_frame {};

constexpr double degree = std::numbers::pi / 180.0;

std::string message_of(const std::string& type, const std::string& data) {
  return "CCSDS_AEM_VERS = 2.0\nCREATION_DATE =\nORIGINATOR =\n\nMETA_START\nOBJECT_NAME =\nOBJECT_ID =\n"
         "REF_FRAME_A = A\nREF_FRAME_B = B\nTIME_SYSTEM = UTC\nSTART_TIME = 2006-090T05:00:00.000\n"
         "STOP_TIME = 2006-090T05:10:00.000\nATTITUDE_TYPE = " +
         type + "\nMETA_STOP\n\nDATA_START\n" + data + "DATA_STOP\n";
}
AttitudeEphemerisSegment segment_of(const std::string& type, const std::string& numbers) {
  return AttitudeEphemerisMessage::parse(message_of(type, "2006-090T05:00:00.000 " + numbers + "\n"))
      .segments()
      .front();
}
Eigen::Quaterniond attitude(const AttitudeEphemerisSegment& segment) {
  return segment.samples<A, B>(called<A>("A"), called<B>("B")).front().q_a_from_b.eigen();
}
/// w_ab^b
Eigen::Vector3d rate(const AttitudeEphemerisSegment& segment) {
  return segment.angular_velocities<A, B>(in<B>, called<A>("A"), called<B>("B")).front().coordinates();
}
Eigen::Quaterniond turn(const Eigen::Vector3d& angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle.norm(), angle.stableNormalized()));
}

// The example of CCSDS 504.0-B-2, F5.4, whose results have four decimals.
constexpr double printed = 5e-5;
const std::string momentum = "0 80 45 1 0 70 0.01";

void expect_quaternion(Eigen::Quaterniond q, const Eigen::Vector4d& xyzw) {
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  EXPECT_LT((q.coeffs() - xyzw).cwiseAbs().maxCoeff(), printed) << q.coeffs().transpose();
}

TEST(SpinOfAMessage, IsTheExampleOfTheStandard) {
  const auto segment = segment_of("SPIN/NUTATION_MOM", momentum);
  EXPECT_EQ(segment.type(), AttitudeType::spin_nutation_momentum);
  const Eigen::Quaterniond start = attitude(segment);
  expect_quaternion(start, {0.0805, 0.0334, 0.9204, 0.3812});
  EXPECT_LT((start * Eigen::Vector3d::UnitZ() - Eigen::Vector3d(0.1736, 0.0, 0.9848)).norm(), 1.5 * printed);

  // The momentum in b is what is left of the rate without the spin; it stays in a.
  const Eigen::Vector3d spin = 1.0 * degree * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d nutation_a = start * (rate(segment) - spin);
  EXPECT_LT((nutation_a / (0.01 * degree) - Eigen::Vector3d(0.3420, 0.0, 0.9397)).norm(), 1.5 * printed);
  const auto later = [&](double t) { return turn(nutation_a * t) * start * turn(spin * t); };
  expect_quaternion(later(300.0), {0.0584, 0.0650, 0.6263, 0.7747});
  EXPECT_LT((later(300.0) * Eigen::Vector3d::UnitZ() - Eigen::Vector3d(0.1739, -0.0091, 0.9847)).norm(),
            1.5 * printed);
}

// The other description of the same nutation: of 10 deg in 36000 s.
TEST(SpinOfAMessage, OfTwoDescriptionsIsTheSame) {
  const auto one = segment_of("SPIN/NUTATION_MOM", momentum);
  const Eigen::Vector3d h_b = (rate(one) - degree * Eigen::Vector3d::UnitZ()) / (0.01 * degree);
  const double phase = std::atan2(-h_b.y(), h_b.x()) / degree;
  const auto two = segment_of("SPIN/NUTATION", "0 80 45 1 10 36000 " + detail::text(phase));
  constexpr double rounding = 1e-15;
  EXPECT_EQ(attitude(one).coeffs(), attitude(two).coeffs());
  EXPECT_LT((rate(one) - rate(two)).norm(), rounding * rate(one).norm());
  const auto in_a = [](const auto& segment) {
    return segment.template angular_velocities<A, B>(in<A>, called<A>("A"), called<B>("B"))
        .front()
        .coordinates();
  };
  EXPECT_LT((in_a(one) - attitude(one) * rate(one)).norm(), rounding * rate(one).norm());
  const Eigen::Vector3d of_a =
      one.angular_velocities<B, A>(in<B>, called<B>("B"), called<A>("A"))[0].coordinates();
  EXPECT_LT((of_a + rate(one)).norm(), rounding * rate(one).norm());
}

// Two lines of a flight, ST5-224, from the example of CCSDS 504.0-B-2, figure G-5: the phase of one follows
// from the other by the rate; a phase that counted the other way would be off by 27 deg.
TEST(SpinOfAMessage, OfAFlightTurnsByItsRate) {
  const auto message = AttitudeEphemerisMessage::parse(
      message_of("SPIN",
                 "2006-090T05:00:00.071 2.6862511e+002 6.8448486e+001 1.5969509e+002 -1.0996528e+002\n"
                 "2006-090T05:00:00.196 2.6863990e+002 6.8432197e+001 1.4593720e+002 -1.0996493e+002\n"));
  const auto& segment = message.segments().front();
  const auto samples = segment.samples<A, B>(called<A>("A"), called<B>("B"));
  const Eigen::Vector3d w = rate(segment);
  EXPECT_EQ(w.x(), 0.0);
  EXPECT_EQ(w.y(), 0.0);
  EXPECT_NEAR(w.z(), -109.96528 * degree, 1e-14);
  const Eigen::Quaterniond expected = samples[0].q_a_from_b.eigen() * turn(w * 0.125);
  constexpr double nutation = 0.03 * degree;  // the axis moves by 0.02 deg
  EXPECT_LT(expected.angularDistance(samples[1].q_a_from_b.eigen()), nutation);
}

// The rate of Euler angles is the derivative of their quaternion, in every sequence.
TEST(EulerAnglesOfAMessage, HaveTheRateOfTheirDerivatives) {
  constexpr double h = 1e-6, error = 1e-9;  // s, of differences
  for (const char* sequence : {"XYZ", "321", "ZXZ", "YXY", "132"}) {
    const std::string type = "EULER_ANGLE/DERIVATIVE\nEULER_ROT_SEQ = " + std::string{sequence};
    const auto at = [&](double t) {
      std::string numbers;
      for (const double angle : {40.0 + 3.0 * t, -25.0 - 2.0 * t, 70.0 + 5.0 * t})
        numbers += detail::text(angle) + " ";
      return segment_of(type, numbers + "3 -2 5");
    };
    const Eigen::Quaterniond change = attitude(at(-h)).conjugate() * attitude(at(h));
    const Eigen::Vector3d expected = 2.0 * change.vec() / change.w() / (2.0 * h);
    EXPECT_LT((rate(at(0.0)) - expected).norm(), error) << sequence;
  }
}

TEST(EulerAnglesOfAMessage, HaveTheRateThatIsWritten) {
  const std::string type = "EULER_ANGLE/ANGVEL\nEULER_ROT_SEQ = ZYX\nANGVEL_FRAME = REF_FRAME_B";
  const auto segment = segment_of(type, "10 20 30 1 -2 3");
  EXPECT_EQ(attitude(segment).coeffs(),
            attitude(segment_of("EULER_ANGLE\nEULER_ROT_SEQ = ZYX", "10 20 30")).coeffs());
  EXPECT_LT((rate(segment) - degree * Eigen::Vector3d(1.0, -2.0, 3.0)).norm(), 1e-17);
  const std::string without = "EULER_ANGLE/ANGVEL\nEULER_ROT_SEQ = ZYX";
  EXPECT_EQ(complaint([&] { segment_of(without, "10 20 30 1 -2 3"); }),
            "attitude ephemeris message, the segment from line 5 on: there is no ANGVEL_FRAME");
}

TEST(SpinOfAMessage, IsWrittenAsItWas) {
  for (const auto& [type, numbers] :
       {std::pair{"SPIN", "1.0e+00 -2.0e+00 3.0e+00 4.0e+00"},
        {"SPIN/NUTATION", "1.0e+00 -2.0e+00 3.0e+00 4.0e+00 5.0e+00 6.0e+00 7.0e+00"},
        {"SPIN/NUTATION_MOM", "1.0e+00 -2.0e+00 3.0e+00 4.0e+00 5.0e+00 6.0e+00 7.0e+00"},
        {"EULER_ANGLE/DERIVATIVE\nEULER_ROT_SEQ = ZXZ", "1.0e+00 2.0e+00 3.0e+00 4.0e+00 5.0e+00 6.0e+00"},
        {"EULER_ANGLE/ANGVEL\nEULER_ROT_SEQ = ZXZ\nANGVEL_FRAME = REF_FRAME_A",
         "1.0e+00 2.0e+00 3.0e+00 4.0e+00 5.0e+00 6.0e+00"}}) {
    const std::string text = message_of(type, "2006-03-31T05:00:00.000 " + std::string{numbers} + "\n");
    const auto message = AttitudeEphemerisMessage::parse(text);
    std::string canonical = text;
    for (const char* time : {":00:00.000\nSTOP", ":10:00.000\nATT"})
      canonical.replace(canonical.find(time) - 11, 8, "2006-03-31");
    EXPECT_EQ(message.text(), canonical);
    EXPECT_EQ(AttitudeEphemerisMessage::parse(message.xml()).text(), canonical);
  }
  const auto message = AttitudeEphemerisMessage::parse(message_of("SPIN", "2006-090T05:00:00 1 2 3 4\n"));
  EXPECT_NE(message.xml().find("<attitudeState><spin>"), std::string::npos);
}

TEST(SpinOfAMessage, IsRefusedWhereItMeansNothing) {
  for (const char* period : {"0", "-6", "1e-310"})
    EXPECT_EQ(complaint([&] { segment_of("SPIN/NUTATION", "1 2 3 4 5 " + std::string{period} + " 7"); }),
              "attitude ephemeris message, line 17, column 33 (NUTATION_PER): '" + std::string{period} +
                  "': no period of a nutation, which is positive");
  const std::string type = "EULER_ANGLE/DERIVATIVE\nEULER_ROT_SEQ = ZXZ";
  EXPECT_EQ(
      complaint([&] { rate(segment_of(type, "0 0 0 1e308 0 1e308")); }),
      "attitude ephemeris message, the segment from line 5 on: the rate at 2006-03-31T05:00:00.000 is too "
      "large for a double");
  const auto spin = segment_of("SPIN", "1 2 3 4");
  const std::string place = "attitude ephemeris message, the segment from line 5 on: ";
  EXPECT_EQ(complaint([&] {
              AttitudeEphemerisMessage({"1.0", "", ""}, {spin});
            }),
            place + "version 1.0 is written without the attitude type SPIN");
  EXPECT_EQ(
      complaint([&] {
        AttitudeParameterMessage({"2.0", "", ""}, {spin});
      }),
      place + "the attitude type is SPIN; a state is a quaternion, Euler angles or an angular velocity");
}

}  // namespace
}  // namespace vectrix::spin_and_angles_test

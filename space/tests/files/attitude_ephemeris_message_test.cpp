#include <array>
#include <cmath>
#include <random>

#include "files/attitude_ephemeris_texts.hpp"

namespace vectrix::attitude_ephemeris_message_test {
namespace {

// rad: angles of 16 digits, up to 36 deg, are rounded to 0.5e-14 deg; the half of three of them, and the
// roundings of their sines and products.
constexpr double written_angles = 1e-14;
// Three turns of up to 400 deg, 7 rad with half an ulp of 0.9e-15 each, and the products of two ways.
constexpr double elementary_turns = 1e-14;
constexpr double half_an_ulp = 1.2e-16;  // of a number up to 1

// Made of the definition of the standard, in elementary turns of the axes, without quaternions.
Eigen::Matrix3d turned_axes(int axis, double degrees) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  m(j, j) = m(k, k) = std::cos(degrees * degree);
  m(j, k) = std::sin(degrees * degree);
  m(k, j) = -m(j, k);
  return m;
}

TEST(AttitudeEphemerisMessage, QuaternionsAndAnglesOfGmatAreOneAttitude) {
  const auto quaternions = segment_of(gmat_quaternions).samples<Eme2000, Body>(body);
  const auto angles = segment_of(gmat_angles).samples<Eme2000, Body>(body);
  ASSERT_EQ(quaternions.size(), 3U);
  ASSERT_EQ(angles.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(quaternions[i].time, angles[i].time);
    EXPECT_LT(angle_between(quaternions[i].q_a_from_b, angles[i].q_a_from_b), written_angles);
  }
  // Coordinates go from A to B by the matrix R1(c) R2(b) R3(a) of the standard.
  const Eigen::Matrix3d standard = turned_axes(0, 18.80387738364443) * turned_axes(1, -15.74726604135554) *
                                   turned_axes(2, 35.4540963916258);
  EXPECT_LT((inverse(dcm(quaternions[0].q_a_from_b)).matrix() - standard).norm(), written_angles);
  EXPECT_EQ(quaternions[2].time, Epoch::from_utc("2000-01-01T12:02:02.637"));
  EXPECT_EQ(quaternions[0].q_a_from_b.eigen().w(), 0.9240493645517975);
}

TEST(AttitudeEphemerisMessage, EverySequenceIsThatOfTheStandard) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-400.0, 400.0);
  for (const std::string sequence :
       {"123", "132", "213", "231", "312", "321", "121", "131", "212", "232", "313", "323"}) {
    const double t[] = {any(random), any(random), any(random)};
    const std::string line =
        "2000-01-01T11:59:28 " + detail::text(t[0]) + " " + detail::text(t[1]) + " " + detail::text(t[2]);
    std::string letters = sequence;
    for (char& c : letters) c = static_cast<char>(c - '1' + 'X');
    const Eigen::Matrix3d standard = turned_axes(sequence[2] - '1', t[2]) *
                                     turned_axes(sequence[1] - '1', t[1]) *
                                     turned_axes(sequence[0] - '1', t[0]);
    for (const std::string& written : {sequence, letters}) {
      const std::string text =
          replaced(replaced(gmat_angles, "321", written),
                   "2000-01-01T11:59:28.000 35.4540963916258  -15.74726604135554  18.80387738364443", line);
      const auto q = segment_of(text).samples<Eme2000, Body>(body).front().q_a_from_b;
      EXPECT_LT((inverse(dcm(q)).matrix() - standard).norm(), elementary_turns) << written;
    }
  }
}

TEST(AttitudeEphemerisMessage, DirectionAndOrderOfTheScalarAreThoseOfTheFile) {
  const auto a2b = segment_of(gmat_quaternions).samples<Eme2000, Body>(body);
  const auto b2a = segment_of(replaced(gmat_quaternions, "A2B", "b2a")).samples<Eme2000, Body>(body);
  EXPECT_EQ(b2a[1].q_a_from_b.eigen().coeffs(), a2b[1].q_a_from_b.eigen().conjugate().coeffs());
  // Asked for the other way round, and with the frames exchanged in the file.
  const auto reversed = segment_of(gmat_quaternions).samples<Body, Eme2000>(body);
  EXPECT_EQ(reversed[1].q_a_from_b.eigen().coeffs(), inverse(a2b[1].q_a_from_b).eigen().coeffs());
  const std::string exchanged =
      replaced(replaced(gmat_quaternions, "REF_FRAME_A = EME2000", "REF_FRAME_A = SC_BODY_1"),
               "REF_FRAME_B = SC_BODY_1", "REF_FRAME_B = EME2000");
  EXPECT_EQ((segment_of(exchanged).samples<Body, Eme2000>(body)[1].q_a_from_b.eigen().coeffs()),
            a2b[1].q_a_from_b.eigen().coeffs());
  const auto first = segment_of(replaced(gmat_quaternions, "= LAST", "= First")).samples<Eme2000, Body>(body);
  EXPECT_EQ(first[0].q_a_from_b.scalar_first(),
            (std::array{0.1952861484651402, -0.07946016321668915, 0.3188764252036319, 0.9240493645517975}));
}

TEST(AttitudeEphemerisMessage, OfASensor) {
  const Segment segment = segment_of(tracker);
  EXPECT_EQ(segment.ref_frame_a(), "STARTRACKER_2");
  const auto sensor = called<Tracker>("startracker_2");
  const auto ground = called<Ground>("GTOD");
  // B2A: the quaternion of the file gives coordinates in B of those in A.
  const auto [samples, distance] = segment.nearest_samples<Ground, Tracker>(sensor, ground);
  ASSERT_EQ(samples.size(), 4U);
  const Eigen::Quaterniond written(0.68427, 0.56748, 0.03146, 0.45689);
  EXPECT_LT((samples[0].q_a_from_b.eigen().coeffs() - written.normalized().coeffs()).norm(), half_an_ulp);
  constexpr double half_a_digit = 0.5e-5;  // of each of four numbers, of which the sum is 2 at most
  EXPECT_LT(distance, 2 * half_a_digit);
  // That of the second line is the farthest off, as its digits say.
  EXPECT_EQ(distance,
            std::abs(detail::scaled_norm(Eigen::Vector4d(0.42319, -0.45697, 0.23784, 0.74533)) - 1.0));
  EXPECT_EQ((segment.nearest_samples<Tracker, Ground>(ground, sensor).samples[0].q_a_from_b.eigen().coeffs()),
            samples[0].q_a_from_b.eigen().conjugate().coeffs());
  const std::string refused = complaint([&] { return segment.samples<Ground, Tracker>(sensor, ground); });
  EXPECT_EQ(
      refused,
      "attitude ephemeris message, the segment from line 5 on, line 25: the norm of the quaternion differs "
      "from 1 by " +
          detail::text(distance) + ", tolerance 1.2e-10; nearest_samples() projects");
}

TEST(AttitudeEphemerisMessage, OtherFramesAreRefused) {
  const Segment segment = segment_of(gmat_quaternions);
  const std::string place = "attitude ephemeris message, the segment from line 5 on: ";
  EXPECT_EQ(complaint([&] { return segment.samples<Gcrf, Body>(body); }),
            place +
                "REF_FRAME_A is 'EME2000', REF_FRAME_B is 'SC_BODY_1'; asked for 'SC_BODY_1' "
                "(attitude_ephemeris_message_test::Body) relative to 'GCRF' (earth::Gcrf)");
  EXPECT_EQ(complaint([&] { return segment.nearest_samples<Eme2000, Other>(called<Other>("SC_BODY_2")); }),
            place +
                "REF_FRAME_A is 'EME2000', REF_FRAME_B is 'SC_BODY_1'; asked for 'SC_BODY_2' "
                "(attitude_ephemeris_message_test::Other) relative to 'EME2000' (earth::Eme2000)");
  EXPECT_EQ(complaint([&] { return segment.samples<Gcrf, Body>(body, called<Gcrf>("EME2000")); }),
            place + "REF_FRAME_A is 'EME2000', earth::Eme2000; it was claimed to be earth::Gcrf");
  EXPECT_EQ(complaint([&] { return segment.angular_velocities<Eme2000, Body>(in<Body>, body); }),
            place + "ATTITUDE_TYPE is QUATERNION, which has no rates");
  EXPECT_NO_THROW(static_cast<void>(segment.samples<Other, Body>(body, called<Other>("EME2000"))));
}

TEST(AttitudeEphemerisMessage, RatesOfTheFile) {
  const auto message = Message::parse(rates);
  ASSERT_EQ(message.segments().size(), 2U);
  const Segment& segment = message.segments()[0];
  EXPECT_EQ(segment.type(), AttitudeType::quaternion_rate);
  EXPECT_EQ(segment.metadata().comments, std::vector<std::string>{"first"});
  EXPECT_EQ(segment.comments(), (std::vector<std::string>{"before the data", "between"}));
  EXPECT_EQ(message.segments()[1].metadata().comments, std::vector<std::string>{"between segments"});
  EXPECT_EQ(message.segments()[1].comments(), std::vector<std::string>{"at the end"});
  const auto lvlh = called<Other>("LVLH");
  const auto imu = called<Body>("IMU_FRAME_1");
  const auto samples = segment.samples<Other, Body>(lvlh, imu);
  EXPECT_EQ(samples[0].time, Epoch::from(scale::tai, "2021-04-15T13:31:20.000000000001"));
  EXPECT_EQ(samples[0].q_a_from_b.scalar_last(), (std::array{0.6, 0.0, 0.0, 0.8}));
  const auto w = segment.angular_velocities<Other, Body>(in<Body>, lvlh, imu);
  static_assert(std::is_same_v<decltype(w), const std::vector<AngularVelocity<Other, Body, In<Body>>>>);
  const Eigen::Vector3d written = degree * Eigen::Vector3d(1, -2.5, 3);
  EXPECT_LT((w[0].coordinates() - written).norm(), half_an_ulp * written.norm());
  const auto opposite = segment.angular_velocities<Body, Other>(in<Body>, lvlh, imu);
  EXPECT_LT((opposite[0].coordinates() + written).norm(), half_an_ulp * written.norm());
  EXPECT_EQ(complaint([&] { return segment.angular_velocities<Other, Body>(in<Other>, lvlh, imu); }),
            "attitude ephemeris message, the segment from line 7 on: the rates are in REF_FRAME_B, "
            "'IMU_FRAME_1'; asked for 'LVLH' (attitude_ephemeris_message_test::Other)");
  const Segment in_a = segment_of(replaced(rates, "= REF_FRAME_B", "= lvlh"));
  EXPECT_NO_THROW(static_cast<void>(in_a.angular_velocities<Other, Body>(in<Other>, lvlh, imu)));
  EXPECT_NO_THROW(static_cast<void>(in_a.angular_velocities<Body, Other>(in<Other>, lvlh, imu)));
  EXPECT_EQ(
      complaint([&] { return in_a.angular_velocities<Other, Body>(in<Body>, lvlh, imu); }),
      "attitude ephemeris message, the segment from line 7 on: the rates are in REF_FRAME_A, 'LVLH'; asked "
      "for 'IMU_FRAME_1' (attitude_ephemeris_message_test::Body)");

  std::string old = replaced(gmat_quaternions, "QUATERNION\n", "QUATERNION/RATE\nRATE_FRAME = REF_FRAME_A\n");
  for (const char* end : {"0.9240493645517975", "0.9240238945722674", "0.9239837093127769"})
    old = replaced(old, end, std::string{end} + " 0 0 0.06");
  EXPECT_EQ((segment_of(old).angular_velocities<Eme2000, Body>(in<Eme2000>, body)[2].coordinates().z()),
            0.06 * degree);
  EXPECT_EQ(
      complaint([&] {
        return segment_of(replaced(old, "A2B", "B2A")).angular_velocities<Eme2000, Body>(in<Eme2000>, body);
      }),
      "attitude ephemeris message, the segment from line 5 on: with ATTITUDE_DIR B2A it is not said "
      "whether the rates are of EME2000 or of SC_BODY_1");
}

// QUATERNION_TYPE says nothing of angles, wherever it comes from.
TEST(AttitudeEphemerisMessage, AnglesHaveNoScalar) {
  const std::string with = replaced(gmat_angles, "EULER_ROT_SEQ", "QUATERNION_TYPE = FIRST\nEULER_ROT_SEQ");
  const Segment segment = segment_of(with);
  EXPECT_EQ((segment.samples<Eme2000, Body>(body)[0].q_a_from_b.scalar_last()),
            (segment_of(gmat_angles).samples<Eme2000, Body>(body)[0].q_a_from_b.scalar_last()));
  EXPECT_NO_THROW(Message({"2.0", "", ""}, {segment}));
  EXPECT_EQ(
      complaint_of(replaced(with, "FIRST", "SECOND")),
      "attitude ephemeris message, line 16, column 19 (QUATERNION_TYPE): 'SECOND': it is FIRST or LAST");
}

TEST(AttitudeEphemerisMessage, DatesByTheDayOfTheYearWithZ) {
  const std::string text = replaced(replaced(spin, "SPIN/NUTATION", "EULER_ANGLE\nEULER_ROT_SEQ = 321"),
                                    " -109.9677896  0.366382445 18.16999799 -156.19211", "");
  const Segment segment = segment_of(text);
  EXPECT_EQ(segment.comments(),
            std::vector<std::string>{"             Spin KF ground solution, SPINKF rates "});
  EXPECT_EQ((segment.samples<Eme2000, Body>(body)[0].time), Epoch::from_utc("2006-03-31T05:00:00.071"));
  // Z is UTC, so that it contradicts another time system.
  EXPECT_EQ(complaint_of(replaced(text, "UTC", "TAI")),
            "attitude ephemeris message, line 23, column 1 (EPOCH): '2006-090T05:00:00.071Z': epoch "
            "'2006-090T05:00:00.071Z' in TAI: it is not written as 2022-04-14T10:22:11.874999");
}

}  // namespace
}  // namespace vectrix::attitude_ephemeris_message_test

#include <array>

#include "files/attitude_ephemeris_texts.hpp"
#include "files/canonical_metadata.hpp"

// Messages with every keyword of their version, and with others, exactly as they are written: no keyword can
// be read into another place, or be left out, without a test that fails.
namespace vectrix::attitude_ephemeris_message_test {
namespace {

using canonical_test::expect_canonical, canonical_test::tai;

const std::string newest = R"(CCSDS_AEM_VERS = 2.0
COMMENT of the header
CLASSIFICATION = public
CREATION_DATE = 2026-01-02T03:04:05
ORIGINATOR = HERE
MESSAGE_ID = 8
MISSION_PHASE = cruise, 2
USER_DEFINED_META_STAR = 1

META_START
COMMENT of the metadata
OBJECT_NAME = ORBITER
OBJECT_ID = 1996-062A
CENTER_NAME = MARS
REF_FRAME_A = GCRF
REF_FRAME_B = SC_BODY_1
TIME_SYSTEM = TAI
START_TIME = 1996-12-18T12:00:00.331
USEABLE_START_TIME = 1996-12-18T12:00:10.331
USEABLE_STOP_TIME = 1996-12-18T12:00:50.331
STOP_TIME = 1996-12-18T12:01:00.331
ATTITUDE_TYPE = QUATERNION/ANGVEL
ANGVEL_FRAME = REF_FRAME_B
INTERPOLATION_METHOD = LINEAR
INTERPOLATION_DEGREE = 1
ZEROTH = = [m]
MASS_KG =
META_STOP

DATA_START
COMMENT of the data
1996-12-18T12:00:00.331 6.0e-01 0.0e+00 0.0e+00 8.0e-01 1.0e+00 -2.5e+00 3.0e+00
1996-12-18T12:01:00.331 0.0e+00 8.0e-01 0.0e+00 6.0e-01 4.0e+00 5.0e+00 6.0e+00
DATA_STOP

META_START
OBJECT_NAME = ORBITER
OBJECT_ID = 1996-062A
REF_FRAME_A = GCRF
REF_FRAME_B = SC_BODY_1
TIME_SYSTEM = TAI
START_TIME = 1996-12-18T12:02:00.000
STOP_TIME = 1996-12-18T12:02:00.000
ATTITUDE_TYPE = EULER_ANGLE
EULER_ROT_SEQ = 321
META_STOP

DATA_START
1996-12-18T12:02:00.000 9.0e+01 0.0e+00 0.0e+00
DATA_STOP
)";
std::string as_oldest() {
  std::string text = replaced(replaced(newest, "CLASSIFICATION = public\n", ""), "MESSAGE_ID = 8\n", "");
  text = replaced(replaced(text, "= 2.0", "= 1.0"), "SC_BODY_1\nTIME", "SC_BODY_1\nATTITUDE_DIR = B2A\nTIME");
  text = replaced(text, "SC_BODY_1\nTIME", "SC_BODY_1\nATTITUDE_DIR = A2B\nTIME");  // of the second segment
  text = replaced(text, "QUATERNION/ANGVEL\n", "QUATERNION/RATE\nQUATERNION_TYPE = FIRST\n");
  return replaced(text, "ANGVEL_FRAME", "RATE_FRAME");
}
const std::string oldest = as_oldest();

// What both versions have.
void expect_attitude(const Message& message, const std::string& version) {
  ASSERT_EQ(message.segments().size(), 2U);
  const Segment& segment = message.segments()[0];
  const EphemerisMetadata& metadata = segment.metadata();
  expect_canonical(message.header(), metadata, version);
  EXPECT_EQ(segment.ref_frame_a(), "GCRF");
  EXPECT_EQ(segment.ref_frame_b(), "SC_BODY_1");
  EXPECT_EQ(segment.type(), AttitudeType::quaternion_rate);
  EXPECT_EQ(metadata.interpolation, "LINEAR");
  EXPECT_EQ(metadata.interpolation_degree, 1);
  EXPECT_EQ(segment.comments(), std::vector<std::string>{"of the data"});
  EXPECT_EQ(message.segments()[1].type(), AttitudeType::euler_angle);
  const auto turned = message.segments()[1].samples<Gcrf, Body>(body);
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_EQ(turned[0].time, tai("1996-12-18T12:02:00"));
  constexpr double rounding = 4e-16;  // of the half of 90 deg in radians, its sine and cosine
  EXPECT_LT((turned[0].q_a_from_b.eigen().coeffs() - Eigen::Vector4d(0, 0, 1, 1) / std::sqrt(2.0)).norm(),
            rounding);
}

TEST(AttitudeEphemerisMessage, EveryKeywordOfVersion2) {
  const auto message = Message::parse(newest);
  expect_attitude(message, "2.0");
  EXPECT_EQ(message.header().classification, "public");
  EXPECT_EQ(message.header().message_id, "8");
  const Segment& segment = message.segments()[0];
  const auto samples = segment.samples<Gcrf, Body>(body);
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].time, tai("1996-12-18T12:00:00.331"));
  EXPECT_EQ(samples[1].time, tai("1996-12-18T12:01:00.331"));
  EXPECT_EQ(samples[0].q_a_from_b.scalar_last(), (std::array{0.6, 0.0, 0.0, 0.8}));
  EXPECT_EQ(samples[1].q_a_from_b.scalar_last(), (std::array{0.0, 0.8, 0.0, 0.6}));
  const auto w = segment.angular_velocities<Gcrf, Body>(in<Body>, body);
  ASSERT_EQ(w.size(), 2U);
  EXPECT_EQ(w[0].coordinates(), Eigen::Vector3d(degree, degree * -2.5, degree * 3.0));
  EXPECT_EQ(w[1].coordinates(), Eigen::Vector3d(degree * 4.0, degree * 5.0, degree * 6.0));
  EXPECT_EQ(message.text(), newest);
}

TEST(AttitudeEphemerisMessage, EveryKeywordOfVersion1) {
  const auto message = Message::parse(oldest);
  expect_attitude(message, "1.0");
  const auto samples = message.segments()[0].samples<Gcrf, Body>(body);
  ASSERT_EQ(samples.size(), 2U);
  // B2A is the inverse, and the scalar comes first.
  EXPECT_EQ(samples[0].q_a_from_b.scalar_first(), (std::array{0.6, -0.0, -0.0, -0.8}));
  EXPECT_EQ(samples[1].q_a_from_b.scalar_first(), (std::array{0.0, -0.8, -0.0, -0.6}));
  EXPECT_EQ(message.text(), oldest);
}

}  // namespace
}  // namespace vectrix::attitude_ephemeris_message_test

#include <array>

#include "files/canonical_metadata.hpp"
#include "files/orbit_ephemeris_texts.hpp"

// Messages with every keyword of their version, and with others, exactly as they are written: no keyword can
// be read into another place, or be left out, without a test that fails.
namespace vectrix::orbit_ephemeris_message_test {
namespace {

using canonical_test::expect_canonical, canonical_test::tai;

const std::string newest = R"(CCSDS_OEM_VERS = 3.0
COMMENT of the header
CLASSIFICATION = public
CREATION_DATE = 2026-01-02T03:04:05
ORIGINATOR = HERE
MESSAGE_ID = 7
MISSION_PHASE = cruise, 2
USER_DEFINED_META_STAR = 1

META_START
COMMENT of the metadata
OBJECT_NAME = ORBITER
OBJECT_ID = 1996-062A
CENTER_NAME = MARS
REF_FRAME = TOD
REF_FRAME_EPOCH = 2000-01-01T11:58:55.816
TIME_SYSTEM = TAI
START_TIME = 1996-12-18T12:00:00.331
USEABLE_START_TIME = 1996-12-18T12:00:10.331
USEABLE_STOP_TIME = 1996-12-18T12:00:50.331
STOP_TIME = 1996-12-18T12:01:00.331
INTERPOLATION = HERMITE
INTERPOLATION_DEGREE = 3
ZEROTH = = [m]
MASS_KG =
META_STOP

COMMENT of the data
1996-12-18T12:00:00.331 2.7e+03 -2.8e-01 1.7e+03 4.75e+00 -2.5e+00 -1.0e+00 1.0e-03 -5.0e-07 1.5e-03
1996-12-18T12:01:00.331 2.8e+03 -3.1e+02 -1.9e+03 5.25e+00 -2.0e+00 0.0e+00 2.0e-03 2.0e-03 -3.0e-03

COVARIANCE_START
EPOCH = 1996-12-18T12:00:00.331
COV_REF_FRAME = RTN
1.0e+00
2.0e+00 3.0e+00
4.0e+00 5.0e+00 6.0e+00
7.0e+00 8.0e+00 9.0e+00 1.0e+01
1.1e+01 1.2e+01 1.3e+01 1.4e+01 1.5e+01
1.6e+01 1.7e+01 1.8e+01 1.9e+01 2.0e+01 2.1e+01
COVARIANCE_STOP
)";
const std::string second = replaced(
    replaced(replaced(newest, "= 3.0", "= 2.0"), "CLASSIFICATION = public\n", ""), "MESSAGE_ID = 7\n", "");
std::string as_oldest() {
  std::string text =
      replaced(replaced(second, "= 2.0", "= 1.0"), "REF_FRAME_EPOCH = 2000-01-01T11:58:55.816\n", "");
  text = replaced(replaced(text, " 1.0e-03 -5.0e-07 1.5e-03\n", "\n"), " 2.0e-03 2.0e-03 -3.0e-03\n", "\n");
  return text.substr(0, text.find("\nCOVARIANCE_START"));
}
const std::string oldest = as_oldest();

const auto mars_claim = called<MarsInertial>("TOD", "MARS");

// What all versions have.
void expect_orbit(const Message& message, const std::string& version) {
  ASSERT_EQ(message.segments().size(), 1U);
  const Segment& segment = message.segments().front();
  const EphemerisMetadata& metadata = segment.metadata();
  expect_canonical(message.header(), metadata, version);
  EXPECT_EQ(segment.ref_frame(), "TOD");
  EXPECT_EQ(metadata.interpolation, "HERMITE");
  EXPECT_EQ(metadata.interpolation_degree, 3);
  EXPECT_EQ(segment.comments(), std::vector<std::string>{"of the data"});
  const auto samples = segment.samples<MarsInertial, Ship>(mars_claim);
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].time, tai("1996-12-18T12:00:00.331"));
  EXPECT_EQ(samples[1].time, tai("1996-12-18T12:01:00.331"));
  EXPECT_EQ(position(samples[0]), Eigen::Vector3d(2.7e6, -280.0, 1.7e6));
  EXPECT_EQ(position(samples[1]), Eigen::Vector3d(2.8e6, -3.1e5, -1.9e6));
  EXPECT_EQ(samples[0].motion.velocity.coordinates(), Eigen::Vector3d(4750.0, -2500.0, -1000.0));
  EXPECT_EQ(samples[1].motion.velocity.coordinates(), Eigen::Vector3d(5250.0, -2000.0, 0.0));
}

// What version 1.0 does not have.
void expect_newer_parts(const Segment& segment) {
  EXPECT_EQ(segment.ref_frame_epoch(), tai("2000-01-01T11:58:55.816"));
  const auto accelerations = segment.accelerations<MarsInertial, Ship>(mars_claim);
  ASSERT_EQ(accelerations.size(), 2U);
  EXPECT_EQ(accelerations[0].coordinates(), Eigen::Vector3d(1.0, -5e-4, 1.5));
  EXPECT_EQ(accelerations[1].coordinates(), Eigen::Vector3d(2.0, 2.0, -3.0));
  ASSERT_EQ(segment.covariances().size(), 1U);
  EXPECT_EQ(segment.covariances()[0].epoch, tai("1996-12-18T12:00:00.331"));
  EXPECT_EQ(segment.covariances()[0].ref_frame, "RTN");
  EXPECT_EQ(
      segment.covariances()[0].lower_triangle,
      (std::array<double, 21>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21}));
}

TEST(OrbitEphemerisMessage, EveryKeywordOfVersion3) {
  const auto message = Message::parse(newest);
  expect_orbit(message, "3.0");
  EXPECT_EQ(message.header().classification, "public");
  EXPECT_EQ(message.header().message_id, "7");
  expect_newer_parts(message.segments().front());
  EXPECT_EQ(message.text(), newest);
}

TEST(OrbitEphemerisMessage, EveryKeywordOfVersion2) {
  const auto message = Message::parse(second);
  expect_orbit(message, "2.0");
  EXPECT_EQ(message.header().classification, "");
  EXPECT_EQ(message.header().message_id, "");
  expect_newer_parts(message.segments().front());
  EXPECT_EQ(message.text(), second);
}

TEST(OrbitEphemerisMessage, EveryKeywordOfVersion1) {
  const auto message = Message::parse(oldest);
  expect_orbit(message, "1.0");
  EXPECT_EQ(message.segments().front().ref_frame_epoch(), std::nullopt);
  EXPECT_TRUE(message.segments().front().covariances().empty());
  EXPECT_EQ(message.text(), oldest);
}

}  // namespace
}  // namespace vectrix::orbit_ephemeris_message_test

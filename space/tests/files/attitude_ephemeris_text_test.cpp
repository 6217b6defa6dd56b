#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "files/attitude_ephemeris_texts.hpp"

namespace vectrix::attitude_ephemeris_message_test {
namespace {

TEST(AttitudeEphemerisMessage, ATextOfAMessageIsTheMessage) {
  for (const std::string& text : {gmat_quaternions, gmat_angles, tracker, rates}) {
    const std::string written = Message::parse(text).text();
    EXPECT_EQ(Message::parse(written).text(), written);
    const TemporaryFile file("");
    Message::parse(text).write(file.path());
    EXPECT_EQ(Message::read(file.path()).text(), written);
  }
  const std::string old = Message::parse(tracker).text(), newer = Message::parse(rates).text();
  for (const char* part : {"REF_FRAME_A = STARTRACKER_2\nREF_FRAME_B = GTOD\nATTITUDE_DIR = B2A\n",
                           "ATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = LAST\n",
                           "INTERPOLATION_METHOD = LINEAR\nINTERPOLATION_DEGREE = 1\n",
                           "1996-11-28T22:08:03.555 4.2319e-01 -4.5697e-01 2.3784e-01 7.4533e-01\n"})
    EXPECT_NE(old.find(part), std::string::npos) << part << old;
  for (const char* part :
       {"ATTITUDE_TYPE = QUATERNION/ANGVEL\nANGVEL_FRAME = REF_FRAME_B\n",
        "COMMENT before the data\nCOMMENT between\n2021-04-15T13:31:20.000",
        "ATTITUDE_TYPE = EULER_ANGLE\nEULER_ROT_SEQ = ZXZ\n", "CLASSIFICATION = public\n",
        "9.0e+01 -4.5e+02 1.0e-300\n", "COMMENT between segments\n", "COMMENT at the end\n"})
    EXPECT_NE(newer.find(part), std::string::npos) << part << newer;
  EXPECT_EQ(newer.find("ATTITUDE_DIR"), std::string::npos);
}

// Random attitudes with and without rates, in both versions: the quaternions to the last bit, the rates,
// which are degrees in the file, to two roundings.
TEST(AttitudeEphemerisMessage, SamplesReadBackToTheLastBit) {
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  std::mt19937_64 random(20261129);
  std::normal_distribution<double> any;
  for (int run = 0; run < 200; ++run) {
    std::vector<AttitudeSample<Gcrf, Body, Epoch>> samples;
    std::vector<AngularVelocity<Gcrf, Body, In<Body>>> w;
    Epoch time = Epoch::from_utc("2016-12-31T23:59:55.123");
    for (int i = 0; i < 10; ++i) {
      const Eigen::Quaterniond q(any(random), any(random), any(random), std::pow(10.0, 3 * any(random)));
      samples.push_back({time, quaternion(to<Gcrf>, from<Body>, q.normalized())});
      w.push_back(angular_velocity(of<Body>, relative_to<Gcrf>,
                                   vectrix::vector<si::angular_velocity>(
                                       in<Body>, Eigen::Vector3d(any(random), any(random), any(random)))));
      time = Epoch::from_utc((time + 1.0 * si::second).utc(6));
    }
    const EphemerisMetadata metadata{"SHIP", "2026-001A"};
    const bool with_rates = run % 2 == 1;
    const Segment segment =
        with_rates ? Segment(metadata, samples, w, body) : Segment(metadata, samples, body);
    const Message message({run % 4 < 2 ? "1.0" : "2.0", "2026-11-29T00:00:00", "HERE"}, {segment});
    const Segment back = segment_of(message.text());
    const auto again = back.samples<Gcrf, Body>(body);
    ASSERT_EQ(again.size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      EXPECT_EQ(again[i].time, samples[i].time);
      EXPECT_EQ(again[i].q_a_from_b.eigen().coeffs(), samples[i].q_a_from_b.eigen().coeffs());
    }
    if (!with_rates) continue;
    const auto w_again = back.angular_velocities<Gcrf, Body>(in<Body>, body);
    for (std::size_t i = 0; i < samples.size(); ++i)
      EXPECT_LE((w_again[i].coordinates() - w[i].coordinates()).norm(),
                roundings * w[i].coordinates().norm());
  }
}

TEST(AttitudeEphemerisMessage, SegmentsOfSamples) {
  const auto samples = segment_of(gmat_quaternions).samples<Eme2000, Body>(body);
  const EphemerisMetadata metadata{"SHIP", "2026-001A"};
  const Segment segment(metadata, samples, body);
  EXPECT_EQ(segment.ref_frame_a(), "EME2000");
  EXPECT_EQ(segment.ref_frame_b(), "SC_BODY_1");
  EXPECT_EQ(segment.metadata().stop_time, samples[2].time);
  const std::string place = "attitude ephemeris segment of 'SHIP': ";
  EXPECT_EQ(complaint([&] { Segment(metadata, samples, called<Body>("SC\nBODY")); }),
            place + "REF_FRAME_B 'SC\nBODY' is not one line of printable ASCII without blanks around it");
  EXPECT_EQ(complaint([&] { Segment(metadata, samples, called<Body>("eme2000")); }),
            place + "both frames have the name 'EME2000'");
  EXPECT_EQ(complaint([&] {
              Segment(metadata, std::vector{samples[1], samples[0]}, body);
            }),
            place +
                "sample 1, at 2000-01-01T11:59:28.000, is not later than the one before, at "
                "2000-01-01T12:00:28.000");
  EXPECT_EQ(complaint([&] {
              Segment(metadata, samples, std::vector<AngularVelocity<Eme2000, Body, In<Body>>>{}, body);
            }),
            "attitude ephemeris segment: there are 3 samples and 0 rates");
  // Its rate is finite, but not in degrees.
  const std::vector<AttitudeSample<Eme2000, Body, Epoch>> two{samples[0], samples[1]};
  const auto w = [](double z) {
    return angular_velocity(of<Body>, relative_to<Eme2000>,
                            vectrix::vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(0, 0, z)));
  };
  EXPECT_EQ(complaint([&] {
              Segment(metadata, two, std::vector{w(1.0), w(1e308)}, body);
            }),
            place + "sample 1 has the number inf");
  EXPECT_EQ(complaint([&] {
              Message({"1.1", "", ""}, {segment});
            }),
            "attitude ephemeris message: the version is '1.1'; the versions are 1.0, 2.0");
  EXPECT_EQ(complaint([&] {
              Message({"1.0", "", ""}, {});
            }),
            "attitude ephemeris message: there are no segments");
  EXPECT_EQ(
      complaint([&] {
        Message({"2.0", "", ""}, {segment_of(tracker)});
      }),
      "attitude ephemeris message, the segment from line 5 on: version 2.0 has the direction A2B and the "
      "scalar last; the segment has B2A");
  EXPECT_EQ(
      complaint([&] {
        Message({"2.0", "", ""}, {segment_of(replaced(gmat_quaternions, "LAST", "FIRST"))});
      }),
      "attitude ephemeris message, the segment from line 5 on: version 2.0 has the direction A2B and the "
      "scalar last; the segment has QUATERNION_TYPE FIRST");
}

}  // namespace
}  // namespace vectrix::attitude_ephemeris_message_test

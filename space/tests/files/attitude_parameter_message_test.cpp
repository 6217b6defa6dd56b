#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "files/attitude_parameter_texts.hpp"
#include "files/replaced.hpp"
#include "temporary_file.hpp"

namespace vectrix::attitude_parameter_message_test {
namespace {

// Nothing merges the two: they are 130 deg apart.
TEST(AttitudeParameterMessage, TwoFormsOfVersion1AreBothKept) {
  const auto message = Message::parse(two_forms);
  EXPECT_EQ(message.epoch().utc(4), "2004-02-14T14:28:15.1172");
  EXPECT_EQ(message.metadata().object_name, "MARS SPIRIT");
  ASSERT_EQ(message.states().size(), 2U);
  EXPECT_EQ(message.states()[0].ref_frame_a(), "INSTRUMENT_A");
  EXPECT_EQ(message.states()[1].ref_frame_a(), "ITRF-97");
  const auto instrument = called<Instrument>("INSTRUMENT_A");
  const auto quaternion = message.states()[0].nearest_samples<Itrf, Instrument>(instrument);
  const auto angles = message.states()[1].samples<Itrf, Instrument>(instrument);
  EXPECT_EQ(quaternion.samples.front().time, message.epoch());
  EXPECT_LT(quaternion.distance, 1e-5);  // of five digits

  // A2B from the instrument to ITRF, and the other way round: q_b^a is Hamilton's product of the half turns.
  const Eigen::Quaterniond q(0.47832, 0.03123, 0.78543, 0.39158);
  constexpr double rounding = 1e-7;  // angularDistance near 0 is the root of a rounding
  EXPECT_LT(quaternion.samples.front().q_a_from_b.eigen().angularDistance(q.conjugate().normalized()),
            rounding);
  const Eigen::Quaterniond e = Eigen::AngleAxisd(-53.3688 * degree, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(139.7527 * degree, Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(25.0658 * degree, Eigen::Vector3d::UnitY());
  EXPECT_LT(angles.front().q_a_from_b.eigen().angularDistance(e), rounding);
  constexpr double apart = 130.0, rounded = 1.0;  // published as a whole number of degrees
  EXPECT_NEAR(e.angularDistance(quaternion.samples.front().q_a_from_b.eigen()) / degree, apart, rounded);
}

TEST(AttitudeParameterMessage, OtherBlocksAreNumbersWithNames) {
  const auto message = Message::parse(two_forms);
  ASSERT_EQ(message.blocks().size(), 5U);
  const auto inertia = message.blocks("inertia");
  ASSERT_EQ(inertia.size(), 1U);
  EXPECT_EQ(inertia[0].number("I11"), 6080.0);
  EXPECT_EQ(inertia[0].number("I12"), -135.9);
  EXPECT_EQ(inertia[0].comments, std::vector<std::string>{"          Spacecraft Parameters"});
  const auto manoeuvres = message.blocks("manoeuvre");
  ASSERT_EQ(manoeuvres.size(), 1U);
  EXPECT_EQ(manoeuvres[0].number("MAN_TOR_2"), -0.5);
  EXPECT_EQ(*manoeuvres[0].text("MAN_REF_FRAME"), "INSTRUMENT_A");
  EXPECT_EQ(message.blocks("Euler angles")[0].number("Y_RATE"), 0.03214);
  EXPECT_EQ(complaint([&] { static_cast<void>(inertia[0].number("IXX")); }), "the inertia: there is no IXX");
  EXPECT_EQ(complaint([&] { static_cast<void>(manoeuvres[0].number("MAN_REF_FRAME")); }),
            "the manoeuvre, MAN_REF_FRAME: 'INSTRUMENT_A': not a finite number");
  EXPECT_EQ(inertia[0].text("MASS"), nullptr);
  const auto two = Message::parse(two_forms + two_forms.substr(two_forms.find("MAN_EPOCH")));
  EXPECT_EQ(two.blocks("manoeuvre").size(), 2U);
}

TEST(AttitudeParameterMessage, BlocksOfVersion2) {
  const auto message = Message::parse(blocks);
  ASSERT_EQ(message.states().size(), 4U);
  const auto body = called<Body>("SC_BODY_1");
  const auto q = message.states()[0].samples<Eme2000, Body>(body).front().q_a_from_b.eigen();
  EXPECT_EQ(q.w(), 0.8);
  EXPECT_EQ(q.z(), 0.6);
  EXPECT_EQ(message.states()[1].ref_frame_b(), "STARTRACKER_2");
  const auto angles = message.states()[2].samples<Eme2000, Body>(body).front().q_a_from_b.eigen();
  const Eigen::Quaterniond b_from_a = Eigen::AngleAxisd(10 * degree, Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(20 * degree, Eigen::Vector3d::UnitX()) *
                                      Eigen::AngleAxisd(30 * degree, Eigen::Vector3d::UnitZ());
  constexpr double rounding = 1e-7;  // as above
  EXPECT_LT(angles.angularDistance(b_from_a.conjugate()), rounding);

  const AttitudeEphemerisSegment& turning = message.states()[3];
  const auto w = turning.angular_velocities<Eme2000, Body>(in<Body>, body).front();
  EXPECT_LT((w.coordinates() - degree * Eigen::Vector3d(1, -2, 3)).norm(), 1e-15);
  EXPECT_EQ(
      (turning.angular_velocities<Body, Eme2000>(in<Body>, body).front().coordinates() + w.coordinates())
          .norm(),
      0.0);
  EXPECT_EQ(
      complaint([&] { static_cast<void>(turning.samples<Eme2000, Body>(body)); }),
      "attitude parameter message, the angular velocity from line 51 on: there is an angular velocity, but "
      "no attitude");
  EXPECT_NE(complaint([&] {
              static_cast<void>(turning.angular_velocities<Eme2000, Body>(in<Eme2000>, body));
            }).find("the rates are in REF_FRAME_B, 'SC_BODY_1'; asked for 'EME2000'"),
            std::string::npos);

  EXPECT_EQ(message.header().others, (std::vector<OtherKeyword>{{"MISSION_PHASE", "cruise, 2"}}));
  EXPECT_EQ(message.metadata().others, (std::vector<OtherKeyword>{{"ZEROTH", "= [m]"}}));
  EXPECT_EQ(*message.blocks("manoeuvre")[0].text("USER_DEFINED_VALVE"), "3");
  EXPECT_EQ(message.blocks("spin")[0].number("NUTATION_VEL"), 7.0);
}

TEST(AttitudeParameterMessage, RepeatedAxesAreInTheOrderOfTheirLines) {
  const auto text = replaced(replaced(two_forms, "= 312", "= 313"), "Y_ANGLE ", "Z_ANGLE ");
  const auto q =
      Message::parse(text).states()[1].samples<Itrf, Instrument>(called<Instrument>("INSTRUMENT_A"));
  const Eigen::Quaterniond e = Eigen::AngleAxisd(-53.3688 * degree, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(139.7527 * degree, Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(25.0658 * degree, Eigen::Vector3d::UnitZ());
  EXPECT_LT(q.front().q_a_from_b.eigen().angularDistance(e), 1e-7);
  EXPECT_EQ(Message::parse(Message::parse(text).text()).text(), Message::parse(text).text());
}

TEST(AttitudeParameterMessage, TextReadsBack) {
  for (const std::string& text : {two_forms, blocks}) {
    const std::string written = Message::parse(text).text();
    const auto again = Message::parse(written);
    EXPECT_EQ(again.text(), written);
    EXPECT_EQ(again.blocks().size(), Message::parse(text).blocks().size());
    for (std::size_t i = 0; i < again.blocks().size(); ++i) {
      EXPECT_EQ(again.blocks()[i].entries, Message::parse(text).blocks()[i].entries);
      EXPECT_EQ(again.blocks()[i].comments, Message::parse(text).blocks()[i].comments);
    }
  }
  // The text of this one is canonical, but for a comment at the end of a block.
  EXPECT_EQ(Message::parse(blocks).text(), replaced(replaced(blocks, "= 3\nCOMMENT at the end", "= 3"),
                                                    "MAN_START\n", "MAN_START\nCOMMENT at the end\n"));
  const TemporaryFile file("");
  Message::parse(blocks).write(file.path());
  EXPECT_EQ(Message::read(file.path()).text(), Message::parse(blocks).text());
}

TEST(AttitudeParameterMessage, OfOwnStates) {
  const Epoch t = Epoch::from_utc("2026-11-29T00:00:00");
  const std::vector<AttitudeSample<Eme2000, Body, Epoch>> samples{
      {t, quaternion_scalar_first(to<Eme2000>, from<Body>, 0.8, 0.6, 0.0, 0.0)}};
  const std::vector w{
      angular_velocity(of<Body>, relative_to<Eme2000>,
                       vector(in<Body>, 0.1 * (si::radian / si::second), 0.2 * (si::radian / si::second),
                              0.3 * (si::radian / si::second)))};
  const auto body = called<Body>("SC_BODY_1");
  const AttitudeEphemerisSegment segment({"SATELLITE", "2026-001A"}, samples, w, body);
  const Message message({"2.0", "2026-11-29T00:00:00", "HERE"}, {segment});
  ASSERT_EQ(message.states().size(), 2U);
  const Message again = Message::parse(message.text());
  EXPECT_EQ(again.epoch(), t);
  const auto q = again.states()[0].samples<Eme2000, Body>(body).front().q_a_from_b;
  EXPECT_EQ(q.eigen().coeffs(), samples.front().q_a_from_b.eigen().coeffs());
  constexpr double rounding = 1e-16;  // to degrees and back
  EXPECT_LT((again.states()[1].angular_velocities<Eme2000, Body>(in<Body>, body).front().coordinates() -
             w.front().coordinates())
                .norm(),
            rounding);

  EXPECT_NE(complaint([&] {
              Message({"1.0", "", ""}, {segment});
            }).find("a message of segments has 2.0"),
            std::string::npos);
  EXPECT_NE(complaint([&] {
              Message({"2.0", "", ""}, {});
            }).find("there are no segments"),
            std::string::npos);
  auto two = samples;
  two.push_back({t + 1.0 * si::second, two.front().q_a_from_b});
  EXPECT_NE(complaint([&] {
              Message({"2.0", "", ""}, {AttitudeEphemerisSegment({"SATELLITE", "2026-001A"}, two, body)});
            }).find("a state has one sample"),
            std::string::npos);
}

}  // namespace
}  // namespace vectrix::attitude_parameter_message_test

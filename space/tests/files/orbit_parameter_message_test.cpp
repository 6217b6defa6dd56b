#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include <vectrix/space.hpp>

#include "files/faults.hpp"
#include "files/replaced.hpp"
#include "temporary_file.hpp"

namespace vectrix::orbit_parameter_message_test {
namespace {

using earth::Eme2000, earth::Itrf, earth::TrueOfDate;
using Message = OrbitParameterMessage;

struct Satellite : moving_frame {};

// Of CS-SI/Orekit (at fe4aee84, Apache-2.0), with a manoeuvre written here: the elements and the state agree.
const std::string eutelsat = R"(CCSDS_OPM_VERS    = 3.0
COMMENT  Current intermediate orbit IO2 and maneuver planning data
CREATION_DATE     = 2000-06-03T05:33:00.000
ORIGINATOR        = GSOC
OBJECT_NAME       = EUTELSAT W4
OBJECT_ID         = 2000-028A
CENTER_NAME       = EARTH
REF_FRAME         = TOD
TIME_SYSTEM       = UTC
COMMENT  State Vector
EPOCH             = 2006-06-03T00:00:00.000
X                 =   6655.9942        [km]
Y                 = -40218.5751        [km]
Z                 =    -82.9177        [km]
X_DOT             =      3.11548208    [km/s]
Y_DOT             =      0.47042605    [km/s]
Z_DOT             =     -0.00101495    [km/s]
COMMENT  Keplerian elements
SEMI_MAJOR_AXIS   =   41399.5123       [km]
ECCENTRICITY      =       0.020842611
INCLINATION       =       0.117746     [deg]
RA_OF_ASC_NODE    =      17.604721     [deg]
ARG_OF_PERICENTER =     218.242943     [deg]
TRUE_ANOMALY      =      41.922339     [deg]
GM                =  398600.4415       [km**3/s**2]
COMMENT  Spacecraft parameters
MASS              =    1913.000        [kg]
SOLAR_RAD_AREA    =      10.000        [m**2]
SOLAR_RAD_COEFF   =       1.300
DRAG_AREA         =      10.000        [m**2]
DRAG_COEFF        =       2.300
COV_REF_FRAME     = RTN
CX_X              = 3.331349476038534e-04
CY_X              = 4.618927349220216e-04
CY_Y              = 6.782421679971363e-04
CZ_X              = -3.070007847730449e-04
CZ_Y              = -4.221234189514228e-04
CZ_Z              = 3.231931992380369e-04
CX_DOT_X          = -3.349365033922630e-07
CX_DOT_Y          = -4.686084221046758e-07
CX_DOT_Z          = 2.484949578400095e-07
CX_DOT_X_DOT      = 4.296022805587290e-10
CY_DOT_X          = -2.211832501084875e-07
CY_DOT_Y          = -2.864186892102733e-07
CY_DOT_Z          = 1.798098699846038e-07
CY_DOT_X_DOT      = 2.608899201686016e-10
CY_DOT_Y_DOT      = 1.767514756338532e-10
CZ_DOT_X          = -3.041346050686871e-07
CZ_DOT_Y          = -4.989496988610662e-07
CZ_DOT_Z          = 3.540310904497689e-07
CZ_DOT_X_DOT      = 1.869263192954590e-10
CZ_DOT_Y_DOT      = 1.008862586240695e-10
CZ_DOT_Z_DOT      = 6.224444338635500e-10
MAN_EPOCH_IGNITION = 2006-154T04:00:00Z
MAN_DURATION = 132.60 [s]
MAN_DELTA_MASS = -18.418 [kg]
MAN_REF_FRAME = EME2000
MAN_DV_1 = -0.02325700
MAN_DV_2 = .01683160
MAN_DV_3 = -.893E-2 [km/s]
USER_DEFINED_OBJ1_TIME_LASTOB_START = 2020-01-29T13:30:00
)";

// The published number is the mean anomaly of the state, with the keyword of the true one.
const std::string with_mean_anomaly = replaced(eutelsat, "TRUE_ANOMALY", "MEAN_ANOMALY");

// One unit in the last digits of the file: 1e-8 km/s is 0.3 m in a, which is 41399.512 km.
constexpr double digits = 1.0, per_second = 1e-4;

TEST(OrbitParameterMessage, StateAndElementsOfOneOrbit) {
  const auto message = Message::parse(with_mean_anomaly);
  EXPECT_EQ(message.epoch().utc(3), "2006-06-03T00:00:00.000");
  const auto sample = message.state().samples<TrueOfDate, Satellite>().front();
  EXPECT_EQ(sample.time, message.epoch());
  EXPECT_EQ(sample.motion.position.coordinates(), Eigen::Vector3d(6655994.2, -40218575.1, -82917.7));
  EXPECT_EQ(sample.motion.velocity.coordinates(), Eigen::Vector3d(3115.48208, 470.42605, -1.01495));
  ASSERT_TRUE(message.elements());
  EXPECT_EQ(message.elements()->semi_major_axis.value(), 41399512.3);
  EXPECT_EQ(message.elements()->gm.value(), 398600.4415e9);
  EXPECT_LT(message.elements_distance().position.value(), digits);
  EXPECT_LT(message.elements_distance().velocity.value(), per_second);

  // The elements of the state are those of the message, to their digits: as numbers, in an inertial frame.
  const auto inertial = Message::parse(replaced(eutelsat, "= TOD", "= EME2000"));
  const auto elements = keplerian_elements(inertial.elements()->gm,
                                           inertial.state().samples<Eme2000, Satellite>().front().motion);
  EXPECT_NEAR(elements.semi_major_axis().value(), 41399512.3, digits);
  EXPECT_NEAR(elements.inclination().in(si::degree), 0.117746, 1e-6);
}

// With the mean anomaly 41.922339 deg for a true one, 1.627060 deg less than 43.549401: r times the angle.
TEST(OrbitParameterMessage, ElementsThatAreAnotherStateAreReportedNotChosen) {
  const auto published = Message::parse(eutelsat);
  constexpr double r = 40765.6e3, angle = 1.62706 * std::numbers::pi / 180.0, rounded = 1e-3;
  EXPECT_NEAR(published.elements_distance().position.value() / (r * angle), 1.0, rounded);
  const auto kept = published.state().samples<TrueOfDate, Satellite>().front();
  EXPECT_EQ(kept.motion.position.coordinates().x(), 6655994.2);
  const auto none = Message::parse(eutelsat.substr(0, eutelsat.find("COMMENT  Keplerian")));
  EXPECT_FALSE(none.elements());
  EXPECT_EQ(
      complaint([&] { static_cast<void>(none.elements_distance()); }),
      "orbit parameter message, the state vector from line 11 on: the message has no Keplerian elements");
}

// tan nu/2 = sqrt((1 + e)/(1 - e)) tan E/2, M = E - e sin E.
TEST(OrbitParameterMessage, ATrueAnomalyIsTheSamePlace) {
  const auto true_one = Message::parse(replaced(eutelsat, "41.922339", "43.549374"));
  EXPECT_LT(true_one.elements_distance().position.value(), digits);
  EXPECT_NEAR(Message::parse(with_mean_anomaly).elements()->true_anomaly.angle.in(si::degree), 43.549374,
              1e-6);
}

TEST(OrbitParameterMessage, CovarianceManoeuvresAndSpacecraft) {
  const auto message = Message::parse(eutelsat);
  ASSERT_EQ(message.state().covariances().size(), 1U);
  const OrbitCovariance& covariance = message.state().covariances().front();
  EXPECT_EQ(covariance.ref_frame, "RTN");
  EXPECT_EQ(covariance.epoch, message.epoch());
  EXPECT_EQ(covariance.lower_triangle[0], 3.331349476038534e-04);
  EXPECT_EQ(covariance.lower_triangle[20], 6.224444338635500e-10);
  const auto manoeuvres = message.blocks("manoeuvre");
  ASSERT_EQ(manoeuvres.size(), 1U);
  EXPECT_EQ(manoeuvres[0].number("MAN_DV_2"), 0.0168316);
  EXPECT_EQ(manoeuvres[0].number("MAN_DV_3"), -0.00893);
  EXPECT_EQ(*manoeuvres[0].text("USER_DEFINED_OBJ1_TIME_LASTOB_START"), "2020-01-29T13:30:00");
  EXPECT_EQ(message.blocks("spacecraft")[0].number("MASS"), 1913.0);
  EXPECT_EQ(message.blocks("spacecraft")[0].comments, std::vector<std::string>{" Spacecraft parameters"});
}

TEST(OrbitParameterMessage, FramesThatWereNotAskedForAreRefused) {
  const auto message = Message::parse(eutelsat);
  EXPECT_EQ(
      complaint([&] { static_cast<void>(message.state().samples<Eme2000, Satellite>()); }),
      "orbit parameter message, the state vector from line 11 on: REF_FRAME is 'TOD', earth::TrueOfDate; "
      "asked for 'EME2000' (earth::Eme2000)");
  const auto still =
      Message::parse(replaced(eutelsat, "TIME_SYSTEM", "REF_FRAME_EPOCH = 2000-01-01T12:00:00\nTIME_SYSTEM"));
  EXPECT_NE(complaint([&] {
              static_cast<void>(still.state().samples<TrueOfDate, Satellite>());
            }).find("REF_FRAME_EPOCH stops TOD at 2000-01-01T12:00:00.000"),
            std::string::npos);
}

TEST(OrbitParameterMessage, TextReadsBack) {
  const auto message = Message::parse(eutelsat);
  const std::string written = message.text();
  EXPECT_EQ(Message::parse(written).text(), written);
  for (std::size_t i = 0; i < message.blocks().size(); ++i) {
    EXPECT_EQ(Message::parse(written).blocks()[i].entries, message.blocks()[i].entries);
    EXPECT_EQ(Message::parse(written).blocks()[i].comments, message.blocks()[i].comments);
  }
  const TemporaryFile file("");
  message.write(file.path());
  EXPECT_EQ(Message::read(file.path()).text(), written);
}

TEST(OrbitParameterMessage, OfAnOwnState) {
  const auto read = Message::parse(eutelsat);
  const Message own({"2.0", "2026-11-29T00:00:00", "HERE"}, read.state());
  const auto again = Message::parse(own.text());
  const auto sample = again.state().samples<TrueOfDate, Satellite>().front();
  const auto expected = read.state().samples<TrueOfDate, Satellite>().front();
  EXPECT_EQ(sample.time, expected.time);
  EXPECT_EQ(sample.motion.position.coordinates(), expected.motion.position.coordinates());
  EXPECT_EQ(sample.motion.velocity.coordinates(), expected.motion.velocity.coordinates());
  EXPECT_EQ(again.state().covariances().front().lower_triangle,
            read.state().covariances().front().lower_triangle);
  EXPECT_NE(complaint([&] {
              Message({"1.0", "", ""}, read.state());
            }).find("the keyword is of version 2.0, the message of version 1.0"),
            std::string::npos);
  const std::vector<PositionSample<TrueOfDate, Satellite, Epoch>> two{
      expected, {expected.time + 1.0 * si::second, expected.motion}};
  EXPECT_NE(complaint([&] {
              Message({"2.0", "", ""}, OrbitEphemerisSegment({"A", "B"}, two));
            }).find("a state has one sample, the segment has 2"),
            std::string::npos);
}

TEST(OrbitParameterMessage, EveryFaultHasALineAColumnAndAReason) {
  expect_faults<Message>(
      eutelsat, "orbit parameter message",
      {{"3.0", "4.0", "line 1, column 21 (CCSDS_OPM_VERS): '4.0': the versions are 1.0, 2.0, 3.0"},
       {"3.0", "1.0",
        "line 32, column 21 (COV_REF_FRAME): 'RTN': the keyword is of version 2.0, the message of "
        "version 1.0"},
       {"REF_FRAME         = TOD", "", "the message: there is no REF_FRAME"},
       {"CENTER_NAME       = EARTH",
        "CENTER_NAME       =", "line 7, column 20 (CENTER_NAME): '': it is empty"},
       {"X                 =   6655.9942        [km]", "", "the state vector from line 11 on: there is no X"},
       {"-40218.5751        [km]", "-40218.5751 [m]",
        "line 13, column 21 (Y): '-40218.5751 [m]': the unit is [km]"},
       {"-40218.5751        [km]", "-40218.5751 [ft]",
        "line 13, column 21 (Y): '-40218.5751 [ft]': the unit is [km]"},
       {"3.11548208    [km/s]", "3.11548208 [m\xC3\x97s\xE2\x81\xBB\xC2\xB9]",
        "line 15, column 39: the byte 195 is no printable character of ASCII"},
       {"3.11548208    [km/s]", "3.11548208D0",
        "line 15, column 26 (X_DOT): '3.11548208D0': its exponent has the letter D, where E is needed"},
       {"3.11548208    [km/s]", "inf", "line 15, column 26 (X_DOT): 'inf': not a finite number"},
       {"SOLAR_RAD_AREA    =      10.000        [m**2]", "SOLAR_RAD_AREA    = 10.000 [s]",
        "line 28, column 21 (SOLAR_RAD_AREA): '10.000 [s]': the unit is [m**2]"},
       {"1913.000", "-1913", "line 27, column 24 (MASS): '-1913        [kg]': it is negative"},
       {"132.60 [s]", "-1 [s]", "line 55, column 16 (MAN_DURATION): '-1 [s]': it is negative"},
       {"1.300", "1.300 [m]", "line 29, column 27 (SOLAR_RAD_COEFF): '1.300 [m]': it has no unit"},
       {"SEMI_MAJOR_AXIS   =   41399.5123       [km]", "SEMI_MAJOR_AXIS = -41399.5123 [km]",
        "line 19, column 19 (SEMI_MAJOR_AXIS): '-41399.5123 [km]': semi_latus_rectum: a (1 - e^2) is "
        "-41381527.754325405 m; it must be finite and positive"},
       {"0.020842611", "-0.1", "line 20, column 27 (ECCENTRICITY): '-0.1': it is negative"},
       {"0.117746     [deg]", "190 [deg]",
        "line 21, column 27 (INCLINATION): '190 [deg]': not in [0, 180] deg"},
       {"GM                =  398600.4415       [km**3/s**2]", "GM = 0",
        "line 25, column 6 (GM): '0': it is not positive"},
       {"GM  ", "MEAN_ANOMALY = 40\nGM  ",
        "line 25, column 16 (MEAN_ANOMALY): '40': there is a TRUE_ANOMALY, too; the elements have one "
        "anomaly"},
       {"TRUE_ANOMALY      =      41.922339     [deg]\n", "",
        "the Keplerian elements from line 19 on: there is no TRUE_ANOMALY"},
       {"6.782421679971363e-04", "-6.782421679971363e-04",
        "line 35, column 21 (CY_Y): '-6.782421679971363e-04': a variance that is negative"},
       {"CZ_DOT_Y          = -4.989496988610662e-07\n", "",
        "the covariance from line 32 on: there is no CZ_DOT_Y"},
       {"MAN_EPOCH_IGNITION = 2006-154T04:00:00Z", "",
        "line 55, column 16 (MAN_DURATION): '132.60 [s]': the manoeuvre begins with MAN_EPOCH_IGNITION"},
       {"2006-154T04", "2006-366T04",
        "line 54, column 22 (MAN_EPOCH_IGNITION): '2006-366T04:00:00Z': epoch '2006-366T04:00:00Z' in UTC: "
        "there is "
        "no such day"},
       {"DRAG_COEFF ", "DRAG_COEF ",
        "line 31, column 26 (DRAG_COEF): '2.300': the keyword is not of the standard, but nearly "
        "DRAG_COEFF"}});
  EXPECT_EQ(complaint_of<Message>(eutelsat.substr(0, eutelsat.find("COMMENT  State"))),
            "orbit parameter message: there are no data");
  EXPECT_EQ(complaint_of<Message>(replaced(
                replaced(eutelsat.substr(0, eutelsat.find("COMMENT  State")), "UTC", "UTC\nMASS = 1"), "3.0",
                "1.0")),
            "orbit parameter message: there is no state vector");
  const std::string hyperbola =
      replaced(replaced(eutelsat, "  41399.5123", "-41399.5123"), "0.020842611", "2");
  EXPECT_EQ(complaint_of<Message>(hyperbola), "nothing was thrown");
  EXPECT_EQ(complaint_of<Message>(replaced(hyperbola, "41.922339     [deg]", "130 [deg]")),
            "orbit parameter message, line 24, column 26 (TRUE_ANOMALY): '130 [deg]': elements: the true "
            "anomaly is "
            "2.2689280275926285 rad, not inside the asymptotes of the orbit");
}

}  // namespace
}  // namespace vectrix::orbit_parameter_message_test

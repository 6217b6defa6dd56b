#include "convert.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>

#include "message_kind.hpp"
#include "plain_attitude.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::convert_test {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;
using earth::Eme2000;

struct Body : moving_frame {};

// A table in the convention in which convert writes one.
TableColumns written_columns(const std::string& reference, const std::string& scale,
                             const TableColumns& like) {
  const std::string q = "q_" + reference + "_from_body_";
  TableColumns columns = like;
  columns.time = "time_" + scale;
  columns.quaternion = {q + "w", q + "x", q + "y", q + "z"};
  columns.stated = {Scalar::first, Maps::to_reference};
  if (!like.rates.empty()) {
    const std::string w = "rate_in_" + (like.rate_axes == RateAxes::body ? "body" : reference) +
                          (like.rates_in_degrees ? "_deg_per_s_" : "_rad_per_s_");
    columns.rates = {w + "x", w + "y", w + "z"};
  }
  return columns;
}

double any_number(double size) {
  return size * (1e-17 * static_cast<double>(*rc::gen::inRange<std::int64_t>(-100'000'000'000'000'000,
                                                                             100'000'000'000'000'001)));
}

std::string convert_to(const AttitudeSource& source, const std::filesystem::path& out) {
  ConvertOptions options;
  options.out = out;
  options.text.object_name = "S";
  options.text.object_id = "2026-001A";
  options.text.originator = "TEST";
  options.body = "SC_BODY_1";
  options.text.creation_date = "2026-11-29T00:00:00";
  std::ostringstream said;
  convert(source, options, said);
  return said.str();
}

// Table, table, message, table: times and numbers are the same to the last digit, and so is every sign.
RC_GTEST_PROP(Convert, LosesNoDigit, ()) {
  TemporaryFolder folder;
  const bool utc = *rc::gen::arbitrary<bool>(), has_rates = *rc::gen::arbitrary<bool>();
  const std::string scale = utc ? "utc" : "tt";
  TableColumns columns{
      "t",
      utc ? TimeScale(scale::utc) : TimeScale(scale::tt),
      {"a", "b", "c", "d"},
      {*rc::gen::element(Scalar::first, Scalar::last), *rc::gen::element(Maps::to_body, Maps::to_reference)},
      "EME2000",
      {}};
  if (has_rates) columns.rates = {"wx", "wy", "wz"};
  columns.rates_in_degrees = true;
  columns.rate_axes = *rc::gen::element(RateAxes::body, RateAxes::reference);
  std::string text = has_rates ? "t,a,b,c,d,wx,wy,wz\n" : "t,a,b,c,d\n";
  const auto start = Epoch::from_utc("2026-11-29T00:00:00");
  for (int i = 0; i < 5; ++i) {
    const Epoch t = start + (10.0 * i + 1.0 + any_number(1.0)) * si::second;
    Eigen::Vector4d q(0.5 + 0.4 * any_number(1.0), any_number(1.0), any_number(1.0), any_number(1.0));
    q /= q.norm() * (1.0 + any_number(0.009));
    text += exact_text(t, columns.scale);
    for (const double number : q) text += "," + detail::text(number);
    for (int k = 0; has_rates && k < 3; ++k) text += "," + detail::text(any_number(5.0));
    text += "\n";
  }
  const AttitudeSource source{folder.written("in.csv", text), columns};
  const PlainAttitude expected = plain(read_attitude(source));
  const TableColumns written = written_columns("eme2000", scale, columns);
  const auto same = [&](const AttitudeSource& found) {
    const PlainAttitude attitude = plain(read_attitude(found));
    return attitude.times == expected.times && attitude.quaternions == expected.quaternions &&
           attitude.rates == expected.rates && (!has_rates || attitude.rate_axes == expected.rate_axes) &&
           attitude.reference == "EME2000" && attitude.time_scale.name() == expected.time_scale.name();
  };
  const std::string report = "5 samples of SC_BODY_1 relative to EME2000\n";
  const AttitudeSource second{folder.file("second.csv"), written}, third{folder.file("third.aem"), {}},
      fourth{folder.file("fourth.csv"), written};
  RC_ASSERT(convert_to(source, second.file) == second.file.string() + ": " + report);
  RC_ASSERT(same(second));
  RC_ASSERT(convert_to(second, third.file) == third.file.string() + ": " + report);
  RC_ASSERT(same(third));
  RC_ASSERT(convert_to(third, fourth.file) == fourth.file.string() + ": " + report);
  RC_ASSERT(same(fourth));
}

constexpr const char* head =
    "CCSDS_AEM_VERS = 1.0\nCOMMENT of the header\nCREATION_DATE = 2020-01-01T00:00:00\nORIGINATOR = "
    "SOMEONE\n";
std::string segment(const std::string& direction, const std::string& type, const std::string& lines) {
  return "META_START\nCOMMENT of the metadata\nOBJECT_NAME = SAT\nOBJECT_ID = 2020-007B\nREF_FRAME_A = "
         "SC_BODY_1\n"
         "REF_FRAME_B = J2000\nATTITUDE_DIR = " +
         direction +
         "\nTIME_SYSTEM = TAI\nSTART_TIME = 2026-11-29T00:00:00\nUSEABLE_START_TIME = 2026-11-29T00:00:30\n"
         "STOP_TIME = 2026-11-29T00:03:00\n" +
         type + "META_STOP\nDATA_START\nCOMMENT of the data\n" + lines + "DATA_STOP\n";
}
const std::string first_scalar = "ATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = FIRST\n";
const std::string three_lines =
    "2026-11-29T00:00:00 0.6 0.8 0 0\n2026-11-29T00:01:00 0.8 0 0.6 0\n2026-11-29T00:03:00 0.8 0 0 -0.6\n";

TEST(Convert, KeepsTheAttitudeOfAMessageAndItsWords) {
  for (const char* direction : {"A2B", "B2A"}) {
    TemporaryFolder folder;
    const auto in = folder.written("in.aem", head + segment(direction, first_scalar, three_lines));
    AttitudeSource source{in};
    ConvertOptions options{folder.file("out.aem")};
    options.text.creation_date = "2026-11-29T00:00:00";
    std::ostringstream said;
    convert(source, options, said);
    const auto before = AttitudeEphemerisMessage::read(in),
               after = AttitudeEphemerisMessage::read(options.out);
    const auto body = called<Body>("SC_BODY_1");
    const auto samples = before.segments()[0].samples<Eme2000, Body>(body),
               found = after.segments()[0].samples<Eme2000, Body>(body);
    ASSERT_EQ(found.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(found[i].time, samples[i].time);
      EXPECT_EQ(found[i].q_a_from_b.scalar_last(), samples[i].q_a_from_b.scalar_last());
    }
    EXPECT_EQ(content(options.out).substr(0, content(options.out).find("DATA_START")),
              "CCSDS_AEM_VERS = 2.0\nCOMMENT of the header\nCREATION_DATE = 2026-11-29T00:00:00\nORIGINATOR "
              "= SOMEONE\n\n"
              "META_START\nCOMMENT of the metadata\nOBJECT_NAME = SAT\nOBJECT_ID = 2020-007B\nREF_FRAME_A = "
              "EME2000\n"
              "REF_FRAME_B = SC_BODY_1\nTIME_SYSTEM = TAI\nSTART_TIME = 2026-11-29T00:00:00.000\n"
              "USEABLE_START_TIME = 2026-11-29T00:00:30.000\nSTOP_TIME = 2026-11-29T00:03:00.000\n"
              "ATTITUDE_TYPE = QUATERNION\nMETA_STOP\n\n");
    EXPECT_EQ(after.segments()[0].comments(), before.segments()[0].comments());
    // Version 1.0, and fewer samples.
    options.aem_version = "1.0";
    options.force = true;
    source.selection.from = Epoch::from("2026-11-29T00:00:45 TAI");
    convert(source, options, said);
    const auto old = AttitudeEphemerisMessage::read(options.out);
    EXPECT_EQ(old.header().version, "1.0");
    EXPECT_EQ(old.segments()[0].size(), 2U);
    EXPECT_EQ(old.segments()[0].metadata().start_time, samples[1].time);
    EXPECT_EQ(old.segments()[0].metadata().useable_start_time, samples[1].time);
    EXPECT_EQ((old.segments()[0].samples<Eme2000, Body>(body)[1].q_a_from_b.scalar_last()),
              samples[2].q_a_from_b.scalar_last());
  }
}

TEST(Convert, TurnsAttitudeAndRatesToTheOtherFrame) {
  PlainAttitude attitude{"body",
                         "EME2000",
                         scale::utc,
                         {Epoch::from_utc("2026-11-29T00:00:00")},
                         {{0.5, -0.5, 0.5, 0.5}},
                         {Eigen::Vector3d(1.0, 2.0, 3.0)}};
  attitude.rate_axes = RateAxes::reference;
  const auto rotation = [](const PlainAttitude& a) {
    const auto& q = a.quaternions[0];
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  };
  const auto turned = relative_to_frame(attitude, "GCRF");
  const Eigen::Matrix3d R_gcrf_from_eme = inverse(eme2000_from_gcrf()).matrix();
  constexpr double rounding = 4e-15;  // of nine numbers, after two turns
  EXPECT_EQ(turned.reference, "GCRF");
  EXPECT_LE((rotation(turned) - R_gcrf_from_eme * rotation(attitude)).norm(), rounding);
  EXPECT_LE((turned.rates[0] - R_gcrf_from_eme * attitude.rates[0]).norm(), rounding);
  EXPECT_GT((rotation(turned) - rotation(attitude)).norm(), 1e-8);
  EXPECT_EQ(turned.computed, std::vector<std::string>{"the attitude is turned from EME2000 to GCRF"});
  const auto back = relative_to_frame(turned, "EME2000");
  EXPECT_LE((rotation(back) - rotation(attitude)).norm(), rounding);
  EXPECT_LE((back.rates[0] - attitude.rates[0]).norm(), rounding);
  attitude.rate_axes = RateAxes::body;
  EXPECT_EQ(relative_to_frame(attitude, "GCRF").rates, attitude.rates);
  EXPECT_TRUE(relative_to_frame(attitude, "EME2000").computed.empty());
}

TEST(Convert, SaysWhatIsNotToTheLastDigit) {
  TemporaryFolder folder;
  const std::string rows =
      "t,w,x,y,z,p,q,r\n2026-11-29T00:00:00,0,3,4,0,1,0,0\n2026-11-29T00:00:01,0,3,4,0,1,0,0\n";
  const AttitudeSource table{folder.written("in.csv", rows), TableColumns{"t",
                                                                          scale::utc,
                                                                          {"w", "x", "y", "z"},
                                                                          {Scalar::first, Maps::to_reference},
                                                                          "GCRF",
                                                                          {"p", "q", "r"}}};
  const auto out = folder.file("out.aem");
  EXPECT_EQ(convert_to(table, out),
            out.string() +
                ": 2 samples of SC_BODY_1 relative to GCRF\n"
                "  not to the last digit: the quaternions, the first of norm 5, are divided by their norms\n"
                "  not to the last digit: the rates are converted from rad/s to deg/s\n");
  const auto written = read_message(out, {});
  EXPECT_EQ(written.numbers[0], (std::array{0.6, 0.8, 0.0, 0.0}));
  EXPECT_NEAR(written.rates_in_radians()[0].x(), 1.0, 1e-15);
  const auto angles = folder.written(
      "angles.aem", head + segment("A2B", "ATTITUDE_TYPE = EULER_ANGLE\nEULER_ROT_SEQ = 321\n",
                                   "2026-11-29T00:00:00 10 20 30\n2026-11-29T00:03:00 10 20 31\n"));
  EXPECT_TRUE(says(convert_to({angles}, folder.file("angles.csv")),
                   "the quaternions are computed from Euler angles"));
}

TEST(Convert, WritesNoMinusZero) {
  TemporaryFolder folder;
  const AttitudeSource table{
      folder.written("in.csv",
                     "t,w,x,y,z,p,q,r\n2026-11-29T00:00:00,1,0,0,0,-0,0,0\n"
                     "2026-11-29T00:00:01,1,0,0,0,-0,0,0\n"),
      TableColumns{
          "t", scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_body}, "GCRF", {"p", "q", "r"}}};
  ConvertOptions options{folder.file("out.csv")};
  std::ostringstream said;
  convert(table, options, said);
  EXPECT_TRUE(says(content(options.out), "\n2026-11-29T00:00:00.000,1,0,0,0,0,0,0\n"));
}

TEST(Convert, RefusesWhatWouldLoseOrOverwriteSomething) {
  TemporaryFolder folder;
  const auto in = folder.written("in.aem", head + segment("A2B", first_scalar, three_lines));
  AttitudeSource source{in};
  ConvertOptions options{folder.written("out.aem", "precious")};
  const auto refusal = [&](const std::filesystem::path& named) {
    std::ostringstream said;
    const std::string text = complaint([&] { convert(source, options, said); }, named);
    EXPECT_EQ(said.str(), "");
    return text;
  };
  options.text.creation_date = "2026-11-29T00:00:00";
  EXPECT_EQ(refusal(options.out), "FILE: exists; --force overwrites it");
  EXPECT_EQ(content(options.out), "precious");
  options.force = true;
  std::filesystem::create_hard_link(in, folder.file("other.aem"));
  for (const auto& same : {in, folder.file("other.aem"), folder.file(".") / "in.aem"}) {
    options.out = same;
    EXPECT_EQ(refusal(same), "FILE: is the same file as " + in.string() + ", which is read");
  }
  EXPECT_EQ(content(in), head + segment("A2B", first_scalar, three_lines));
  options.force = false;
  options.out = folder.file("out.txt");
  EXPECT_EQ(refusal(options.out),
            "FILE: the name ends in none of .aem, .bc, .xml, .csv, .czml and .a, which say what to write");
  options.out = folder.file("new.aem");
  options.frame = "ITRF";
  EXPECT_EQ(refusal(in),
            "FILE: from EME2000 to ITRF needs the orientation of the Earth; missing: --orientation FILE");
  options.frame = "";
  for (const char* body : {"A\nB", "A\tB", "A\x7f"}) {
    options.body = body;
    EXPECT_EQ(refusal(in), "--body holds a line break or another control character");
  }
  options.body = "";
  GivenText& text = options.text;
  for (const auto& [words, option] : {std::pair{&text.object_name, "--object-name"},
                                      {&text.object_id, "--object-id"},
                                      {&text.originator, "--originator"}}) {
    *words = "A\nCOMMENT B";
    EXPECT_EQ(refusal(in), std::string(option) + " holds a line break or another control character");
    words->clear();
  }
  options.body = "GCRF";
  EXPECT_EQ(refusal(in), "--body GCRF is the name of a reference, not of a body");
  options.body = "";
  const std::string part = segment("A2B", first_scalar, three_lines);
  auto no_body = head + part;
  no_body.replace(no_body.find("SC_BODY_1"), 9, "ICRF");
  source.file = folder.written("no_body.aem", no_body);
  EXPECT_EQ(refusal(source.file),
            "FILE: the frames 'ICRF' and 'J2000' are both references; one of them must be a body");
  source.file = folder.written("two.aem", head + part + part);
  EXPECT_EQ(refusal(source.file), "FILE: there are 2 segments; missing: --segment NUMBER");
  source.file = folder.written(
      "b2a.aem",
      head + segment("B2A",
                     "ATTITUDE_TYPE = QUATERNION/RATE\nQUATERNION_TYPE = FIRST\nRATE_FRAME = REF_FRAME_A\n",
                     "2026-11-29T00:00:00 1 0 0 0 1 0 0\n2026-11-29T00:03:00 1 0 0 0 1 0 0\n"));
  EXPECT_EQ(refusal(source.file),
            "FILE: The rates are not used: with ATTITUDE_DIR B2A the message does not say whether they are "
            "of SC_BODY_1 or of "
            "J2000. They would be lost");
  source.file = in;
  source.selection.until = Epoch::from("2026-11-29T00:02:00 TAI");
  std::ostringstream said;
  convert(source, options, said);
  EXPECT_EQ(read_message(options.out, {}).size(), 2U);
  source = {
      folder.written("t.csv", "t,w,x,y,z\n2026-11-29T00:00:00,1,0,0,0\n2026-11-29T00:00:01,1,0,0,0\n"),
      TableColumns{"t", scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference}, "GCRF", {}}};
  options.text.originator = "TEST";
  EXPECT_EQ(refusal(source.file),
            "FILE: the file does not say what a message needs; missing: --object-name NAME, --object-id ID, "
            "--body FRAME");
}

// A viewer's file has no gaps; what is not passed on is said.
TEST(Convert, SaysWhichGapsAViewerDoesNotSee) {
  const TemporaryFolder folder;
  const std::string first_rows = "t,w,x,y,z\n2026-11-29T00:00:00,1,0,0,0\n2026-11-29T00:00:01,1,0,0,0\n";
  const auto said_of = [&](const std::string& last) {
    return convert_to(
        {folder.written("t.csv", first_rows + last + ",1,0,0,0\n"),
         TableColumns{
             "t", scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference}, "GCRF", {}}},
        folder.file(last.substr(17) + ".a"));
  };
  EXPECT_TRUE(says(said_of("2026-11-29T00:00:09"), "  not marked: 1 gap, over which a viewer turns\n"));
  EXPECT_EQ(said_of("2026-11-29T00:00:02").find("not marked"), std::string::npos);
}

// Of a steady turn about the z axis of the body, which Euler angles 321 have in the first one: 6 deg/s.
TEST(Convert, HasTheRatesOfDerivatives) {
  const auto message = [](const std::string& type, const std::string& more, const std::string& lines) {
    return "CCSDS_AEM_VERS = 2.0\nCREATION_DATE = 2026-11-29T00:00:00\nORIGINATOR = "
           "ME\nMETA_START\nOBJECT_NAME = "
           "S\nOBJECT_ID = 2026-001A\nREF_FRAME_A = GCRF\nREF_FRAME_B = SC_BODY_1\nTIME_SYSTEM = "
           "UTC\nSTART_TIME = "
           "2026-11-29T00:00:00\nSTOP_TIME = 2026-11-29T00:00:10\nATTITUDE_TYPE = " +
           type + "\n" + more + "META_STOP\nDATA_START\n" + lines + "DATA_STOP\n";
  };
  const auto rate_of = [](const std::string& text, std::string& said) -> Eigen::Vector3d {
    TemporaryFolder folder;
    said = convert_to({folder.written("in.aem", text)}, folder.file("out.csv"));
    const std::string unit = says(said, "computed") || says(said, "divided") ? "rad" : "deg";
    const std::string name = "rate_in_body_" + unit + "_per_s_";
    const auto table = CsvTable::read(folder.file("out.csv"), {name + "z"});
    const double factor = unit == "rad" ? 1.0 : std::numbers::pi / 180.0;
    return Eigen::Vector3d(table.number(1, name + "x"), table.number(1, name + "y"),
                           table.number(1, name + "z")) *
           factor;
  };
  const Eigen::Vector3d expected(0.0, 0.0, 6.0 * std::numbers::pi / 180.0);
  constexpr double of_the_digits = 1e-6;
  std::string said;
  // q = (0, 0, sin 30 deg, cos 30 deg), and its derivative half of the rate across it.
  EXPECT_LE((rate_of(message("QUATERNION/DERIVATIVE", "",
                             "2026-11-29T00:00:00 0 0 0 1 0 0 0.0523598776 0\n"
                             "2026-11-29T00:00:10 0 0 0.5 0.8660254038 0 0 0.0453449841 -0.0261799388\n"),
                     said) -
             expected)
                .norm(),
            of_the_digits);
  EXPECT_TRUE(says(said, "the rates are computed from the derivatives of the quaternions"));
  EXPECT_LE((rate_of(message("EULER_ANGLE/DERIVATIVE", "EULER_ROT_SEQ = 321\n",
                             "2026-11-29T00:00:00 0 0 0 6 0 0\n2026-11-29T00:00:10 60 0 0 6 0 0\n"),
                     said) -
             expected)
                .norm(),
            of_the_digits);
  EXPECT_TRUE(says(said, "the rates are computed from the rates of the angles or of the spin"));
  EXPECT_LE((rate_of(message("EULER_ANGLE/ANGVEL", "EULER_ROT_SEQ = 321\nANGVEL_FRAME = REF_FRAME_B\n",
                             "2026-11-29T00:00:00 0 0 0 0 0 6\n2026-11-29T00:00:10 60 0 0 0 0 6\n"),
                     said) -
             expected)
                .norm(),
            of_the_digits);
  EXPECT_FALSE(says(said, "rates are computed"));
}

TEST(Convert, SaysWhichMessageItIsNot) {
  TemporaryFolder folder;
  const auto refused = [&](const char* text) {
    const auto file = folder.written("in.txt", text);
    return complaint(
        [&] {
          if (is_message(file)) convert_to({file}, folder.file("out.csv"));
        },
        file);
  };
  EXPECT_EQ(refused("CCSDS_OPM_VERS = 2.0\n"),
            "FILE: is a message of the kind OPM, not AEM; an OPM is an orbit at one instant, which no "
            "command takes; in C++ "
            "OrbitParameterMessage reads it");
  EXPECT_EQ(refused("\xff\xfe"
                    "C"),
            "FILE: is UTF-16, and no XML; a table or a message in keywords is UTF-8");
  EXPECT_EQ(refused("<?xml version=\"1.0\"?>\n<x:tdm/>\n"), "FILE: is a message of the kind TDM, not AEM");
}

TEST(Convert, WritesXml) {
  TemporaryFolder folder;
  const auto aem = folder.file("out.aem"), xml = folder.file("out.xml"), again = folder.file("again.aem");
  const auto source = folder.written("in.csv",
                                     "t,a,b,c,d\n2026-11-29T00:00:00,0.1,0.2,0.3,0.92736184954957\n"
                                     "2026-11-29T00:00:10,0,0,0.6,0.8\n");
  TableColumns columns;
  columns.time = "t";
  columns.quaternion = {"a", "b", "c", "d"};
  columns.stated = {Scalar::last, Maps::to_reference};
  columns.reference = "GCRF";
  convert_to({source, columns}, aem);
  convert_to({aem}, xml);
  convert_to({xml}, again);
  const auto content = [](const std::filesystem::path& file) {
    std::ifstream in(file);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  EXPECT_EQ(content(xml).find("<?xml"), 0U);
  EXPECT_EQ(content(again), content(aem));
}

}  // namespace
}  // namespace vectrix::cli::convert_test

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <vectrix/space.hpp>

#include "daf_text.hpp"
#include "temporary_file.hpp"

// Attitude kernels of three missions, and such that the test writes.
namespace vectrix::attitude_kernel_test {
namespace {

using earth::Gcrf;

struct Ctim : moving_frame {};
struct Lro : moving_frame {};
struct Body : moving_frame {};
struct Craft : moving_frame {};
struct MapCam : moving_frame {};

const std::filesystem::path source = VECTRIX_SOURCE_DIR;
const std::filesystem::path examples = source / "examples/data", data = source / "space/tests/data";

// A clock of 100 ticks a second from 2000 on, in TT.
SpacecraftClock clock_of(int id, const std::string& rate = "1.0") {
  const std::string end = std::to_string(-id);
  return SpacecraftClock::of(
      TextKernel::parse("\\begindata\nSCLK_DATA_TYPE_" + end + " = 1 SCLK01_TIME_SYSTEM_" + end +
                        " = 2 SCLK01_N_FIELDS_" + end + " = 2 SCLK01_MODULI_" + end +
                        " = ( 1e12 100 ) SCLK01_OFFSETS_" + end + " = ( 0 0 ) SCLK_PARTITION_START_" + end +
                        " = 0 SCLK_PARTITION_END_" + end + " = 1e15 SCLK01_COEFFICIENTS_" + end +
                        " = ( 0 0 " + rate + " )\n"),
      id);
}
Epoch at_ticks(double ticks) {
  return Epoch::from_tt("2000-01-01T12:00:00") + ticks / 100.0 * si::second;
}

constexpr double rounding = 1e-14;
// Ticks of 0.01 s near 0: an Epoch has 1e-11 s, here of a turn by less than 1 rad/s.
constexpr double clock_rounding = 1e-10;

template <class B, class A> double angle_between(const Quaternion<B, A>& p, const Quaternion<B, A>& q) {
  return p.eigen().angularDistance(q.eigen());
}

// ---- CTIM, a cubesat in flight: a binary kernel and the table that it was made of ----

SpacecraftClock ctim_clock() {
  return SpacecraftClock::read(examples / "CTIM_clock.tsc", -152950);
}
AttitudeKernel ctim() {
  return AttitudeKernel::open(examples / "CTIM_20230420_attitude.bc", ctim_clock());
}
const auto ctim_frame = called<Ctim>("-152950000");

TEST(AttitudeKernel, OfCtimHasTheNumbersOfItsTable) {
  const auto kernel = ctim();
  ASSERT_EQ(kernel.segments().size(), 1U);
  const auto& segment = kernel.segments().front();
  EXPECT_EQ(segment.frame, -152950000);
  EXPECT_EQ(segment.reference, 1);
  EXPECT_EQ(segment.type, 3);
  EXPECT_TRUE(segment.has_rates);
  EXPECT_NE(kernel.comments().find("ANGULAR_RATE_PRESENT = 'MAKE UP/NO AVERAGING'"), std::string::npos);

  const auto table = CsvTable::read(examples / "CTIM_20230420_attitude.csv", {"UTC"});
  const auto samples = kernel.samples(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim_frame);
  const auto attitude = kernel.attitude(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim_frame);
  ASSERT_EQ(samples.size(), table.rows());
  // Ticks of 1 ms and seconds since 1980 are doubles of 2.4e-7 s: rounded twice for the kernel, with its time
  // of 1.2e-7 s, and once here. The cubesat turns by up to 3e-3 rad/s.
  constexpr double tick_rounding = 4.2e-7, turn = tick_rounding * 3e-3 * std::numbers::sqrt2;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Epoch t = Epoch::from_utc(table.text(i, "UTC"));
    // v_body = R(q) v_J2000, the scalar first
    const auto q_ctim_from_gcrf =
        nearest_quaternion_scalar_first(to<Ctim>, from<Gcrf>, table.number(i, "quaternion_c"),
                                        table.number(i, "quaternion_x"), table.number(i, "quaternion_y"),
                                        table.number(i, "quaternion_z"))
            .quaternion;
    ASSERT_NEAR((samples[i].time - t).value(), 0.0, tick_rounding) << i;
    ASSERT_LT(angle_between(inverse(samples[i].q_a_from_b), q_ctim_from_gcrf), rounding) << i;
    // The other way round, and with the scalar last, it is another attitude.
    ASSERT_GT(samples[i].q_a_from_b.eigen().angularDistance(q_ctim_from_gcrf.eigen()), 1e-3);
    const auto now = attitude(t);
    ASSERT_LT((inverse(now.rotation).matrix() - dcm(q_ctim_from_gcrf).matrix()).norm(), turn) << i;
  }
}

TEST(AttitudeKernel, OfCtimHasRatesInTheReferenceFrame) {
  const auto kernel = ctim();
  const auto attitude = kernel.attitude(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim_frame);
  const auto samples = kernel.samples(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim_frame);
  const auto rates = kernel.recorded_rates(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim_frame);
  ASSERT_EQ(rates.size(), samples.size());
  // The kernel's rates were made up of its quaternions; their noise is a tenth of the rate.
  double straight = 0.0, as_if_in_body = 0.0, size = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const Epoch t = samples[i].time + 1.0 * si::second;
    const auto now = attitude(t);
    const auto w_in_gcrf = now.rotation * now.angular_velocity;
    straight += (w_in_gcrf.coordinates() - attitude.recorded_rate(t).coordinates()).norm();
    as_if_in_body += (now.angular_velocity.coordinates() - attitude.recorded_rate(t).coordinates()).norm();
    size += now.angular_velocity.coordinates().norm();
  }
  EXPECT_LT(straight, 0.1 * size);
  EXPECT_GT(as_if_in_body, size);
  EXPECT_EQ(rates.front().coordinates(),
            Eigen::Vector3d(-0.001650247270364963, -0.0012355816205982296, -0.0004190087914249165));
}

TEST(AttitudeKernel, OfCtimIsAnEdgeThatKnowsItsFrames) {
  const auto kernel = ctim();
  const auto graph =
      frame_graph(edge(kernel.attitude(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim_frame)));
  const auto now = graph.at(Epoch::from_utc("2023-04-20T05:01:00"));
  EXPECT_GT(now.angular_velocity(of<Ctim>, relative_to<Gcrf>, in<Ctim>).coordinates().norm(), 1e-3);
  EXPECT_EQ(
      complaint([&] {
        static_cast<void>(graph.at(Epoch::from_utc("2023-04-20T04:00:00")).rotation(to<Ctim>, from<Gcrf>));
      }),
      "attitude kernel " + (examples / "CTIM_20230420_attitude.bc").string() + ", " + frame_name<Ctim>() +
          " relative to " + frame_name<Gcrf>() +
          ": the epoch 2023-04-20T04:00:00.000000 UTC, "
          "1365998469185.596 ticks, is outside the intervals that were read");
}

TEST(AttitudeKernel, GivesThePartThatIsAskedFor) {
  const auto kernel = ctim();
  const auto span = from_until(Epoch::from_utc("2023-04-20T05:10:00"), 60.0 * si::second);
  const auto samples = kernel.samples(of<Ctim>, relative_to<Gcrf>, span, ctim_frame);
  ASSERT_EQ(samples.size(), 6U);
  EXPECT_TRUE(span.contains(samples.front().time) && span.contains(samples.back().time));
  const auto part = kernel.attitude(of<Ctim>, relative_to<Gcrf>, span, ctim_frame);
  const auto whole = kernel.attitude(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim_frame);
  for (const Epoch& t : every(1.0 * si::second, span))
    EXPECT_EQ(part(t).rotation.matrix(), whole(t).rotation.matrix());
  EXPECT_THROW(part(span.end() + 1.0 * si::second), BadInput);
  const auto nearest =
      kernel.nearest_sample(of<Ctim>, relative_to<Gcrf>, span.start(), 2.0 * si::second, ctim_frame);
  EXPECT_NEAR((nearest.time - Epoch::from_utc("2023-04-20T05:09:59.001")).value(), 0.0, 1e-6);
  EXPECT_THROW(static_cast<void>(kernel.nearest_sample(of<Ctim>, relative_to<Gcrf>, span.start(),
                                                       0.5 * si::second, ctim_frame)),
               BadInput);
}

TEST(AttitudeKernel, RefusesOtherFramesAndClocks) {
  const auto kernel = ctim();
  const auto path = (examples / "CTIM_20230420_attitude.bc").string();
  const auto asked = [&](const auto& call) { return complaint(call, path); };
  EXPECT_EQ(asked([&] {
              static_cast<void>(
                  kernel.attitude(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-152950001")));
            }),
            "attitude kernel FILE: it has -152950000 relative to 'J2000' (1); asked for -152950001 (" +
                frame_name<Body>() + ") relative to 'J2000' (1) (" + frame_name<Gcrf>() + ")");
  EXPECT_EQ(asked([&] {
              static_cast<void>(kernel.attitude(of<Ctim>, relative_to<Craft>, kernel.span(), ctim_frame,
                                                called<Craft>("ECLIPJ2000")));
            }),
            "attitude kernel FILE: it has -152950000 relative to 'J2000' (1); asked for -152950000 (" +
                frame_name<Ctim>() + ") relative to 'ECLIPJ2000' (17) (" + frame_name<Craft>() + ")");
  EXPECT_NE(
      asked([&] {
        static_cast<void>(kernel.attitude(of<Ctim>, relative_to<earth::Eme2000>, kernel.span(), ctim_frame));
      }).find("in them J2000 is earth::Gcrf"),
      std::string::npos);
  // Who claims it gets it.
  EXPECT_NO_THROW(static_cast<void>(kernel.attitude(of<Ctim>, relative_to<earth::Eme2000>, kernel.span(),
                                                    ctim_frame, called<earth::Eme2000>("J2000"))));
  EXPECT_EQ(
      asked([&] { static_cast<void>(AttitudeKernel::open(path, clock_of(-77))); }),
      "attitude kernel FILE, segment 1 '/Users/brst3037/code/ctim_config/kernels': the ticks of the frame "
      "-152950000 are those of the clock -152950; given was the clock -77");
  EXPECT_EQ(asked([&] {
              static_cast<void>(kernel.samples(
                  of<Ctim>, relative_to<Gcrf>,
                  from_until(Epoch::from_utc("2024-01-01T00:00:00"), 1.0 * si::second), ctim_frame));
            }),
            "attitude kernel FILE, segment 1 '/Users/brst3037/code/ctim_config/kernels': it goes from "
            "2023-04-20T05:00:09.001000 UTC to 2023-04-20T06:59:59.001000 UTC; asked for "
            "2024-01-01T00:00:00.000000 UTC "
            "to 2024-01-01T00:00:01.000000 UTC");
}

// ---- transfer files ----

TEST(AttitudeKernel, OfLunarReconnaissanceOrbiterInTransferForm) {
  // The clock is made up: the test is of the numbers.
  const auto kernel = AttitudeKernel::open(data / "lro_transfer.xc", clock_of(-85));
  const auto lro = called<Lro>("-85000");
  const auto samples = kernel.samples(of<Lro>, relative_to<Gcrf>, kernel.span(), lro);
  const auto rates = kernel.recorded_rates(of<Lro>, relative_to<Gcrf>, kernel.span(), lro);
  ASSERT_EQ(samples.size(), 67U);
  const Eigen::Quaterniond q(0.2156567076343611, 0.9202889099180395, -0.002332797755759, 0.3264277328733043);
  constexpr double digits = 1e-14;
  EXPECT_LT((samples.front().q_a_from_b.eigen().conjugate().coeffs() - q.normalized().coeffs()).norm(),
            digits);
  constexpr double rate_digits = 1e-11;
  EXPECT_LT(
      (rates.front().coordinates() - Eigen::Vector3d(1.2290299e-4, -8.3713154e-4, -3.6818095e-4)).norm(),
      rate_digits);
  EXPECT_NE(kernel.comments().find("03821_16N196_S1_new_spice.cub"), std::string::npos);
}

TEST(AttitudeKernel, OfACameraRelativeToItsSpacecraftInTransferForm) {
  const auto kernel = AttitudeKernel::open(data / "orex_gimbal_transfer.xc", clock_of(-64, "1e-3"));
  const auto attitude = kernel.attitude(of<MapCam>, relative_to<Craft>, kernel.span(),
                                        called<MapCam>("-64361"), called<Craft>("-64000"));
  const auto now = attitude(kernel.span().start() + 1.0 * si::second);
  const Eigen::Quaterniond q(0.9999973091578, 7.470581692e-4, -1.407450119e-3, 1.686020557e-3);
  constexpr double digits = 1e-11;
  EXPECT_LT((inverse(now.rotation).matrix() - q.toRotationMatrix()).norm(), digits);
  EXPECT_EQ(now.angular_velocity.coordinates(), Eigen::Vector3d::Zero());
}

// ---- kernels that the test writes ----

struct Turn {
  Eigen::Quaterniond q;  // v_body = R(q) v_reference
  Eigen::Vector3d w;     // in the reference
};
void add(std::vector<double>& numbers, const Turn& turn, double norm, bool with_rate) {
  for (const double x : {turn.q.w(), turn.q.x(), turn.q.y(), turn.q.z()}) numbers.push_back(norm * x);
  if (with_rate) numbers.insert(numbers.end(), turn.w.begin(), turn.w.end());
}
// A steady turn at w, in the reference: the body's axes turn by w t, so that q_ref_from_body = exp(w t) q0.
const Eigen::Vector3d w{0.03, -0.02, 0.05};
const Eigen::Quaterniond q0_reference_from_body = Eigen::Quaterniond(0.3, 0.5, -0.7, 0.2).normalized();
Turn steady(double seconds) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(w.norm() * seconds, w.normalized()));
  return {(turn * q0_reference_from_body).conjugate(), w};
}

DafTestArray segment(const std::string& name, int type, bool rates, const std::vector<double>& numbers,
                     double first, double last) {
  return {name, {first, last}, {-77001, 1, type, rates ? 1 : 0}, numbers};
}
void add_directory(std::vector<double>& numbers, const std::vector<double>& all) {
  for (std::size_t i = 99; i + 1 < all.size(); i += 100) numbers.push_back(all[i]);
}
/// Records of the steady turn at these ticks; of type 3 with intervals, of type 1 without.
DafTestArray steady_segment(const std::string& name, const std::vector<double>& ticks, bool rates,
                            const std::vector<double>& intervals, double norm = 1.0, double offset = 0.0) {
  std::vector<double> numbers;
  for (const double t : ticks) add(numbers, steady(t / 100.0 + offset), norm, rates);
  numbers.insert(numbers.end(), ticks.begin(), ticks.end());
  add_directory(numbers, ticks);
  if (!intervals.empty()) {
    numbers.insert(numbers.end(), intervals.begin(), intervals.end());
    add_directory(numbers, intervals);
    numbers.push_back(static_cast<double>(intervals.size()));
  }
  numbers.push_back(static_cast<double>(ticks.size()));
  return segment(name, intervals.empty() ? 1 : 3, rates, numbers, ticks.front(), ticks.back());
}
std::vector<double> ticks_from(double first, double step, int count) {
  std::vector<double> ticks;
  for (int i = 0; i < count; ++i) ticks.push_back(first + i * step);
  return ticks;
}

AttitudeKernel written(const std::vector<DafTestArray>& arrays, bool big = false) {
  static std::vector<std::unique_ptr<TemporaryFile>> kept;
  kept.push_back(std::make_unique<TemporaryFile>(daf_bytes("CK", arrays, big)));
  auto kernel = AttitudeKernel::open(kept.back()->path(), clock_of(-77));
  kept.clear();  // an open file can be read on
  return kernel;
}
KernelAttitude<Gcrf, Body> attitude_of(const AttitudeKernel& kernel) {
  return kernel.attitude(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001"));
}

void expect_steady(const KernelAttitude<Gcrf, Body>& attitude, double ticks) {
  const auto now = attitude(at_ticks(ticks));
  const Turn turn = steady(ticks / 100.0);
  EXPECT_LT((inverse(now.rotation).matrix() - turn.q.toRotationMatrix()).norm(), clock_rounding) << ticks;
  EXPECT_LT((now.rotation.matrix() * now.angular_velocity.coordinates() - w).norm(), clock_rounding) << ticks;
  EXPECT_LT((attitude.recorded_rate(at_ticks(ticks)).coordinates() - w).norm(), clock_rounding) << ticks;
}

TEST(AttitudeKernel, Type3TurnsEvenlyBetweenItsRecords) {
  const auto ticks = ticks_from(1000.0, 250.0, 400);  // with directories of its ticks
  for (const bool big : {false, true}) {
    for (const double norm : {1.0, 2.0e9, 1e-9, -3.0}) {
      const auto attitude = attitude_of(written({steady_segment("S", ticks, true, {1000.0}, norm)}, big));
      for (const double t : {1000.0, 1000.1, 1124.9, 1250.0, 50000.0, 100749.9, 100750.0})
        expect_steady(attitude, t);
      EXPECT_THROW(attitude(at_ticks(999.99)), BadInput);
      EXPECT_THROW(attitude(at_ticks(100750.01)), BadInput);
    }
  }
}

TEST(AttitudeKernel, Type3StopsAtTheEndOfAnInterval) {
  std::vector<double> ticks = ticks_from(0.0, 100.0, 5);  // to 400
  const auto second = ticks_from(500.0, 100.0, 5);        // from 500: one step behind, and not across it
  ticks.insert(ticks.end(), second.begin(), second.end());
  const auto kernel = written({steady_segment("S", ticks, true, {0.0, 500.0})});
  const auto attitude = attitude_of(kernel);
  for (const double t : {0.0, 399.9, 400.0, 500.0, 500.1, 900.0}) expect_steady(attitude, t);
  for (const double t : {400.1, 450.0, 499.9}) EXPECT_THROW(attitude(at_ticks(t)), BadInput) << t;
  // Read in parts, it stops there, too.
  for (const double from : {150.0, 350.0, 400.0, 450.0}) {
    const auto part = kernel.attitude(of<Body>, relative_to<Gcrf>,
                                      from_until(at_ticks(from), at_ticks(650.0)), called<Body>("-77001"));
    EXPECT_THROW(part(at_ticks(450.0)), BadInput) << from;
    expect_steady(part, 600.0);
  }
  const auto one = written({steady_segment("S", ticks, true, {0.0})});
  expect_steady(attitude_of(one), 450.0);
}

TEST(AttitudeKernel, Type3SaysWhereARecordIsAlone) {
  const auto kernel =
      written({steady_segment("S", {0.0, 100.0, 200.0, 300.0, 400.0}, true, {0.0, 200.0, 300.0})});
  const auto attitude = attitude_of(kernel);
  const auto at = [&](double ticks) {
    return complaint([&] { static_cast<void>(attitude(at_ticks(ticks))); });
  };
  EXPECT_NE(at(200.0).find(
                "segment 1 'S': the record of 2000-01-01T11:58:57.816000 UTC, 200 ticks, is alone in its "
                "interval, and nothing says how it turns; samples() has it"),
            std::string::npos)
      << at(200.0);
  for (const double ticks : {199.0, 201.0, 299.0})
    EXPECT_NE(at(ticks).find("is outside the intervals"), std::string::npos) << ticks;
  expect_steady(attitude, 300.0);
  EXPECT_EQ(kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001")).size(), 5U);
}

TEST(AttitudeKernel, Type3MayHaveNoRates) {
  const auto kernel = written({steady_segment("S", ticks_from(0.0, 100.0, 5), false, {0.0})});
  const auto attitude = attitude_of(kernel);
  const auto now = attitude(at_ticks(150.0));
  EXPECT_LT((inverse(now.rotation).matrix() - steady(1.5).q.toRotationMatrix()).norm(), clock_rounding);
  EXPECT_THROW(static_cast<void>(attitude.recorded_rate(at_ticks(150.0))), BadInput);
  EXPECT_THROW(static_cast<void>(
                   kernel.recorded_rates(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001"))),
               BadInput);
}

TEST(AttitudeKernel, Type2TurnsAtTheRateOfItsRecord) {
  for (const std::size_t count : {1U, 2U, 100U, 101U, 250U}) {
    std::vector<double> numbers, starts, stops;
    for (std::size_t i = 0; i < count; ++i) {
      const double start = 1000.0 * static_cast<double>(i);
      add(numbers, steady(start / 100.0), 5.0, true);
      numbers.push_back(0.01);  // seconds per tick
      starts.push_back(start);
      stops.push_back(start + 900.0);
    }
    numbers.insert(numbers.end(), starts.begin(), starts.end());
    numbers.insert(numbers.end(), stops.begin(), stops.end());
    add_directory(numbers, starts);
    for (const bool big : {false, true}) {
      const auto attitude = attitude_of(written({segment("S", 2, true, numbers, 0.0, stops.back())}, big));
      for (const double t : {0.0, 1.0, 450.0, 900.0, stops.back() - 450.0, stops.back()})
        expect_steady(attitude, t);
      if (count > 1) {
        EXPECT_THROW(attitude(at_ticks(950.0)), BadInput);
        expect_steady(attitude, 1500.0);
      }
    }
  }
}

TEST(AttitudeKernel, Type1HasSingleAttitudes) {
  for (const bool rates : {false, true}) {
    const auto ticks = ticks_from(0.0, 100.0, 301);
    const auto kernel = written({steady_segment("S", ticks, rates, {})});
    const auto body = called<Body>("-77001");
    const auto samples = kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), body);
    ASSERT_EQ(samples.size(), ticks.size());
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      EXPECT_NEAR((samples[i].time - at_ticks(ticks[i])).value(), 0.0, clock_rounding);
      EXPECT_LT(samples[i].q_a_from_b.eigen().conjugate().angularDistance(steady(ticks[i] / 100.0).q),
                clock_rounding);
    }
    EXPECT_EQ(kernel.samples(of<Body>, relative_to<Gcrf>, from_until(at_ticks(150.0), at_ticks(400.0)), body)
                  .size(),
              3U);
    const auto nearest =
        kernel.nearest_sample(of<Body>, relative_to<Gcrf>, at_ticks(1234.0), 0.5 * si::second, body);
    EXPECT_NEAR((nearest.time - at_ticks(1200.0)).value(), 0.0, clock_rounding);
    const std::string text = complaint([&] { static_cast<void>(attitude_of(kernel)); });
    EXPECT_NE(text.find("segment 1 'S': type 1 has single attitudes and nothing between them"),
              std::string::npos)
        << text;
  }
}

TEST(AttitudeKernel, TheLastSegmentThatKnowsAnInstantCounts) {
  const auto wide = steady_segment("WIDE", ticks_from(0.0, 100.0, 21), true, {0.0});
  // Three seconds ahead, with a gap from 900 to 1000.
  auto ticks = ticks_from(800.0, 50.0, 3);
  const auto more = ticks_from(1000.0, 50.0, 3);
  ticks.insert(ticks.end(), more.begin(), more.end());
  const auto narrow = steady_segment("NARROW", ticks, true, {800.0, 1000.0}, 1.0, 3.0);
  const auto first_body = [](const DafTestArray& first, const DafTestArray& second, double t) {
    const auto now = attitude_of(written({first, second}))(at_ticks(t));
    return Eigen::Quaterniond(inverse(now.rotation).matrix());
  };
  for (const double t : {700.0, 850.0, 950.0, 1050.0, 1500.0}) {
    const bool is_narrow = t == 850.0 || t == 1050.0;
    EXPECT_LT(first_body(wide, narrow, t).angularDistance(steady(t / 100.0 + (is_narrow ? 3.0 : 0.0)).q),
              1e-7)
        << t;
    EXPECT_LT(first_body(narrow, wide, t).angularDistance(steady(t / 100.0).q), 1e-7) << t;
  }
  const auto kernel = written({wide, narrow});
  EXPECT_THROW(
      static_cast<void>(kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001"))),
      BadInput);
  // Where one ends and the next begins they share an instant.
  const auto joined = written(
      {steady_segment("A", {0.0, 100.0}, true, {0.0}), steady_segment("B", {100.0, 200.0}, true, {100.0})});
  EXPECT_EQ(joined.samples(of<Body>, relative_to<Gcrf>, joined.span(), called<Body>("-77001")).size(), 3U);
}

TEST(AttitudeKernel, RefusesNumbersThatDoNotFit) {
  const auto good = steady_segment("S", {0.0, 100.0, 200.0}, true, {0.0, 100.0});
  const auto with = [&](std::size_t at, double number) {
    DafTestArray array = good;
    array.numbers[at] = number;
    const TemporaryFile file(daf_bytes("CK", {array}));
    return complaint(
        [&] { static_cast<void>(attitude_of(AttitudeKernel::open(file.path(), clock_of(-77)))); },
        file.path());
  };
  const std::string place = "attitude kernel FILE, segment 1 'S'";
  EXPECT_EQ(with(0, good.numbers[0]), "nothing was thrown");
  EXPECT_EQ(with(8, NAN), place + ", record 2: its number 2 is nan");
  EXPECT_EQ(with(13, HUGE_VAL), place + ", record 2: its number 7 is inf");
  EXPECT_EQ(with(7, 1e200), place + ", record 2: a quaternion of norm inf");
  EXPECT_EQ(with(22, 250.0), place + ", record 3: the ticks are 200, after 250");
  EXPECT_EQ(with(22, NAN), place + ", record 2: the ticks are nan, after 0");
  EXPECT_EQ(with(24, 50.0), place + ", interval 1: it does not begin with the first record");
  EXPECT_EQ(with(25, 150.0), place + ", an interval begins at 150 ticks, where there is no record");
  EXPECT_EQ(with(26, 4.0), place + ": it has 4 intervals and 3 records");
  EXPECT_EQ(with(26, 1.5), place + ": the number of intervals is 1.5, in a segment of 28 numbers");
  EXPECT_EQ(with(27, 1e15), place + ": the number of records is 1e+15, in a segment of 28 numbers");
  EXPECT_EQ(with(27, NAN), place + ": the number of records is nan, in a segment of 28 numbers");
  EXPECT_EQ(with(27, 2.0), place + ": 2 records of type 3 are 20 numbers; it has 28");
  DafTestArray zero = good;
  for (std::size_t i = 0; i < 4; ++i) zero.numbers[i] = 0.0;
  const TemporaryFile file(daf_bytes("CK", {zero}));
  EXPECT_EQ(
      complaint([&] { static_cast<void>(attitude_of(AttitudeKernel::open(file.path(), clock_of(-77)))); },
                file.path()),
      place + ", record 1: a quaternion of norm 0");
}

TEST(AttitudeKernel, RefusesAReferenceThatIsClaimedToBeAnother) {
  const auto kernel = ctim();
  const auto asked = [&](const Called<earth::Itrf>& claim) {
    return complaint([&] {
      static_cast<void>(
          kernel.attitude(of<Ctim>, relative_to<earth::Itrf>, kernel.span(), ctim_frame, claim));
    });
  };
  EXPECT_EQ(asked(called<earth::Itrf>("J2000")), "text kernel: 'J2000' was claimed to be earth::Itrf");
  // Of that frame the kernel has nothing, and says so.
  EXPECT_NE(asked(called<earth::Itrf>("ITRF93")).find("asked for -152950000"), std::string::npos);
}

TEST(AttitudeKernel, RefusesAnotherTypeWhereItIsNeeded) {
  const auto good = steady_segment("S", {0.0, 100.0}, true, {0.0});
  auto other = steady_segment("T", {200.0, 300.0}, true, {200.0});
  other.integers[2] = 5;
  const TemporaryFile file(daf_bytes("CK", {good, other}));
  const auto kernel = AttitudeKernel::open(file.path(), clock_of(-77));
  const auto asked = [&](const TimeSpan& span) {
    return complaint(
        [&] {
          static_cast<void>(kernel.attitude(of<Body>, relative_to<Gcrf>, span,
                                            called<Body>(std::to_string(good.integers[0]))));
        },
        file.path());
  };
  EXPECT_EQ(kernel.segments()[1].type, 5);
  EXPECT_EQ(asked(from_until(at_ticks(0.0), at_ticks(100.0))), "nothing was thrown");
  EXPECT_EQ(asked(kernel.span()),
            "attitude kernel FILE, segment 2 'T': it is of type 5; the types 1, 2 and 3 are read");
}

TEST(AttitudeKernel, RefusesOtherFiles) {
  const auto opened = [](const std::string& bytes) {
    const TemporaryFile file(bytes);
    return complaint([&] { static_cast<void>(AttitudeKernel::open(file.path(), clock_of(-77))); },
                     file.path());
  };
  auto array = steady_segment("S", {0.0, 100.0}, true, {0.0});
  EXPECT_EQ(opened(daf_bytes("SPK", {array})), "DAF file FILE: it is a file of the kind 'SPK', not CK");
  array.integers[3] = 2;
  EXPECT_EQ(opened(daf_bytes("CK", {array})),
            "attitude kernel FILE, segment 1 'S': the flag of the rates is 2");
  array.integers.pop_back();
  EXPECT_EQ(opened(daf_bytes("CK", {array})),
            "attitude kernel FILE, segment 1 'S': a summary of 2 doubles and 5 integers; an attitude kernel "
            "has 2 and 6");
  array = steady_segment("S", {0.0, 100.0}, true, {0.0});
  array.doubles[0] = NAN;
  EXPECT_EQ(opened(daf_bytes("CK", {array})),
            "attitude kernel FILE, segment 1 'S': it goes from nan to 100 ticks");
}

}  // namespace
}  // namespace vectrix::attitude_kernel_test

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include "files/attitude_kernels.hpp"

// Attitude kernels of three missions.
namespace vectrix::attitude_kernel_test {
namespace {

struct Lro : moving_frame {};
struct MapCam : moving_frame {};

const std::filesystem::path data = std::filesystem::path{VECTRIX_SOURCE_DIR} / "space/tests/data";

constexpr double rounding = 1e-14;

template <class B, class A> double angle_between(const Quaternion<B, A>& p, const Quaternion<B, A>& q) {
  return p.eigen().angularDistance(q.eigen());
}

// ---- CTIM: a binary kernel and the table that it was made of ----

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

}  // namespace
}  // namespace vectrix::attitude_kernel_test

#include <vectrix/space/files/attitude_ephemeris_segment.hpp>

#include <cmath>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "attitude_lines.hpp"
#include "frame_claim.hpp"
#include "kvn.hpp"
#include "text_file.hpp"

namespace vectrix {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Eigen::Quaterniond hamilton(const detail::AttitudeLines& lines, const double* x) {
  if (detail::has_spin(lines.type)) {
    const auto turn = [](double degrees, int axis) {
      return Eigen::Quaterniond(Eigen::AngleAxisd(degree * degrees, Eigen::Vector3d::Unit(axis)));
    };
    return turn(x[0] + 90.0, 2) * turn(90.0 - x[1], 0) * turn(x[2], 2);
  }
  if (detail::has_euler_angles(lines.type)) {
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    for (const int axis : lines.euler_axes)
      q = q * Eigen::AngleAxisd(degree * *x++, Eigen::Vector3d::Unit(axis));
    return q;
  }
  if (lines.is_scalar_first) return {x[0], x[1], x[2], x[3]};
  return {x[3], x[0], x[1], x[2]};
}

/// w of REF_FRAME_B relative to A, in B, deg/s.
Eigen::Vector3d rate_of_euler_angles(const detail::AttitudeLines& lines, const double* x) {
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q_k_from_b = Eigen::Quaterniond::Identity();  // k: behind the turn
  for (std::size_t i = lines.euler_axes.size(); i-- > 0;) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(lines.euler_axes[i]);
    w += q_k_from_b.conjugate() * (x[i + 3] * axis);
    q_k_from_b = Eigen::AngleAxisd(degree * x[i], axis) * q_k_from_b;
  }
  return w;
}
Eigen::Vector3d rate_of_spin(const detail::AttitudeLines& lines, const double* x) {
  const Eigen::Vector3d spin = x[3] * Eigen::Vector3d::UnitZ();
  if (lines.type == AttitudeType::spin) return spin;
  const double *more = x + 4, first = degree * more[0];
  if (lines.type == AttitudeType::spin_nutation) {
    const double phase = degree * more[2];
    return spin + 360.0 / more[1] *
                      Eigen::Vector3d(std::sin(first) * std::cos(phase), -std::sin(first) * std::sin(phase),
                                      std::cos(first));
  }
  const double delta = degree * more[1];
  const Eigen::Vector3d h_a(std::cos(delta) * std::cos(first), std::cos(delta) * std::sin(first),
                            std::sin(delta));
  return spin + more[2] * (hamilton(lines, x).conjugate() * h_a);
}

}  // namespace

AttitudeEphemerisSegment::AttitudeEphemerisSegment(detail::Trusted, EphemerisMetadata metadata,
                                                   detail::AttitudeLines lines)
    : metadata_(std::move(metadata)), lines_(std::move(lines)) {}

AttitudeEphemerisSegment::AttitudeEphemerisSegment(detail::Trusted, EphemerisMetadata metadata,
                                                   detail::AttitudeLines lines, const detail::FrameClaim& a,
                                                   const detail::FrameClaim& b)
    : lines_(std::move(lines)) {
  lines_.place = "attitude ephemeris segment of '" + detail::excerpt(metadata.object_name) + "'";
  lines_.ref_frame_a = detail::name_of(a);
  lines_.ref_frame_b = detail::name_of(b);
  detail::require_text(lines_.place, "REF_FRAME_A", lines_.ref_frame_a);
  detail::require_text(lines_.place, "REF_FRAME_B", lines_.ref_frame_b);
  if (detail::upper_case(lines_.ref_frame_a) == detail::upper_case(lines_.ref_frame_b))
    throw BadInput(lines_.place + ": both frames have the name '" + detail::excerpt(lines_.ref_frame_a) +
                   "'");
  metadata_ =
      detail::checked_metadata(lines_.place, detail::attitude_ephemeris, std::move(metadata), lines_.times);
  for (std::size_t i = 0; i < lines_.numbers.size(); ++i) {
    if (!std::isfinite(lines_.numbers[i]))
      throw BadInput(lines_.place + ": sample " + detail::text(i / detail::numbers_in_line(lines_.type)) +
                     " has the number " + detail::text(lines_.numbers[i]));
  }
  static_cast<void>(is_reversed(a, b));
}

void AttitudeEphemerisSegment::require_unit_norms() const {
  if (lines_.norm_error > unit_norm_tolerance)
    throw BadInput(lines_.place + ", line " + detail::text(lines_.norm_line) +
                   ": the norm of the quaternion differs from 1 by " + detail::text(lines_.norm_error) +
                   ", tolerance " + detail::text(unit_norm_tolerance) + "; nearest_samples() projects");
}

void AttitudeEphemerisSegment::require_attitude() const {
  if (lines_.type == AttitudeType::angular_velocity)
    throw BadInput(lines_.place + ": there is an angular velocity, but no attitude");
}

bool AttitudeEphemerisSegment::is_reversed(const detail::FrameClaim& a, const detail::FrameClaim& b) const {
  const std::string frame_a = lines_.frame_keyword + "_A", frame_b = lines_.frame_keyword + "_B";
  const bool straight = detail::names(a, ref_frame_a()) && detail::names(b, ref_frame_b());
  if (!straight && !(detail::names(a, ref_frame_b()) && detail::names(b, ref_frame_a())))
    throw BadInput(lines_.place + ": " + frame_a + " is '" + detail::excerpt(ref_frame_a()) + "', " +
                   frame_b + " is '" + detail::excerpt(ref_frame_b()) + "'; asked for " + detail::shown(b) +
                   " relative to " + detail::shown(a));
  detail::require_named(lines_.place, straight ? frame_a : frame_b, straight ? ref_frame_a() : ref_frame_b(),
                        a);
  detail::require_named(lines_.place, straight ? frame_b : frame_a, straight ? ref_frame_b() : ref_frame_a(),
                        b);
  return !straight;
}

Eigen::Quaterniond AttitudeEphemerisSegment::quaternion(std::size_t line, bool reversed) const {
  const Eigen::Quaterniond q =
      hamilton(lines_, lines_.numbers.data() + line * detail::numbers_in_line(lines_.type));
  return lines_.is_b_to_a == reversed ? q : q.conjugate();
}

Eigen::Vector3d AttitudeEphemerisSegment::rate_of_derivative(std::size_t line, bool reversed,
                                                             bool in_a) const {
  const double* numbers = lines_.numbers.data() + line * detail::numbers_in_line(lines_.type);
  const Eigen::Quaterniond written = hamilton(lines_, numbers), change = hamilton(lines_, numbers + 4);
  constexpr double most = 0.01;  // as much as a norm may be off
  const double along = written.coeffs().dot(change.coeffs());
  if (!(std::abs(along) <= most * change.norm()))
    throw BadInput(lines_.place + ": the derivative of the quaternion at " +
                   exact_text(lines_.times[line], metadata_.time_system) + " has " + detail::text(along) +
                   " 1/s along the quaternion; it must be across it");
  const bool straight = lines_.is_b_to_a == reversed;
  const Eigen::Quaterniond q = straight ? written : written.conjugate(),
                           qdot = straight ? change : change.conjugate();
  const Eigen::Quaterniond product = in_a ? qdot * q.conjugate() : q.conjugate() * qdot;
  return 2.0 / written.squaredNorm() * product.vec();
}

Eigen::Vector3d AttitudeEphemerisSegment::rate_of_angles(std::size_t line, bool reversed, bool in_a) const {
  const double* numbers = lines_.numbers.data() + line * detail::numbers_in_line(lines_.type);
  Eigen::Vector3d w = degree * (detail::has_spin(lines_.type) ? rate_of_spin(lines_, numbers)
                                                              : rate_of_euler_angles(lines_, numbers));
  if (in_a != reversed) w = hamilton(lines_, numbers) * w;
  if (!w.allFinite())
    throw BadInput(lines_.place + ": the rate at " + exact_text(lines_.times[line], metadata_.time_system) +
                   " is too large for a double");
  return reversed ? Eigen::Vector3d(-w) : w;  // w_ba = -w_ab
}

std::vector<Eigen::Vector3d> AttitudeEphemerisSegment::rates(const detail::FrameClaim& a,
                                                             const detail::FrameClaim& b, bool in_a) const {
  const bool reversed = is_reversed(a, b);
  std::vector<Eigen::Vector3d> all;
  all.reserve(size());
  if (lines_.type == AttitudeType::quaternion_derivative) {
    for (std::size_t line = 0; line < size(); ++line) all.push_back(rate_of_derivative(line, reversed, in_a));
    return all;
  }
  if (detail::has_spin(lines_.type) || lines_.type == AttitudeType::euler_angle_derivative) {
    for (std::size_t line = 0; line < size(); ++line) all.push_back(rate_of_angles(line, reversed, in_a));
    return all;
  }
  if (!detail::has_rate(lines_.type))
    throw BadInput(lines_.place + ": ATTITUDE_TYPE is " + detail::type_name(lines_.type, "2.0") +
                   ", which has no rates");
  if (lines_.is_b_to_a)
    throw BadInput(lines_.place + ": with ATTITUDE_DIR B2A it is not said whether the rates are of " +
                   ref_frame_a() + " or of " + ref_frame_b());
  const bool are_in_a = lines_.rate_frame == detail::RateFrame::a;
  if (are_in_a != (in_a != reversed))
    throw BadInput(lines_.place + ": the rates are in " + detail::rate_frame_name(lines_.rate_frame) + ", '" +
                   detail::excerpt(are_in_a ? ref_frame_a() : ref_frame_b()) + "'; asked for " +
                   detail::shown(in_a ? a : b));
  const double scale = reversed ? -degree : degree;  // w_ba = -w_ab
  for (std::size_t line = 0; line < size(); ++line) {
    const double* w = lines_.numbers.data() + (line + 1) * detail::numbers_in_line(lines_.type) - 3;
    all.emplace_back(scale * w[0], scale * w[1], scale * w[2]);
  }
  return all;
}

}  // namespace vectrix

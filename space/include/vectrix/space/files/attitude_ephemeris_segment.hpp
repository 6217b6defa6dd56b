#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>
#include <vectrix/kinematics/samples/attitude_sample.hpp>
#include <vectrix/space/files/ephemeris_metadata.hpp>
#include <vectrix/space/files/file_frame.hpp>

namespace vectrix {

/// The attitude types that are read: QUATERNION, QUATERNION/DERIVATIVE, QUATERNION/RATE (in version 2.0
/// QUATERNION/ANGVEL) and EULER_ANGLE; of version 2.0 also EULER_ANGLE/DERIVATIVE, EULER_ANGLE/ANGVEL, SPIN,
/// SPIN/NUTATION and SPIN/NUTATION_MOM; in parameter messages also an angular velocity without attitude.
enum class AttitudeType {
  quaternion,
  quaternion_derivative,
  quaternion_rate,
  euler_angle,
  euler_angle_derivative,
  euler_angle_rate,
  spin,
  spin_nutation,
  spin_nutation_momentum,
  angular_velocity
};

/// Samples of unit quaternions, and the largest | |q| - 1 | before the projection.
template <Frame A, Frame B> struct NearestSamples {
  std::vector<AttitudeSample<A, B, Epoch>> samples;
  double distance;
};

namespace detail {

/// The frame of the rates in the data lines.
enum class RateFrame { none, a, b };

/// The data lines as the file has them, in its order and units, each with the numbers of its type.
struct AttitudeLines {
  std::string place{};                      // begins messages
  std::string frame_keyword = "REF_FRAME";  // followed by _A or _B
  std::string ref_frame_a{}, ref_frame_b{};
  AttitudeType type = AttitudeType::quaternion;
  bool is_b_to_a = false, is_scalar_first = false;
  std::string euler_sequence{};     // as it is written, 321 or ZYX
  std::array<int, 3> euler_axes{};  // of it, 0 to 2
  RateFrame rate_frame = RateFrame::none;
  std::vector<Epoch> times{};
  std::vector<double> numbers{};
  std::vector<std::string> comments{};
  double norm_error = 0.0;  // the largest
  std::size_t norm_line = 0;
};

}  // namespace detail

/// One segment of an attitude ephemeris message. The file names two frames, the caller claims types for them:
///     segment.samples<earth::Eme2000, Body>(called<Body>("SC_BODY_1"))
/// gives samples of Body relative to Eme2000, whichever of the two is REF_FRAME_A. The standard names are
/// those of OrbitEphemerisSegment; CENTER_NAME does not matter. With the matrix R(q) of Hamilton's product
///     A2B:  v^a = R(q) v^b,  q_b^a = q        B2A:  v^b = R(q) v^a,  q_a^b = q
/// and Euler angles t1, t2, t3 about the axes i, j, k of EULER_ROT_SEQ, in their order, are the quaternion
/// q_i(t1) q_j(t2) q_k(t3). In version 2.0 the direction is A2B. A spin with the right ascension a and the
/// declination d of its axis in REF_FRAME_A and the phase s is, after 504.0-B-2, F5,
///     q = q_z(a + 90 deg) q_x(90 deg - d) q_z(s):  the axis is z of REF_FRAME_B
class VECTRIX_EXPORT AttitudeEphemerisSegment {
  template <class A, class B> using Samples = std::vector<AttitudeSample<A, B, Epoch>>;
  template <class A, class B, class C> using Rates = std::vector<AngularVelocity<A, B, In<C>>>;
  template <class A, class B, class C>
  using RatesInOne = std::enable_if_t<std::is_same_v<C, A> || std::is_same_v<C, B>, Rates<A, B, C>>;

 public:
  /// Of samples: REF_FRAME_A is a, REF_FRAME_B is b, the direction A2B, the scalar last. Throws BadInput as
  /// OrbitEphemerisSegment does.
  template <Frame A, Frame B, class... Given>
    requires(detail::are_claims<A, B, Given...>)
  AttitudeEphemerisSegment(EphemerisMetadata metadata,
                           const std::vector<AttitudeSample<A, B, Epoch>>& samples, const Given&... called)
      : AttitudeEphemerisSegment(detail::trusted, std::move(metadata), lines_of(samples),
                                 detail::claim_among<A>(called...), detail::claim_among<B>(called...)) {}
  /// With the rate w_ab^c of each sample, where c is one of the two frames. BadInput if they are not as many.
  template <Frame A, Frame B, Frame C, class... Given>
    requires(detail::are_claims<A, B, Given...> && (std::is_same_v<C, A> || std::is_same_v<C, B>))
  AttitudeEphemerisSegment(EphemerisMetadata metadata,
                           const std::vector<AttitudeSample<A, B, Epoch>>& samples,
                           const std::vector<AngularVelocity<A, B, In<C>>>& rates, const Given&... called)
      : AttitudeEphemerisSegment(detail::trusted, std::move(metadata), lines_of(samples, rates),
                                 detail::claim_among<A>(called...), detail::claim_among<B>(called...)) {}
  template <class Wrong, class... Given>
  AttitudeEphemerisSegment(  // metadata, samples of b relative to a by Epoch, called<B>("NAME")
      EphemerisMetadata, const Wrong&, const Given&...) = delete;

  AttitudeEphemerisSegment(detail::Trusted, EphemerisMetadata metadata, detail::AttitudeLines lines);

  [[nodiscard]] const EphemerisMetadata& metadata() const { return metadata_; }
  [[nodiscard]] const std::string& ref_frame_a() const { return lines_.ref_frame_a; }
  [[nodiscard]] const std::string& ref_frame_b() const { return lines_.ref_frame_b; }
  [[nodiscard]] AttitudeType type() const { return lines_.type; }
  [[nodiscard]] std::size_t size() const { return lines_.times.size(); }
  /// Those between the data lines, in their order.
  [[nodiscard]] const std::vector<std::string>& comments() const { return lines_.comments; }

  /// q_b^a of every line. Throws BadInput that names both frames if the file has others, or the line if
  /// | |q| - 1 | exceeds unit_norm_tolerance there: nearest_samples() projects; and if there is no attitude.
  template <Frame A, Frame B, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, Samples<A, B>, Given...> samples(const Given&... called) const {
    const bool reversed = is_reversed(detail::claim_among<A>(called...), detail::claim_among<B>(called...));
    require_attitude();
    require_unit_norms();
    return samples_of<A, B>([&](std::size_t line) { return quaternion(line, reversed); });
  }
  template <class A, class B, class... Given>
  auto samples(  // two frames; if F has no standard name in a file: samples<A, B>(called<F>("NAME"))
      const Given&...) const -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// The same, q / |q|, of files with few digits.
  template <Frame A, Frame B, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, NearestSamples<A, B>, Given...> nearest_samples(
      const Given&... called) const {
    const bool reversed = is_reversed(detail::claim_among<A>(called...), detail::claim_among<B>(called...));
    require_attitude();
    return {samples_of<A, B>([&](std::size_t line) { return quaternion(line, reversed).normalized(); }),
            lines_.norm_error};
  }
  template <class A, class B, class... Given>
  auto nearest_samples(  // two frames; if F has no standard name in a file: called<F>("NAME")
      const Given&...) const -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// w_ab^c of every line, where c, one of the two frames, is that of RATE_FRAME or ANGVEL_FRAME. Throws
  /// BadInput if it is the other one, for files without rates, and for B2A, of which version 1.0 does not say
  /// whose rate it has. In both frames and directions they follow, as w of REF_FRAME_B relative to A in B, of
  ///     QUATERNION/DERIVATIVE      2 q* dq/dt; BadInput for a line whose derivative is not across q, to 0.01
  ///     EULER_ANGLE/DERIVATIVE     the sum of the rates of the angles, each about its axis
  ///     SPIN                       SPIN_ANGLE_VEL z: about the spin axis alone
  ///     SPIN/NUTATION, .../NUTATION_MOM    SPIN_ANGLE_VEL z + NUTATION_VEL h, with the unit vector h of the
  ///                                angular momentum, and NUTATION_VEL = 360 deg / NUTATION_PER
  template <Frame A, Frame B, Frame C, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, RatesInOne<A, B, C>, Given...> angular_velocities(
      In<C>, const Given&... called) const {
    Rates<A, B, C> all;
    all.reserve(size());
    for (const Eigen::Vector3d& w :
         rates(detail::claim_among<A>(called...), detail::claim_among<B>(called...), std::is_same_v<C, A>))
      all.emplace_back(detail::trusted, w);
    return all;
  }
  template <class A, class B, class Wrong, class... Given>
  auto angular_velocities(  // <A, B>(in<C>), in A or B; if F has no standard name: called<F>("NAME")
      const Wrong&, const Given&...) const -> Refused = delete;

  /// The data lines without their frames, for the writer.
  [[nodiscard]] const detail::AttitudeLines& lines(detail::Trusted) const { return lines_; }

 private:
  AttitudeEphemerisSegment(detail::Trusted, EphemerisMetadata metadata, detail::AttitudeLines lines,
                           const detail::FrameClaim& a, const detail::FrameClaim& b);

  template <class A, class B> static detail::AttitudeLines lines_of(const Samples<A, B>& samples) {
    detail::AttitudeLines lines;
    for (const auto& [time, q_a_from_b] : samples) {
      const auto numbers = q_a_from_b.scalar_last();
      lines.times.push_back(time);
      lines.numbers.insert(lines.numbers.end(), numbers.begin(), numbers.end());
    }
    return lines;
  }
  template <class A, class B, class C>
  static detail::AttitudeLines lines_of(const Samples<A, B>& samples, const Rates<A, B, C>& rates) {
    if (rates.size() != samples.size())
      throw BadInput("attitude ephemeris segment: there are " + detail::text(samples.size()) +
                     " samples and " + detail::text(rates.size()) + " rates");
    detail::AttitudeLines lines;
    lines.type = AttitudeType::quaternion_rate;
    lines.rate_frame = std::is_same_v<C, A> ? detail::RateFrame::a : detail::RateFrame::b;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto numbers = samples[i].q_a_from_b.scalar_last();
      const Eigen::Vector3d degrees = rates[i].coordinates() * (180.0 / std::numbers::pi);
      lines.times.push_back(samples[i].time);
      lines.numbers.insert(lines.numbers.end(), numbers.begin(), numbers.end());
      lines.numbers.insert(lines.numbers.end(), degrees.begin(), degrees.end());
    }
    return lines;
  }
  template <class A, class B, class Make> [[nodiscard]] Samples<A, B> samples_of(const Make& make) const {
    Samples<A, B> samples;
    samples.reserve(size());
    for (std::size_t line = 0; line < size(); ++line)
      samples.push_back({lines_.times[line], Quaternion<A, B>{detail::trusted, make(line)}});
    return samples;
  }

  void require_unit_norms() const;
  void require_attitude() const;
  /// Whether the first claim is of REF_FRAME_B. Throws BadInput if they are other frames.
  [[nodiscard]] bool is_reversed(const detail::FrameClaim& a, const detail::FrameClaim& b) const;
  /// q_b^a of the claims.
  [[nodiscard]] Eigen::Quaterniond quaternion(std::size_t line, bool reversed) const;
  /// 2 q* dq/dt, or in the frame of the first claim 2 dq/dt q*.
  [[nodiscard]] Eigen::Vector3d rate_of_derivative(std::size_t line, bool reversed, bool in_a) const;
  /// The rate of Euler angles with their derivatives, or of a spin: w_ab in the frame of the first claim, or
  /// of the second.
  [[nodiscard]] Eigen::Vector3d rate_of_angles(std::size_t line, bool reversed, bool in_a) const;
  /// w_ab in the frame of the first claim, or of the second.
  [[nodiscard]] std::vector<Eigen::Vector3d> rates(const detail::FrameClaim& a, const detail::FrameClaim& b,
                                                   bool in_a) const;

  EphemerisMetadata metadata_;
  detail::AttitudeLines lines_;
};

}  // namespace vectrix

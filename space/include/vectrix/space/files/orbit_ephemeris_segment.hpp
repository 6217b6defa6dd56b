#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/samples/interpolated_position.hpp>
#include <vectrix/space/files/ephemeris_metadata.hpp>
#include <vectrix/space/files/ephemeris_position.hpp>
#include <vectrix/space/files/file_frame.hpp>

namespace vectrix {

/// A covariance of position and velocity as the message has it: the lower triangle, row by row, in km^2,
/// km^2/s and km^2/s^2. The frame is COV_REF_FRAME; empty for that of the segment.
struct OrbitCovariance {
  Epoch epoch;
  std::string ref_frame;
  std::array<double, 21> lower_triangle;
};

namespace detail {

/// A data line, in m, m/s and m/s^2.
struct OrbitLine {
  Epoch time;
  Eigen::Vector3d position, velocity;
  std::optional<Eigen::Vector3d> acceleration;
};
struct OrbitLines {
  std::string place;  // begins messages
  std::string ref_frame;
  std::optional<Epoch> ref_frame_epoch;
  std::vector<OrbitLine> lines;
  std::vector<OrbitCovariance> covariances;
  std::vector<std::string> comments;
};

}  // namespace detail

/// One segment of an orbit ephemeris message: the motion of one object relative to CENTER_NAME in REF_FRAME.
/// The file names its frame, the caller claims a type for it:
///     segment.samples<earth::Eme2000, Satellite>()
///     segment.samples<MarsInertial, Orbiter>(called<MarsInertial>("EME2000", "MARS BARYCENTER"))
/// BadInput that names both frames if REF_FRAME or CENTER_NAME is another one. The standard names are GCRF
/// and ICRF for earth::Gcrf, EME2000 and J2000 for Eme2000, ITRF, also of a year, for Itrf, TEME and
/// TEMEOFDATE for Teme, TOD for TrueOfDate, MOD for MeanOfDate; with REF_FRAME_EPOCH the last four are other
/// frames.
class VECTRIX_EXPORT OrbitEphemerisSegment {
 public:
  /// Of samples. Throws BadInput if there are none, the times do not increase or are before the first one of
  /// the time system, a number is not finite, a text cannot be a line of a message, another keyword cannot be
  /// kept, or a sample is more than 1 ms outside START_TIME and STOP_TIME.
  template <Frame A, Frame Q, class... Given>
    requires(detail::is_claim<A, Given...>)
  OrbitEphemerisSegment(EphemerisMetadata metadata, const std::vector<PositionSample<A, Q, Epoch>>& samples,
                        const Given&... called)
      : OrbitEphemerisSegment(detail::trusted, std::move(metadata), lines_of(samples),
                              detail::claim_of<A>(called...)) {}
  template <class Samples, class... Given>
  OrbitEphemerisSegment(  // metadata, samples of q in a by Epoch, called<A>("NAME")
      EphemerisMetadata, const Samples&, const Given&...) = delete;

  OrbitEphemerisSegment(detail::Trusted, EphemerisMetadata metadata, detail::OrbitLines lines);

  [[nodiscard]] const EphemerisMetadata& metadata() const { return metadata_; }
  [[nodiscard]] const std::string& ref_frame() const { return lines_.ref_frame; }
  [[nodiscard]] const std::optional<Epoch>& ref_frame_epoch() const { return lines_.ref_frame_epoch; }
  [[nodiscard]] std::size_t size() const { return lines_.lines.size(); }
  /// Those between the data lines, in their order.
  [[nodiscard]] const std::vector<std::string>& comments() const { return lines_.comments; }
  [[nodiscard]] const std::vector<OrbitCovariance>& covariances() const { return lines_.covariances; }

  /// r_aq^a and v_aq|a^a of every line: position and velocity of q relative to the origin of a.
  template <Frame A, Frame Q, class... Given>
  [[nodiscard]] detail::Claimed<A, std::vector<PositionSample<A, Q, Epoch>>, Given...> samples(
      const Given&... called) const {
    require_frame(detail::claim_of<A>(called...));
    std::vector<PositionSample<A, Q, Epoch>> samples;
    samples.reserve(size());
    for (const detail::OrbitLine& line : lines_.lines)
      samples.push_back({line.time,
                         {Displacement<A, Q, In<A>>{detail::trusted, line.position},
                          Velocity<A, Q, ObservedFrom<A>, In<A>>{detail::trusted, line.velocity}}});
    return samples;
  }
  template <class A, class Q, class... Given>
  auto samples(  // if A has no standard name in a file: samples<A, Q>(called<A>("NAME"))
      const Given&...) const -> detail::Unclaimed<A, Given...> = delete;

  /// a_aq|a^a of every line. BadInput if a line has none.
  template <Frame A, Frame Q, class... Given>
  [[nodiscard]] detail::Claimed<A, std::vector<Acceleration<A, Q, ObservedFrom<A>, In<A>>>, Given...>
  accelerations(const Given&... called) const {
    require_frame(detail::claim_of<A>(called...));
    require_accelerations();
    std::vector<Acceleration<A, Q, ObservedFrom<A>, In<A>>> all;
    all.reserve(size());
    for (const detail::OrbitLine& line : lines_.lines) all.emplace_back(detail::trusted, *line.acceleration);
    return all;
  }
  template <class A, class Q, class... Given>
  auto accelerations(  // if A has no standard name in a file: accelerations<A, Q>(called<A>("NAME"))
      const Given&...) const -> detail::Unclaimed<A, Given...> = delete;

  /// An edge that interpolates as the file says, Lagrange or Hermite of its degree. A call outside
  /// USEABLE_START_TIME and USEABLE_STOP_TIME throws BadInput, also where there are samples; for other errors
  /// see InterpolatedPosition. BadInput if the file says another interpolation or none.
  template <Frame A, Frame Q, class... Given>
  [[nodiscard]] detail::Claimed<A, FunctionEdge<EphemerisPosition<A, Q>>, Given...> sampled_edge(
      const Quantity<si::time>& longest_gap, const Given&... called) const {
    const bool hermite = is_hermite();
    const int degree = interpolation_degree();
    using Motion = InterpolatedPosition<A, Q, Epoch>;
    auto motion = hermite ? Motion(samples<A, Q>(called...), Hermite{degree}, longest_gap)
                          : Motion(samples<A, Q>(called...), Lagrange{degree}, longest_gap);
    return edge(EphemerisPosition<A, Q>(std::move(motion), useable()));
  }
  template <class A, class Q, class... Given>
  auto sampled_edge(  // if A has no standard name in a file: sampled_edge<A, Q>(gap, called<A>("NAME"))
      const Quantity<si::time>&, const Given&...) const -> detail::Unclaimed<A, Given...> = delete;

  /// The data lines without their frame, for the writer.
  [[nodiscard]] const detail::OrbitLines& lines(detail::Trusted) const { return lines_; }

 private:
  OrbitEphemerisSegment(detail::Trusted, EphemerisMetadata metadata, std::vector<detail::OrbitLine> lines,
                        const detail::FrameClaim& claim);

  template <class A, class Q>
  static std::vector<detail::OrbitLine> lines_of(const std::vector<PositionSample<A, Q, Epoch>>& samples) {
    std::vector<detail::OrbitLine> lines;
    lines.reserve(samples.size());
    for (const auto& [time, motion] : samples)
      lines.push_back({time, motion.position.coordinates(), motion.velocity.coordinates(), std::nullopt});
    return lines;
  }
  void require_frame(const detail::FrameClaim& claim) const;
  void require_accelerations() const;
  [[nodiscard]] bool is_hermite() const;
  [[nodiscard]] int interpolation_degree() const;
  [[nodiscard]] detail::UseableSpan useable() const;

  EphemerisMetadata metadata_;
  detail::OrbitLines lines_;
};

}  // namespace vectrix

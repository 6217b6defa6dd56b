#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/points/parallel.hpp>
#include <vectrix/space/files/daf_file.hpp>
#include <vectrix/space/files/file_frame.hpp>
#include <vectrix/space/sky/geocentric.hpp>
#include <vectrix/space/time/time_span.hpp>

namespace vectrix {
namespace detail {

struct LoadedSegment;
struct OrbitSegments;

/// The motion of one body relative to another along the axes of J2000 or of its ecliptic.
class VECTRIX_EXPORT KernelOrbit {
 public:
  explicit KernelOrbit(std::shared_ptr<const OrbitSegments> segments) : segments_(std::move(segments)) {}

  [[nodiscard]] PlainMotion at(const Epoch& epoch) const;

 private:
  std::shared_ptr<const OrbitSegments> segments_;
};

/// The name in kernels of a body of the sky.
template <class P> inline constexpr const char* kernel_body = nullptr;
template <> inline constexpr const char* kernel_body<sky::Sun> = "SUN";
template <> inline constexpr const char* kernel_body<sky::Moon> = "MOON";
template <> inline constexpr const char* kernel_body<sky::Mercury> = "MERCURY";
template <> inline constexpr const char* kernel_body<sky::Venus> = "VENUS";
template <> inline constexpr const char* kernel_body<sky::Mars> = "MARS BARYCENTER";
template <> inline constexpr const char* kernel_body<sky::Jupiter> = "JUPITER BARYCENTER";
template <> inline constexpr const char* kernel_body<sky::Saturn> = "SATURN BARYCENTER";
template <> inline constexpr const char* kernel_body<sky::Uranus> = "URANUS BARYCENTER";
template <> inline constexpr const char* kernel_body<sky::Neptune> = "NEPTUNE BARYCENTER";

template <class Q, class... Given> FrameClaim body_claim(const Given&... given) {
  if constexpr (kernel_body<Q> != nullptr) {
    return {frame_name<Q>(), StandardFrame::none, kernel_body<Q>, default_center};
  } else {
    return claim_among<Q>(given...);
  }
}
/// Whether the given names are of q and of a, if they have no standard ones.
template <class A, class Q, class... Given>
inline constexpr bool are_motion_claims = are_claims<A, Q, Given...>;
template <class A, class Q, class... Given>
  requires(kernel_body<Q> != nullptr)
inline constexpr bool are_motion_claims<A, Q, Given...> = is_claim<A, Given...>;

}  // namespace detail

/// The motion of q relative to the origin of a, observed from a, from an ephemeris kernel.
template <Frame A, Point Q> class KernelMotion {
 public:
  KernelMotion(detail::Trusted, detail::KernelOrbit orbit) : orbit_(std::move(orbit)) {}

  /// Throws BadInput where the kernel has nothing within the span that was asked for.
  [[nodiscard]] PointMotion<A, Q, A> at(const Epoch& t) const {
    const auto now = orbit_.at(t);
    return {Displacement<A, Q, In<A>>{detail::trusted, now.position},
            Velocity<A, Q, ObservedFrom<A>, In<A>>{detail::trusted, now.velocity}};
  }
  /// at() with axes of q parallel to those of a: an edge of a frame graph.
  auto operator()(const Epoch& t) const requires Frame<Q> { return parallel(at(t)); }

 private:
  detail::KernelOrbit orbit_;
};

/// A segment of an ephemeris kernel: of the body `target` relative to `center` in the frame `frame`.
struct EphemerisKernelSegment {
  std::string name;
  std::int32_t target, center, frame;
  int type;
  Epoch start, end;
};

/// An ephemeris kernel of SPICE (SPK) of the types 2, 3 (Chebyshev polynomials: the planets of JPL), 8, 9
/// (Lagrange), 12, 13 (Hermite) and 10 (two-line elements), binary in either byte order or as transfer file.
///     const auto kernel = EphemerisKernel::open("ctim_orbit.bsp");
///     const auto orbit = kernel.motion(of<Ctim>, relative_to<earth::Gcrf>, kernel.span(),
///     called<Ctim>("-152950")); const auto sun = EphemerisKernel::open("de440s.bsp").motion(of<sky::Sun>,
///     relative_to<earth::Gcrf>, span);
/// A body is known by its name or its number, and the origin of a frame by the second name of its claim:
///     relative_to<MarsInertial>, called<MarsInertial>("J2000", "MARS BARYCENTER")
/// Segments are added up to lead from one body to the other; of those of one body that know an instant the
/// last in the file counts. Frames are J2000, that is earth::Gcrf as in FrameKernel, and ECLIPJ2000, turned
/// from it by 84381.448 arcsec about x. Mars and the planets beyond stand for the barycentres with their
/// moons. In type 10 SGP4 is blended between two sets, and turned from TEME by IAU 1976 and 1980.
class VECTRIX_EXPORT EphemerisKernel {
 public:
  /// Reads the summaries only. Throws BadInput with file, segment and reason for another file. Segments of
  /// other types are refused by the calls that need them.
  static EphemerisKernel open(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<EphemerisKernelSegment>& segments() const { return segments_; }
  /// From the first start to the last end of all segments.
  [[nodiscard]] TimeSpan span() const;
  /// The text of the comment area.
  [[nodiscard]] std::string comments() const { return file_.comments(); }

  /// Reads what the span needs, and checks it. Throws BadInput with the place and the number for what is
  /// wrong, and one that names both bodies, or the frames, if the kernel has others. A centre that is claimed
  /// of the body is refused.
  template <Point Q, Frame A, class... Given>
    requires(detail::are_motion_claims<A, Q, Given...>)
  [[nodiscard]] KernelMotion<A, Q> motion(Of<Q>, RelativeTo<A>, const TimeSpan& span,
                                          const Given&... called) const {
    return {detail::trusted,
            orbit(detail::body_claim<Q>(called...), detail::claim_among<A>(called...), span)};
  }
  template <class Q, class A, class... Given>
    requires(!detail::are_motion_claims<A, Q, Given...>)
  auto motion(  // of<Q>, relative_to<A>, span; if one has no standard name in kernels: called<Q>("NAME")
      Of<Q>, RelativeTo<A>, const TimeSpan&, const Given&...) const -> Refused = delete;

 private:
  explicit EphemerisKernel(DafFile file) : file_(std::move(file)) {}

  [[nodiscard]] detail::KernelOrbit orbit(const detail::FrameClaim& q, const detail::FrameClaim& a,
                                          const TimeSpan& span) const;
  /// Why the segment cannot be read; empty if it can.
  [[nodiscard]] std::string refusal_of(std::size_t segment, const detail::FrameClaim& a) const;
  [[nodiscard]] std::string place() const;
  [[nodiscard]] std::string place_of(std::size_t segment) const;

  DafFile file_;
  std::vector<EphemerisKernelSegment> segments_;
};

}  // namespace vectrix

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/kinematics/samples/attitude_sample.hpp>
#include <vectrix/space/files/daf_file.hpp>
#include <vectrix/space/files/file_frame.hpp>
#include <vectrix/space/files/frame_kernel.hpp>
#include <vectrix/space/files/spacecraft_clock.hpp>
#include <vectrix/space/time/time_span.hpp>

namespace vectrix {
namespace detail {

/// q_b^a and w_ab^b.
struct KernelTurn {
  Eigen::Quaterniond q_a_from_b;
  Eigen::Vector3d w_ab_b;
};
/// A record: q_b^a, w_ab^a if the segment has rates, and whether it begins an interval.
struct KernelAttitudeRecord {
  Epoch time;
  Eigen::Quaterniond q_a_from_b;
  std::optional<Eigen::Vector3d> w_ab_a;
  bool begins;
};

class AttitudeRecords;

/// What was read of the segments of one frame, in the order of their priority.
class VECTRIX_EXPORT KernelTurns {
 public:
  KernelTurns(std::string place, const SpacecraftClock& clock, std::vector<AttitudeRecords> segments);

  [[nodiscard]] KernelTurn at(const Epoch& epoch) const;
  [[nodiscard]] Eigen::Vector3d recorded_rate(const Epoch& epoch) const;

 private:
  /// Says why there is nothing at the epoch.
  [[noreturn]] void fail(const Epoch& epoch, double ticks) const;

  std::string place_;
  SpacecraftClock clock_;
  std::shared_ptr<const std::vector<AttitudeRecords>> segments_;
};

}  // namespace detail

/// The attitude of b relative to a from an attitude kernel: a function of the epoch, an edge of a frame
/// graph. Between two records of an interval the turn is the shortest one at constant rate, evenly in the
/// ticks of the clock (type 3), or the rate is that of the record (type 2). It never crosses from one
/// interval to another. The rate w_ab^b is that of this motion, the derivative of its rotation. A call throws
/// BadInput outside the intervals and the span that was asked for, and at a record that is alone in one.
template <Frame A, Frame B> class KernelAttitude {
 public:
  KernelAttitude(detail::Trusted, detail::KernelTurns turns) : turns_(std::move(turns)) {}

  MovingDcm<A, B> operator()(const Epoch& t) const {
    const auto now = turns_.at(t);
    return {dcm(Quaternion<A, B>{detail::trusted, now.q_a_from_b}),
            AngularVelocity<A, B, In<B>>{detail::trusted, now.w_ab_b}};
  }
  /// w_ab^a as the file has it, in a by definition, linear between two records. Where it differs from the
  /// rate of the attitude, one of the two is wrong: there are kernels with rates in b. Throws BadInput if the
  /// segment has no rates.
  [[nodiscard]] AngularVelocity<A, B, In<A>> recorded_rate(const Epoch& t) const {
    return AngularVelocity<A, B, In<A>>{detail::trusted, turns_.recorded_rate(t)};
  }

 private:
  detail::KernelTurns turns_;
};

/// A segment of an attitude kernel: of the frame with the number `frame` relative to `reference`.
struct AttitudeKernelSegment {
  std::string name;
  std::int32_t frame, reference;
  int type;
  bool has_rates;
  Epoch start, end;
};
/// What of a segment, counted from 0, does not count: a later one in the file knows the attitude of that
/// time.
struct HiddenAttitude {
  std::size_t segment;
  TimeSpan span;
};

/// An attitude kernel of SPICE (CK) of the types 1, 2 and 3, binary in either byte order or as transfer file.
///     const auto clock = SpacecraftClock::read("ctim_clock.tsc", -152950);
///     const auto kernel = AttitudeKernel::open("ctim_attitude.bc", clock);
///     const auto attitude = kernel.attitude(of<Ctim>, relative_to<earth::Gcrf>, kernel.span(),
///                                           called<Ctim>("-152950000"));
/// With Hamilton's R(q) the format means v^b = R(q / |q|) v^a, q_a^b, the scalar first: the transpose of an
/// attitude ephemeris message in A2B. The norm of q does not matter in this format. Of segments that know one
/// instant the last in the file counts. J2000 is earth::Gcrf, as in FrameKernel, whose names can be used.
class VECTRIX_EXPORT AttitudeKernel {
 public:
  /// Reads the summaries only. Throws BadInput, with file, segment and reason, for another file, a segment
  /// whose clock is not this one, or counts that do not fit into the segment. Segments of other types are
  /// refused by the calls that need them.
  static AttitudeKernel open(const std::filesystem::path& file, const SpacecraftClock& clock,
                             const FrameKernel& frames = {});

  [[nodiscard]] const std::vector<AttitudeKernelSegment>& segments() const { return segments_; }
  /// From the first start to the last end of all segments.
  [[nodiscard]] TimeSpan span() const;
  /// The text of the comment area.
  [[nodiscard]] std::string comments() const { return file_.comments(); }

  /// Reads what the span needs, and checks it. Throws BadInput with the place and the number for what is
  /// wrong, and one that names both frames if the kernel has others, or nothing within the span. Segments of
  /// type 1 do not say what is between their records: samples() has them.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, KernelAttitude<A, B>, Given...> attitude(
      Of<B>, RelativeTo<A>, const TimeSpan& span, const Given&... called) const {
    return {detail::trusted,
            turns(detail::claim_among<B>(called...), detail::claim_among<A>(called...), span)};
  }
  template <class B, class A, class... Given>
  auto attitude(  // of<B>, relative_to<A>, span; if F has no standard name in a file: called<F>("NAME")
      Of<B>, RelativeTo<A>, const TimeSpan&, const Given&...) const
      -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// The records of types 1 and 3 within the span, in the order of time. Of type 2, which has rotations at
  /// constant rate: the begin of each, its end if the next one does not begin there, and between them steps
  /// of at most a quarter of a turn. Where two segments know the attitude, those of the later one in the
  /// file; one of type 1 counts from its first record to its last.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, std::vector<AttitudeSample<A, B, Epoch>>, Given...> samples(
      Of<B>, RelativeTo<A>, const TimeSpan& span, const Given&... called) const {
    std::vector<AttitudeSample<A, B, Epoch>> all;
    for (const auto& record :
         records(detail::claim_among<B>(called...), detail::claim_among<A>(called...), span))
      all.push_back({record.time, Quaternion<A, B>{detail::trusted, record.q_a_from_b}});
    return all;
  }
  template <class B, class A, class... Given>
  auto samples(  // of<B>, relative_to<A>, span; if F has no standard name in a file: called<F>("NAME")
      Of<B>, RelativeTo<A>, const TimeSpan&, const Given&...) const
      -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// w_ab^a of the same records. BadInput if a segment has no rates.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, std::vector<AngularVelocity<A, B, In<A>>>, Given...> recorded_rates(
      Of<B>, RelativeTo<A>, const TimeSpan& span, const Given&... called) const {
    std::vector<AngularVelocity<A, B, In<A>>> all;
    for (const auto& record :
         records(detail::claim_among<B>(called...), detail::claim_among<A>(called...), span))
      all.emplace_back(detail::trusted, rate_of(record));
    return all;
  }
  template <class B, class A, class... Given>
  auto recorded_rates(  // of<B>, relative_to<A>, span; if F has no standard name in a file: called<F>("NAME")
      Of<B>, RelativeTo<A>, const TimeSpan&, const Given&...) const
      -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// When intervals begin: the times of those samples to which nothing leads from the one before, within one
  /// segment or to another one with the same attitude there. Type 1 has no intervals, but where it is hidden.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, std::vector<Epoch>, Given...> interval_starts(
      Of<B>, RelativeTo<A>, const TimeSpan& span, const Given&... called) const {
    std::vector<Epoch> all;
    for (const auto& record :
         records(detail::claim_among<B>(called...), detail::claim_among<A>(called...), span))
      if (record.begins) all.push_back(record.time);
    return all;
  }
  template <class B, class A, class... Given>
  auto
  interval_starts(  // of<B>, relative_to<A>, span; if F has no standard name in a file: called<F>("NAME")
      Of<B>, RelativeTo<A>, const TimeSpan&, const Given&...) const
      -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// When attitude() answers, within the span: the intervals of all segments, joined where they touch. What
  /// is there may be no motion from one to the next: interval_starts() says where. Type 1 has none.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, std::vector<TimeSpan>, Given...> coverage(
      Of<B>, RelativeTo<A>, const TimeSpan& span, const Given&... called) const {
    return coverage_of(detail::claim_among<B>(called...), detail::claim_among<A>(called...), span);
  }
  template <class B, class A, class... Given>
  auto coverage(  // of<B>, relative_to<A>, span; if F has no standard name in a file: called<F>("NAME")
      Of<B>, RelativeTo<A>, const TimeSpan&, const Given&...) const
      -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// The stretches of segments whose samples do not count, in the order of the file.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, std::vector<HiddenAttitude>, Given...> hidden(
      Of<B>, RelativeTo<A>, const TimeSpan& span, const Given&... called) const {
    return hidden_of(detail::claim_among<B>(called...), detail::claim_among<A>(called...), span);
  }
  template <class B, class A, class... Given>
  auto hidden(  // of<B>, relative_to<A>, span; if F has no standard name in a file: called<F>("NAME")
      Of<B>, RelativeTo<A>, const TimeSpan&, const Given&...) const
      -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// The sample next to the epoch. BadInput if it is farther away than the tolerance.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, AttitudeSample<A, B, Epoch>, Given...> nearest_sample(
      Of<B>, RelativeTo<A>, const Epoch& t, const Quantity<si::time>& tolerance,
      const Given&... called) const {
    const auto record =
        nearest(detail::claim_among<B>(called...), detail::claim_among<A>(called...), t, tolerance);
    return {record.time, Quaternion<A, B>{detail::trusted, record.q_a_from_b}};
  }
  template <class B, class A, class... Given>
  auto nearest_sample(  // of<B>, relative_to<A>, epoch, tolerance, called<F>("NAME")
      Of<B>, RelativeTo<A>, const Epoch&, const Quantity<si::time>&, const Given&...) const
      -> detail::UnclaimedPair<A, B, Given...> = delete;

 private:
  AttitudeKernel(DafFile file, const SpacecraftClock& clock, const FrameKernel& frames);

  [[nodiscard]] detail::KernelTurns turns(const detail::FrameClaim& b, const detail::FrameClaim& a,
                                          const TimeSpan& span) const;
  [[nodiscard]] std::vector<detail::KernelAttitudeRecord> records(const detail::FrameClaim& b,
                                                                  const detail::FrameClaim& a,
                                                                  const TimeSpan& span) const;
  [[nodiscard]] detail::KernelAttitudeRecord nearest(const detail::FrameClaim& b, const detail::FrameClaim& a,
                                                     const Epoch& t,
                                                     const Quantity<si::time>& tolerance) const;
  [[nodiscard]] const Eigen::Vector3d& rate_of(const detail::KernelAttitudeRecord& record) const;
  [[nodiscard]] std::vector<TimeSpan> coverage_of(const detail::FrameClaim& b, const detail::FrameClaim& a,
                                                  const TimeSpan& span) const;
  [[nodiscard]] std::vector<HiddenAttitude> hidden_of(const detail::FrameClaim& b,
                                                      const detail::FrameClaim& a,
                                                      const TimeSpan& span) const;
  /// The segments of b relative to a within the span, in the order of the file. BadInput if there are none.
  [[nodiscard]] std::vector<std::size_t> segments_of(const detail::FrameClaim& b, const detail::FrameClaim& a,
                                                     const TimeSpan& span) const;
  [[nodiscard]] std::vector<detail::AttitudeRecords> load(const std::vector<std::size_t>& segments,
                                                          const TimeSpan& span) const;
  [[nodiscard]] std::string place_of(std::size_t segment) const;

  DafFile file_;
  SpacecraftClock clock_;
  FrameKernel frames_;
  std::vector<AttitudeKernelSegment> segments_;
};

}  // namespace vectrix

#include "kernel_chain.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vectrix/kinematics/named/graph.hpp>
#include <vectrix/kinematics/named/motions.hpp>

#include "figures.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr std::int32_t j2000_number = 1, ecliptic_number = 17, itrf93_number = 13000;

struct LinkBase : moving_frame {};
struct LinkFrame : moving_frame {};
Called<LinkBase> base_of(const KernelLink& link) {
  return called<LinkBase>(detail::text(link.base));
}
Called<LinkFrame> frame_of(const KernelLink& link) {
  return called<LinkFrame>(detail::text(link.frame));
}

// The number that a frame has in attitude kernels.
std::int32_t in_attitudes(std::int32_t frame, const FrameKernel& frames) {
  return frames.attitude_id_of(detail::claim_of<LinkFrame>(called<LinkFrame>(detail::text(frame))));
}

// What the kernel has a frame relative to in the times of the span, or if it has nothing in them, in others.
std::set<std::int32_t> bases_of(std::int32_t frame, const AttitudeKernel& kernel, const TimeSpan& span) {
  std::set<std::int32_t> within, others;
  for (const AttitudeKernelSegment& segment : kernel.segments()) {
    if (segment.frame != frame) continue;
    const bool is_within = segment.start <= span.end() && span.start() <= segment.end;
    (is_within ? within : others).insert(segment.reference);
  }
  return within.empty() ? others : within;
}

// R_j2000^eclipj2000, as SPICE has the ecliptic: IAU 1976.
Eigen::Matrix3d j2000_from_ecliptic() {
  constexpr double obliquity = 84381.448 / 3600.0 * std::numbers::pi / 180.0;
  return Eigen::AngleAxisd(obliquity, Vector3d::UnitX()).toRotationMatrix();
}

// A factor at any of its times, by the rate of its motion and by that of its records.
struct Factor {
  std::function<NamedMovingDcm(const Epoch&)> motion, recorded;
};

class Factors {
 public:
  Factors(const KernelChain& chain, const AttitudeKernel& kernel, const FrameKernel& frames,
          const TimeSpan& span) {
    graph_.add_frame(frames.shown(chain.root), FrameMotion::moving);
    // From the root on.
    if (chain.root == ecliptic_number) {
      all_.push_back(fixed(graph_.add_frame(frames.shown(j2000_number), FrameMotion::moving),
                           graph_.frame(frames.shown(ecliptic_number)), j2000_from_ecliptic()));
    }
    for (auto link = chain.links.rbegin(); link != chain.links.rend(); ++link) {
      const NamedFrame base = graph_.frame(frames.shown(link->base)),
                       frame = graph_.add_frame(frames.shown(link->frame), FrameMotion::moving);
      all_.push_back(link->is_mounted ? mounted(base, frame, *link, frames)
                                      : of_kernel(base, frame, *link, kernel, span));
    }
  }

  [[nodiscard]] BodyMotion motion(const Epoch& t) const {
    const NamedMovingDcm R = product_of(&Factor::motion, t);
    return {Quaterniond(R.rotation().matrix()), R.angular_velocity().coordinates()};
  }
  /// By the rates of the records, in the axes of the reference.
  [[nodiscard]] Vector3d recorded_rate(const Epoch& t) const {
    const NamedMovingDcm R = product_of(&Factor::recorded, t);
    return (R.rotation() * R.angular_velocity()).coordinates();
  }

 private:
  static NamedMovingDcm at_rest(NamedFrame base, NamedFrame frame, const Eigen::Matrix3d& R) {
    const auto w = angular_velocity(Of(frame), RelativeTo(base),
                                    vector<si::angular_velocity>(In(frame), Vector3d(0.0, 0.0, 0.0)));
    return moving_dcm(NamedDcm{detail::trusted, base, frame, R}, w);
  }
  static Factor fixed(NamedFrame base, NamedFrame frame, const Eigen::Matrix3d& R_base_from_frame) {
    const auto f = [R = at_rest(base, frame, R_base_from_frame)](const Epoch&) { return R; };
    return {f, f};
  }
  static Factor mounted(NamedFrame base, NamedFrame frame, const KernelLink& link,
                        const FrameKernel& frames) {
    const auto R = frames.nearest_rotation(to<LinkBase>, from<LinkFrame>, base_of(link), frame_of(link))
                       .rotation.matrix();
    return fixed(base, frame, R);
  }
  static Factor of_kernel(NamedFrame base, NamedFrame frame, const KernelLink& link,
                          const AttitudeKernel& kernel, const TimeSpan& span) {
    const auto attitude =
        kernel.attitude(of<LinkFrame>, relative_to<LinkBase>, span, base_of(link), frame_of(link));
    const auto with = [base, frame](const auto& R_base_from_frame, const Vector3d& w, NamedFrame in) {
      const auto rate =
          angular_velocity(Of(frame), RelativeTo(base), vector<si::angular_velocity>(In(in), w));
      return moving_dcm(NamedDcm{detail::trusted, base, frame, R_base_from_frame.matrix()}, rate);
    };
    return {[attitude, with, frame](const Epoch& t) {
              const auto now = attitude(t);
              return with(now.rotation, now.angular_velocity.coordinates(), frame);
            },
            [attitude, with, base](const Epoch& t) {
              return with(attitude(t).rotation, attitude.recorded_rate(t).coordinates(), base);
            }};
  }
  [[nodiscard]] NamedMovingDcm product_of(std::function<NamedMovingDcm(const Epoch&)> Factor::*rate,
                                          const Epoch& t) const {
    NamedMovingDcm R = (all_.front().*rate)(t);
    for (std::size_t k = 1; k < all_.size(); ++k) R = R * (all_[k].*rate)(t);
    return R;
  }

  NamedGraph graph_;  // the names
  std::vector<Factor> all_;
};

// The times that are in both.
std::vector<TimeSpan> in_common(const std::vector<TimeSpan>& some, const std::vector<TimeSpan>& others) {
  std::vector<TimeSpan> both;
  for (auto a = some.begin(), b = others.begin(); a != some.end() && b != others.end();) {
    const Epoch start = std::max(a->start(), b->start()), end = std::min(a->end(), b->end());
    if (start < end) both.push_back(from_until(start, end));
    ++(a->end() < b->end() ? a : b);
  }
  return both;
}

double seconds_of(const std::vector<TimeSpan>& spans) {
  double sum = 0.0;
  for (const TimeSpan& span : spans) sum += (span.end() - span.start()).value();
  return sum;
}

// The times of those that are sorted, strictly between two.
struct Between {
  std::vector<Epoch>::const_iterator begin, end;

  Between(const std::vector<Epoch>& sorted, const Epoch& start, const Epoch& stop)
      : begin(std::upper_bound(sorted.begin(), sorted.end(), start)),
        end(std::lower_bound(begin, sorted.end(), stop)) {}
};

// From `start` on those of the factor that has most of them before `stop`.
void add_times(const Epoch& start, const Epoch& stop, const std::vector<std::vector<Epoch>>& of_factors,
               std::vector<Epoch>& times) {
  std::vector<Between> all;
  for (const std::vector<Epoch>& some : of_factors) all.emplace_back(some, start, stop);
  const auto most = std::max_element(all.begin(), all.end(), [](const Between& a, const Between& b) {
    return a.end - a.begin < b.end - b.begin;
  });
  times.push_back(start);
  times.insert(times.end(), most->begin, most->end);
}

}  // namespace

bool KernelChain::is_direct() const {
  return links.size() == 1 && !links.front().is_mounted && root == j2000_number;
}

std::string KernelChain::reference() const {
  return root == itrf93_number ? "ITRF" : "GCRF";  // J2000 means GCRF in kernels
}

KernelChain KernelChain::of(std::int32_t frame, const AttitudeKernel& kernel, const FrameKernel& frames,
                            const TimeSpan& span, const std::string& file) {
  KernelChain chain{{}, frame};
  std::set<std::int32_t> passed;
  while (chain.root != j2000_number && chain.root != ecliptic_number && chain.root != itrf93_number) {
    const std::int32_t id = in_attitudes(chain.root, frames);
    const std::string name = frames.shown(chain.root);
    if (!passed.insert(id).second)
      throw BadInput(file + ": the frame " + name + " is relative to itself, by way of others");
    const auto bases = bases_of(id, kernel, span);
    if (bases.size() > 1)
      throw BadInput(file + ": it has " + name + " relative to " + frames.shown(*bases.begin()) + " and to " +
                     frames.shown(*std::next(bases.begin())) +
                     " in these times; times with one of them must be asked for");
    const auto mount = bases.empty() ? frames.mounted_on(chain.root) : std::nullopt;
    if (bases.empty() && !mount)
      throw BadInput(file + ": it has " +
                     frames.shown(chain.links.empty() ? frame : chain.links.back().frame) + " relative to " +
                     name +
                     ", whose attitude is neither in this file nor known: " + frames.shown(j2000_number) +
                     ", " + frames.shown(ecliptic_number) + " and " + frames.shown(itrf93_number) +
                     " are, and frames that a frame kernel has mounted on others");
    chain.links.push_back({chain.root, mount ? *mount : *bases.begin(), mount.has_value()});
    chain.root = chain.links.back().base;
  }
  if (std::all_of(chain.links.begin(), chain.links.end(), [](const auto& link) { return link.is_mounted; }))
    throw BadInput(file + ": it has no attitude of " + frames.shown(frame) + ", which is mounted on " +
                   frames.shown(chain.root));
  return chain;
}

std::string hidden_segments(const AttitudeKernel& kernel, const std::vector<HiddenAttitude>& hidden) {
  std::map<std::size_t, double> seconds;
  for (const auto& [segment, span] : hidden) seconds[segment] += (span.end() - span.start()).value();
  std::string text;
  for (const auto& [segment, sum] : seconds)
    text += (text.empty() ? "segment " : ", segment ") + detail::text(segment + 1) + " '" +
            kernel.segments()[segment].name + "' for " + shown(sum) + " s";
  return text;
}

void multiply(const KernelChain& chain, const AttitudeKernel& kernel, const FrameKernel& frames,
              const TimeSpan& span, AttitudeRecord& record) {
  std::vector<TimeSpan> known{span};
  std::vector<std::vector<Epoch>> times;  // of the factors
  std::vector<Epoch> starts;
  std::string without_rates;
  bool has_rates = false;
  for (const KernelLink& link : chain.links) {
    record.chain += (record.chain.empty() ? "" : ", ") + frames.shown(link.frame) + " relative to " +
                    frames.shown(link.base);
    if (link.is_mounted) {
      record.chain += ", mounted";
      continue;
    }
    const auto base = base_of(link);
    const auto frame = frame_of(link);
    const auto coverage = kernel.coverage(of<LinkFrame>, relative_to<LinkBase>, span, base, frame);
    record.chain += " for " + shown(seconds_of(coverage)) + " s";
    known = in_common(known, coverage);
    times.emplace_back();
    for (const auto& sample : kernel.samples(of<LinkFrame>, relative_to<LinkBase>, span, base, frame))
      times.back().push_back(sample.time);
    for (const Epoch& t : kernel.interval_starts(of<LinkFrame>, relative_to<LinkBase>, span, base, frame))
      starts.push_back(t);
    const std::string hidden =
        hidden_segments(kernel, kernel.hidden(of<LinkFrame>, relative_to<LinkBase>, span, base, frame));
    record.hidden_segments += (record.hidden_segments.empty() || hidden.empty() ? "" : ", ") + hidden;
    const std::int32_t id = in_attitudes(link.frame, frames);
    for (const AttitudeKernelSegment& segment : kernel.segments()) {
      if (segment.frame != id) continue;
      has_rates = has_rates || segment.has_rates;
      if (!segment.has_rates) without_rates = frames.shown(link.frame);
    }
  }
  record.chain += "; all of them for " + shown(seconds_of(known)) + " s";
  if (has_rates && !without_rates.empty())
    record.chain += "; without rates, which " + without_rates + " does not have";
  if (known.empty()) throw BadInput(record.file + ": it has " + record.chain);

  const auto factors = std::make_shared<const Factors>(chain, kernel, frames, span);
  std::sort(starts.begin(), starts.end());
  for (const TimeSpan& each : known) {
    Epoch start = each.start();
    const Between inner(starts, each.start(), each.end());
    for (auto next = inner.begin; next != inner.end; ++next) {
      if (*next == start) continue;
      record.interval_starts.push_back(start);
      add_times(start, *next, times, record.times);
      start = *next;
    }
    record.interval_starts.push_back(start);
    add_times(start, each.end(), times, record.times);
    record.times.push_back(each.end());
  }
  for (const Epoch& t : record.times) {
    const Quaterniond q = factors->motion(t).to_reference.conjugate();
    record.numbers.push_back({q.w(), q.x(), q.y(), q.z()});
    if (without_rates.empty()) record.rates.push_back(factors->recorded_rate(t));
  }
  record.motion = [factors](const Epoch& t) { return factors->motion(t); };
}

}  // namespace vectrix::cli

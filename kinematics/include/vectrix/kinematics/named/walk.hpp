#pragma once

#include <map>
#include <span>
#include <vectrix/kinematics/named/path_cache.hpp>

namespace vectrix::detail {

/// The values of the edges at one instant, evaluated at each request.
struct FreshMotions {
  static constexpr bool fresh = true;
  double t;
  Square<double> rotation(const EdgeFunction& function) const { return function.rotation(t); }
  EdgeMotion motion(const EdgeFunction& function) const { return function.motion(t); }
  PlacedMotion placed_motion(const EdgeFunction& function) const { return function.placed_motion(t); }
};

/// The same, but the values are kept between queries.
struct KeptMotions {
  static constexpr bool fresh = false;
  double t;
  std::map<const EdgeFunction*, PlacedMotion>& kept;
  const Square<double>& rotation(const EdgeFunction& function) const { return motion(function).R; }
  const EdgeMotion& motion(const EdgeFunction& function) const { return placed_motion(function).turning; }
  const PlacedMotion& placed_motion(const EdgeFunction& function) const {
    auto place = kept.find(&function);
    if (place == kept.end()) place = kept.emplace(&function, Evaluation{function, t}).first;
    return place->second;
  }

 private:
  // Becomes the value where the map keeps it.
  struct Evaluation {
    const EdgeFunction& function;
    double t;
    operator PlacedMotion() const { return function.placed_motion(t); }
  };
};

/// A product of rotations, from the left. Consecutive quaternions are multiplied as quaternions.
class RotationProduct {
 public:
  void times(const Square<double>& R) {
    turn_quaternion();
    if (empty_) {
      R_ = R;
    } else {
      R_ = (R_ * R).eval();
    }
    empty_ = false;
  }
  void times(const Eigen::Quaterniond& q) {
    q_ = pending_ ? q_ * q : q;
    pending_ = true;
  }
  Square<double> result() {
    turn_quaternion();
    return R_;
  }

 private:
  void turn_quaternion() {
    if (!pending_) return;
    pending_ = false;
    times(q_.toRotationMatrix());
  }

  bool empty_ = true, pending_ = false;
  Square<double> R_ = Square<double>::Identity();
  Eigen::Quaterniond q_ = Eigen::Quaterniond::Identity();
};

/// R_a^b along the path from b to a.
template <class Motions> Square<double> rotation_along(const NamedPath& path, const Motions& motions) {
  RotationProduct product;
  for (const PathLeg& leg : path.legs) {
    if (leg.function == nullptr) {
      product.times(leg.fixed);
    } else if (leg.in_quaternions && Motions::fresh) {
      const Eigen::Quaterniond q = leg.function->quaternion(motions.t);
      product.times(leg.against ? q.conjugate() : q);
    } else if (leg.against) {
      product.times(Square<double>(motions.rotation(*leg.function).transpose()));
    } else {
      product.times(motions.rotation(*leg.function));
    }
  }
  return product.result();
}

struct RatePair {
  Column<double> w = Column<double>::Zero(), alpha = Column<double>::Zero();
};

/// w_am^m, and at the acceleration level alpha_am^m, where m is the frame at the end of the steps from a.
/// `turned` if the steps belong to the reversed path. From m to n:
///     along an edge:   w_an^n = R_m^n w_am^m + w_mn^n,    alpha_an^n = R_m^n alpha_am^m + alpha_mn^n
///                                                                      + (R_m^n w_am^m) x w_mn^n
///     against one:     w_an^n = R_m^n (w_am^m - w_nm^m),  alpha_an^n = R_m^n (alpha_am^m - alpha_nm^m
///                                                                             - w_am^m x w_nm^m)
template <Level level, class Motions, class Iterator>
RatePair rate_along(Iterator step, Iterator end, bool turned, const Motions& motions) {
  RatePair rate;
  for (; step != end; ++step) {
    const EdgeMotion& here = motions.motion(step->edge->function());
    if (step->against == turned) {
      const Column<double> w = here.R.transpose() * rate.w;
      if constexpr (level == Level::acceleration)
        rate.alpha = (here.R.transpose() * rate.alpha + here.alpha + w.cross(here.w)).eval();
      rate.w = w + here.w;
    } else {
      if constexpr (level == Level::acceleration)
        rate.alpha = (here.R * (rate.alpha - here.alpha - rate.w.cross(here.w))).eval();
      rate.w = (here.R * (rate.w - here.w)).eval();
    }
  }
  return rate;
}

/// The number of common steps of two paths from one frame.
inline std::size_t shared_steps(std::span<const PathStep> one, std::span<const PathStep> other) {
  std::size_t shared = 0;
  while (shared < one.size() && shared < other.size() && one[shared] == other[shared]) ++shared;
  return shared;
}

/// A vector in the frame at the begin of the steps, re-expressed in the frame at their end. `turned` if the
/// steps belong to the reversed path.
template <class Motions, class Iterator>
[[gnu::always_inline]] inline void carry(Column<double>& vector, Iterator step, Iterator end, bool turned,
                                         const Motions& motions) {
  for (; step != end; ++step) {
    const Square<double>& R = motions.rotation(step->edge->function());
    vector = (step->against == turned ? Column<double>(R.transpose() * vector) : Column<double>(R * vector))
                 .eval();
  }
}

/// w_ab^c or alpha_ab^c. The paths from a to b and from a to c part at m; each edge is used once:
///     w_ab^m = w_am^m - w_bm^m,    alpha_ab^m = alpha_am^m - alpha_bm^m - w_am^m x w_bm^m
template <Level level, class Motions>
Column<double> rate_between(const NamedPath& to_b, const NamedPath& to_c, const Motions& motions) {
  const std::span b(to_b.steps), c(to_c.steps);
  const auto shared = static_cast<std::ptrdiff_t>(shared_steps(b, c));
  const RatePair am = rate_along<level>(b.begin(), b.begin() + shared, false, motions);
  const RatePair bm = rate_along<level>(b.rbegin(), b.rend() - shared, true, motions);
  Column<double> rate;
  if constexpr (level == Level::rate) {
    rate = am.w - bm.w;
  } else {
    rate = am.alpha - bm.alpha - am.w.cross(bm.w);
  }
  carry(rate, c.begin() + shared, c.end(), false, motions);
  return rate;
}

}  // namespace vectrix::detail

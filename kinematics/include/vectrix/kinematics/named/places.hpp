#pragma once

#include <vectrix/kinematics/named/walk.hpp>

namespace vectrix::detail {

/// The motion of b relative to a as a typed value of the level.
template <Level level, Frame A, Frame B> auto typed_motion(const PlacedMotion& ab) {
  const Dcm<A, B> R_a_from_b{trusted, ab.turning.R};
  const Displacement<A, B, In<A>> r_ab_a{trusted, ab.r};
  if constexpr (level == Level::rotation) {
    return Transform<A, B>{R_a_from_b, r_ab_a};
  } else {
    const AngularVelocity<A, B, In<B>> w_ab_b{trusted, ab.turning.w};
    const Velocity<A, B, ObservedFrom<A>, In<A>> v_ab_a_a{trusted, ab.v};
    if constexpr (level == Level::rate) {
      return MovingTransform<A, B>{{R_a_from_b, w_ab_b}, r_ab_a, v_ab_a_a};
    } else {
      const AngularAcceleration<A, B, In<B>> alpha_ab_b{trusted, ab.turning.alpha};
      const Acceleration<A, B, ObservedFrom<A>, In<A>> a_ab_a_a{trusted, ab.a};
      return AcceleratingTransform<A, B>{{R_a_from_b, w_ab_b, alpha_ab_b}, r_ab_a, v_ab_a_a, a_ab_a_a};
    }
  }
}

/// The motion relative to a, at the level, of the frame at the end of the steps from a: the product of the
/// typed motions of the edges.
template <Level level, class Motions>
PlacedMotion motion_along(std::span<const PathStep> steps, const Motions& motions) {
  using A = Some<'a'>;
  using B = Some<'b'>;
  using D = Some<'d'>;
  const auto none = Column<double>::Zero();
  PlacedMotion ab{{Square<double>::Identity(), none, none}, none, none, none};
  for (const PathStep& step : steps) {
    const PlacedMotion& edge = motions.placed_motion(step.edge->function());
    const auto before = typed_motion<level, A, B>(ab);
    if (step.against) {
      ab = placed_motion_of(before * inverse(typed_motion<level, D, B>(edge)));
    } else {
      ab = placed_motion_of(before * typed_motion<level, B, D>(edge));
    }
  }
  return ab;
}

/// The parts of the paths from the observer a to p, q and c. Those to p and to q part at m.
struct PlacePaths {
  std::span<const PathStep> am, mp, mq, ac;

  PlacePaths(const NamedPath& to_p, const NamedPath& to_q, const NamedPath& to_c) : ac(to_c.steps) {
    const std::span p(to_p.steps), q(to_q.steps);
    const std::size_t shared = shared_steps(p, q);
    am = p.first(shared);
    mp = p.subspan(shared);
    mq = q.subspan(shared);
  }
};

/// r_pq^m, v_pq|a^m or a_pq|a^m. An observer in m sees the motion along the paths from m:
///     v_pq|a = v_pq|m + w_am x r_pq, and the same for the acceleration
template <Level level, class Motions>
Column<double> place_at_parting(const PlacePaths& paths, const Motions& motions) {
  using A = Some<'a'>;
  using M = Some<'m'>;
  using P = Some<'p'>;
  using Q = Some<'q'>;
  const auto mp = typed_motion<level, M, P>(motion_along<level>(paths.mp, motions));
  const auto mq = typed_motion<level, M, Q>(motion_along<level>(paths.mq, motions));
  const auto r_pq_m = -mp.translation + mq.translation;
  if constexpr (level == Level::rotation) {
    return r_pq_m.coordinates();
  } else {
    const RatePair am = rate_along<level>(paths.am.begin(), paths.am.end(), false, motions);
    const AngularVelocity<A, M, In<M>> w_am_m{trusted, am.w};
    const auto v_pq_m = -mp.velocity + mq.velocity;
    if constexpr (level == Level::rate) {
      return transport(observed_from<A>, v_pq_m, r_pq_m, w_am_m).coordinates();
    } else {
      const AngularAcceleration<A, M, In<M>> alpha_am_m{trusted, am.alpha};
      const auto a_pq_m = -mp.acceleration + mq.acceleration;
      return transport(observed_from<A>, a_pq_m, v_pq_m, r_pq_m, alpha_am_m, w_am_m).coordinates();
    }
  }
}

/// r_pq^c, v_pq|a^c or a_pq|a^c.
template <Level level, class Motions>
Column<double> place_between(const PlacePaths& paths, const Motions& motions) {
  Column<double> place = place_at_parting<level>(paths, motions);
  const auto shared = static_cast<std::ptrdiff_t>(shared_steps(paths.am, paths.ac));
  carry(place, paths.am.rbegin(), paths.am.rend() - shared, true, motions);
  carry(place, paths.ac.begin() + shared, paths.ac.end(), false, motions);
  return place;
}

}  // namespace vectrix::detail

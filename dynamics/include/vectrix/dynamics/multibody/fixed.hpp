#pragma once

#include <vectrix/dynamics/multibody/joint.hpp>

namespace vectrix::multibody {

/// b does not move relative to its parent. It remains a body of its own: its accelerations and what its joint
/// transmits can be asked.
struct Fixed {
  static constexpr int positions = 0, speeds = 0;

  template <class S, class Parent>
  static void place(const Joint<S>& j, const S*, const S*, const Parent& p, Moving<S>& b) {
    b.R = in_hub(p, j.K0);
    b.r = in_hub(p, j.origin_p);
    b.w = p.w;
    b.alpha0 = turned_with(p, zero_column<S>());
    b.a0 = carried_by(p, b.r);
  }
  template <class S> static Accelerations<S> relative(const Square<S>&, const S*, const Moving<S>&) {
    return {zero_column<S>(), zero_column<S>()};
  }
  template <class S> static void rates(const S*, const S*, S*) {}
  template <class S> static void eliminate(const Square<S>&, const S*, Moving<S>&) {}
  template <class S> static void advance(const Square<S>&, Moving<S>&, S*) {}
  template <class S> static Column<S> velocity(const Square<S>&, const S*, const Moving<S>&) {
    return zero_column<S>();
  }
};

}  // namespace vectrix::multibody

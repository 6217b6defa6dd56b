#pragma once

#include <vectrix/frames/graph/walk.hpp>
#include <vectrix/frames/transform.hpp>

namespace vectrix::detail {

/// Zero: the position, velocity and acceleration of a frame's origin relative to itself.
struct Nil {};
struct NoMotion {
  Nil translation, velocity, acceleration;
};

/// x_pq^m = -x_mp^m + x_mq^m
template <class Q> const Q& apart(Nil, const Q& x_mq_m) {
  return x_mq_m;
}
template <class P> auto apart(const P& x_mp_m, Nil) {
  return -x_mp_m;
}
template <class P, class Q> auto apart(const P& x_mp_m, const Q& x_mq_m) {
  return -x_mp_m + x_mq_m;
}

/// The answers of a frame graph about the origins of its frames.
template <class Topology, class Values> class PlaceWalk : public GraphWalk<Topology, Values> {
  using Walk = GraphWalk<Topology, Values>;

 public:
  using Walk::Walk;

  // X_a^b
  template <class B, class A> auto transform() const {
    if constexpr (std::is_same_v<A, B>) {
      using S = typename Topology::scalar;
      return vectrix::Transform<B, A, S>{Walk::template rotation<B, A>(),
                                         coincident<A, B, B, S>(of<A>, relative_to<B>, in<B>)};
    } else {
      return Walk::template product<B, A, length<B, A>>(
          [](const auto& value) -> decltype(auto) { return transform_of(value); });
    }
  }

  // The paths from p to q and from p to c part at m: r_pq^m = -r_mp^m + r_mq^m, then re-expressed from m in
  // c.
  template <class Q, class P, class C> auto position() const {
    using M = Parting<P, Q, C>;
    return Walk::template carried<M, C, 0>([&] { return apart(place<M, P>(), place<M, Q>()); });
  }

  // The paths from p to q and from p to the observer a part at m: v_pq|a = v_pq|m + w_am x r_pq.
  template <class Q, class P, class A, class C> auto velocity() const {
    using M = Parting<P, Q, A>;
    return Walk::template carried<M, C, 0>([&] {
      const auto part = [](const auto& value) -> decltype(auto) { return moving_transform_of(value); };
      const auto mp = motion<M, P>(part);
      const auto mq = motion<M, Q>(part);
      const auto v_pq_m = apart(mp.velocity, mq.velocity);
      if constexpr (std::is_same_v<A, M>) {
        return v_pq_m;
      } else {
        return transport(observed_from<A>, v_pq_m, apart(mp.translation, mq.translation),
                         Walk::template rate<A, M, length<A, M>>());
      }
    });
  }

  // The same for the acceleration.
  template <class Q, class P, class A, class C> auto acceleration() const {
    using M = Parting<P, Q, A>;
    return Walk::template carried<M, C, 0>([&] {
      const auto part = [](const auto& value) -> decltype(auto) { return (value); };
      const auto mp = motion<M, P>(part);
      const auto mq = motion<M, Q>(part);
      const auto a_pq_m = apart(mp.acceleration, mq.acceleration);
      if constexpr (std::is_same_v<A, M>) {
        return a_pq_m;
      } else {
        const auto am = Walk::template product<A, M, length<A, M>>(
            [](const auto& value) -> decltype(auto) { return accelerating_part(value); });
        return transport(observed_from<A>, a_pq_m, apart(mp.velocity, mq.velocity),
                         apart(mp.translation, mq.translation), angular_acceleration_of(am),
                         angular_velocity_of(am));
      }
    });
  }

 private:
  template <class Start, class Goal>
  static constexpr std::size_t length = Topology::template path_between<Start, Goal>.length;
  template <class Start, class Goal, class Other>
  using Parting = typename Topology::template PartingFrame<Start, Goal, Other>;

  // The motion of a frame's origin relative to m, observed from m.
  template <class M, class Goal, class Part> auto motion(Part part) const {
    if constexpr (std::is_same_v<M, Goal>) {
      return NoMotion{};
    } else {
      return Walk::template product<M, Goal, length<M, Goal>>(part);
    }
  }

  // r_mq^m, where m is `step` steps from Start on the path to q. Starts at q and rotates only vectors.
  template <class Start, class Q, std::size_t step = 0> auto place() const {
    if constexpr (std::is_same_v<Start, Q>) {
      return Nil{};
    } else {
      static constexpr auto& path = Topology::template path_between<Start, Q>;
      const auto& here = Walk::template value<path.edge[step]>();
      if constexpr (step + 1 == path.length) {
        if constexpr (path.reversed[step]) {
          return inverse(rotation_of(here)) * -here.translation;
        } else {
          return here.translation;
        }
      } else if constexpr (path.reversed[step]) {
        return inverse(rotation_of(here)) * (-here.translation + place<Start, Q, step + 1>());
      } else {
        return here.translation + rotation_of(here) * place<Start, Q, step + 1>();
      }
    }
  }
};

}  // namespace vectrix::detail

#pragma once

#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/motion.hpp>
#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>

namespace vectrix {
namespace detail {

/// The motion of a body relative to its parent, in the parent's axes, by the engine's own kinematics.
struct RelativeMotion {
  Square3 R;
  Column3 r, w, v, alpha, a;
};
/// `udot` may be null: then without accelerations.
template <class Shape, class B>
RelativeMotion relative_motion(const CraftCore& core, const double* y, const double* ydot) {
  constexpr std::size_t last = Shape::template link_of<B>() - 1;
  constexpr std::size_t q_at = Shape::template position_at<B>, u_at = Shape::template speed_at<B>;
  const auto& links = core.tree.numbers().links;
  const multibody::OnHub<double> resting{multibody::zero_column<double>()};
  const Square3 one = multibody::identity<double>();
  multibody::Moving<double> b;
  if constexpr (Shape::template has_joint_of<B, JointKind::gimbal>) {
    multibody::Moving<double> ring;
    multibody::Hinge::place(links[last - 1].joint, y + q_at, y + u_at, resting, ring);
    if (ydot) ring.alpha0 += multibody::Hinge::relative(one, ydot + u_at, ring).alpha;
    multibody::Hinge::place(links[last].joint, y + q_at + 1, y + u_at + 1, ring, b);
    if (ydot) b.alpha0 += multibody::Hinge::relative(one, ydot + u_at + 1, b).alpha;
    return {b.R, ring.r, b.w, multibody::zero_column<double>(), b.alpha0, ring.a0};
  } else {
    using Kind = typename EngineKind<Shape::template Part<B>::joint>::type;
    Kind::place(links[last].joint, y + q_at, y + u_at, resting, b);
    if (ydot) {
      const auto added = Kind::relative(one, ydot + u_at, b);
      b.alpha0 += added.alpha;
      b.a0 += added.a;
    }
    return {b.R, b.r, b.w, Kind::velocity(one, y + u_at, b), b.alpha0, b.a0};
  }
}
template <class P, class B> MovingTransform<P, B> moving_transform(const RelativeMotion& b) {
  return {{Dcm<P, B>{trusted, eigen(b.R)},
           AngularVelocity<P, B, In<B>>{trusted, eigen(multibody::transposed_times(b.R, b.w))}},
          Displacement<P, B, In<P>>{trusted, eigen(b.r)},
          Velocity<P, B, ObservedFrom<P>, In<P>>{trusted, eigen(b.v)}};
}
template <class P, class B> AcceleratingTransform<P, B> accelerating_transform(const RelativeMotion& b) {
  const auto X = moving_transform<P, B>(b);
  return {accelerating_dcm(
              X.turning.rotation, X.turning.angular_velocity,
              AngularAcceleration<P, B, In<B>>{trusted, eigen(multibody::transposed_times(b.R, b.alpha))}),
          X.translation, X.velocity, Acceleration<P, B, ObservedFrom<P>, In<P>>{trusted, eigen(b.a)}};
}

/// The edges of the hub, the bodies and the mounts; rotors and modes have none.
template <class C> auto moving_edges_of_hub() {
  if constexpr (C::shape::free)
    return edge([](const CraftState<C>& s) { return s.hub_motion(); });
  else
    return edge([](const CraftState<C>& s) { return s.turning(); });
}
template <class C> auto accelerating_edge_of_hub() {
  using I = typename C::shape::inertial;
  using H = typename C::shape::hub;
  const auto turning = [](const CraftMotion<C>& m) {
    const auto ab = m.state().turning();
    return accelerating_dcm(ab.rotation, ab.angular_velocity, m.angular_acceleration(of<H>, in<H>));
  };
  if constexpr (C::shape::free) {
    return edge([turning](const CraftMotion<C>& m) {
      const auto X = m.state().hub_motion();
      return AcceleratingTransform<I, H>{turning(m), X.translation, X.velocity, m.acceleration(of<H>, in<I>)};
    });
  } else {
    return edge(turning);
  }
}
template <class C, bool accelerating, class Part>
auto edges_of_part(const std::shared_ptr<const CraftCore>& core, std::type_identity<Part>) {
  using F = typename Part::frame;
  using Shape = typename C::shape;
  if constexpr (Part::role == PartRole::hub) {
    if constexpr (accelerating)
      return std::tuple{accelerating_edge_of_hub<C>()};
    else
      return std::tuple{moving_edges_of_hub<C>()};
  } else if constexpr (Part::role == PartRole::body) {
    using P = typename Part::carrier;
    if constexpr (accelerating) {
      return std::tuple{edge([core](const CraftMotion<C>& m) {
        return accelerating_transform<P, F>(
            relative_motion<Shape, F>(*core, m.state().data(), m.rates().data()));
      })};
    } else {
      return std::tuple{edge([core](const CraftState<C>& s) {
        return moving_transform<P, F>(relative_motion<Shape, F>(*core, s.data(), nullptr));
      })};
    }
  } else if constexpr (Part::role == PartRole::mount) {
    using B = typename Part::carrier;
    const PlainMount& mount = core->mounts[Shape::template mount_at<F>];
    return std::tuple{rigid_edge(Transform<B, F>{Dcm<B, F>{trusted, eigen(mount.R_b_from_c)},
                                                 Displacement<B, F, In<B>>{trusted, eigen(mount.r_bc_b)}})};
  } else {
    return std::tuple{};
  }
}
template <class C, bool accelerating, class... Parts, class... Edges>
auto edges_of(const C& craft, std::type_identity<std::tuple<Parts...>>, const Edges&... edges) {
  return std::tuple_cat(edges_of_part<C, accelerating>(craft.core(), std::type_identity<Parts>{})...,
                        std::tuple{edges...});
}
template <class C, bool accelerating, class... Edges> auto graph_of(const C& craft, const Edges&... edges) {
  return std::apply(
      [](const auto&... edge) { return frame_graph(edge...); },
      edges_of<C, accelerating>(craft, std::type_identity<typename C::shape::parts>{}, edges...));
}
template <class Tuple> struct FaultOfEdges;
template <class... Edges>
struct FaultOfEdges<std::tuple<Edges...>> : std::type_identity<FaultOf<Edges...>> {};
/// What is wrong with edges beside those of a craft; Nothing if all is well.
template <class C, bool accelerating, class... Edges>
using CraftGraphFault = typename FaultOfEdges<decltype(edges_of<C, accelerating>(
    std::declval<const C&>(), std::type_identity<typename C::shape::parts>{},
    std::declval<const Edges&>()...))>::type;

}  // namespace detail

/// The frames of a craft, its inertial frame, bodies and mounts, joined with other edges to one frame graph,
/// which is asked at a state or a motion:
///     graph.at(state).angular_velocity(of<Camera>, relative_to<Itrf>, in<Camera>)
/// An edge that is a function of time is given the time of the state.
template <CraftType C, class... Edges>
  requires std::is_same_v<detail::CraftGraphFault<C, false, Edges...>, Nothing>
auto frame_graph_of(const C& craft, const Edges&... edges) {
  return detail::graph_of<C, false>(craft, edges...);
}
/// The same with accelerations, asked at a motion.
template <CraftType C, class... Edges>
  requires std::is_same_v<detail::CraftGraphFault<C, true, Edges...>, Nothing>
auto accelerating_frame_graph_of(const C& craft, const Edges&... edges) {
  return detail::graph_of<C, true>(craft, edges...);
}
template <CraftType C, class... Edges, class Fault = detail::CraftGraphFault<C, false, Edges...>>
  requires(!std::is_same_v<Fault, Nothing>)
auto frame_graph_of(  // edges that join other frames to those of the craft, which has its own: see Fault
    const C&, const Edges&...) -> Refused = delete;
template <CraftType C, class... Edges, class Fault = detail::CraftGraphFault<C, true, Edges...>>
  requires(!std::is_same_v<Fault, Nothing>)
auto accelerating_frame_graph_of(  // edges that join other frames to those of the craft: see Fault
    const C&, const Edges&...) -> Refused = delete;

}  // namespace vectrix

#pragma once

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/named/algebra.hpp>
#include <vectrix/kinematics/named/sampled_edge.hpp>
#include <vectrix/kinematics/named/snapshot.hpp>
#include <vectrix/kinematics/named/transform_doors.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>

namespace vectrix {
namespace detail {

/// An answer of a graph as the function of an edge of a FrameGraph.
template <class V> struct AnswerOfGraph {
  const NamedGraphCore* core;

  V operator()(Quantity<si::time> t) const {
    using A = typename LevelOf<V>::first;
    using B = typename LevelOf<V>::second;
    if constexpr (LevelOf<V>::placed) {
      const FrameRecord &a = core->record<A>(), &b = core->record<B>();
      const FreshMotions motions{finite_time(t.value())};
      return typed_motion<LevelOf<V>::level, A, B>(
          motion_between<LevelOf<V>::level>({"typed_edge", b, a, &a}, *core, a, b, motions));
    } else if constexpr (LevelOf<V>::level == Level::rotation) {
      return NamedSnapshot{*core, t.value()}.rotation(to<A>, from<B>);
    } else {
      return with_motion(NamedSnapshot{*core, t.value()}, to<A>, from<B>);
    }
  }

 private:
  // The snapshot keeps the values of its edges.
  template <class A, class B> static V with_motion(const NamedSnapshot& now, To<A> a, From<B> b) {
    const auto moving = moving_dcm(now.rotation(a, b), now.angular_velocity(of<B>, relative_to<A>, in<B>));
    if constexpr (LevelOf<V>::level == Level::rate) {
      return moving;
    } else {
      return {moving.rotation, moving.angular_velocity,
              now.angular_acceleration(of<B>, relative_to<A>, in<B>)};
    }
  }
};

/// Throws BadInput unless the graph has a path from a to b that can answer with a V.
template <class V>
void require_answer(const NamedGraphCore& core, const FrameRecord& b, const FrameRecord& a) {
  const NamedQuery query{"typed_edge", b, a, &a};
  core.with_path(a, b, [&](const NamedPath* path) {
    if (path == nullptr) query.no_path(a, b);
    query.require_level(path->steps, LevelOf<V>::level);
    if constexpr (LevelOf<V>::placed) query.require_places(path->steps);
  });
}

/// Whether a NamedGraph can evaluate an edge of a FrameGraph.
template <class Edge>
inline constexpr bool stands_alone =
    Edge::template takes<Quantity<si::time>> && !asks<Edge> && std::same_as<ScalarOf<Edge>, double>;

}  // namespace detail

/// A tree of frames known at run time, for example from a file, or wheel k of N. Queries and levels are those
/// of a FrameGraph. Where a FrameGraph does not compile, it throws BadInput.
///     NamedGraph graph;
///     const NamedFrame body = graph.add_frame("body", FrameMotion::moving);
///     graph.add_edge(rigid_edge(turned_x(To(body), From(camera), angle)));
///     graph.at(t).angular_velocity(Of(camera), RelativeTo("gcrf"), In(body))
/// Threads may query while others add, without waiting. Only the first query for a pair of frames may wait
/// while their trees are joined. Frames and edges are never removed.
class NamedGraph {
 public:
  /// Keeps the paths of the first `cached_paths` pairs of frames that are queried. Other paths are searched
  /// at each query.
  explicit NamedGraph(std::size_t cached_paths = 1024)
      : core_(std::make_unique<detail::NamedGraphCore>(cached_paths)) {}

  /// Adds a frame, and with a type F binds that type to it. Throws BadInput when the name is empty or taken,
  /// or F is bound already.
  NamedFrame add_frame(std::string name, FrameMotion motion) {
    return core_->add_frame(std::move(name), motion, nullptr);
  }
  template <Frame F> NamedFrame add_frame(std::string name) {
    return core_->add_frame(std::move(name), motion_of_type<F>, &typeid(F));
  }

  /// Claims that the type F and a frame of the graph are the same frame. Throws BadInput when either is bound
  /// already, the frame is unknown, or only one of them is inertial.
  template <Frame F> void bind(NamedFrame frame) { bind_to<F>(core_->record(frame)); }
  template <Frame F> void bind(std::string_view name) { bind_to<F>(core_->record(name)); }

  /// Adds an edge. Throws BadInput when its frames belong to another graph, are already joined by an edge or
  /// a path, or its fixed rotation or position is not finite.
  void add_edge(NamedEdge edge) { core_->add_edge(std::move(edge)); }

  /// Adds an edge of a FrameGraph, static_edge(R_a_from_b), rigid_edge(X_a_from_b) or edge(f), between the
  /// frames to which its types are bound.
  template <class Edge, class V = typename Edge::value_type>
  std::enable_if_t<detail::stands_alone<Edge>> add_edge(Edge edge) {
    using namespace detail;
    const NamedFrame a = frame<FirstOf<Edge>>();
    const NamedFrame b = frame<SecondOf<Edge>>();
    if constexpr (is_constant<Edge>) {
      core_->add_edge(
          {trusted, a, b,
           std::make_unique<ConstantFunction>(level_of<V>, is_placed<V>, placed_motion_of(edge.value()))});
    } else {
      core_->add_edge({trusted, a, b, std::make_unique<FunctionOfTime<Edge, V>>(a, b, std::move(edge))});
    }
  }
  template <class Edge, class V = typename Edge::value_type>
    requires(!detail::stands_alone<Edge>)
  auto add_edge(  // a value, or a function of seconds alone: no answers of other edges; in double
      const Edge&) -> Refused = delete;

  /// The graph at one instant, in seconds since an epoch of the caller's choice, one for all edges. Throws
  /// BadInput when the time is not finite.
  NamedSnapshot at(const Quantity<si::time>& t) const& { return {*core_, t.value()}; }
  NamedSnapshot at(  // the snapshot refers to the graph: give the graph a name first
      const Quantity<si::time>&) const&& = delete;
  template <class Instant>
    requires(!std::convertible_to<const Instant&, Quantity<si::time>>)
  NamedSnapshot at(  // seconds since an epoch of your choice: graph.at(t - t0)
      const Instant&)
  const = delete;

  /// The frame of that name, or bound to that type. Throws BadInput with the nearest name if there is none.
  NamedFrame frame(std::string_view name) const { return NamedFrame{core_->record(name)}; }
  template <Frame F> NamedFrame frame() const { return NamedFrame{core_->record<F>()}; }
  /// An answer of this graph as an edge of a FrameGraph; V, a Dcm<A, B>, MovingDcm or AcceleratingDcm, or one
  /// with a position, gives its frames and level. Throws BadInput in this call when the graph cannot answer.
  /// The edge must not outlive the graph.
  template <EdgeValue V> auto typed_edge() const& {
    using A = typename LevelOf<V>::first;
    using B = typename LevelOf<V>::second;
    detail::require_answer<V>(*core_, core_->record<B>(), core_->record<A>());
    return edge(detail::AnswerOfGraph<V>{core_.get()});
  }
  template <EdgeValue V>
  void typed_edge() const&& = delete;  // the edge refers to the graph: give the graph a name first

  /// Converts a typed value to a named one, with the frames to which its types are bound.
  template <class Typed>
    requires(detail::frames_in<Typed> > 0)
  auto named(const Typed& x) const { return named(x, typename detail::FramesIn<Typed>::type{}); }

  /// Converts a named value to a typed one: typed<Twist<A, B, At<B>, In<B>>>(V_ab). Throws BadInput when its
  /// frames are not bound to these types.
  template <class Typed, class X>
    requires detail::takes<Typed, X> Typed typed(const X& x)
  const {
    require_bound(typename detail::FramesIn<Typed>::type{}, detail::Naming<X>::frames(x));
    return detail::relabelled<Typed>(x);
  }
  /// The same by the words of the door.
  template <Frame B, Frame A> Dcm<B, A> typed(To<B>, From<A>, const NamedDcm& R_b_from_a) const {
    return typed<Dcm<B, A>>(R_b_from_a);
  }
  template <Frame B, Frame A>
  Quaternion<B, A> typed(To<B>, From<A>, const NamedQuaternion& q_b_from_a) const {
    return typed<Quaternion<B, A>>(q_b_from_a);
  }
  template <Frame B, Frame A> Transform<B, A> typed(To<B>, From<A>, const NamedTransform& X_b_from_a) const {
    return typed<Transform<B, A>>(X_b_from_a);
  }
  template <Frame C, class U> Vector<C, U> typed(In<C>, const NamedVector<U>& r_c) const {
    return typed<Vector<C, U>>(r_c);
  }
  template <Frame B, Frame A, Frame C>
  AngularVelocity<A, B, In<C>> typed(Of<B>, RelativeTo<A>, In<C>, const NamedAngularVelocity& w_ab_c) const {
    return typed<AngularVelocity<A, B, In<C>>>(w_ab_c);
  }
  template <Frame B, Frame A, Frame C>
  AngularAcceleration<A, B, In<C>> typed(Of<B>, RelativeTo<A>, In<C>,
                                         const NamedAngularAcceleration& alpha_ab_c) const {
    return typed<AngularAcceleration<A, B, In<C>>>(alpha_ab_c);
  }
  template <Frame Q, Frame P, Frame C>
  Displacement<P, Q, In<C>> typed(Of<Q>, RelativeTo<P>, In<C>, const NamedDisplacement& r_pq_c) const {
    return typed<Displacement<P, Q, In<C>>>(r_pq_c);
  }
  template <Frame Q, Frame P, Frame A, Frame C>
  Velocity<P, Q, ObservedFrom<A>, In<C>> typed(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>,
                                               const NamedVelocity& v_pq_a_c) const {
    return typed<Velocity<P, Q, ObservedFrom<A>, In<C>>>(v_pq_a_c);
  }
  template <Frame Q, Frame P, Frame A, Frame C>
  Acceleration<P, Q, ObservedFrom<A>, In<C>> typed(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>,
                                                   const NamedAcceleration& a_pq_a_c) const {
    return typed<Acceleration<P, Q, ObservedFrom<A>, In<C>>>(a_pq_a_c);
  }

  /// All frames, in the order in which they were added.
  std::vector<NamedFrame> frames() const { return core_->frames(); }

  std::size_t cached_paths() const { return core_->cached_paths(); }

 private:
  template <class F>
  static constexpr FrameMotion motion_of_type =
      InertialFrame<F> ? FrameMotion::inertial : FrameMotion::moving;

  template <class Typed, class... Fs> auto named(const Typed& x, detail::FrameList<Fs...>) const {
    using X = typename detail::NamedFor<detail::FormOf<Typed>>::type;
    return detail::Naming<X>::make({frame<Fs>()...}, x);
  }
  template <class... Fs, class Frames>
  void require_bound(detail::FrameList<Fs...>, const Frames& given) const {
    std::size_t i = 0;
    (require_bound<Fs>(given[i++]), ...);
  }
  template <class F> void require_bound(NamedFrame given) const {
    const NamedFrame bound = frame<F>();
    if (bound == given) return;
    throw BadInput("typed: the type " + frame_name<F>() + " is bound to the frame " +
                   detail::in_quotes(bound) + ", the value carries " + detail::in_quotes(given) +
                   (bound.name() == given.name() ? " of another graph" : ""));
  }

  template <class F> void bind_to(const detail::FrameRecord& record) {
    core_->bind(typeid(F), frame_name<F>(), motion_of_type<F>, record);
  }

  std::unique_ptr<detail::NamedGraphCore> core_;
};

}  // namespace vectrix

#pragma once

#include <vectrix/kinematics/named/query.hpp>

namespace vectrix {
namespace detail {

template <class F>
concept AnyFrame = Frame<F> || RunTimeFrame<F>;

/// The record of the frame in an argument: to<Body>, To(camera), To("camera").
template <template <class> class Word, class F>
const FrameRecord& record_in(const NamedGraphCore& core, const Word<F>& word) {
  if constexpr (Frame<F>) {
    return core.record<F>();
  } else {
    return core.record(word.frame);
  }
}

}  // namespace detail

/// A NamedGraph at one instant. A query takes frames by handle, by name, or by the type bound to them; if all
/// are types, the answer is typed. Each edge is evaluated at most once: a named snapshot keeps the values, a
/// temporary one, `graph.at(t).rotation(...)`, uses each value only once. It must not outlive the graph. Two
/// threads must not share a snapshot: take one per thread.
class NamedSnapshot {
 public:
  NamedSnapshot(const detail::NamedGraphCore& core, double t) : core_(&core), t_(detail::finite_time(t)) {}

  /// R_a^b between any two joined frames. Throws BadInput for an unknown frame, a frame of another graph, or
  /// two frames without a path.
  template <detail::AnyFrame B, detail::AnyFrame A> auto rotation(To<B> b, From<A> a) const& {
    return rotation(b, a, kept());
  }
  template <detail::AnyFrame B, detail::AnyFrame A> auto rotation(To<B> b, From<A> a) && {
    return rotation(b, a, fresh());
  }

  /// w_ab^c, of b relative to a, expressed in c. Throws BadInput as rotation() does, and also when b is a, or
  /// an edge from a to b has no rate.
  template <detail::AnyFrame B, detail::AnyFrame A, detail::AnyFrame C>
  auto angular_velocity(Of<B> b, RelativeTo<A> a, In<C> c) const& {
    return angular_velocity(b, a, c, kept());
  }
  template <detail::AnyFrame B, detail::AnyFrame A, detail::AnyFrame C>
  auto angular_velocity(Of<B> b, RelativeTo<A> a, In<C> c) && {
    return angular_velocity(b, a, c, fresh());
  }

  /// alpha_ab^c, of b relative to a, expressed in c. Throws BadInput as angular_velocity(), for the
  /// acceleration.
  template <detail::AnyFrame B, detail::AnyFrame A, detail::AnyFrame C>
  auto angular_acceleration(Of<B> b, RelativeTo<A> a, In<C> c) const& {
    return angular_acceleration(b, a, c, kept());
  }
  template <detail::AnyFrame B, detail::AnyFrame A, detail::AnyFrame C>
  auto angular_acceleration(Of<B> b, RelativeTo<A> a, In<C> c) && {
    return angular_acceleration(b, a, c, fresh());
  }

  /// X_a^b between any two joined frames. Throws BadInput as rotation() does, and also when an edge from a to
  /// b has no position.
  template <detail::AnyFrame B, detail::AnyFrame A> auto transform(To<B> b, From<A> a) const& {
    return transform(b, a, kept());
  }
  template <detail::AnyFrame B, detail::AnyFrame A> auto transform(To<B> b, From<A> a) && {
    return transform(b, a, fresh());
  }

  /// r_pq^c, of q's origin relative to p's, expressed in c. Throws BadInput as rotation() does, and also when
  /// q is p, or an edge from p to q has no position.
  template <detail::AnyFrame Q, detail::AnyFrame P, detail::AnyFrame C>
  auto position(Of<Q> q, RelativeTo<P> p, In<C> c) const& {
    return position(q, p, c, kept());
  }
  template <detail::AnyFrame Q, detail::AnyFrame P, detail::AnyFrame C>
  auto position(Of<Q> q, RelativeTo<P> p, In<C> c) && {
    return position(q, p, c, fresh());
  }

  /// v_pq|a^c, of q's origin relative to p's, observed from a, expressed in c. Throws BadInput as position(),
  /// and also when an edge between p, q and a has no rate.
  template <detail::AnyFrame Q, detail::AnyFrame P, detail::AnyFrame A, detail::AnyFrame C>
  auto velocity(Of<Q> q, RelativeTo<P> p, ObservedFrom<A> a, In<C> c) const {
    const auto v = observed<Level::rate, si::velocity>("velocity", q, p, a, c);
    if constexpr (Frame<Q> && Frame<P> && Frame<A> && Frame<C>) {
      return vectrix::velocity(q, p, a, v);
    } else {
      return v;
    }
  }

  /// a_pq|a^c: as velocity(), with accelerations instead of rates.
  template <detail::AnyFrame Q, detail::AnyFrame P, detail::AnyFrame A, detail::AnyFrame C>
  auto acceleration(Of<Q> q, RelativeTo<P> p, ObservedFrom<A> a, In<C> c) const {
    const auto a_pq = observed<Level::acceleration, si::acceleration>("acceleration", q, p, a, c);
    if constexpr (Frame<Q> && Frame<P> && Frame<A> && Frame<C>) {
      return vectrix::acceleration(q, p, a, a_pq);
    } else {
      return a_pq;
    }
  }

 private:
  detail::FreshMotions fresh() const { return {t_}; }
  detail::KeptMotions kept() const { return {t_, kept_}; }

  template <class B, class A, class Motions> auto rotation(To<B> b, From<A> a, const Motions& motions) const {
    using namespace detail;
    const FrameRecord& to_b = record_in(*core_, b);
    const FrameRecord& from_a = record_in(*core_, a);
    const auto R = [&] { return detail::rotation(*core_, to_b, from_a, motions); };
    if constexpr (Frame<B> && Frame<A>) {
      return Dcm<B, A>{trusted, R};
    } else {
      return NamedDcm{trusted, NamedFrame{to_b}, NamedFrame{from_a}, R};
    }
  }

  template <class B, class A, class C, class Motions>
  auto angular_velocity(Of<B> b, RelativeTo<A> a, In<C> c, const Motions& motions) const {
    const auto w = rate<Level::rate, si::angular_velocity>(b, a, c, motions);
    if constexpr (Frame<B> && Frame<A> && Frame<C>) {
      return vectrix::angular_velocity(of<B>, relative_to<A>, w);
    } else {
      return w;
    }
  }
  template <class B, class A, class C, class Motions>
  auto angular_acceleration(Of<B> b, RelativeTo<A> a, In<C> c, const Motions& motions) const {
    const auto alpha = rate<Level::acceleration, si::angular_acceleration>(b, a, c, motions);
    if constexpr (Frame<B> && Frame<A> && Frame<C>) {
      return vectrix::angular_acceleration(of<B>, relative_to<A>, alpha);
    } else {
      return alpha;
    }
  }

  // The answer, a typed vector if all frames are types, else a named one.
  template <Level level, class U, class B, class A, class C, class Motions>
  auto rate(Of<B> b, RelativeTo<A> a, In<C> c, const Motions& motions) const {
    using namespace detail;
    const FrameRecord& of_b = record_in(*core_, b);
    const FrameRecord& relative_to_a = record_in(*core_, a);
    const FrameRecord& in_c = record_in(*core_, c);
    const Column<double> answer = detail::rate<level>(*core_, of_b, relative_to_a, in_c, motions);
    if constexpr (Frame<B> && Frame<A> && Frame<C>) {
      return Vector<C, U>{trusted, answer};
    } else {
      return NamedRelativeVector<U>{trusted, NamedFrame{of_b}, NamedFrame{relative_to_a},
                                    NamedVector<U>{trusted, NamedFrame{in_c}, answer}};
    }
  }

  template <class B, class A, class Motions>
  auto transform(To<B> b, From<A> a, const Motions& motions) const {
    using namespace detail;
    const FrameRecord& to_b = record_in(*core_, b);
    const FrameRecord& from_a = record_in(*core_, a);
    const PlacedMotion ba =
        motion_between<Level::rotation>({"transform", to_b, from_a}, *core_, to_b, from_a, motions);
    if constexpr (Frame<B> && Frame<A>) {
      return typed_motion<Level::rotation, B, A>(ba);
    } else {
      const NamedDcm R{trusted, NamedFrame{to_b}, NamedFrame{from_a}, ba.turning.R};
      return NamedTransform{trusted, R, ba.r};
    }
  }

  template <class Q, class P, class C, class Motions>
  auto position(Of<Q> q, RelativeTo<P> p, In<C> c, const Motions& motions) const {
    using namespace detail;
    const FrameRecord& of_q = record_in(*core_, q);
    const FrameRecord& relative_to_p = record_in(*core_, p);
    const FrameRecord& in_c = record_in(*core_, c);
    // Every observer sees the same position. From c, each edge is used once.
    const Column<double> r =
        place<Level::rotation>({"position", of_q, relative_to_p, &in_c}, *core_, in_c, motions);
    if constexpr (Frame<Q> && Frame<P> && Frame<C>) {
      return displacement(q, p, Vector<C, si::length>{trusted, r});
    } else {
      return NamedDisplacement{
          trusted, NamedFrame{of_q}, NamedFrame{relative_to_p}, {trusted, NamedFrame{in_c}, r}};
    }
  }

  // The answer, a typed vector if all frames are types, else a named one. It keeps the values, because the
  // path to c may share edges with the others.
  template <Level level, class U, class Q, class P, class A, class C>
  auto observed(const char* what, Of<Q> q, RelativeTo<P> p, ObservedFrom<A> a, In<C> c) const {
    using namespace detail;
    const FrameRecord& of_q = record_in(*core_, q);
    const FrameRecord& relative_to_p = record_in(*core_, p);
    const FrameRecord& from_a = record_in(*core_, a);
    const FrameRecord& in_c = record_in(*core_, c);
    const Column<double> answer =
        place<level>({what, of_q, relative_to_p, &in_c, &from_a}, *core_, from_a, kept());
    if constexpr (Frame<Q> && Frame<P> && Frame<A> && Frame<C>) {
      return Vector<C, U>{trusted, answer};
    } else {
      return NamedObservedVector<U>{trusted,
                                    NamedFrame{of_q},
                                    NamedFrame{relative_to_p},
                                    NamedFrame{from_a},
                                    {trusted, NamedFrame{in_c}, answer}};
    }
  }

  const detail::NamedGraphCore* core_;
  double t_;
  mutable std::map<const detail::EdgeFunction*, detail::PlacedMotion> kept_;
};

}  // namespace vectrix

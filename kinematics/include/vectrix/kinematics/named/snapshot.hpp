#pragma once

#include <algorithm>
#include <vectrix/kinematics/named/graph_core.hpp>

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

/// A query of a snapshot, for messages.
struct NamedQuery {
  const char* what;
  const FrameRecord &b, &a, &c;
  Level level;

  [[noreturn, gnu::cold, gnu::noinline]] void refuse(const std::string& why) const {
    const bool rotation = level == Level::rotation;
    throw BadInput(std::string{what} + (rotation ? "(to " : "(of ") + in_quotes(b.name) +
                   (rotation ? ", from " : ", relative to ") + in_quotes(a.name) +
                   (rotation ? "" : ", in " + in_quotes(c.name)) + "): " + why);
  }
  [[noreturn, gnu::cold, gnu::noinline]] void no_path(const FrameRecord& from, const FrameRecord& to) const {
    refuse("no path, " + in_quotes(from.name) + " and " + in_quotes(to.name) + " are in two trees");
  }
  void require_level(const NamedPath& path) const {
    if (const NamedEdge* edge = path.edge_below(level)) [[unlikely]]
      refuse(described(*edge) + (level == Level::rate ? " has no rate" : " has no acceleration"));
  }
};

template <class Motions>
Square<double> rotation(const NamedGraphCore& core, const FrameRecord& b, const FrameRecord& a,
                        const Motions& motions) {
  return core.with_path(b, a, [&](const NamedPath* path) {
    if (path == nullptr) [[unlikely]]
      NamedQuery{"rotation", b, a, a, Level::rotation}.no_path(a, b);
    return rotation_along(*path, motions);
  });
}

template <Level level, class Motions>
Column<double> rate(const NamedGraphCore& core, const FrameRecord& b, const FrameRecord& a,
                    const FrameRecord& c, const Motions& motions) {
  const NamedQuery query{level == Level::rate ? "angular_velocity" : "angular_acceleration", b, a, c, level};
  if (&a == &b) query.refuse("a frame does not move relative to itself; ask for two frames");
  return core.with_path(a, b, [&](const NamedPath* to_b) {
    if (to_b == nullptr) query.no_path(a, b);
    query.require_level(*to_b);
    return core.with_path(a, c, [&](const NamedPath* to_c) {
      if (to_c == nullptr) query.no_path(a, c);
      return rate_between<level>(*to_b, *to_c, motions);
    });
  });
}

}  // namespace detail

/// A NamedGraph at one instant. A query takes frames by handle, by name, or by the type bound to them; if all
/// are types, the answer is typed. Each edge is evaluated at most once: a named snapshot keeps the values, a
/// temporary one, `graph.at(t).rotation(...)`, uses each value only once. It must not outlive the graph. Two
/// threads must not share a snapshot: take one per thread.
class NamedSnapshot {
 public:
  NamedSnapshot(const detail::NamedGraphCore& core, double t) : core_(&core), t_(t) {
    if (!(t - t == 0.0)) [[unlikely]]
      throw BadInput("NamedGraph: the time is " + detail::text(t) + " s");
  }

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
    return velocity(b, a, c, kept());
  }
  template <detail::AnyFrame B, detail::AnyFrame A, detail::AnyFrame C>
  auto angular_velocity(Of<B> b, RelativeTo<A> a, In<C> c) && {
    return velocity(b, a, c, fresh());
  }

  /// alpha_ab^c, of b relative to a, expressed in c. Throws BadInput as angular_velocity(), for the
  /// acceleration.
  template <detail::AnyFrame B, detail::AnyFrame A, detail::AnyFrame C>
  auto angular_acceleration(Of<B> b, RelativeTo<A> a, In<C> c) const& {
    return acceleration(b, a, c, kept());
  }
  template <detail::AnyFrame B, detail::AnyFrame A, detail::AnyFrame C>
  auto angular_acceleration(Of<B> b, RelativeTo<A> a, In<C> c) && {
    return acceleration(b, a, c, fresh());
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
  auto velocity(Of<B> b, RelativeTo<A> a, In<C> c, const Motions& motions) const {
    const auto w = rate<Level::rate, si::angular_velocity>(b, a, c, motions);
    if constexpr (Frame<B> && Frame<A> && Frame<C>) {
      return vectrix::angular_velocity(of<B>, relative_to<A>, w);
    } else {
      return w;
    }
  }
  template <class B, class A, class C, class Motions>
  auto acceleration(Of<B> b, RelativeTo<A> a, In<C> c, const Motions& motions) const {
    const auto alpha = rate<Level::acceleration, si::angular_acceleration>(b, a, c, motions);
    if constexpr (Frame<B> && Frame<A> && Frame<C>) {
      return vectrix::angular_acceleration(of<B>, relative_to<A>, alpha);
    } else {
      return alpha;
    }
  }

  // The answer, a typed vector if all frames are types, else a NamedRate.
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
      return NamedRate<U>{trusted, NamedFrame{of_b}, NamedFrame{relative_to_a},
                          NamedVector<U>{trusted, NamedFrame{in_c}, answer}};
    }
  }

  const detail::NamedGraphCore* core_;
  double t_;
  mutable std::map<const detail::EdgeFunction*, detail::EdgeMotion> kept_;
};

}  // namespace vectrix

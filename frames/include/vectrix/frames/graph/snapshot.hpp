#pragma once

#include <tuple>
#include <type_traits>
#include <vectrix/frames/graph/question.hpp>

namespace vectrix {

/// The result type of a refused at(); see Refused.
struct RefusedSnapshot {
  template <class... Asked> Refused rotation(const Asked&...) const;
  template <class... Asked> Refused angular_velocity(const Asked&...) const;
  template <class... Asked> Refused angular_acceleration(const Asked&...) const;
  template <class... Asked> Refused transform(const Asked&...) const;
  template <class... Asked> Refused position(const Asked&...) const;
  template <class... Asked> Refused velocity(const Asked&...) const;
  template <class... Asked> Refused acceleration(const Asked&...) const;
};

/// A frame graph at one instant. It answers questions from the edges on the path between two frames;
/// question.hpp lists what each question needs. It evaluates each edge at most once: a named snapshot keeps
/// the values, a temporary one, `graph.at(t).rotation(...)`, uses each value only once. It holds a reference
/// to the graph. Two threads must not share a snapshot: take one per thread.
template <class Instant, class... Edges> class GraphSnapshot {
  using Topology = detail::Topology<Edges...>;

  template <class Question>
  using Answered = std::enable_if_t<std::is_same_v<detail::LackOf<Question, Topology>, Nothing>, int>;
  template <class Question>
  using Unanswered = std::enable_if_t<!std::is_same_v<detail::LackOf<Question, Topology>, Nothing>,
                                      detail::LackOf<Question, Topology>>;

 public:
  GraphSnapshot(const std::tuple<Edges...>& edges, const Instant& instant)
      : evaluation_{edges, instant, {}} {}

  [[nodiscard]] const Instant& instant() const { return evaluation_.instant; }

  /// R_a^b
  template <class B, class A, Answered<AskRotation<B, A>> = 0> auto rotation(To<B>, From<A>) const& {
    return AskRotation<B, A>::answer(kept());
  }
  template <class B, class A, Answered<AskRotation<B, A>> = 0> auto rotation(To<B>, From<A>) && {
    return AskRotation<B, A>::answer(fresh());
  }
  template <class B, class A, class Lacking = Unanswered<AskRotation<B, A>>>
  auto rotation(  // the graph lacks something to answer: see Lacking
      To<B>, From<A>) const -> Refused = delete;

  /// w_ab^c, of b relative to a, expressed in c
  template <class B, class A, class C, Answered<AskAngularVelocity<B, A, C>> = 0>
  auto angular_velocity(Of<B>, RelativeTo<A>, In<C>) const& {
    return AskAngularVelocity<B, A, C>::answer(kept());
  }
  template <class B, class A, class C, Answered<AskAngularVelocity<B, A, C>> = 0>
  auto angular_velocity(Of<B>, RelativeTo<A>, In<C>) && {
    return AskAngularVelocity<B, A, C>::answer(fresh());
  }
  template <class B, class A, class C, class Lacking = Unanswered<AskAngularVelocity<B, A, C>>>
  auto angular_velocity(  // the graph lacks something to answer: see Lacking
      Of<B>, RelativeTo<A>, In<C>) const -> Refused = delete;

  /// alpha_ab^c, of b relative to a, expressed in c
  template <class B, class A, class C, Answered<AskAngularAcceleration<B, A, C>> = 0>
  auto angular_acceleration(Of<B>, RelativeTo<A>, In<C>) const& {
    return AskAngularAcceleration<B, A, C>::answer(kept());
  }
  template <class B, class A, class C, Answered<AskAngularAcceleration<B, A, C>> = 0>
  auto angular_acceleration(Of<B>, RelativeTo<A>, In<C>) && {
    return AskAngularAcceleration<B, A, C>::answer(fresh());
  }
  template <class B, class A, class C, class Lacking = Unanswered<AskAngularAcceleration<B, A, C>>>
  auto angular_acceleration(  // the graph lacks something to answer: see Lacking
      Of<B>, RelativeTo<A>, In<C>) const -> Refused = delete;

  /// X_a^b
  template <class B, class A, Answered<AskTransform<B, A>> = 0> auto transform(To<B>, From<A>) const {
    return AskTransform<B, A>::answer(kept());
  }
  template <class B, class A, class Lacking = Unanswered<AskTransform<B, A>>>
  auto transform(  // the graph lacks something to answer: see Lacking
      To<B>, From<A>) const -> Refused = delete;

  /// r_pq^c, of q's origin relative to p's, expressed in c
  template <class Q, class P, class C, Answered<AskPosition<Q, P, C>> = 0>
  auto position(Of<Q>, RelativeTo<P>, In<C>) const {
    return AskPosition<Q, P, C>::answer(kept());
  }
  template <class Q, class P, class C, class Lacking = Unanswered<AskPosition<Q, P, C>>>
  auto position(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, In<C>) const -> Refused = delete;

  /// v_pq|a^c, of q's origin relative to p's, observed from a, expressed in c
  template <class Q, class P, class A, class C, Answered<AskVelocity<Q, P, A, C>> = 0>
  auto velocity(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const {
    return AskVelocity<Q, P, A, C>::answer(kept());
  }
  template <class Q, class P, class A, class C, class Lacking = Unanswered<AskVelocity<Q, P, A, C>>>
  auto velocity(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const -> Refused = delete;
  template <class Q, class P, class C>
  auto velocity(  // of<Q>, relative_to<P>, observed_from<A>, in<C>
      Of<Q>, RelativeTo<P>, In<C>) const -> Refused = delete;

  /// a_pq|a^c, of q's origin relative to p's, observed from a, expressed in c
  template <class Q, class P, class A, class C, Answered<AskAcceleration<Q, P, A, C>> = 0>
  auto acceleration(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const {
    return AskAcceleration<Q, P, A, C>::answer(kept());
  }
  template <class Q, class P, class A, class C, class Lacking = Unanswered<AskAcceleration<Q, P, A, C>>>
  auto acceleration(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const -> Refused = delete;
  template <class Q, class P, class C>
  auto acceleration(  // of<Q>, relative_to<P>, observed_from<A>, in<C>
      Of<Q>, RelativeTo<P>, In<C>) const -> Refused = delete;

 private:
  using KeptValues = detail::KeptValues<Instant, Edges...>;

  detail::PlaceWalk<Topology, KeptValues> kept() const {
    return detail::PlaceWalk<Topology, KeptValues>{KeptValues{evaluation_}};
  }
  auto fresh() const {
    if constexpr ((detail::asks<Edges> || ...)) {
      return kept();  // an edge may be asked by another edge and lie on the path too
    } else {
      using Values = detail::FreshValues<Instant, Edges...>;
      return detail::GraphWalk<Topology, Values>{Values{evaluation_.edges, evaluation_.instant}};
    }
  }

  detail::Evaluation<Instant, Edges...> evaluation_;
};

}  // namespace vectrix

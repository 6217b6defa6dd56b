#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <sstream>
#include <tuple>
#include <utility>
#include <vectrix/kinematics/named/graph.hpp>

#include "testing/attitudes.hpp"

/// The words of named values against those of typed ones.
namespace named_words {

using namespace vectrix;
using namespace vectrix_test;

struct A : inertial_frame {};
struct B : moving_frame {};
struct C : moving_frame {};
struct D : moving_frame {};
struct P : moving_frame {};
struct Q : moving_frame {};

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

template <class U, class F> Vector<F, U> vector_in(In<F> f) {
  return vector<U>(f, *triple());
}
template <class T, class F> Dcm<T, F> any_rotation(To<T> b, From<F> a) {
  return trust_dcm(b, a, *rotation_matrix());
}
template <class X, class Y, class Z> AngularVelocity<X, Y, In<Z>> any_rate(Of<Y>, RelativeTo<X>, In<Z>) {
  return angular_velocity(of<Y>, relative_to<X>, vector_in<si::angular_velocity>(in<Z>));
}
template <class X, class Y, class Z>
AngularAcceleration<X, Y, In<Z>> any_change(Of<Y>, RelativeTo<X>, In<Z>) {
  return angular_acceleration(of<Y>, relative_to<X>, vector_in<si::angular_acceleration>(in<Z>));
}
template <class X, class Y, class Z> Displacement<X, Y, In<Z>> any_place(Of<Y>, RelativeTo<X>, In<Z>) {
  return displacement(of<Y>, relative_to<X>, vector_in<si::length>(in<Z>));
}

template <class X> std::string text_of(const X& x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

/// Whether to swap frames in this draw. Refusals do not depend on the numbers: one draw in ten is enough.
inline bool sometimes() {
  return *rc::gen::inRange(0, 10) == 0;
}

/// A graph whose frames are bound to the types above, and one frame more.
class Words {
 public:
  explicit Words(bool swaps = true) : swaps_(swaps) {
    graph.add_frame<A>("a");
    graph.add_frame<B>("b");
    graph.add_frame<C>("c");
    graph.add_frame<D>("d");
    graph.add_frame<P>("p");
    graph.add_frame<Q>("q");
  }

  /// The word gives for named values exactly what it gives for the typed ones: the numbers, the frames, and
  /// the error, with the names in place of the types. And if one frame of an operand is another, the word
  /// refuses it by both names, unless that frame is in no other place.
  template <class Word, class... Typed> void agree(const Word& word, const Typed&... x) const {
    const auto operands = std::tuple(named(x)...);
    using Operands = std::remove_const_t<decltype(operands)>;
    const Said<Operands> said = [&](const Operands& all) {
      return message<BadInput>([&] { std::apply(word, all); });
    };
    const std::string typed_error = message<BadInput>([&] { word(x...); });
    RC_ASSERT(said(operands) == with_names(typed_error));
    if (!typed_error.empty()) return;
    require_same(std::apply(word, operands), word(x...));
    if (swaps_) swap_frames(said, operands, std::index_sequence_for<Typed...>{});
  }

  template <class X> auto named(const X& x) const {
    if constexpr (detail::frames_in<X> == 0) {
      return x;
    } else {
      return graph.named(x);
    }
  }
  template <class X> auto named(const std::vector<X>& list) const {
    std::vector<decltype(named(list.front()))> names;
    for (const X& x : list) names.push_back(named(x));
    return names;
  }

  NamedGraph graph;
  NamedFrame other = graph.add_frame("other", FrameMotion::moving);

 private:
  /// What a word says of operands. Of the operands alone: swap_frames() is compiled once for all words of
  /// these.
  template <class Operands> using Said = std::function<std::string(const Operands&)>;

  bool swaps_;

  static std::string with_names(std::string text) {
    for (const auto& [type, name] :
         {std::pair(frame_name<A>(), "a"), std::pair(frame_name<B>(), "b"), std::pair(frame_name<C>(), "c"),
          std::pair(frame_name<D>(), "d"), std::pair(frame_name<P>(), "p"), std::pair(frame_name<Q>(), "q")})
      detail::put_name(text, type, name);
    return text;
  }
  template <class... Xs, class... Typed>
  void require_same(const std::tuple<Xs...>& x, const std::tuple<Typed...>& typed) const {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (require_same(std::get<i>(x), std::get<i>(typed)), ...);
    }
    (std::index_sequence_for<Xs...>{});
  }
  template <class X, class Typed> void require_same(const X& x, const Typed& typed) const {
    if constexpr (detail::frames_in<Typed> == 0) {
      RC_ASSERT(text_of(x) == text_of(typed));
    } else {
      RC_ASSERT(text_of(graph.typed<detail::Evaluated<Typed>>(x)) == text_of(typed));
      RC_ASSERT(text_of(x) == with_names(text_of(typed)));
    }
  }
  template <class X> static void add_frames(std::vector<NamedFrame>& list, const X& x) {
    if constexpr (detail::HasForm<X>)
      for (const NamedFrame frame : detail::Naming<X>::frames(x)) list.push_back(frame);
  }
  template <class X> static void add_frames(std::vector<NamedFrame>& list, const std::vector<X>& all) {
    for (const X& x : all) add_frames(list, x);
  }
  template <class Operands, std::size_t... i>
  void swap_frames(const Said<Operands>& said_of, const Operands& operands, std::index_sequence<i...>) const {
    std::vector<NamedFrame> all;
    (add_frames(all, std::get<i>(operands)), ...);
    (swap_frames_of<i>(said_of, operands, all), ...);
  }
  template <std::size_t i, class Operands>
  void swap_frames_of(const Said<Operands>& said_of, const Operands& operands,
                      const std::vector<NamedFrame>& all) const {
    using X = std::tuple_element_t<i, Operands>;
    if constexpr (detail::HasForm<X>) {
      using Naming = detail::Naming<X>;
      const X& x = std::get<i>(operands);
      for (std::size_t k = 0; k < Naming::frames(x).size(); ++k) {
        auto frames = Naming::frames(x);
        const NamedFrame right = std::exchange(frames[k], other);
        Operands wrong = operands;
        std::get<i>(wrong) = Naming::make(frames, detail::relabelled<typename Naming::form>(x));
        const std::string said = said_of(wrong);
        if (std::count(all.begin(), all.end(), right) == 1) {
          RC_ASSERT(said == "");
        } else {
          RC_ASSERT(contains(said, "\"other\"") && contains(said, detail::in_quotes(right)));
        }
      }
    }
  }
};

}  // namespace named_words

#pragma once

#include <sstream>
#include <string_view>
#include <vector>
#include <vectrix/kinematics/named/forms.hpp>

namespace vectrix {

/// The operands of a typed law, between frames Some<'a'>, Some<'b'>, ...: one letter is one frame.
template <class... Operands> struct Law {};

namespace detail {

template <class X>
concept HasForm = requires {
  typename Naming<X>::form;
};

/// Whether the operand of a law can be this value: the same quantity, or a number of this type.
template <class Operand, class Given>
inline constexpr bool takes = std::same_as<Operand, Given> || std::same_as<Named<Operand>, Given> ||
                              std::same_as<typename NamedFor<FormOf<Operand>>::type, Given>;
template <class Operand, class Given>
inline constexpr bool takes<std::vector<Operand>, std::vector<Given>> = takes<Operand, Given>;
template <class L, class... Given> inline constexpr bool law_takes = false;
template <class... Operands, class... Given>
  requires(sizeof...(Operands) == sizeof...(Given))
inline constexpr bool law_takes<Law<Operands...>, Given...> = (takes<Operands, Given> && ...);

template <class... Fs, class Frames> void lend(Lent& lent, FrameList<Fs...>, const Frames& frames) {
  std::size_t i = 0;
  (lent.give<Fs>(frames[i++]), ...);
}
template <class Operand, class Given> void lend(Lent& lent, const Given& given) {
  if constexpr (HasForm<Given>) lend(lent, typename FramesIn<Operand>::type{}, Naming<Given>::frames(given));
}
template <class Operands, class Given> void lend(Lent& lent, const std::vector<Given>& given) {
  for (const Given& one : given) lend<typename Operands::value_type>(lent, one);
}

/// What carries the frames of a typed value, named.
template <class Typed> auto named_value(const Lent& lent, const Typed& x) {
  if constexpr (frames_in<Typed> == 0) {
    return x;
  } else {
    return [&]<class... Fs>(FrameList<Fs...>) {
      using Form = FormOf<Typed>;
      using X = typename NamedFor<Form>::type;
      if constexpr (std::same_as<X, Named<Form>> && !Relabels<Form, Typed>) {
        return Named<Typed>{trusted, {lent[LetterOf<Fs>::value]...}, x};
      } else {
        return Naming<X>::make({lent[LetterOf<Fs>::value]...}, x);
      }
    }(typename FramesIn<Typed>::type{});
  }
}

template <class Operand> struct Relabel<std::vector<Operand>> {
  template <class Given> static std::vector<Operand> of(const std::vector<Given>& given) {
    std::vector<Operand> typed;
    typed.reserve(given.size());
    for (const Given& one : given) typed.push_back(relabelled<Operand>(one));
    return typed;
  }
};

/// Each part of a result with several.
template <class... Typed> auto named_value(const Lent& lent, const std::tuple<Typed...>& parts) {
  return std::apply([&](const auto&... part) { return std::tuple(named_value(lent, part)...); }, parts);
}

/// The type as the compiler writes it, without the scalar: Twist<Some<'a'>, Some<'b'>, At<Some<'b'>>, ...
template <class F> std::string type_text() {
  std::string text = name_in(__PRETTY_FUNCTION__);
  replace_all(text, ", double", "");
  replace_all(text, " >", ">");
  return text;
}
template <class U> std::string described(const NamedVector<U>& r) {
  return "a vector in " + in_quotes(r.in());
}
inline std::string described(const NamedQuaternion& q) {
  return "q" + to_from(q.to(), q.from());
}
inline std::string described(To<NamedFrame> b) {
  return "to " + in_quotes(b.frame);
}
inline std::string described(From<NamedFrame> a) {
  return "from " + in_quotes(a.frame);
}
inline std::string described(Of<NamedFrame> b) {
  return "of " + in_quotes(b.frame);
}
inline std::string described(RelativeTo<NamedFrame> a) {
  return "relative to " + in_quotes(a.frame);
}
inline std::string described(ObservedFrom<NamedFrame> a) {
  return "observed from " + in_quotes(a.frame);
}
inline std::string described(In<NamedFrame> c) {
  return "in " + in_quotes(c.frame);
}
template <class Given> void describe(std::string& list, const char* between, const Given& given) {
  if constexpr (requires { described(given); }) {
    list += (list.empty() ? "" : between) + described(given);
  } else if constexpr (HasForm<Given>) {
    using Form = typename Naming<Given>::form;
    Lent lent;
    lend<Form>(lent, given);
    list += (list.empty() ? "" : between) + lent.named(type_text<Form>());
  }
}
template <class Given>
void describe(std::string& list, const char* between, const std::vector<Given>& given) {
  if (!given.empty()) describe(list, between, given.front());
}
/// "rate(R to "a" from "b", w of "b" ...)", "product of R to "a" from "b" and ...".
template <class... Given> std::string action_text(std::string_view word, const Given&... given) {
  const bool is_operation = word == "product" || word == "sum" || word == "difference";
  std::string list;
  (describe(list, is_operation ? " and " : ", ", given), ...);
  return std::string{word} + (is_operation ? " of " + list : "(" + list + ")");
}
template <class... Given> void require_door(std::string_view, const Given&...) {}
template <class... Given>
void require_door(std::string_view door, To<NamedFrame> b, From<NamedFrame> a, const Given&...) {
  require_two(door, b.frame, a.frame);
}
template <class... Given>
void require_door(std::string_view door, Of<NamedFrame> b, RelativeTo<NamedFrame> a, const Given&...) {
  if (b.frame == a.frame)
    throw BadInput(std::string{door} + "(of " + in_quotes(b.frame) + ", relative to " + in_quotes(a.frame) +
                   "): a door takes two frames, and these are one");
}

/// word(given...) by the first of the laws whose frames go together.
template <class First, class... Others> struct LawsInOrder;
template <class... Operands, class... Others> struct LawsInOrder<Law<Operands...>, Others...> {
  template <class Word, class... Given>
  static auto use(const Lent* nearest, std::string_view name, const Word& word, const Given&... given) {
    Lent lent;
    (lend<Operands>(lent, given), ...);
    if (lent.clashes() == 0)
      return named_value(lent, lent.call([&] { return word(relabelled<Operands>(given)...); }));
    if (nearest == nullptr || lent.clashes() < nearest->clashes()) nearest = &lent;
    if constexpr (sizeof...(Others) > 0) {
      return LawsInOrder<Others...>::use(nearest, name, word, given...);
    } else {
      throw BadInput(action_text(name, given...) + ": " + nearest->first_clash());
    }
  }
};

template <class Done, class Rest, class... Given> struct Fitting;
template <class... Done, class... Given> struct Fitting<std::tuple<Done...>, std::tuple<>, Given...> {
  using type = LawsInOrder<Done...>;
};
template <class... Done, class L, class... Rest, class... Given>
struct Fitting<std::tuple<Done...>, std::tuple<L, Rest...>, Given...>
    : std::conditional_t<law_takes<L, Given...>,
                         Fitting<std::tuple<Done..., L>, std::tuple<Rest...>, Given...>,
                         Fitting<std::tuple<Done...>, std::tuple<Rest...>, Given...>> {};

}  // namespace detail

/// word(given...) of values between frames known at run time, where `word` is a function of typed values and
/// each Law one way in which their frames may go together. The first law that fits is used; one letter is
/// one frame. The result carries the frames of its letters. Throws BadInput that names two frames if no law
/// fits, and what the word throws, with the frames in place of the letters:
///     using A = Some<'a'>; using B = Some<'b'>;
///     typed_law<Law<Dcm<A, B>, AngularVelocity<A, B, In<B>>>>("rate", word, R_a_from_b, w_ab_b)
template <class... Laws, class Word, class... Given>
  requires(detail::law_takes<Laws, Given...> || ...)
auto typed_law(std::string_view name, const Word& word, const Given&... given) {
  detail::require_door(name, given...);
  return detail::Fitting<std::tuple<>, std::tuple<Laws...>, Given...>::type::use(nullptr, name, word,
                                                                                 given...);
}

template <class... Laws, class Word, class... Given>
  requires(!(detail::law_takes<Laws, Given...> || ...))
auto typed_law(  // a Law with the types of these operands, in their order; each frame is a Some<'a'>
    std::string_view, const Word&, const Given&...) -> Refused = delete;

namespace detail {

/// The letters of the laws below, by the names of the frames in them.
namespace letters {
using A = Some<'a'>;
using B = Some<'b'>;
using C = Some<'c'>;
using D = Some<'d'>;
using P = Some<'p'>;
using Q = Some<'q'>;
using S = Some<'s'>;
}  // namespace letters

template <class X> using FormOfNamed = typename Naming<X>::form;

/// word(x): a typed function of one value, whose frames need no check.
template <class Word, class X> auto of_one(std::string_view name, const Word& word, const X& x) {
  return typed_law<Law<FormOfNamed<X>>>(name, word, x);
}

}  // namespace detail

template <class Form> template <class Read> auto Named<Form>::read(const Read& part) const {
  return detail::of_one("member", part, *this);
}

template <class Form> std::ostream& print_framed(std::ostream& out, const Named<Form>& x) {
  detail::Lent lent;
  detail::lend<Form>(lent, x);
  std::ostringstream text;
  text.copyfmt(out);
  print_framed(text, x.value());
  return out << lent.named(text.str());
}

}  // namespace vectrix

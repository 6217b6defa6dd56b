#pragma once

#include <array>
#include <concepts>
#include <tuple>
#include <vectrix/frames/operators.hpp>
#include <vectrix/frames/trusted.hpp>
#include <vectrix/kinematics/named/some.hpp>

namespace vectrix {
namespace detail {

template <class... Fs> struct FrameList { static constexpr std::size_t size = sizeof...(Fs); };

template <class... Lists> struct JoinedFrames;
template <class... Fs> struct JoinedFrames<FrameList<Fs...>> : std::type_identity<FrameList<Fs...>> {};
template <class... Fs, class... Gs, class... Rest>
struct JoinedFrames<FrameList<Fs...>, FrameList<Gs...>, Rest...>
    : JoinedFrames<FrameList<Fs..., Gs...>, Rest...> {};

/// The frames among the arguments of a type, in their order: of AngularVelocity<A, B, In<C>> A, B, C.
template <class T> struct FramesIn : std::type_identity<FrameList<>> {};
template <Frame F> struct FramesIn<F> : std::type_identity<FrameList<F>> {};
template <template <class...> class T, class... Args>
  requires(!Frame<T<Args...>>)
struct FramesIn<T<Args...>> : JoinedFrames<FrameList<>, typename FramesIn<Args>::type...> {};
template <class T> inline constexpr std::size_t frames_in = FramesIn<T>::type::size;

/// T with Some<next>, Some<next + 1>, ... in place of its frames.
template <class T, char next> struct Lettered : std::type_identity<T> { static constexpr char after = next; };
template <Frame F, char next> struct Lettered<F, next> : std::type_identity<Some<next>> {
  static constexpr char after = next + 1;
};
template <template <class...> class T, class Done, char next, class... Args> struct LetteredArguments;
template <template <class...> class T, class... Done, char next>
struct LetteredArguments<T, std::tuple<Done...>, next> : std::type_identity<T<Done...>> {
  static constexpr char after = next;
};
template <template <class...> class T, class... Done, char next, class First, class... Rest>
struct LetteredArguments<T, std::tuple<Done...>, next, First, Rest...>
    : LetteredArguments<T, std::tuple<Done..., typename Lettered<First, next>::type>,
                        Lettered<First, next>::after, Rest...> {};
template <template <class...> class T, class... Args, char next>
  requires(!Frame<T<Args...>>)
struct Lettered<T<Args...>, next> : LetteredArguments<T, std::tuple<>, next, Args...> {};

/// The form of T: the same quantity of the frames Some<'a'>, Some<'b'>, ..., each of its own letter.
template <class T> using FormOf = typename Lettered<T, 'a'>::type;

/// Makes a To with the numbers of x, a value of the same quantity between other frames. Claims the frames.
template <class To> struct Relabel {
  template <class X>
    requires requires(const X& x) {
      x.matrix();
    }
  static To of(const X& x) { return To(trusted, x.matrix()); }
  template <class X>
    requires requires(const X& x) {
      x.eigen();
    }
  static To of(const X& x) {
    return To(trusted, [&] { return x.eigen(); });
  }
  template <class X>
    requires requires(const X& x) {
      x.coordinates();
    }
  static To of(const X& x) { return To(trusted, x.coordinates()); }
  // of<B>: a word without numbers
  template <class X>
    requires std::is_empty_v<To>
  static To of(const X&) { return To{}; }
};
/// Other types, such as a function of time, keep their letters.
template <class To, class X>
concept Relabels = std::same_as<To, X> || requires(const X& x) {
  Relabel<To>::of(x);
};
template <class To, class X> To relabelled(const X& x) {
  if constexpr (std::same_as<To, X>) {
    return x;
  } else {
    return Relabel<To>::of(x);
  }
}

}  // namespace detail

/// A quantity between frames known at run time whose typed form is Form, for example a rotation vector,
/// Named<RotationVector<Some<'a'>, Some<'b'>>>. Its members are those of the typed quantity. Made by the
/// words of the typed one, which check the frames when they are called; there is no default. Must not outlive
/// the graph.
template <class Form> class Named {
 public:
  using form = Form;
  using Frames = std::array<NamedFrame, detail::frames_in<Form>>;

  Named(detail::Trusted, const Frames& frames, const Form& value) : frames_(frames), value_(value) {}

  /// The frames in the order of the typed quantity's arguments: of a RotationVector<A, B> a and b.
  const Frames& frames() const { return frames_; }
  /// The numbers, with letters for the frames. The frames are no longer checked.
  const Form& value() const { return value_; }

  auto operator-() const {
    return read([](const Form& x) { return -x; });
  }

  /// Of a function of time, such as a Slerp: its value at t.
  template <class T> auto operator()(const T& t) const {
    return read([&](const Form& x) { return x(t); });
  }

  auto coordinates() const { return value_.coordinates(); }
  auto matrix() const { return value_.matrix(); }
  auto eigen() const { return value_.eigen(); }
  auto scalar_first() const { return value_.scalar_first(); }
  auto angle() const { return value_.angle(); }
  auto weight() const { return value_.weight(); }
  auto deviation() const { return value_.deviation(); }
  auto measured() const {
    return read([](const Form& x) { return x.measured(); });
  }
  auto reference() const {
    return read([](const Form& x) { return x.reference(); });
  }
  auto rotation() const { return value_.rotation(); }
  auto translation() const { return value_.translation(); }
  auto first() const { return value_.first(); }
  auto second() const { return value_.second(); }
  auto third() const { return value_.third(); }
  auto distance_from_singularity() const { return value_.distance_from_singularity(); }
  auto in_reference() const {
    return read([](const Form& x) { return x.in_reference(); });
  }
  auto in_turned() const {
    return read([](const Form& x) { return x.in_turned(); });
  }
  auto rotation_vector() const {
    return read([](const Form& x) { return x.rotation_vector(); });
  }
  auto shadow() const {
    return read([](const Form& x) { return x.shadow(); });
  }
  auto vector() const {
    return read([](const Form& x) { return x.vector(); });
  }
  auto angular_velocity() const {
    return read([](const Form& x) { return x.angular_velocity(); });
  }
  auto velocity() const {
    return read([](const Form& x) { return x.velocity(); });
  }
  auto angular_acceleration() const {
    return read([](const Form& x) { return x.angular_acceleration(); });
  }
  auto velocity_rate() const {
    return read([](const Form& x) { return x.velocity_rate(); });
  }

 private:
  template <class Read> auto read(const Read& part) const;

  Frames frames_;
  Form value_;
};

template <class Form> inline constexpr bool detail::is_framed<Named<Form>> = true;

namespace detail {

/// A named type beside Named<Form>: its form, its frames in the form's order, and how it is made of a value.
template <class X> struct Naming;
/// The named type of a form.
template <class Form> struct NamedFor : std::type_identity<Named<Form>> {};

template <class Form> struct Naming<Named<Form>> {
  using form = Form;
  static const auto& frames(const Named<Form>& x) { return x.frames(); }
  template <class Typed> static Named<Form> make(const typename Named<Form>::Frames& f, const Typed& x) {
    return {trusted, f, relabelled<Form>(x)};
  }
};
template <class To, class Form> To relabelled(const Named<Form>& x) {
  return relabelled<To>(x.value());
}

}  // namespace detail
}  // namespace vectrix

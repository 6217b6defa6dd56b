#pragma once

#include <sstream>
#include <vectrix/kinematics/named/quaternion.hpp>
#include <vectrix/kinematics/named/transform.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>

namespace vectrix {
namespace detail {

template <class... Fs> struct FrameList { static constexpr std::size_t size = sizeof...(Fs); };

template <class... Lists> struct Joined;
template <class... Fs> struct Joined<FrameList<Fs...>> : std::type_identity<FrameList<Fs...>> {};
template <class... Fs, class... Gs, class... Rest>
struct Joined<FrameList<Fs...>, FrameList<Gs...>, Rest...> : Joined<FrameList<Fs..., Gs...>, Rest...> {};

/// The frames among the arguments of a type, in their order: of AngularVelocity<A, B, In<C>> A, B, C.
template <class T> struct FramesIn : std::type_identity<FrameList<>> {};
template <Frame F> struct FramesIn<F> : std::type_identity<FrameList<F>> {};
template <template <class...> class T, class... Args>
  requires(!Frame<T<Args...>>)
struct FramesIn<T<Args...>> : Joined<FrameList<>, typename FramesIn<Args>::type...> {};
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
  template <class X> static To of(const X& x) {
    if constexpr (requires { x.matrix(); }) {
      return To(trusted, x.matrix());
    } else if constexpr (requires { x.eigen(); }) {
      return To(trusted, [&] { return x.eigen(); });
    } else if constexpr (requires { x.coordinates(); }) {
      return To(trusted, x.coordinates());
    } else {
      return To{};  // of<B>: a word without numbers
    }
  }
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

  auto operator-() const { return read([](const Form& x) { return -x; }); }

  /// Of a function of time, such as a Slerp: its value at t.
  template <class T> auto operator()(const T& t) const {
    return read([&](const Form& x) { return x(t); });
  }

  auto coordinates() const { return value_.coordinates(); }
  auto matrix() const { return value_.matrix(); }
  auto eigen() const { return value_.eigen(); }
  auto scalar_first() const { return value_.scalar_first(); }
  auto angle() const { return value_.angle(); }
  auto rotation() const { return value_.rotation(); }
  auto translation() const { return value_.translation(); }
  auto first() const { return value_.first(); }
  auto second() const { return value_.second(); }
  auto third() const { return value_.third(); }
  auto distance_from_singularity() const { return value_.distance_from_singularity(); }
  auto in_reference() const { return read([](const Form& x) { return x.in_reference(); }); }
  auto in_turned() const { return read([](const Form& x) { return x.in_turned(); }); }
  auto rotation_vector() const { return read([](const Form& x) { return x.rotation_vector(); }); }
  auto shadow() const { return read([](const Form& x) { return x.shadow(); }); }
  auto vector() const { return read([](const Form& x) { return x.vector(); }); }
  auto angular_velocity() const { return read([](const Form& x) { return x.angular_velocity(); }); }
  auto velocity() const { return read([](const Form& x) { return x.velocity(); }); }
  auto angular_acceleration() const { return read([](const Form& x) { return x.angular_acceleration(); }); }
  auto velocity_rate() const { return read([](const Form& x) { return x.velocity_rate(); }); }

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

template <> struct NamedFor<Dcm<Some<'a'>, Some<'b'>>> : std::type_identity<NamedDcm> {};
template <> struct Naming<NamedDcm> {
  using form = Dcm<Some<'a'>, Some<'b'>>;
  static std::array<NamedFrame, 2> frames(const NamedDcm& R) { return {R.to(), R.from()}; }
  template <class Typed> static NamedDcm make(const std::array<NamedFrame, 2>& f, const Typed& R) {
    return {trusted, f[0], f[1], R.matrix()};
  }
};
template <> struct NamedFor<Quaternion<Some<'a'>, Some<'b'>>> : std::type_identity<NamedQuaternion> {};
template <> struct Naming<NamedQuaternion> {
  using form = Quaternion<Some<'a'>, Some<'b'>>;
  static std::array<NamedFrame, 2> frames(const NamedQuaternion& q) { return {q.to(), q.from()}; }
  template <class Typed> static NamedQuaternion make(const std::array<NamedFrame, 2>& f, const Typed& q) {
    return {trusted, f[0], f[1], q.eigen()};
  }
};
template <class U> struct NamedFor<Vector<Some<'a'>, U>> : std::type_identity<NamedVector<U>> {};
template <class U> struct Naming<NamedVector<U>> {
  using form = Vector<Some<'a'>, U>;
  static std::array<NamedFrame, 1> frames(const NamedVector<U>& r) { return {r.in()}; }
  template <class Typed> static NamedVector<U> make(const std::array<NamedFrame, 1>& f, const Typed& r) {
    return {trusted, f[0], r.coordinates()};
  }
};

// To(b), Of(b), ...
template <template <class> class W>
  requires std::derived_from<W<NamedFrame>, Word<NamedFrame>>
struct NamedFor<W<Some<'a'>>> : std::type_identity<W<NamedFrame>> {};
template <template <class> class W>
  requires std::derived_from<W<NamedFrame>, Word<NamedFrame>>
struct Naming<W<NamedFrame>> {
  using form = W<Some<'a'>>;
  static std::array<NamedFrame, 1> frames(const W<NamedFrame>& word) { return {word.frame}; }
};

template <class X, class Form> struct NamingOfPair {
  using form = Form;
  static std::array<NamedFrame, 3> frames(const X& ab) { return {ab.relative_to(), ab.of(), ab.in()}; }
  template <class Typed> static X make(const std::array<NamedFrame, 3>& f, const Typed& ab) {
    return {trusted, f[1], f[0], {trusted, f[2], ab.coordinates()}};
  }
};
template <template <class, class, class, class> class X>
using PairForm = X<Some<'a'>, Some<'b'>, In<Some<'c'>>, double>;
template <> struct NamedFor<PairForm<AngularVelocity>> : std::type_identity<NamedAngularVelocity> {};
template <>
struct Naming<NamedAngularVelocity> : NamingOfPair<NamedAngularVelocity, PairForm<AngularVelocity>> {};
template <> struct NamedFor<PairForm<AngularAcceleration>> : std::type_identity<NamedAngularAcceleration> {};
template <>
struct Naming<NamedAngularAcceleration>
    : NamingOfPair<NamedAngularAcceleration, PairForm<AngularAcceleration>> {};
template <> struct NamedFor<PairForm<Displacement>> : std::type_identity<NamedDisplacement> {};
template <> struct Naming<NamedDisplacement> : NamingOfPair<NamedDisplacement, PairForm<Displacement>> {};

template <class X, class Form> struct NamingOfObserved {
  using form = Form;
  static std::array<NamedFrame, 4> frames(const X& x) {
    return {x.relative_to(), x.of(), x.observed_from(), x.in()};
  }
  template <class Typed> static X make(const std::array<NamedFrame, 4>& f, const Typed& x) {
    return {trusted, f[1], f[0], f[2], {trusted, f[3], x.coordinates()}};
  }
};
template <template <class, class, class, class, class> class X>
using ObservedForm = X<Some<'a'>, Some<'b'>, ObservedFrom<Some<'c'>>, In<Some<'d'>>, double>;
template <> struct NamedFor<ObservedForm<Velocity>> : std::type_identity<NamedVelocity> {};
template <> struct Naming<NamedVelocity> : NamingOfObserved<NamedVelocity, ObservedForm<Velocity>> {};
template <> struct NamedFor<ObservedForm<Acceleration>> : std::type_identity<NamedAcceleration> {};
template <>
struct Naming<NamedAcceleration> : NamingOfObserved<NamedAcceleration, ObservedForm<Acceleration>> {};

}  // namespace detail
}  // namespace vectrix

#pragma once

#include <vectrix/kinematics/named/named.hpp>
#include <vectrix/kinematics/named/quaternion.hpp>
#include <vectrix/kinematics/named/transform.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>

// The typed forms of the values that a NamedGraph answers, and how one is made of the other.

namespace vectrix {

template <> inline constexpr bool detail::is_framed<NamedQuaternion> = true;
template <> inline constexpr bool detail::is_framed<NamedMovingDcm> = true;
template <> inline constexpr bool detail::is_framed<NamedAcceleratingDcm> = true;
template <> inline constexpr bool detail::is_framed<NamedMovingTransform> = true;
template <> inline constexpr bool detail::is_framed<NamedAcceleratingTransform> = true;

namespace detail {

// A product of rotations that is not stored yet is a rotation.
template <class B, class A, std::size_t N, class S>
struct FramesIn<DcmChain<B, A, N, S>> : FramesIn<Dcm<B, A, S>> {};
template <class B, class A, std::size_t N, class S, char next>
struct Lettered<DcmChain<B, A, N, S>, next> : Lettered<Dcm<B, A, S>, next> {};
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
struct NamedFor<W<Some<'a'>>> : std::type_identity<W<NamedFrame>> {
};
template <template <class> class W>
  requires std::derived_from<W<NamedFrame>, Word<NamedFrame>>
struct Naming<W<NamedFrame>> {
  using form = W<Some<'a'>>;
  static std::array<NamedFrame, 1> frames(const W<NamedFrame>& word) { return {word.frame}; }
  template <class Typed> static W<NamedFrame> make(const std::array<NamedFrame, 1>& f, const Typed&) {
    return W<NamedFrame>(f[0]);
  }
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

// Values of several parts: how typed ones are made of named ones, and back.
template <class A, class B> struct Relabel<MovingDcm<A, B>> {
  static MovingDcm<A, B> of(const NamedMovingDcm& x) {
    return {relabelled<Dcm<A, B>>(x.rotation()),
            relabelled<AngularVelocity<A, B, In<B>>>(x.angular_velocity())};
  }
};
template <class A, class B> struct Relabel<AcceleratingDcm<A, B>> {
  static AcceleratingDcm<A, B> of(const NamedAcceleratingDcm& x) {
    return {relabelled<Dcm<A, B>>(x.rotation()),
            relabelled<AngularVelocity<A, B, In<B>>>(x.angular_velocity()),
            relabelled<AngularAcceleration<A, B, In<B>>>(x.angular_acceleration())};
  }
};
template <class B, class A> struct Relabel<Transform<B, A>> {
  static Transform<B, A> of(const NamedTransform& X) {
    return {relabelled<Dcm<B, A>>(X.rotation()), relabelled<Displacement<B, A, In<B>>>(X.translation())};
  }
};
template <class A, class B> struct Relabel<MovingTransform<A, B>> {
  static MovingTransform<A, B> of(const NamedMovingTransform& x) {
    return {relabelled<MovingDcm<A, B>>(x.turning()), relabelled<Displacement<A, B, In<A>>>(x.translation()),
            relabelled<Velocity<A, B, ObservedFrom<A>, In<A>>>(x.velocity())};
  }
};
template <class A, class B> struct Relabel<AcceleratingTransform<A, B>> {
  static AcceleratingTransform<A, B> of(const NamedAcceleratingTransform& x) {
    return {relabelled<AcceleratingDcm<A, B>>(x.turning()),
            relabelled<Displacement<A, B, In<A>>>(x.translation()),
            relabelled<Velocity<A, B, ObservedFrom<A>, In<A>>>(x.velocity()),
            relabelled<Acceleration<A, B, ObservedFrom<A>, In<A>>>(x.acceleration())};
  }
};
using TwoFrames = std::array<NamedFrame, 2>;
template <> struct NamedFor<MovingDcm<Some<'a'>, Some<'b'>>> : std::type_identity<NamedMovingDcm> {};
template <> struct Naming<NamedMovingDcm> {
  using form = MovingDcm<Some<'a'>, Some<'b'>>;
  static TwoFrames frames(const NamedMovingDcm& x) { return Naming<NamedDcm>::frames(x.rotation()); }
  template <class Typed> static NamedMovingDcm make(const TwoFrames& f, const Typed& x) {
    return {trusted, Naming<NamedDcm>::make(f, x.rotation),
            Naming<NamedAngularVelocity>::make({f[0], f[1], f[1]}, x.angular_velocity)};
  }
};
template <>
struct NamedFor<AcceleratingDcm<Some<'a'>, Some<'b'>>> : std::type_identity<NamedAcceleratingDcm> {};
template <> struct Naming<NamedAcceleratingDcm> {
  using form = AcceleratingDcm<Some<'a'>, Some<'b'>>;
  static TwoFrames frames(const NamedAcceleratingDcm& x) { return Naming<NamedDcm>::frames(x.rotation()); }
  template <class Typed> static NamedAcceleratingDcm make(const TwoFrames& f, const Typed& x) {
    return {trusted, Naming<NamedMovingDcm>::make(f, x),
            Naming<NamedAngularAcceleration>::make({f[0], f[1], f[1]}, x.angular_acceleration)};
  }
};
template <> struct NamedFor<Transform<Some<'a'>, Some<'b'>>> : std::type_identity<NamedTransform> {};
template <> struct Naming<NamedTransform> {
  using form = Transform<Some<'a'>, Some<'b'>>;
  static TwoFrames frames(const NamedTransform& X) { return Naming<NamedDcm>::frames(X.rotation()); }
  template <class Typed> static NamedTransform make(const TwoFrames& f, const Typed& X) {
    return {trusted, Naming<NamedDcm>::make(f, X.rotation), X.translation.coordinates()};
  }
};
template <>
struct NamedFor<MovingTransform<Some<'a'>, Some<'b'>>> : std::type_identity<NamedMovingTransform> {};
template <> struct Naming<NamedMovingTransform> {
  using form = MovingTransform<Some<'a'>, Some<'b'>>;
  static TwoFrames frames(const NamedMovingTransform& x) {
    return Naming<NamedMovingDcm>::frames(x.turning());
  }
  template <class Typed> static NamedMovingTransform make(const TwoFrames& f, const Typed& x) {
    return {Naming<NamedMovingDcm>::make(f, x.turning),
            Naming<NamedDisplacement>::make({f[0], f[1], f[0]}, x.translation),
            Naming<NamedVelocity>::make({f[0], f[1], f[0], f[0]}, x.velocity)};
  }
};
template <>
struct NamedFor<AcceleratingTransform<Some<'a'>, Some<'b'>>>
    : std::type_identity<NamedAcceleratingTransform> {};
template <> struct Naming<NamedAcceleratingTransform> {
  using form = AcceleratingTransform<Some<'a'>, Some<'b'>>;
  static TwoFrames frames(const NamedAcceleratingTransform& x) {
    return Naming<NamedAcceleratingDcm>::frames(x.turning());
  }
  template <class Typed> static NamedAcceleratingTransform make(const TwoFrames& f, const Typed& x) {
    return {Naming<NamedAcceleratingDcm>::make(f, x.turning),
            Naming<NamedDisplacement>::make({f[0], f[1], f[0]}, x.translation),
            Naming<NamedVelocity>::make({f[0], f[1], f[0], f[0]}, x.velocity),
            Naming<NamedAcceleration>::make({f[0], f[1], f[0], f[0]}, x.acceleration)};
  }
};

}  // namespace detail
}  // namespace vectrix

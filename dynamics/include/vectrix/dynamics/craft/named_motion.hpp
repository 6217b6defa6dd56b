#pragma once

#include <functional>
#include <vectrix/dynamics/craft/named_held.hpp>
#include <vectrix/dynamics/craft/named_state.hpp>
#include <vectrix/dynamics/multibody/tree.hpp>

namespace vectrix {

/// A craft at one instant: a view of its state, with the place and the velocity of every body. Frames, those
/// of the bodies and the inertial one, are given by handle, Of(panel), or by name, Of("panel").
class VECTRIX_EXPORT NamedNow : public detail::NamedNumbers<NamedNow> {
 public:
  NamedNow(detail::Trusted, const detail::NamedCraftCore& core, double segment_start, double t,
           const double* y, const multibody::Work<double>& work)
      : core_(&core), segment_start_(segment_start), t_(t), y_(y), work_(&work) {}

  Quantity<si::time> time() const { return Quantity<si::time>::from_value(t_); }
  /// The start of the smooth segment. A load that jumps at a breakpoint decides by this, not by the time: the
  /// time of the breakpoint is the end of one segment and the start of the next.
  Quantity<si::time> segment_start() const { return Quantity<si::time>::from_value(segment_start_); }
  NamedFrame frame(std::string_view name) const;
  NamedFrame frame(NamedFrame frame) const;

  /// R_a^b.
  template <detail::RunTimeFrame B, detail::RunTimeFrame A> NamedDcm rotation(To<B> b, From<A> a) const {
    return rotation_between(frame(b.frame), frame(a.frame));
  }
  /// w_ab^c.
  template <detail::RunTimeFrame B, detail::RunTimeFrame A, detail::RunTimeFrame C>
  NamedAngularVelocity angular_velocity(Of<B> b, RelativeTo<A> a, In<C> c) const {
    return rate(frame(b.frame), frame(a.frame), frame(c.frame));
  }
  /// r_ab^c of the origins, and v_ab|o^c. Throw BadInput if they depend on where a turning hub is.
  template <detail::RunTimeFrame B, detail::RunTimeFrame A, detail::RunTimeFrame C>
  NamedDisplacement position(Of<B> b, RelativeTo<A> a, In<C> c) const {
    return place(frame(b.frame), frame(a.frame), frame(c.frame));
  }
  template <detail::RunTimeFrame B, detail::RunTimeFrame A, detail::RunTimeFrame O, detail::RunTimeFrame C>
  NamedVelocity velocity(Of<B> b, RelativeTo<A> a, ObservedFrom<O> o, In<C> c) const {
    return speed(frame(b.frame), frame(a.frame), frame(o.frame), frame(c.frame));
  }

  /// Kinetic energy, and that of the modes' springs. Of a turning hub: relative to the centre of mass.
  Quantity<si::energy> energy() const;
  /// In the inertial frame. The angular momentum is about the inertial origin; of a turning hub about the
  /// centre of mass, where the momentum is zero.
  NamedVector<si::momentum> momentum() const;
  NamedVector<si::angular_momentum> angular_momentum() const;

  detail::NamedView view() const { return {core_, y_}; }

 private:
  NamedDcm rotation_between(NamedFrame b, NamedFrame a) const;
  NamedAngularVelocity rate(NamedFrame b, NamedFrame a, NamedFrame c) const;
  NamedDisplacement place(NamedFrame b, NamedFrame a, NamedFrame c) const;
  NamedVelocity speed(NamedFrame b, NamedFrame a, NamedFrame o, NamedFrame c) const;
  multibody::Conserved<double> conserved() const;

  const detail::NamedCraftCore* core_;
  double segment_start_, t_;
  const double* y_;
  const multibody::Work<double>* work_;
};

/// Where a load puts its forces; those of several loads add up. Vectors may be expressed in the frame of any
/// body, or in the inertial one. Throws BadInput for a name, an axis or a kind of joint that the craft has
/// not.
class VECTRIX_EXPORT NamedForces {
 public:
  NamedForces(detail::Trusted, const detail::NamedCraftCore& core, multibody::Work<double>& work)
      : core_(&core), work_(&work) {}

  /// A force on a body, through its origin; or through the point q of the body, r_bq from its origin.
  void force(NamedFrame body, const NamedVector<si::force>& F_c);
  void force(NamedFrame body, const NamedVector<si::length>& r_bq_d, const NamedVector<si::force>& F_c);
  /// A torque on a body.
  void torque(NamedFrame body, const NamedVector<si::torque>& M_c);
  /// A torque of the parent on the body about an axis of its hinge or gimbal; a force along its slider. The
  /// parent has the reaction. Springs, dampers and motors of joints are efforts.
  void effort(std::string_view body, const Quantity<si::torque>& about, int axis = 1);
  void effort(std::string_view body, const Quantity<si::force>& along);
  /// A torque of the parent on a body that hangs on a ball joint or a free one.
  void effort(std::string_view body, const NamedVector<si::torque>& M_c);
  /// A torque of the body on its rotor.
  void motor(std::string_view rotor, const Quantity<si::torque>& torque);
  /// A force on a mode, kg^1/2 m/s^2.
  void modal(std::string_view mode, double force);
  /// A uniform field: the same acceleration for every mass.
  void field(const NamedVector<si::acceleration>& g_c);

 private:
  const detail::NamedCraftCore* core_;
  multibody::Work<double>* work_;
};

/// What acts on a craft: it sees the state, and adds forces. Called once in each evaluation.
using NamedLoads = std::function<void(const NamedNow&, NamedForces&)>;

/// A state with its accelerations. Made by craft.motion().
class VECTRIX_EXPORT NamedMotion {
 public:
  NamedMotion(detail::Trusted, std::shared_ptr<const detail::NamedCraftCore> core, double t,
              std::vector<double> y, std::vector<double> ydot, multibody::Work<double> work)
      : core_(std::move(core)), t_(t), y_(std::move(y)), ydot_(std::move(ydot)), work_(std::move(work)) {}

  /// Places and velocities. It must not outlive the motion.
  [[nodiscard]] NamedNow now() const& { return {detail::trusted, *core_, t_, t_, y_.data(), work_}; }
  NamedNow now() && = delete;  // the view refers to the motion: give the motion a name first

  /// The derivative of the state.
  [[nodiscard]] const std::vector<double>& rates() const& { return ydot_; }
  /// alpha_ib^c, and a_ib|i^c of the origin, relative to the inertial frame.
  [[nodiscard]] NamedAngularAcceleration angular_acceleration(Of<std::string_view> body,
                                                              In<std::string_view> c) const;
  [[nodiscard]] NamedAcceleration acceleration(Of<std::string_view> body, In<std::string_view> c) const;
  /// What the joint of a body transmits to it, about its origin. Throws BadInput for the hub.
  [[nodiscard]] NamedVector<si::force> joint_force(Of<std::string_view> body, In<std::string_view> c) const;
  [[nodiscard]] NamedVector<si::torque> joint_torque(Of<std::string_view> body, In<std::string_view> c) const;
  /// What a lock or a drive adds to the efforts of the loads about an axis of a hinge or gimbal, along a
  /// slider, and to the motor of a rotor. Throws BadInput for another joint or axis.
  [[nodiscard]] Quantity<si::torque> holding_torque(Of<std::string_view> body, int axis = 1) const;
  [[nodiscard]] Quantity<si::force> holding_force(Of<std::string_view> body) const;

 private:
  std::shared_ptr<const detail::NamedCraftCore> core_;
  double t_;
  std::vector<double> y_, ydot_;
  multibody::Work<double> work_;
};

}  // namespace vectrix

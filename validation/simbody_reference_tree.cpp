#include "simbody_reference_tree.hpp"

#include <Simbody.h>

namespace vectrix::validation {
namespace {

using SimTK::Inertia;
using SimTK::Mat33;
using SimTK::MobilizedBody;
using SimTK::Quaternion;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::SymMat33;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;
using SimTK::Vec4;

constexpr double share_of_wheel = 0.05;

Vec3 simbody(const Vector3& v) {
  return {v[0], v[1], v[2]};
}
Mat33 simbody(const Matrix3& m) {
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
}
Vector3 plain(const Vec3& v) {
  return {v[0], v[1], v[2]};
}
Rotation rotation(const double* q) {
  return Rotation(Quaternion(Vec4(q[0], q[1], q[2], q[3]).normalize(), true));
}

/// Mass, centre and inertia about the centre of a body that lends mass to its wheels.
struct Carrier {
  double mass;
  Vec3 centre;
  Mat33 inertia;

  Mat33 lend(const Vec3& axis, double J) {
    const Mat33 along = axis * ~axis;
    const Mat33 disc = J * along + 0.5 * J * (Mat33(1.0) - along);
    inertia -= disc;
    return disc;
  }
  SimTK::Body::Rigid rigid() const {
    const Mat33 J = inertia + mass * (centre.normSqr() * Mat33(1.0) - centre * ~centre);
    return SimTK::Body::Rigid(SimTK::MassProperties(
        mass, centre, Inertia(SymMat33(J(0, 0), J(1, 0), J(1, 1), J(2, 0), J(2, 1), J(2, 2)))));
  }
};

int positions_of(SimbodyJoint joint) {
  constexpr int counts[]{1, 1, 2, 4, 7, 0};
  return counts[static_cast<int>(joint)];
}

}  // namespace

struct SimbodyTree::System {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::DiscreteForces discrete{forces, matter};
  MobilizedBody::Free hub;
  std::vector<MobilizedBody> bodies, wheels;
  std::vector<SimbodyJoint> joints;
  std::vector<Rotation> mounts;
  std::vector<Rotation> turned;  // R_b^F of ball and free joints
  SimTK::State state;
};

SimbodyTree::SimbodyTree(const SimbodyTreeCraft& craft) : system_(std::make_unique<System>()) {
  System& s = *system_;
  s.matter.setShowDefaultGeometry(false);
  SimTK::Force::UniformGravity(s.forces, s.matter, simbody(craft.field_i));
  std::vector<Carrier> carriers{{craft.mass_kg, simbody(craft.centre_b), simbody(craft.inertia_c_b)}};
  for (const auto& b : craft.bodies)
    carriers.push_back({b.mass_kg, simbody(b.centre_b), simbody(b.inertia_c_b)});
  std::vector<Carrier> wheels;
  for (const auto& rotor : craft.rotors) {
    Carrier& carrier = carriers[static_cast<std::size_t>(rotor.body + 1)];
    const double mass = share_of_wheel * carrier.mass;
    wheels.push_back({mass, Vec3(0), carrier.lend(simbody(rotor.axis_b), rotor.inertia)});
    carrier.mass -= mass;
  }

  s.hub = MobilizedBody::Free(s.matter.Ground(), Transform(), carriers[0].rigid(), Transform());
  const auto mobilized = [&](int body) {
    return body < 0 ? MobilizedBody(s.hub) : s.bodies[static_cast<std::size_t>(body)];
  };
  for (std::size_t i = 0; i < craft.bodies.size(); ++i) {
    const SimbodyTreeBody& b = craft.bodies[i];
    MobilizedBody parent = mobilized(b.parent);
    const SimTK::Body::Rigid rigid = carriers[i + 1].rigid();
    const Rotation R0(simbody(b.R_p_from_b), true);
    const Vec3 p = simbody(b.r_pb_p);
    // A joint's own frame has an axis along the given one, in the body and, turned by R0, in the parent.
    const auto along = [&](const SimTK::CoordinateAxis& axis) {
      return Rotation(UnitVec3(simbody(b.axis_1_b)), axis);
    };
    switch (b.joint) {
      case SimbodyJoint::hinge: {
        const Rotation Z = along(SimTK::ZAxis);
        s.bodies.push_back(MobilizedBody::Pin(parent, Transform(R0 * Z, p), rigid, Transform(Z)));
        break;
      }
      case SimbodyJoint::slider: {
        const Rotation X = along(SimTK::XAxis);
        s.bodies.push_back(MobilizedBody::Slider(parent, Transform(R0 * X, p), rigid, Transform(X)));
        break;
      }
      case SimbodyJoint::gimbal: {
        const Rotation F(UnitVec3(simbody(b.axis_1_b)), SimTK::XAxis, simbody(b.axis_2_b), SimTK::YAxis);
        s.bodies.push_back(MobilizedBody::Universal(parent, Transform(R0 * F, p), rigid, Transform(F)));
        break;
      }
      case SimbodyJoint::ball:
        s.bodies.push_back(MobilizedBody::Ball(parent, Transform(R0, p), rigid, Transform()));
        break;
      case SimbodyJoint::free:
        s.bodies.push_back(MobilizedBody::Free(parent, Transform(R0, p), rigid, Transform()));
        break;
      case SimbodyJoint::fixed:
        s.bodies.push_back(MobilizedBody::Weld(parent, Transform(R0, p), rigid, Transform()));
        break;
    }
    s.joints.push_back(b.joint);
    s.mounts.push_back(R0);
  }
  s.turned.resize(s.bodies.size());
  for (std::size_t i = 0; i < craft.rotors.size(); ++i) {
    MobilizedBody carrier = mobilized(craft.rotors[i].body);
    const Rotation Z(UnitVec3(simbody(craft.rotors[i].axis_b)), SimTK::ZAxis);
    const Vec3 centre = carriers[static_cast<std::size_t>(craft.rotors[i].body + 1)].centre;
    s.wheels.push_back(MobilizedBody::Pin(carrier, Transform(Z, centre), wheels[i].rigid(), Transform(Z)));
  }
  s.state = s.system.realizeTopology();
  s.matter.setUseEulerAngles(s.state, false);
  s.system.realizeModel(s.state);

  for (int i = -1; i < static_cast<int>(s.bodies.size()); ++i) {
    const std::size_t at = static_cast<std::size_t>(i + 1);
    s.discrete.setOneBodyForce(s.state, mobilized(i),
                               SpatialVec(simbody(craft.torque_i[at]), simbody(craft.force_i[at])));
  }
  for (std::size_t i = 0; i < s.bodies.size(); ++i) {
    const SimbodyTreeBody& b = craft.bodies[i];
    if (b.joint == SimbodyJoint::hinge || b.joint == SimbodyJoint::slider)
      s.discrete.setOneMobilityForce(s.state, s.bodies[i], SimTK::MobilizerUIndex(0), b.effort);
    if (b.locked && b.joint != SimbodyJoint::fixed) s.bodies[i].lock(s.state, SimTK::Motion::Acceleration);
  }
  for (std::size_t i = 0; i < s.wheels.size(); ++i)
    s.discrete.setOneMobilityForce(s.state, s.wheels[i], SimTK::MobilizerUIndex(0),
                                   craft.rotors[i].torque_nm);
}

SimbodyTree::~SimbodyTree() = default;

// Simbody has the speeds of Ball and Free in the parent's axes at zero; ours are in the body's, and of the
// origin in the parent's.
void SimbodyTree::evaluate(const double* y) {
  System& s = *system_;
  const Vec3 w_i = rotation(y) * Vec3(y[4], y[5], y[6]);
  s.hub.setQ(s.state, SimTK::Vec7(y[0], y[1], y[2], y[3], y[7], y[8], y[9]));
  s.hub.setU(s.state, SimTK::Vec6(w_i[0], w_i[1], w_i[2], y[10], y[11], y[12]));
  const double* q = y + 13;
  const double* u = q;
  for (const SimbodyJoint joint : s.joints) u += positions_of(joint);
  for (std::size_t i = 0; i < s.bodies.size(); ++i) {
    const MobilizedBody& b = s.bodies[i];
    const auto set = [&](int first, const Vec3& moved, const Vec3& speed) {
      for (int k = 0; k < 3; ++k) {
        if (first == 3) b.setOneQ(s.state, 4 + k, moved[k]);
        b.setOneU(s.state, first + k, speed[k]);
      }
    };
    switch (s.joints[i]) {
      case SimbodyJoint::ball:
      case SimbodyJoint::free:
        s.turned[i] = rotation(q);
        for (int k = 0; k < 4; ++k) b.setOneQ(s.state, k, q[k]);
        set(0, Vec3(0), s.turned[i] * Vec3(u[0], u[1], u[2]));
        u += 3;
        if (s.joints[i] == SimbodyJoint::free) {
          set(3, ~s.mounts[i] * Vec3(q[4], q[5], q[6]), ~s.mounts[i] * Vec3(u[0], u[1], u[2]));
          u += 3;
        }
        break;
      default:
        for (int k = 0; k < positions_of(s.joints[i]); ++k) {
          b.setOneQ(s.state, k, q[k]);
          b.setOneU(s.state, k, *u++);
        }
    }
    q += positions_of(s.joints[i]);
  }
  for (const MobilizedBody& wheel : s.wheels) wheel.setOneU(s.state, 0, *u++);
  s.system.realize(s.state, SimTK::Stage::Acceleration);
}

std::vector<double> SimbodyTree::rates() const {
  const System& s = *system_;
  std::vector<double> rates;
  const auto add = [&](const Vec3& v) {
    for (int k = 0; k < 3; ++k) rates.push_back(v[k]);
  };
  add(~s.hub.getBodyRotation(s.state) * s.hub.getBodyAngularAcceleration(s.state));
  add(s.hub.getBodyOriginAcceleration(s.state));
  for (std::size_t i = 0; i < s.bodies.size(); ++i) {
    const MobilizedBody& b = s.bodies[i];
    const auto three = [&](int first) {
      return Vec3(b.getOneUDot(s.state, first), b.getOneUDot(s.state, first + 1),
                  b.getOneUDot(s.state, first + 2));
    };
    if (s.joints[i] == SimbodyJoint::ball || s.joints[i] == SimbodyJoint::free) {
      add(~s.turned[i] * three(0));  // the axes turn with the speed itself
      if (s.joints[i] == SimbodyJoint::free) add(s.mounts[i] * three(3));
    } else {
      for (int k = 0; k < positions_of(s.joints[i]); ++k) rates.push_back(b.getOneUDot(s.state, k));
    }
  }
  for (const MobilizedBody& wheel : s.wheels) rates.push_back(wheel.getOneUDot(s.state, 0));
  return rates;
}

std::vector<SimbodyTree::Transmitted> SimbodyTree::reactions() const {
  const System& s = *system_;
  SimTK::Vector_<SpatialVec> all;
  s.matter.calcMobilizerReactionForces(s.state, all);
  std::vector<Transmitted> list;
  for (const MobilizedBody& b : s.bodies) {
    const SpatialVec& of = all[b.getMobilizedBodyIndex()];
    list.push_back({plain(of[1]), plain(of[0])});
  }
  return list;
}

}  // namespace vectrix::validation

#include "simbody_system.hpp"

namespace vectrix::detail {
namespace {

using SimTK::Matrix;
using SimTK::Vector;

/// The modes of a body in inertial axes, in Simbody's unit of time: they act on it, which has the
/// accelerations x = (alpha, a), a less the field, with the wrench -(K x + c).
struct Appendage {
  SimTK::Mat66 K{0.0};
  SimTK::Vec6 c{0.0};
  Vec3 moment{0.0};  ///< d_t eta

  void add(const Vec3& r, const Vec3& t, double eta, double rate, double free, const Vec3& w) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        K(i, j) -= r[i] * r[j];
        K(i, 3 + j) -= r[i] * t[j];
        K(3 + i, j) -= t[i] * r[j];
        K(3 + i, 3 + j) -= t[i] * t[j];
      }
    const Vec3 torque = r * free + rate * (w % r),
               force = t * free + 2.0 * rate * (w % t) + eta * (w % (w % t));
    for (int i = 0; i < 3; ++i) c[i] += torque[i], c[3 + i] += force[i];
    moment += t * eta;
  }
  void add_first_moment() {
    const Mat33 m = SimTK::crossMat(moment);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) K(i, 3 + j) += m(i, j), K(3 + i, j) -= m(i, j);
  }
};

}  // namespace

// Unknown efforts f act along freedoms of the tree, the columns of G: those of held joints, and all six of
// each body that has modes. With the mass matrix M and what the accelerations x along G are without f,
//     x = x_0 + L f,  L = G^T M^-1 G;    of a held joint x is given;    of a flexible body f = -(K x + c)
void SimbodyEngine::System::give(const SimTK::State& s, SimTK::Vector_<SpatialVec>& body_forces,
                                 Vector& mobility_forces) const {
  struct HeldSpeed {
    int number;
    double acceleration;
  };
  std::vector<HeldSpeed> held;
  const auto hold = [&](const MobilizedBody& body, int k, double acceleration) {
    held.push_back({int(body.getFirstUIndex(s)) + k, acceleration * T * T});
  };
  const double* given = acting.given.data();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Hung& hung = links[i];
    const bool driven = acting.driven_links[i] != 0, locked = acting.locked_links[i] != 0;
    if (locks.links[i] && !locked) throw Freed{};
    const auto hold_three = [&](int first, const Vec3& given_p) {
      for (int k = 0; k < 3; ++k) hold(hung.body, first + k, given_p[k]);
    };
    if (driven || (locked && !locks.links[i])) {
      if (hung.turns_freely()) {
        hold_three(0, turned(hung.body, s) * three(given));
        if (hung.joint == SimbodyJoint::free) hold_three(3, ~hung.mount * three(given + 3));
      } else {
        for (int k = 0; k < hung.speeds(); ++k) hold(hung.body, k, given[k]);
      }
    }
    given += hung.speeds();
  }
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    if (locks.rotors[i] && !acting.locked_rotors[i]) throw Freed{};
    if (acting.locked_rotors[i] && !locks.rotors[i]) hold(wheels[i], 0, 0.0);
    if (acting.driven_rotors[i]) hold(wheels[i], 0, acting.given_spins[i]);
  }
  if (held.empty() && flexible.empty()) return;

  Vector residual, accelerations;
  matter.calcResidualForceIgnoringConstraints(s, mobility_forces, body_forces, Vector(), residual);
  matter.multiplyByMInv(s, residual, accelerations);
  accelerations *= -1.0;
  SimTK::Vector_<SpatialVec> of_bodies;
  matter.calcBodyAccelerationFromUDot(s, accelerations, of_bodies);

  const int joints = static_cast<int>(held.size()), n = joints + 6 * static_cast<int>(flexible.size());
  Matrix G(matter.getNumMobilities(), n, 0.0), solved(matter.getNumMobilities(), n);
  Vector x(n);
  for (int k = 0; k < joints; ++k) {
    G(held[static_cast<std::size_t>(k)].number, k) = 1.0;
    x[k] = accelerations[held[static_cast<std::size_t>(k)].number];
  }
  const Vec3 field = hub_has_place ? T * T * simbody(acting.field_i) : Vec3(0);
  for (int k = joints; k < n; ++k) {
    const int axis = (k - joints) % 6;
    const auto body = mobilized(flexible[static_cast<std::size_t>((k - joints) / 6)]).getMobilizedBodyIndex();
    SimTK::Vector_<SpatialVec> unit(matter.getNumBodies(), SpatialVec(Vec3(0)));
    unit[body][axis / 3][axis % 3] = 1.0;
    Vector column;
    matter.multiplyBySystemJacobianTranspose(s, unit, column);
    G(k) = column;
    x[k] = of_bodies[body][axis / 3][axis % 3] - (axis < 3 ? 0.0 : field[axis - 3]);
  }
  for (int k = 0; k < n; ++k) {
    Vector column;
    matter.multiplyByMInv(s, Vector(G(k)), column);
    solved(k) = column;
  }
  const Matrix L = ~G * solved;

  Matrix S(L);
  Vector right(n);
  for (int k = 0; k < joints; ++k) right[k] = held[static_cast<std::size_t>(k)].acceleration - x[k];
  std::vector<double> free(modes.size());
  for (std::size_t b = 0; b < flexible.size(); ++b) {
    const MobilizedBody body = mobilized(flexible[b]);
    Appendage appendage;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const Bending& mode = modes[i];
      if (mode.body != flexible[b]) continue;
      const double eta = mode.slider.getOneQ(s, 0), rate = mode.slider.getOneU(s, 0), W = T * mode.frequency;
      free[i] = T * T * acting.modal[i] - W * (2.0 * mode.damping_ratio * rate + W * eta);
      const Rotation& R = body.getBodyRotation(s);
      appendage.add(R * mode.rotation, R * mode.translation, eta, rate, free[i],
                    body.getBodyAngularVelocity(s));
    }
    appendage.add_first_moment();
    const int first = joints + 6 * static_cast<int>(b);
    for (int i = 0; i < 6; ++i) {
      right[first + i] = -appendage.c[i];
      for (int k = 0; k < n; ++k) {
        S(first + i, k) = first + i == k ? 1.0 : 0.0;
        for (int j = 0; j < 6; ++j) S(first + i, k) += appendage.K(i, j) * L(first + j, k);
      }
      for (int j = 0; j < 6; ++j) right[first + i] -= appendage.K(i, j) * x[first + j];
    }
  }
  Vector f;
  SimTK::FactorLU(S).solve(right, f);
  x += L * f;

  for (int k = 0; k < joints; ++k) mobility_forces[held[static_cast<std::size_t>(k)].number] += f[k];
  const auto three_at = [](const Vector& v, int at) { return Vec3(v[at], v[at + 1], v[at + 2]); };
  for (std::size_t b = 0; b < flexible.size(); ++b) {
    const MobilizedBody body = mobilized(flexible[b]);
    const int first = joints + 6 * static_cast<int>(b);
    body_forces[body.getMobilizedBodyIndex()] += SpatialVec(three_at(f, first), three_at(f, first + 3));
    const Rotation& R = body.getBodyRotation(s);
    for (std::size_t i = 0; i < modes.size(); ++i)
      if (modes[i].body == flexible[b])
        modes[i].slider.applyOneMobilityForce(s, 0,
                                              free[i] - dot(R * modes[i].rotation, three_at(x, first)) -
                                                  dot(R * modes[i].translation, three_at(x, first + 3)),
                                              mobility_forces);
  }
}

}  // namespace vectrix::detail

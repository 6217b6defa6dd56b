#pragma once

#include <Eigen/Cholesky>
#include <limits>

#include "random_craft.hpp"

/// The equations of a craft assembled by another way: Jacobians of the bodies' centres in inertial axes, one
/// dense mass matrix, Cholesky. It shares no code with the engine.
namespace vectrix_test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

inline Matrix3d hat(const Vector3d& c) {
  return (Matrix3d() << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0).finished();
}

/// What acts, by described body (0: the hub) and in inertial axes.
struct Acting {
  std::vector<Vector3d> force, torque;
  VectorXd efforts, motors, modal;  // by speed, rotor, mode
  Vector3d field = Vector3d::Zero();
  std::vector<bool> held;  // by described body
  VectorXd given;          // by speed
};

struct DenseBody {
  Matrix3d R;
  Vector3d r, w, alpha, a;
  MatrixXd turning, moving;  // w = turning * speeds + ..., of the origin v = moving * speeds + ...
};

struct DenseMotion {
  Vector3d alpha_h, a_i;   // of the hub, in its axes and in inertial ones
  VectorXd accelerations;  // of the joints, the rotors, the modes
  double rounding;         // of these beside the largest: n epsilon and the condition of the mass matrix
  std::vector<DenseBody> bodies;  // with alpha and a as they are
  /// What the joint of a body transmits to it: the rate of momentum of all that hangs on it less what acts.
  std::vector<Vector3d> force, torque;
};

inline int speeds_of(JointKind joint) {
  constexpr int of[]{1, 1, 2, 3, 6, 0};
  return of[static_cast<int>(joint)];
}
inline Matrix3d turn(const double* q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

inline DenseMotion dense_motion(const DescribedCraft& craft, const double* y, const Acting& acting) {
  const int bodies = static_cast<int>(craft.bodies.size());
  int joint_speeds = 0, positions = 0;
  for (const Described& b : craft.bodies) {
    joint_speeds += speeds_of(b.joint);
    positions += speeds_of(b.joint) + (b.joint == JointKind::ball || b.joint == JointKind::free ? 1 : 0);
  }
  const int rotors = static_cast<int>(craft.rotors.size()), modes = static_cast<int>(craft.modes.size());
  const int n = 6 + joint_speeds + rotors + modes;
  const double *q = y + 13, *u = q + positions, *spin = u + joint_speeds, *eta = spin + rotors,
               *rate = eta + modes;

  DenseMotion out;
  DenseBody hub{turn(y),
                Vector3d(y[7], y[8], y[9]),
                {},
                Vector3d::Zero(),
                Vector3d::Zero(),
                MatrixXd::Zero(3, n),
                MatrixXd::Zero(3, n)};
  hub.w = hub.R * Vector3d(y[4], y[5], y[6]);
  hub.turning.leftCols(3).setIdentity();
  hub.moving.middleCols(3, 3).setIdentity();
  out.bodies.push_back(hub);
  std::vector<int> column_of{0};
  std::vector<bool> given(static_cast<std::size_t>(n), false);
  VectorXd known = VectorXd::Zero(n);
  int at = 6;
  for (int i = 0; i < bodies; ++i) {
    const Described& d = craft.bodies[std::size_t(i)];
    const DenseBody p = out.bodies[std::size_t(d.parent)];
    DenseBody b = p;
    Matrix3d Q = d.R_p_from_b;
    Vector3d slide = Vector3d::Zero(), slide_rate = slide;
    const Vector3d n1 = p.R * d.R_p_from_b * d.axis_1;
    const auto turned_by = [&](const Vector3d& axis, int column, double speed) {
      b.turning.col(column) += axis;
      b.alpha += b.w.cross(axis * speed);
      b.w += axis * speed;
    };
    switch (d.joint) {
      case JointKind::hinge:
        Q = Q * Eigen::AngleAxisd(q[0], d.axis_1).toRotationMatrix();
        turned_by(n1, at, u[0]);
        break;
      case JointKind::slider:
        slide = n1 * q[0], slide_rate = n1 * u[0];
        break;
      case JointKind::gimbal: {
        const Matrix3d first = Eigen::AngleAxisd(q[0], d.axis_1).toRotationMatrix();
        turned_by(n1, at, u[0]);
        turned_by(p.R * Q * first * d.axis_2, at + 1, u[1]);
        Q = Q * first * Eigen::AngleAxisd(q[1], d.axis_2).toRotationMatrix();
        break;
      }
      case JointKind::ball:
      case JointKind::free: {
        Q = Q * turn(q);
        const Matrix3d R = p.R * Q;
        const Vector3d relative = R * Vector3d(u[0], u[1], u[2]);
        b.turning.middleCols(at, 3) += R;
        b.alpha += b.w.cross(relative);
        b.w += relative;
        if (d.joint == JointKind::free) {
          slide = p.R * Vector3d(q[4], q[5], q[6]), slide_rate = p.R * Vector3d(u[3], u[4], u[5]);
        }
        break;
      }
      case JointKind::fixed:
        break;
    }
    b.R = p.R * Q;
    const Vector3d r = p.R * d.r_pb_p + slide;
    b.r = p.r + r;
    b.moving = p.moving - hat(r) * p.turning;
    if (d.joint == JointKind::slider) b.moving.col(at) += n1;
    if (d.joint == JointKind::free) b.moving.middleCols(at + 3, 3) += p.R;
    b.a = p.a + p.alpha.cross(r) + p.w.cross(p.w.cross(r)) + 2.0 * p.w.cross(slide_rate);
    out.bodies.push_back(b);
    for (int k = 0; k < speeds_of(d.joint); ++k) {
      given[std::size_t(at + k)] = acting.held[std::size_t(i) + 1];
      if (given[std::size_t(at + k)]) known[at + k] = acting.given[at + k - 6];
    }
    column_of.push_back(at);
    q += speeds_of(d.joint) + (d.joint == JointKind::ball || d.joint == JointKind::free ? 1 : 0);
    u += speeds_of(d.joint);
    at += speeds_of(d.joint);
  }

  // M x = F, the known accelerations on the right
  MatrixXd M = MatrixXd::Zero(n, n);
  VectorXd F = VectorXd::Zero(n);
  F.segment(6, joint_speeds) = acting.efforts;
  const auto described = [&](int i) -> const Described& {
    return i == 0 ? craft.hub : craft.bodies[std::size_t(i) - 1];
  };
  for (int i = 0; i <= bodies; ++i) {
    const Described& d = described(i);
    const DenseBody& b = out.bodies[std::size_t(i)];
    const Vector3d c = b.R * d.c;
    const Matrix3d J = b.R * d.J * b.R.transpose();
    const MatrixXd centre = b.moving - hat(c) * b.turning;
    const Vector3d a_c = b.a + b.alpha.cross(c) + b.w.cross(b.w.cross(c));
    M += d.m * centre.transpose() * centre + b.turning.transpose() * J * b.turning;
    F -= centre.transpose() * (d.m * (a_c - acting.field)) +
         b.turning.transpose() * (J * b.alpha + b.w.cross(J * b.w));
    F += b.moving.transpose() * acting.force[std::size_t(i)] +
         b.turning.transpose() * acting.torque[std::size_t(i)];
  }
  for (int k = 0; k < rotors; ++k) {
    const auto& rotor = craft.rotors[std::size_t(k)];
    const DenseBody& b = out.bodies[std::size_t(rotor.body)];
    const Vector3d axis = b.R * eigen(rotor.axis);
    const int c = 6 + joint_speeds + k;
    M(c, c) += rotor.inertia;
    const VectorXd coupling = b.turning.transpose() * axis * rotor.inertia;
    M.col(c) += coupling, M.row(c) += coupling.transpose();
    F -= b.turning.transpose() * b.w.cross(axis * rotor.inertia * spin[k]);
    F[c] += acting.motors[k] - rotor.inertia * axis.dot(b.alpha);
  }
  for (int k = 0; k < modes; ++k) {
    const auto& mode = craft.modes[std::size_t(k)];
    const DenseBody& b = out.bodies[std::size_t(mode.body)];
    const Vector3d r = b.R * eigen(mode.rotation), t = b.R * eigen(mode.translation), moment = t * eta[k];
    const int c = 6 + joint_speeds + rotors + k;
    M(c, c) += 1.0;
    const VectorXd coupling = b.turning.transpose() * r + b.moving.transpose() * t;
    M.col(c) += coupling, M.row(c) += coupling.transpose();
    const MatrixXd first = b.turning.transpose() * hat(moment) * b.moving;
    M += first + first.transpose();
    const Vector3d f = b.alpha.cross(moment) + b.w.cross(b.w.cross(moment)) + 2.0 * b.w.cross(t) * rate[k];
    const Vector3d torque = moment.cross(b.a - acting.field) + b.w.cross(r) * rate[k];
    F -= b.moving.transpose() * f + b.turning.transpose() * torque;
    const double W = mode.frequency;
    F[c] += acting.modal[k] - 2.0 * mode.damping_ratio * W * rate[k] - W * W * eta[k] - r.dot(b.alpha) -
            t.dot(b.a - acting.field);
  }
  F -= M * known;
  for (int c = 0; c < n; ++c) {
    if (!given[std::size_t(c)]) continue;
    M.row(c).setZero(), M.col(c).setZero();
    M(c, c) = 1.0;
    F[c] = 0.0;
  }
  const Eigen::LDLT<MatrixXd> factors(M);
  out.rounding = static_cast<double>(n) * std::numeric_limits<double>::epsilon() / factors.rcond();
  const VectorXd x = factors.solve(F) + known;
  out.alpha_h = hub.R.transpose() * x.head<3>();
  out.a_i = x.segment<3>(3);
  out.accelerations = x.tail(n - 6);

  out.force.assign(std::size_t(bodies) + 1, Vector3d::Zero());
  out.torque = out.force;
  for (int i = 0; i <= bodies; ++i) {
    DenseBody& b = out.bodies[std::size_t(i)];
    b.alpha += b.turning * x;
    b.a += b.moving * x;
  }
  for (int i = bodies; i >= 0; --i) {
    const Described& d = described(i);
    const DenseBody& b = out.bodies[std::size_t(i)];
    const Vector3d c = b.R * d.c;
    const Matrix3d J = b.R * d.J * b.R.transpose();
    const Vector3d f = d.m * (b.a + b.alpha.cross(c) + b.w.cross(b.w.cross(c)) - acting.field);
    Vector3d& force = out.force[std::size_t(i)];
    Vector3d& torque = out.torque[std::size_t(i)];
    force += f - acting.force[std::size_t(i)];
    torque += J * b.alpha + b.w.cross(J * b.w) + c.cross(f) - acting.torque[std::size_t(i)];
    for (int k = 0; k < rotors; ++k) {
      const auto& rotor = craft.rotors[std::size_t(k)];
      if (rotor.body != i) continue;
      const Vector3d axis = b.R * eigen(rotor.axis) * rotor.inertia;
      torque += axis * out.accelerations[joint_speeds + k] + b.w.cross(axis) * spin[k];
    }
    for (int k = 0; k < modes; ++k) {
      const auto& mode = craft.modes[std::size_t(k)];
      if (mode.body != i) continue;
      const Vector3d r = b.R * eigen(mode.rotation), t = b.R * eigen(mode.translation), moment = t * eta[k];
      const double second = out.accelerations[joint_speeds + rotors + k];
      force += b.alpha.cross(moment) + b.w.cross(b.w.cross(moment) + 2.0 * t * rate[k]) + t * second;
      torque += moment.cross(b.a - acting.field) + b.w.cross(r) * rate[k] + r * second;
    }
    if (i == 0) continue;
    const Vector3d r = b.r - out.bodies[std::size_t(d.parent)].r;
    out.force[std::size_t(d.parent)] += force;
    out.torque[std::size_t(d.parent)] += torque + r.cross(force);
  }
  return out;
}

}  // namespace vectrix_test

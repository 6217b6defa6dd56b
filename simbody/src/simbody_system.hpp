#pragma once

#include <Simbody.h>

#include <array>
#include <cstddef>
#include <exception>
#include <memory>
#include <vector>
#include <vectrix/simbody/engine.hpp>

namespace vectrix::detail {

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

inline Vec3 simbody(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}
inline Vec3 three(const double* v) {
  return {v[0], v[1], v[2]};
}
inline Mat33 simbody(const std::array<double, 9>& m) {
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
}
inline std::array<double, 3> plain(const Vec3& v) {
  return {v[0], v[1], v[2]};
}
inline void put(const Vec3& v, double* to) {
  for (int k = 0; k < 3; ++k) to[k] = v[k];
}
inline Rotation rotation(const Vec4& q) {
  return Rotation(Quaternion(q.normalize(), true));
}

constexpr int positions_of[]{1, 1, 4, 7, 0};
constexpr int speeds_of[]{1, 1, 3, 6, 0};

/// A link with the places of its numbers in a state of ours.
struct Hung {
  SimbodyJoint joint;
  MobilizedBody body;
  Rotation mount;
  int positions_at, speeds_at;

  bool turns_freely() const { return joint == SimbodyJoint::ball || joint == SimbodyJoint::free; }
  int speeds() const { return speeds_of[static_cast<int>(joint)]; }
};

/// A mode of a body, and the slider that has its coordinate.
struct Bending {
  MobilizedBody slider;
  int body;
  Vec3 rotation, translation;
  double frequency, damping_ratio;
};

inline Rotation turned(const MobilizedBody& body, const SimTK::State& s) {
  return rotation(Vec4(body.getOneQ(s, 0), body.getOneQ(s, 1), body.getOneQ(s, 2), body.getOneQ(s, 3)));
}

/// A load frees what Simbody's own lock holds: it ends with its segment only.
struct Freed {};

/// The craft in Simbody, and what is kept from call to call. `y` are the numbers that the loads see; what
/// they throw is kept in `trouble`.
struct SimbodyEngine::System {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  MobilizedBody::Free hub;
  std::vector<Hung> links;
  std::vector<MobilizedBody> wheels;
  std::vector<Bending> modes;
  std::vector<int> flexible;  ///< the bodies that have modes
  bool hub_has_place;
  int wheels_at, modes_at;

  SimbodyPair pair;
  double accuracy, T;
  Loads loads;
  SimbodyLoads acting;
  struct Locks {
    std::vector<char> links, rotors;
    bool operator!=(const Locks& other) const { return links != other.links || rotors != other.rotors; }
  };
  Locks locks, asked_locks;     ///< Simbody's own, of the state that is realized, and of `asked`
  std::vector<double> y, last;  ///< what the loads see; where a step began
  double origin = 0.0, stop = 0.0, longest = 0.0;
  std::exception_ptr trouble;
  std::size_t evaluations = 0, failures_before = 0;

  SimTK::State fresh, asked;
  std::unique_ptr<SimTK::Integrator> integrator;

  MobilizedBody mobilized(int body) const {
    return body == 0 ? MobilizedBody(hub) : links[static_cast<std::size_t>(body) - 1].body;
  }
  void hang(const SimbodyCraft& craft);
  void write(SimTK::State& s, const double* numbers) const;
  template <class Q, class U>
  void put_numbers(const SimTK::State& s, const Q& q, const U& u, double* to) const;
  void read(const SimTK::State& s, double* numbers) const;
  void read_rates(const SimTK::State& s, double* rates) const;
  Locks found_locks() const { return {acting.locked_links, acting.locked_rotors}; }
  Locks no_locks() const { return {std::vector<char>(links.size(), 0), std::vector<char>(wheels.size(), 0)}; }
  void lock(SimTK::State& s) const;
  void give(const SimTK::State& s, SimTK::Vector_<SpatialVec>& body_forces,
            SimTK::Vector& mobility_forces) const;
  void integrate_from(double elapsed, const double* numbers);
  void make_integrator(const SimTK::State& s);
  void turn_wheels_back();
  void require_no_trouble();
};

}  // namespace vectrix::detail

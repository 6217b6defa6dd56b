#include <vectrix/space/files/frame_kernel.hpp>

#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include <vectrix/frames/errors.hpp>
#include <vectrix/kinematics/attitude/quaternion.hpp>

#include "frame_claim.hpp"
#include "kernel_names.hpp"
#include "kvn.hpp"
#include "text_file.hpp"

namespace vectrix {
namespace {

struct Mounted : moving_frame {};
struct Base : moving_frame {};

constexpr std::string_view frame_begin = "FRAME_";

/// [t]_a: coordinates in axes that are turned by t about the axis a.
Eigen::Matrix3d turned_axes(double angle, int axis) {
  return Eigen::AngleAxisd(-angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

std::optional<double> radians_of(const std::string& unit) {
  constexpr double one_degree = std::numbers::pi / 180.0;
  const std::string capitals = detail::upper_case(unit);
  if (capitals == "DEGREES") return one_degree;
  if (capitals == "RADIANS") return 1.0;
  if (capitals == "ARCMINUTES") return one_degree / 60.0;
  if (capitals == "ARCSECONDS") return one_degree / 3600.0;
  if (capitals == "HOURANGLE") return 15.0 * one_degree;
  return std::nullopt;
}

detail::KernelRotation nearest_of_matrix(const Eigen::Matrix3d& matrix) {
  const auto nearest = nearest_dcm(to<Base>, from<Mounted>, matrix);
  return {nearest.dcm.matrix(), nearest.distance};
}

}  // namespace

FrameKernel FrameKernel::of(TextKernel kernel) {
  FrameKernel result;
  result.kernel_ = std::move(kernel);
  const TextKernel& text = result.kernel_;
  for (auto it = text.variables().lower_bound(frame_begin);
       it != text.variables().end() && it->first.starts_with(frame_begin); ++it) {
    // FRAME_name = id defines a frame, which FRAME_id_NAME repeats. The others are of its class and so on.
    const auto& value = it->second.values.front();
    const std::string name = it->first.substr(frame_begin.size());
    constexpr double most = 2147483647.0;
    if (value.kind != TextKernel::Value::Kind::number || !(std::abs(value.number) <= most)) continue;
    const std::string repeated = "FRAME_" + detail::text(static_cast<std::int32_t>(value.number)) + "_NAME";
    if (!text.find(repeated) || detail::upper_case(text.text(repeated)) != detail::upper_case(name)) continue;
    KernelFrame frame{name, text.integer(it->first), 0, 0, 0};
    frame.frame_class = text.integer(result.property(frame, "FRAME_", "_CLASS"));
    frame.class_id = text.integer(result.property(frame, "FRAME_", "_CLASS_ID"));
    frame.center = text.integer(result.property(frame, "FRAME_", "_CENTER"));
    if (result.find(frame.id))
      text.refuse(it->first, "has the number of another frame, " + detail::text(frame.id));
    result.by_id_[frame.id] = result.by_name_[detail::upper_case(name)] = result.frames_.size();
    result.frames_.push_back(std::move(frame));
  }
  return result;
}

FrameKernel FrameKernel::read(const std::filesystem::path& file) {
  return of(TextKernel::read(file));
}

std::string FrameKernel::property(const KernelFrame& frame, const char* begin, const char* end) const {
  const std::string by_name = begin + frame.name + end;
  return kernel_.find(by_name) ? by_name : begin + detail::text(frame.id) + end;
}

const KernelFrame* FrameKernel::find(std::string_view name) const {
  const auto found = by_name_.find(detail::upper_case(std::string{name}));
  return found == by_name_.end() ? nullptr : &frames_[found->second];
}

const KernelFrame* FrameKernel::find(std::int32_t id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &frames_[found->second];
}

std::optional<std::int32_t> FrameKernel::clock_of(std::int32_t class_id) const {
  const std::string name = "CK_" + detail::text(class_id) + "_SCLK";
  if (!kernel_.find(name)) return std::nullopt;
  return kernel_.integer(name);
}

std::string FrameKernel::shown(std::int32_t id) const {
  const KernelFrame* const frame = find(id);
  const auto known = detail::name_of_frame(id);
  if (!frame && !known) return detail::text(id);
  return "'" + detail::excerpt(frame ? frame->name : *known) + "' (" + detail::text(id) + ")";
}

std::int32_t FrameKernel::id_of(const detail::FrameClaim& claim) const {
  if (!claim.name) {
    if (claim.standard == detail::StandardFrame::gcrf) return detail::j2000_id;
    throw BadInput(
        kernel_.place() + ": " + claim.type +
        " has no standard name in kernels; in them J2000 is earth::Gcrf, and another frame is said by "
        "called<" +
        claim.type + ">(\"NAME\")");
  }
  const auto number = detail::kernel_id(*claim.name);
  if (const auto id = number ? number : detail::id_of_frame(*claim.name)) {
    detail::require_kernel_claim(kernel_.place(), *id, claim);
    return *id;
  }
  const KernelFrame* const frame = find(*claim.name);
  if (!frame)
    throw BadInput(kernel_.place() + ": there is no frame '" + detail::excerpt(*claim.name) + "' (" +
                   claim.type + "); give its number, or the frame kernel that defines it");
  return frame->id;
}

std::int32_t FrameKernel::attitude_id_of(const detail::FrameClaim& claim) const {
  const std::int32_t id = id_of(claim);
  constexpr std::int32_t of_attitude_kernels = 3;
  const KernelFrame* const frame = find(id);
  return frame && frame->frame_class == of_attitude_kernels ? frame->class_id : id;
}

void FrameKernel::require_clock(const std::string& place, std::int32_t class_id, std::int32_t clock) const {
  constexpr std::int32_t frames_of_a_spacecraft = 1000;
  const auto said = clock_of(class_id);
  const std::int32_t wanted = said ? *said : class_id / frames_of_a_spacecraft;
  if (wanted != clock)
    throw BadInput(place + ": the ticks of the frame " + detail::text(class_id) + " are those of the clock " +
                   detail::text(wanted) + "; given was the clock " + detail::text(clock));
}

std::optional<FrameKernel::Mount> FrameKernel::mount_of(std::int32_t id) const {
  const KernelFrame* const frame = find(id);
  constexpr std::int32_t mounted_class = 4;
  if (!frame || frame->frame_class != mounted_class) return std::nullopt;
  const auto name = [&](const char* end) { return property(*frame, "TKFRAME_", end); };
  const std::string& relative = kernel_.text(name("_RELATIVE"));
  const auto known = detail::id_of_frame(relative);
  const KernelFrame* const base = find(relative);
  if (!known && !base)
    kernel_.refuse(name("_RELATIVE"),
                   "is '" + detail::excerpt(relative) + "', which is no frame of the kernel");
  Mount mount{known ? *known : base->id, {}};

  const std::string spec = detail::upper_case(kernel_.text(name("_SPEC")));
  const auto numbers = [&](const char* end, std::size_t count) {
    auto all = kernel_.numbers(name(end));
    if (all.size() != count)
      kernel_.refuse(name(end),
                     "has " + detail::text(all.size()) + " numbers instead of " + detail::text(count));
    return all;
  };
  const auto checked = [&](const char* end, const auto& make) {
    try {
      return make();
    } catch (const BadInput& error) {
      kernel_.refuse(name(end), std::string{"is no rotation: "} + error.what());
    }
  };
  if (spec == "MATRIX") {
    const auto by_columns = numbers("_MATRIX", 9);
    mount.rotation = checked(
        "_MATRIX", [&] { return nearest_of_matrix(Eigen::Map<const Eigen::Matrix3d>(by_columns.data())); });
  } else if (spec == "QUATERNION") {
    const auto q = numbers("_Q", 4);
    mount.rotation = checked("_Q", [&] {
      const auto nearest = nearest_quaternion_scalar_first(to<Base>, from<Mounted>, q[0], q[1], q[2], q[3]);
      return detail::KernelRotation{nearest.quaternion.eigen().toRotationMatrix(), nearest.distance};
    });
  } else if (spec == "ANGLES") {
    const auto angles = numbers("_ANGLES", 3), axes = numbers("_AXES", 3);
    const auto unit = radians_of(kernel_.text(name("_UNITS")));
    if (!unit)
      kernel_.refuse(name("_UNITS"), "is '" + detail::excerpt(kernel_.text(name("_UNITS"))) +
                                         "', which is no unit of angles");
    mount.rotation = {Eigen::Matrix3d::Identity(), 0.0};
    for (std::size_t i = 0; i < angles.size(); ++i) {
      if (axes[i] != 1.0 && axes[i] != 2.0 && axes[i] != 3.0)
        kernel_.refuse(name("_AXES"), "has the axis " + detail::text(axes[i]));
      mount.rotation.matrix =
          mount.rotation.matrix * turned_axes(angles[i] * *unit, static_cast<int>(axes[i]) - 1);
    }
  } else {
    kernel_.refuse(name("_SPEC"), "is '" + detail::excerpt(spec) + "'; it is MATRIX, QUATERNION or ANGLES");
  }
  return mount;
}

std::optional<std::int32_t> FrameKernel::mounted_on(std::int32_t id) const {
  const auto mount = mount_of(id);
  return mount ? std::optional(mount->relative) : std::nullopt;
}

std::optional<detail::KernelRotation> FrameKernel::climb(std::int32_t from, std::int32_t to) const {
  detail::KernelRotation R{Eigen::Matrix3d::Identity(), 0.0};
  for (std::size_t steps = 0; from != to; ++steps) {
    const auto mount = mount_of(from);
    if (!mount) return std::nullopt;
    if (steps > frames_.size())
      throw BadInput(kernel_.place() + ": the frame " + shown(from) + " is mounted on itself");
    R = {mount->rotation.matrix * R.matrix, std::max(R.distance, mount->rotation.distance)};
    from = mount->relative;
  }
  return R;
}

detail::KernelRotation FrameKernel::mounted(const detail::FrameClaim& to,
                                            const detail::FrameClaim& from) const {
  const std::int32_t b = id_of(to), a = id_of(from);
  if (a == b)
    throw BadInput(kernel_.place() + ": " + to.type + " and " + from.type + " are both the frame " +
                   shown(a));
  if (const auto R = climb(a, b)) return *R;
  if (const auto R = climb(b, a)) return {R->matrix.transpose(), R->distance};
  throw BadInput(kernel_.place() + ": neither of " + shown(b) + " and " + shown(a) +
                 " is mounted on the other");
}

void FrameKernel::require_orthonormal(const detail::KernelRotation& R) const {
  if (R.distance > orthonormality_tolerance)
    throw BadInput(kernel_.place() + ": the numbers differ from a rotation by " + detail::text(R.distance) +
                   ", tolerance " + detail::text(orthonormality_tolerance) + "; nearest_rotation() projects");
}

}  // namespace vectrix

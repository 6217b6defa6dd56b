#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <vectrix/frames/dcm.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/files/file_frame.hpp>
#include <vectrix/space/files/text_kernel.hpp>

namespace vectrix {

/// A frame that a frame kernel defines. The classes are: 1 inertial, 2 of a body, 3 of an attitude kernel,
/// 4 mounted on another frame, 5 dynamic, 6 switched. In class 3 class_id is the number in attitude kernels.
struct KernelFrame {
  std::string name;
  std::int32_t id, frame_class, class_id, center;
};

/// A rotation from a kernel, and how far its numbers were from one.
template <Frame B, Frame A> struct NearestKernelRotation {
  Dcm<B, A> rotation;
  double distance;
};

namespace detail {

struct KernelRotation {
  Eigen::Matrix3d matrix;
  double distance;
};

}  // namespace detail

/// The frames of a frame kernel (FK) of SPICE, and the rotations of those that are mounted on others, class
/// 4:
///     frames.nearest_rotation(to<Craft>, from<Camera>, called<Craft>("CRAFT"),
///     called<Camera>("CRAFT_CAMERA"))
/// SPICE writes the rotation that takes coordinates of the frame to the one it is mounted on:
///     MATRIX       v_relative = M v_frame, with M by columns
///     QUATERNION   v_relative = R(q) v_frame, the scalar first
///     ANGLES       v_relative = [t1]_a1 [t2]_a2 [t3]_a3 v_frame,  [t]_3 = [cos t, sin t, 0; -sin t, cos t,
///     0; 0, 0, 1]
/// A frame may be mounted on a mounted one. In kernels "J2000" is earth::Gcrf: SPICE makes no difference
/// between the two. Who knows better says so: called<earth::Eme2000>("J2000").
class VECTRIX_EXPORT FrameKernel {
 public:
  FrameKernel() = default;  ///< without frames

  /// Throws BadInput with the place in the kernel if a frame has no name, class or number of its class.
  static FrameKernel of(TextKernel kernel);
  static FrameKernel read(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<KernelFrame>& frames() const { return frames_; }
  /// Null if the kernel has none. Capitals do not matter.
  [[nodiscard]] const KernelFrame* find(std::string_view name) const;
  [[nodiscard]] const KernelFrame* find(std::int32_t id) const;
  /// CK_..._SCLK of a frame of class 3: the clock of its attitude kernels.
  [[nodiscard]] std::optional<std::int32_t> clock_of(std::int32_t class_id) const;

  /// The number of the frame on which one of class 4 is mounted; nothing for others.
  [[nodiscard]] std::optional<std::int32_t> mounted_on(std::int32_t id) const;

  /// R_a^b where one of the frames is mounted on the other, or on one that is. Throws BadInput that names
  /// both if it is not; and if the numbers of the file differ from a rotation by more than
  /// orthonormality_tolerance: nearest_rotation() projects.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, Dcm<B, A>, Given...> rotation(To<B>, From<A>,
                                                                        const Given&... called) const {
    const auto R = mounted(detail::claim_among<B>(called...), detail::claim_among<A>(called...));
    require_orthonormal(R);
    return dcm(to<B>, from<A>, R.matrix);
  }
  template <class B, class A, class... Given>
  auto rotation(  // to<B>, from<A>; if F has no standard name in a file: called<F>("NAME")
      To<B>, From<A>, const Given&...) const -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// The nearest rotation, and how far the numbers of the file are from it.
  template <Frame B, Frame A, class... Given>
  [[nodiscard]] detail::ClaimedPair<A, B, NearestKernelRotation<B, A>, Given...> nearest_rotation(
      To<B>, From<A>, const Given&... called) const {
    const auto R = mounted(detail::claim_among<B>(called...), detail::claim_among<A>(called...));
    return {dcm(to<B>, from<A>, R.matrix), R.distance};
  }
  template <class B, class A, class... Given>
  auto nearest_rotation(  // to<B>, from<A>; if F has no standard name in a file: called<F>("NAME")
      To<B>, From<A>, const Given&...) const -> detail::UnclaimedPair<A, B, Given...> = delete;

  /// The name of a frame for messages: 'CTIM_COORD' (-152950000).
  [[nodiscard]] std::string shown(std::int32_t id) const;
  /// The number of the claimed frame. Throws BadInput if the kernel does not have its name.
  [[nodiscard]] std::int32_t id_of(const detail::FrameClaim& claim) const;
  /// The number that a frame of class 3 has in attitude kernels.
  [[nodiscard]] std::int32_t attitude_id_of(const detail::FrameClaim& claim) const;
  /// Throws BadInput if the clock of a frame in attitude kernels is another one: that of CK_..._SCLK, or the
  /// number of the spacecraft, a thousandth of that of the frame.
  void require_clock(const std::string& place, std::int32_t class_id, std::int32_t clock) const;

 private:
  [[nodiscard]] detail::KernelRotation mounted(const detail::FrameClaim& to,
                                               const detail::FrameClaim& from) const;
  /// From a frame to the one that it is mounted on. Nothing if it is not mounted.
  struct Mount {
    std::int32_t relative;
    detail::KernelRotation rotation;
  };
  [[nodiscard]] std::optional<Mount> mount_of(std::int32_t id) const;
  [[nodiscard]] std::optional<detail::KernelRotation> climb(std::int32_t from, std::int32_t to) const;
  [[nodiscard]] std::string property(const KernelFrame& frame, const char* begin, const char* end) const;
  void require_orthonormal(const detail::KernelRotation& R) const;

  TextKernel kernel_;
  std::vector<KernelFrame> frames_;
  std::map<std::int32_t, std::size_t> by_id_;
  std::map<std::string, std::size_t, std::less<>> by_name_;  // in capitals
};

}  // namespace vectrix

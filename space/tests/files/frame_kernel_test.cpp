#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <vectrix/space.hpp>

#include "temporary_file.hpp"

// Frame kernels: the three ways to write a mounting, and the direction of each.
namespace vectrix::frame_kernel_test {
namespace {

using earth::Gcrf;

struct Ctim : moving_frame {};
struct Radiometer : moving_frame {};
struct Craft : moving_frame {};
struct Camera : moving_frame {};
struct Deck : moving_frame {};

const std::filesystem::path examples = std::filesystem::path{VECTRIX_SOURCE_DIR} / "examples/data";
constexpr double rounding = 1e-15;

std::string frame(const std::string& name, int id, int frame_class, const std::string& mounting = "") {
  const std::string number = std::to_string(id);
  return "FRAME_" + name + " = " + number + "\nFRAME_" + number + "_NAME = '" + name + "'\nFRAME_" + number +
         "_CLASS = " + std::to_string(frame_class) + "\nFRAME_" + number + "_CLASS_ID = " + number +
         "\nFRAME_" + number + "_CENTER = -77\n" + mounting;
}
FrameKernel kernel(const std::string& mounting) {
  return FrameKernel::of(
      TextKernel::parse("\\begindata\n" + frame("CRAFT", -77000, 3) + frame("DECK", -77100, 4, mounting) +
                        frame("CAMERA", -77200, 4,
                              "TKFRAME_-77200_RELATIVE = 'DECK'\nTKFRAME_-77200_SPEC = 'ANGLES'\n"
                              "TKFRAME_-77200_ANGLES = ( 90, 0, 0 )\nTKFRAME_-77200_AXES = ( 1, 2, 3 )\n"
                              "TKFRAME_-77200_UNITS = 'DEGREES'\n")));
}
std::string mounted(const std::string& numbers, const std::string& relative = "CRAFT") {
  return "TKFRAME_-77100_RELATIVE = '" + relative + "'\n" + numbers;
}
const auto craft = called<Craft>("CRAFT");
const auto deck = called<Deck>("DECK");
const auto camera = called<Camera>("CAMERA");

TEST(FrameKernel, OfCtimMountsTheRadiometer) {
  const auto frames = FrameKernel::read(examples / "CTIM_frames.tf");
  ASSERT_EQ(frames.frames().size(), 2U);
  const KernelFrame* const coord = frames.find("ctim_coord");
  ASSERT_NE(coord, nullptr);
  EXPECT_EQ(coord->id, -152950000);
  EXPECT_EQ(coord->frame_class, 3);
  EXPECT_EQ(coord->class_id, -152950000);
  EXPECT_EQ(coord->center, -152950);
  EXPECT_EQ(frames.clock_of(-152950000), -152950);
  EXPECT_EQ(frames.find(-152950100)->name, "CTIM_TIM_COORD");

  // v_body = R(q) v_radiometer, of seven digits
  const auto ctim = called<Ctim>("CTIM_COORD");
  const auto radiometer = called<Radiometer>("CTIM_TIM_COORD");
  const auto mounting = frames.nearest_rotation(to<Ctim>, from<Radiometer>, ctim, radiometer);
  const Eigen::Quaterniond q(9.999876e-01, 1.534418e-03, 4.728365e-03, -7.255375e-06);
  EXPECT_LT((mounting.rotation.matrix() - q.normalized().toRotationMatrix()).norm(), rounding);
  constexpr double digits = 1e-7;
  EXPECT_NEAR(mounting.distance, std::abs(q.norm() - 1.0), rounding);
  EXPECT_LT(mounting.distance, digits);
  EXPECT_NE(complaint([&] {
              static_cast<void>(frames.rotation(to<Ctim>, from<Radiometer>, ctim, radiometer));
            }).find("nearest_rotation() projects"),
            std::string::npos);
  const auto back = frames.nearest_rotation(to<Radiometer>, from<Ctim>, ctim, radiometer);
  EXPECT_EQ(back.rotation.matrix(), mounting.rotation.matrix().transpose());
}

TEST(FrameKernel, GivesAttitudeKernelsTheirNames) {
  const auto frames = FrameKernel::read(examples / "CTIM_frames.tf");
  const auto clock = SpacecraftClock::read(examples / "CTIM_clock.tsc", -152950);
  const auto attitudes = AttitudeKernel::open(examples / "CTIM_20230420_attitude.bc", clock, frames);
  EXPECT_EQ(
      attitudes.samples(of<Ctim>, relative_to<Gcrf>, attitudes.span(), called<Ctim>("CTIM_COORD")).size(),
      692U);
  const std::string text = complaint([&] {
    static_cast<void>(attitudes.samples(of<Radiometer>, relative_to<Gcrf>, attitudes.span(),
                                        called<Radiometer>("CTIM_TIM_COORD")));
  });
  EXPECT_NE(text.find("it has 'CTIM_COORD' (-152950000) relative to 'J2000' (1); asked for 'CTIM_TIM_COORD' "
                      "(-152950100)"),
            std::string::npos)
      << text;
}

TEST(FrameKernel, AMatrixIsWrittenByColumns) {
  // The deck's x axis is the craft's y, its y the craft's z.
  const auto frames =
      kernel(mounted("TKFRAME_-77100_SPEC = 'MATRIX'\nTKFRAME_-77100_MATRIX = ( 0 1 0  0 0 1  1 0 0 )\n"));
  const auto R = frames.rotation(to<Craft>, from<Deck>, craft, deck);
  EXPECT_LT(((R * unit_x(in<Deck>)).coordinates() - Eigen::Vector3d::UnitY()).norm(), rounding);
  EXPECT_LT(((R * unit_y(in<Deck>)).coordinates() - Eigen::Vector3d::UnitZ()).norm(), rounding);
}

TEST(FrameKernel, SaysOnWhatAFrameIsMounted) {
  const auto frames =
      kernel(mounted("TKFRAME_-77100_SPEC = 'MATRIX'\nTKFRAME_-77100_MATRIX = ( 0 1 0  0 0 1  1 0 0 )\n"));
  const auto* const base = frames.find("CRAFT");
  ASSERT_NE(base, nullptr);
  EXPECT_EQ(frames.mounted_on(-77100), base->id);
  EXPECT_EQ(frames.mounted_on(base->id), std::nullopt);
  EXPECT_EQ(frames.mounted_on(-4711), std::nullopt);
}

TEST(FrameKernel, AQuaternionTakesTheFrameToTheOneItIsMountedOn) {
  // A turn of the deck by 90 deg about z: its x axis is the craft's y.
  const auto frames =
      kernel(mounted("TKFRAME_-77100_SPEC = 'QUATERNION'\nTKFRAME_-77100_Q = ( 0.7071067811865476 0 0 "
                     "0.7071067811865476 )\n"));
  const auto R = frames.rotation(to<Craft>, from<Deck>, craft, deck);
  EXPECT_LT(((R * unit_x(in<Deck>)).coordinates() - Eigen::Vector3d::UnitY()).norm(), rounding);
}

TEST(FrameKernel, AnglesAreThoseOfATopocentricFrame) {
  // As kernels of ground stations write it: longitude 30 deg, latitude 50 deg; z up, x to the north.
  const auto frames =
      kernel(mounted("TKFRAME_-77100_SPEC = 'ANGLES'\nTKFRAME_-77100_UNITS = 'DEGREES'\n"
                     "TKFRAME_-77100_AXES = ( 3, 2, 3 )\nTKFRAME_-77100_ANGLES = ( -30, -40, 180 )\n"));
  const auto R = frames.rotation(to<Craft>, from<Deck>, craft, deck);
  constexpr double degree = std::numbers::pi / 180.0;
  const double lon = 30.0 * degree, lat = 50.0 * degree;
  const Eigen::Vector3d up(std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat));
  const Eigen::Vector3d north(-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon), std::cos(lat));
  EXPECT_LT(((R * unit_z(in<Deck>)).coordinates() - up).norm(), rounding);
  EXPECT_LT(((R * unit_x(in<Deck>)).coordinates() - north).norm(), rounding);
}

TEST(FrameKernel, MountsOverSeveralFrames) {
  const auto frames =
      kernel(mounted("TKFRAME_-77100_SPEC = 'MATRIX'\nTKFRAME_-77100_MATRIX = ( 0 1 0  0 0 1  1 0 0 )\n"));
  const auto R = frames.rotation(to<Craft>, from<Camera>, craft, camera);
  const auto product = frames.rotation(to<Craft>, from<Deck>, craft, deck) *
                       frames.rotation(to<Deck>, from<Camera>, deck, camera);
  EXPECT_LT((R.matrix() - product.matrix()).norm(), rounding);
  EXPECT_EQ(frames.rotation(to<Camera>, from<Craft>, craft, camera).matrix(), R.matrix().transpose());
}

TEST(FrameKernel, IsRefusedWhereItIsWrong) {
  const auto asked = [](const std::string& mounting) {
    return complaint(
        [&] { static_cast<void>(kernel(mounting).rotation(to<Craft>, from<Deck>, craft, deck)); });
  };
  const std::string spec = "TKFRAME_-77100_SPEC = ";
  EXPECT_EQ(asked(mounted(spec + "'MATRIX'\nTKFRAME_-77100_MATRIX = ( 0 1 0  0 0 1  -1 0 0 )\n"))
                .find("text kernel, line 14: the variable 'TKFRAME_-77100_MATRIX' is no rotation"),
            0U);
  EXPECT_EQ(asked(mounted(spec + "'MATRIX'\nTKFRAME_-77100_MATRIX = ( 0 1 0 )\n")),
            "text kernel, line 14: the variable 'TKFRAME_-77100_MATRIX' has 3 numbers instead of 9");
  EXPECT_EQ(
      asked(mounted(spec + "'Q'\n")),
      "text kernel, line 13: the variable 'TKFRAME_-77100_SPEC' is 'Q'; it is MATRIX, QUATERNION or ANGLES");
  EXPECT_EQ(asked(mounted(spec + "'QUATERNION'\nTKFRAME_-77100_Q = ( 0 0 0 0 )\n"))
                .find("text kernel, line 14: the variable 'TKFRAME_-77100_Q' is no rotation"),
            0U);
  EXPECT_EQ(asked(mounted(spec + "'ANGLES'\nTKFRAME_-77100_ANGLES = ( 1 2 3 )\nTKFRAME_-77100_AXES = ( 1 2 4 "
                                 ")\nTKFRAME_-77100_UNITS = 'DEGREES'\n")),
            "text kernel, line 15: the variable 'TKFRAME_-77100_AXES' has the axis 4");
  EXPECT_EQ(asked(mounted(spec + "'ANGLES'\nTKFRAME_-77100_ANGLES = ( 1 2 3 )\nTKFRAME_-77100_AXES = ( 1 2 3 "
                                 ")\nTKFRAME_-77100_UNITS = 'GON'\n")),
            "text kernel, line 16: the variable 'TKFRAME_-77100_UNITS' is 'GON', which is no unit of angles");
  EXPECT_EQ(asked(mounted(spec + "'MATRIX'\n", "NOWHERE")),
            "text kernel, line 12: the variable 'TKFRAME_-77100_RELATIVE' is 'NOWHERE', which is no frame of "
            "the kernel");
  EXPECT_EQ(asked(mounted(spec + "'MATRIX'\nTKFRAME_-77100_MATRIX = ( 1 0 0  0 1 0  0 0 1 )\n", "DECK")),
            "text kernel: the frame 'DECK' (-77100) is mounted on itself");
  EXPECT_EQ(asked(mounted(spec + "'MATRIX'\nTKFRAME_-77100_MATRIX = ( 1 0 0  0 1 0  0 0 1 )\n", "J2000")),
            "text kernel: neither of 'CRAFT' (-77000) and 'DECK' (-77100) is mounted on the other");
  EXPECT_EQ(complaint([&] { static_cast<void>(FrameKernel().rotation(to<Craft>, from<Deck>, craft, deck)); }),
            "text kernel: there is no frame 'CRAFT' (" + frame_name<Craft>() +
                "); give its number, or the frame kernel that defines it");
  EXPECT_EQ(complaint([&] {
              static_cast<void>(
                  FrameKernel::of(TextKernel::parse("\\begindata\nFRAME_A = 7\nFRAME_7_NAME = 'A'\n")));
            }),
            "text kernel: there is no variable 'FRAME_7_CLASS'");
}

}  // namespace
}  // namespace vectrix::frame_kernel_test

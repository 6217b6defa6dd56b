#include "report/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "report/data.hpp"
#include "report/svg.hpp"
#include "report/thinning.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Vector3d;

constexpr double scene_size = 480.0, scene_radius = 170.0;  // of the unit sphere
constexpr double scene_degree = std::numbers::pi / 180.0;
constexpr std::array<const char*, 3> scene_axis_names{"x", "y", "z"};

// The parallel projection of scene.js: pixels to the right and down, and the distance towards who looks.
Vector3d projected(const Vector3d& v) {
  constexpr double azimuth = -55.0 * scene_degree, elevation = 22.0 * scene_degree;
  const double ahead = std::cos(azimuth) * v.x() + std::sin(azimuth) * v.y();
  const double right = -std::sin(azimuth) * v.x() + std::cos(azimuth) * v.y();
  const double up = std::cos(elevation) * v.z() - std::sin(elevation) * ahead;
  return {0.5 * scene_size + scene_radius * right, 0.5 * scene_size - scene_radius * up,
          std::sin(elevation) * v.z() + std::cos(elevation) * ahead};
}

struct Label {
  double x, y;
  std::string words, kind;

  [[nodiscard]] double width() const { return 7.0 * static_cast<double>(words.size()); }
  [[nodiscard]] double left() const { return x < 0.5 * scene_size ? x - width() : x; }
  [[nodiscard]] bool overlaps(const Label& other) const {
    constexpr double height = 14.0;
    return std::abs(y - other.y) < height && left() < other.left() + other.width() &&
           other.left() < left() + width();
  }
};

// Draws what is behind the body first, and the labels last.
class Picture {
 public:
  void arrow(const Vector3d& tip, const std::string& name, const std::string& kind) {
    if (!tip.allFinite()) return;
    const Vector3d from = projected(Vector3d::Zero()), to = projected(tip);
    std::string& layer = to.z() > 0.0 ? front_ : behind_;
    layer += svg_line(from.x(), from.y(), to.x(), to.y(), "arrow " + kind);
    const double dx = to.x() - from.x(), dy = to.y() - from.y(), length = std::hypot(dx, dy);
    constexpr double head = 9.0, gap = 6.0;
    if (length > head) {
      const double ux = dx / length * head, uy = dy / length * head;
      std::string points;
      add_point(points, to.x(), to.y());
      add_point(points, to.x() - ux - 0.4 * uy, to.y() - uy + 0.4 * ux);
      add_point(points, to.x() - ux + 0.4 * uy, to.y() - uy - 0.4 * ux);
      layer += svg_path("polygon", points, "tip " + kind);
    }
    const double far = length > 0.0 ? gap / length : 0.0;
    labels_.push_back({to.x() + far * dx, to.y() + far * dy + 4.0, name, kind});
  }

  void path(const std::vector<Vector3d>& points, const std::string& kind) {
    std::string line;
    bool in_front = false;
    const auto finish = [&] {
      if (!line.empty()) (in_front ? front_ : behind_) += svg_path("polyline", line, kind);
      line.clear();
    };
    for (const Vector3d& point : points) {
      const Vector3d at = projected(point);
      if (!at.allFinite()) {
        finish();
        continue;
      }
      if (const bool now = at.z() > 0.0; now != in_front) {
        if (!line.empty()) add_point(line, at.x(), at.y());
        finish();
        in_front = now;
      }
      add_point(line, at.x(), at.y());
    }
    finish();
  }

  // A box, whose sides differ, so that its attitude can be seen.
  void body(const Eigen::Quaterniond& attitude) {
    const Vector3d half(0.17, 0.24, 0.33);
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0}) {
        const Vector3d normal = attitude * Vector3d(side * Vector3d::Unit(axis));
        if (!(projected(normal).z() > 0.0)) continue;
        std::string points;
        for (const auto& [a, b] :
             std::array<std::pair<double, double>, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) {
          Vector3d corner = side * Vector3d::Unit(axis);
          corner[(axis + 1) % 3] = a;
          corner[(axis + 2) % 3] = b;
          const Vector3d at = projected(attitude * Vector3d(corner.cwiseProduct(half)));
          add_point(points, at.x(), at.y());
        }
        faces_ += svg_path("polygon", points, "face");
      }
  }

  [[nodiscard]] std::string text() {
    std::string text = behind_ + faces_ + front_;
    std::sort(labels_.begin(), labels_.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
    std::vector<Label> placed;
    for (Label label : labels_) {
      constexpr double step = 3.0;
      while (std::any_of(placed.begin(), placed.end(),
                         [&](const Label& other) { return label.overlaps(other); }))
        label.y += step;
      placed.push_back(label);
      text += svg_text(label.x, label.y, "name " + label.kind + (label.left() < label.x ? " side" : ""),
                       label.words);
    }
    return text;
  }

 private:
  std::string behind_, faces_, front_;
  std::vector<Label> labels_;
};

// The points at an angle from an axis.
std::vector<Vector3d> sphere_circle(const Vector3d& axis, double angle) {
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Vector3d> points;
  constexpr int sides = 72;
  for (int i = 0; i <= sides; ++i) {
    const double a = 2.0 * std::numbers::pi * i / sides;
    points.push_back(std::cos(angle) * axis + std::sin(angle) * (std::cos(a) * u + std::sin(a) * v));
  }
  return points;
}

void add_sphere(Picture& picture) {
  for (const double latitude : {-60.0, -30.0, 0.0, 30.0, 60.0})
    picture.path(sphere_circle(Vector3d::UnitZ(), (90.0 - latitude) * scene_degree), "sphere");
  for (int longitude = 0; longitude < 180; longitude += 30)
    picture.path(sphere_circle({std::cos(longitude * scene_degree), std::sin(longitude * scene_degree), 0.0},
                               90.0 * scene_degree),
                 "sphere");
}

void add_axes(Picture& picture, const Eigen::Matrix3d& axes, double length, const std::string& frame,
              const std::string& kind) {
  for (int i = 0; i < 3; ++i)
    picture.arrow(length * axes.col(i),
                  std::string(scene_axis_names[static_cast<std::size_t>(i)]) + " " + frame,
                  kind + " " + scene_axis_names[static_cast<std::size_t>(i)]);
}

void add_trail(Picture& picture, const Report::Scene& scene) {
  const Vector3d axis = scene.axes.empty() ? Vector3d::UnitZ() : scene.axes.front().axis;
  constexpr std::size_t most_points = 1500;
  std::vector<Vector3d> points;
  for (const std::size_t i : even_samples(gaps_of(scene), most_points))
    points.push_back(scene.reference_from_body[i] * axis);
  picture.path(points, "trail");
}

}  // namespace

std::string scene_svg(const Report::Scene& scene) {
  Picture picture;
  add_sphere(picture);
  if (!scene.positions.empty()) {
    const Eigen::Vector4d earth = limb(scene.positions.front());
    if (earth.allFinite()) picture.path(sphere_circle(earth.head<3>(), earth(3)), "earth");
  }
  add_trail(picture, scene);
  add_axes(picture, Eigen::Matrix3d::Identity(), 1.0, scene.reference, "reference");
  for (std::size_t i = 0; i < scene.directions.size(); ++i)
    picture.arrow(scene.directions[i].vectors.front(), scene.directions[i].name, "d" + detail::text(i % 6));
  const Eigen::Quaterniond& attitude = scene.reference_from_body.front();
  if (attitude.coeffs().allFinite()) {
    picture.body(attitude);
    add_axes(picture, attitude.toRotationMatrix(), 0.8, scene.body, "body");
    for (const auto& frame : scene.frames)
      add_axes(picture, (attitude * frame.body_from_frame).toRotationMatrix(), 0.55, frame.name, "fixed");
    for (const auto& axis : scene.axes) picture.arrow(attitude * axis.axis, axis.name, "marked");
  }
  const std::string rim = element("circle",
                                  {{"class", "sphere"},
                                   {"cx", pixel(0.5 * scene_size)},
                                   {"cy", pixel(0.5 * scene_size)},
                                   {"r", pixel(scene_radius)}},
                                  "");
  return svg("still", scene_size, scene_size,
             scene.body + " seen from " + scene.reference + " at the first time", rim + picture.text());
}

}  // namespace vectrix::cli

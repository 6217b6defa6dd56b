#include "tf2_reference.hpp"

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

namespace bench {

struct Tf2Reference::Buffer {
  tf2::BufferCore core{ros::Duration(1000.0)};
};

Tf2Reference::Tf2Reference() : buffer_(std::make_unique<Buffer>()) {}
Tf2Reference::~Tf2Reference() = default;

void Tf2Reference::add(const std::string& parent, const std::string& child, double t,
                       const std::array<double, 4>& q, bool fixed) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.header.stamp = ros::Time(t);
  message.transform.rotation.w = q[0];
  message.transform.rotation.x = q[1];
  message.transform.rotation.y = q[2];
  message.transform.rotation.z = q[3];
  buffer_->core.setTransform(message, "bench", fixed);
}

std::array<double, 4> Tf2Reference::look_up(const std::string& target, const std::string& source,
                                            double t) const {
  const auto q = buffer_->core.lookupTransform(target, source, ros::Time(t)).transform.rotation;
  return {q.w, q.x, q.y, q.z};
}

}  // namespace bench

#pragma once

#include <vectrix/kinematics/named/graph_core.hpp>
#include <vectrix/kinematics/named/places.hpp>

namespace vectrix::detail {

/// A query of a snapshot, for messages: to b from a; of b relative to a, in c; or the same observed from o.
struct NamedQuery {
  const char* what;
  const FrameRecord &b, &a;
  const FrameRecord *c = nullptr, *o = nullptr;

  [[noreturn, gnu::cold, gnu::noinline]] void refuse(const std::string& why) const {
    std::string text = what;
    if (c == nullptr) {
      text += "(to " + in_quotes(b.name) + ", from " + in_quotes(a.name);
    } else {
      text += "(of " + in_quotes(b.name) + ", relative to " + in_quotes(a.name);
      if (o != nullptr) text += ", observed from " + in_quotes(o->name);
      text += ", in " + in_quotes(c->name);
    }
    throw BadInput(text + "): " + why);
  }
  [[noreturn, gnu::cold, gnu::noinline]] void no_path(const FrameRecord& from, const FrameRecord& to) const {
    refuse("no path, " + in_quotes(from.name) + " and " + in_quotes(to.name) + " are in two trees");
  }
  void require_two_frames() const {
    if (&a == &b) [[unlikely]]
      refuse("a frame does not move relative to itself; ask for two frames");
  }
  void require_level(std::span<const PathStep> steps, Level level) const {
    for (const PathStep& step : steps)
      if (step.edge->level() < level) [[unlikely]]
        refuse(described(*step.edge) + (level == Level::rate ? " has no rate" : " has no acceleration"));
  }
  void require_places(std::span<const PathStep> steps) const {
    for (const PathStep& step : steps)
      if (!step.edge->placed()) [[unlikely]]
        refuse(described(*step.edge) + " has no position");
  }
};

template <class Motions>
Square<double> rotation(const NamedGraphCore& core, const FrameRecord& b, const FrameRecord& a,
                        const Motions& motions) {
  return core.with_path(b, a, [&](const NamedPath* path) {
    if (path == nullptr) [[unlikely]]
      NamedQuery{"rotation", b, a}.no_path(a, b);
    return rotation_along(*path, motions);
  });
}

template <Level level, class Motions>
Column<double> rate(const NamedGraphCore& core, const FrameRecord& b, const FrameRecord& a,
                    const FrameRecord& c, const Motions& motions) {
  const NamedQuery query{level == Level::rate ? "angular_velocity" : "angular_acceleration", b, a, &c};
  query.require_two_frames();
  return core.with_path(a, b, [&](const NamedPath* to_b) {
    if (to_b == nullptr) query.no_path(a, b);
    query.require_level(to_b->steps, level);
    return core.with_path(a, c, [&](const NamedPath* to_c) {
      if (to_c == nullptr) query.no_path(a, c);
      return rate_between<level>(*to_b, *to_c, motions);
    });
  });
}

/// The motion of b relative to a, at the level.
template <Level level, class Motions>
PlacedMotion motion_between(const NamedQuery& query, const NamedGraphCore& core, const FrameRecord& a,
                            const FrameRecord& b, const Motions& motions) {
  return core.with_path(a, b, [&](const NamedPath* path) {
    if (path == nullptr) query.no_path(b, a);
    query.require_level(path->steps, level);
    query.require_places(path->steps);
    return motion_along<level>(path->steps, motions);
  });
}

/// r_pq^c; at the levels above the rotation v_pq|a^c or a_pq|a^c, as a sees it.
template <Level level, class Motions>
Column<double> place(const NamedQuery& query, const NamedGraphCore& core, const FrameRecord& a,
                     const Motions& motions) {
  const FrameRecord &q = query.b, &p = query.a, &c = *query.c;
  query.require_two_frames();
  return core.with_path(a, p, [&](const NamedPath* to_p) {
    if (to_p == nullptr) query.no_path(a, p);
    return core.with_path(a, q, [&](const NamedPath* to_q) {
      if (to_q == nullptr) query.no_path(a, q);
      return core.with_path(a, c, [&](const NamedPath* to_c) {
        if (to_c == nullptr) query.no_path(a, c);
        const PlacePaths paths(*to_p, *to_q, *to_c);
        query.require_level(paths.am, level);
        for (const auto& steps : {paths.mp, paths.mq}) {
          query.require_level(steps, level);
          query.require_places(steps);
        }
        return place_between<level>(paths, motions);
      });
    });
  });
}

/// Throws BadInput unless the time is finite.
inline double finite_time(double t) {
  if (!(t - t == 0.0)) [[unlikely]]
    throw BadInput("NamedGraph: the time is " + text(t) + " s");
  return t;
}

}  // namespace vectrix::detail

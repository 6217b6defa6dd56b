// Cases that prove nothing, each in its own way
struct Metres {};

void wait(int);
void wait(Metres) = delete;

namespace no_mistake {
// mistake: there is none
// expect: Metres
Metres use() {
#ifdef REPAIRED
#else
#endif
  return {};
}
}  // namespace no_mistake

namespace other_reason {
// mistake: refused, but not for the reason it gives
// expect: Metres
// expect: Gyroscope
#ifdef REPAIRED
Metres length;
#else
int length = Metres{};
#endif
}  // namespace other_reason

namespace only_its_name_says_so {
// mistake: the reason stands in the name of the case and in that of the file, not in the message
// expect: says_so|rejected
#ifdef REPAIRED
Metres length;
#else
int length = Metres{};
#endif
}  // namespace only_its_name_says_so

namespace bad_repair {
// mistake: a length is no number; and the repair compiles only with a warning
// expect: Metres
int use() {
#ifdef REPAIRED
  int shadowed = 1;
  {
    int shadowed = 2;
    return shadowed;
  }
#else
  return Metres{};
#endif
}
}  // namespace bad_repair

namespace long_message {
// mistake: eleven at once
// expect: Metres
void use() {
#ifdef REPAIRED
#else
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
  wait(Metres{});
#endif
}
}  // namespace long_message

// mistake: eleven at once
// expect: Metres
struct Metres {};

void wait(int);
void wait(Metres) = delete;

void use() {
#ifndef REPAIRED
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

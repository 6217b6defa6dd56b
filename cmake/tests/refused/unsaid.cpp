// A mistake that says nothing of what the compiler must answer.
#ifndef REPAIRED
int length = "long";
#endif

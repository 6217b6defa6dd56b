// mistake: only a header that does not exist
// expect: no_such_header
#ifndef REPAIRED
#include <vectrix/no_such_header.hpp>
#endif

#pragma once

namespace vectrix::detail {

#ifdef __x86_64__
template <class Function> [[gnu::target("avx2,fma")]] auto in_wide_registers(const Function& compute) {
  return compute();
}
#endif

/// compute(), with registers of four numbers and with multiplications and additions in one, as the C library
/// has its sines where the processor can. What it calls must be inlined for that, and so must compute itself.
template <class Function> auto fused(const Function& compute) {
#ifdef __x86_64__
  static const bool can = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (can) return in_wide_registers(compute);
#endif
  return compute();
}

}  // namespace vectrix::detail

// SPDX-License-Identifier: MIT
#include "croquis/skinning/kernels.h"

namespace croquis::skinning_kernels {

KernelList available_kernels() {
  static constexpr KernelSet kSets[] = {
      {"x86-64-v3", linear_x86_64_v3, dual_quaternion_x86_64_v3},
      {"portable", linear_portable, dual_quaternion_portable},
  };
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has_avx2 ? KernelList{kSets, 2} : KernelList{kSets + 1, 1};
}

}  // namespace croquis::skinning_kernels

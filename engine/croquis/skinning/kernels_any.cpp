// SPDX-License-Identifier: MIT
#include "croquis/skinning/kernels.h"

namespace croquis::skinning_kernels {

KernelList available_kernels() {
  static constexpr KernelSet kSets[] = {{"portable", linear_portable, dual_quaternion_portable}};
  return {kSets, 1};
}

}  // namespace croquis::skinning_kernels

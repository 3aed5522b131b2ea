// SPDX-License-Identifier: MIT
#include "fuzz/readers.h"
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)croquis::fuzz_bvh({reinterpret_cast<const std::byte*>(data), size});
  return 0;
}

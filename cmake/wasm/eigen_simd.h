// SPDX-License-Identifier: MIT
// clang calls itself GCC 4.2, for which Eigen 3.4 would pick x86 inline assembly in pmin and pmax.
#pragma once
#if defined(__cplusplus)
#include <Eigen/src/Core/util/Macros.h>
#undef EIGEN_COMP_GNUC
#define EIGEN_COMP_GNUC 120
#endif

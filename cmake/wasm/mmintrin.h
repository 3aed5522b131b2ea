// SPDX-License-Identifier: MIT
// Empty on purpose: Eigen asks for this x86-only header when SSE is on; emscripten's SSE headers do without it.
#pragma once

// SPDX-License-Identifier: MIT
#include "croquis/sketch/stroke.h"

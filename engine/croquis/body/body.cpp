// SPDX-License-Identifier: MIT
#include "croquis/body/body.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/body/animals.h"
#include "croquis/body/mannequin.h"
#include "croquis/body/tree.h"

namespace croquis {
namespace {

void check(const Proportions& p) {
  const auto want = [](const char* name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw_invalid_argument("proportions of a built-in character: " + std::string(name) + " is " + format_double(value) +
                           ", wanted " + format_double(low) + " to " + format_double(high));
  };
  want("heads", p.heads, 3.0, 9.0);
  want("shoulders", p.shoulders, 0.6, 1.6);
  want("hips", p.hips, 0.6, 1.6);
  want("limbs", p.limbs, 0.7, 1.4);
  want("hands", p.hands, 0.6, 1.8);
  want("head", p.head, 0.7, 1.6);
  want("muscle", p.muscle, 0.6, 1.6);
}

}  // namespace

std::vector<std::string> builtin_character_names() { return {"mannequin", "cat", "snake", "tree"}; }

bool is_builtin_character(std::string_view name) {
  const std::vector<std::string> names = builtin_character_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

Character make_builtin_character(std::string_view name, const Proportions& proportions) {
  check(proportions);
  if (name == "mannequin") return make_mannequin(proportions);
  if (name == "cat") return make_cat(proportions);
  if (name == "snake") return make_snake(proportions);
  if (name == "tree") return make_tree(proportions);
  throw_invalid_argument("no built-in character is named '" + printable(name) + "'; there are " +
                         join(builtin_character_names(), ", "));
}

}  // namespace croquis

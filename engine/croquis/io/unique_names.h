// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace croquis {

/// Gives out names of which none is given twice.
class UniqueNames {
 public:
  /// A name that may not be given out any more.
  void take(const std::string& name) { last_number_.try_emplace(name, 1); }

  /// `wanted`, or where that is taken `wanted` + `separator` + a number from 2 on.
  [[nodiscard]] std::string next(const std::string& wanted, std::string_view separator) {
    int& number = last_number_[wanted];  // stays valid while others are added
    std::string name = wanted;
    while (++number > 1) {
      name = wanted + std::string(separator) + std::to_string(number);
      if (last_number_.try_emplace(name, 1).second) break;
    }
    return name;
  }

 private:
  std::map<std::string, int> last_number_;  // of every name that is taken: the last that was tried with it
};

}  // namespace croquis

// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace croquis {

/// What kind of failure an Error reports; each face turns it into its own form (exit status, JavaScript `code`).
enum class ErrorCode {
  invalid_argument,  ///< the caller broke a promise: a size, a range, a name that is not there
  bad_file,          ///< data from outside is not what its format wants
  unsupported,       ///< the data is sound, but uses something Croquis does not do (named in the text)
  io,                ///< a file could not be opened, read or written
  internal,          ///< a bug of ours
};

/// The name that faces show: "invalid_argument", "bad_file", ...
[[nodiscard]] std::string_view to_string(ErrorCode code);

/// The one exception class of the engine: a code, and one line of text that names the place and what was wanted.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
  [[nodiscard]] ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

[[noreturn]] void throw_invalid_argument(const std::string& text);

/// Throws bad_file with "place: text"; `place` is a JSON pointer, "line 12", "byte 40", ...
[[noreturn]] void throw_bad_file(std::string_view place, std::string_view text);

}  // namespace croquis

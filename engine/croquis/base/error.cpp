// SPDX-License-Identifier: MIT
#include "croquis/base/error.h"

namespace croquis {

std::string_view to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
      return "invalid_argument";
    case ErrorCode::bad_file:
      return "bad_file";
    case ErrorCode::unsupported:
      return "unsupported";
    case ErrorCode::io:
      return "io";
    case ErrorCode::internal:
      return "internal";
  }
  return "internal";
}

void throw_invalid_argument(const std::string& text) { throw Error(ErrorCode::invalid_argument, text); }

void throw_bad_file(std::string_view place, std::string_view text) {
  std::string message(place);
  if (!message.empty()) message += ": ";
  message += text;
  throw Error(ErrorCode::bad_file, message);
}

}  // namespace croquis

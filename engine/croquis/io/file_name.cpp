// SPDX-License-Identifier: MIT
#include "croquis/io/file_name.h"

#include "croquis/base/text.h"

namespace croquis {
namespace {

std::string_view without_folder(std::string_view file_name) {
  const std::size_t slash = file_name.find_last_of("/\\");
  return slash == std::string_view::npos ? file_name : file_name.substr(slash + 1);
}

}  // namespace

std::string file_stem(std::string_view file_name) {
  const std::string_view name = without_folder(file_name);
  const std::size_t dot = name.find_last_of('.');
  return std::string(dot == std::string_view::npos || dot == 0 ? name : name.substr(0, dot));
}

std::string file_format(std::string_view file_name) {
  const std::string_view name = without_folder(file_name);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string_view::npos ? std::string() : to_lower(name.substr(dot + 1));
}

}  // namespace croquis

// SPDX-License-Identifier: MIT
#include "croquis/io/disk.h"

#include <fstream>
#include <random>
#include <system_error>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{2} << 30U;

[[noreturn]] void throw_io(const fs::path& path, const std::string& what) {
  throw Error(ErrorCode::io, "'" + printable(path.string(), 400) + "' " + what);
}

/// A name beside `path` that no other writer uses at the same time.
fs::path temporary_beside(const fs::path& path) {
  std::random_device random;
  fs::path temporary = path;
  temporary += "." + std::to_string(random()) + ".tmp";
  return temporary;
}

}  // namespace

Bytes read_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw_io(path, "is not there");
  if (fs::is_directory(status)) throw_io(path, "is a folder, wanted a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw_io(path, "cannot be opened for reading");
  Bytes bytes;
  // Read by pieces: a pipe or device has no size to ask for, and a file's size may be a lie.
  constexpr std::size_t kPiece = std::size_t{1} << 20U;
  if (fs::is_regular_file(status)) {
    const std::uintmax_t size = fs::file_size(path, error);
    if (!error && size > kLargestFile) throw_io(path, "is larger than 2 GiB");
    if (!error) bytes.reserve(static_cast<std::size_t>(size) + 1);
  }
  while (file) {
    const std::size_t had = bytes.size();
    if (had > kLargestFile) throw_io(path, "is larger than 2 GiB");
    bytes.resize(had + std::min(kPiece, std::max<std::size_t>(bytes.capacity() - had, 4096)));
    file.read(reinterpret_cast<char*>(bytes.data() + had), static_cast<std::streamsize>(bytes.size() - had));
    bytes.resize(had + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw_io(path, "cannot be read to its end");
  return bytes;
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw_io(path, "is a folder, wanted a file name");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    throw_io(folder, "is not a folder: cannot write '" + path.filename().string() + "'");
  // A link keeps pointing where it did, and what it points to is replaced.
  fs::path target = path;
  if (fs::is_symlink(path, error)) {
    const fs::path real = fs::weakly_canonical(path, error);
    if (!error) target = real;
  }
  // A device or pipe (/dev/stdout) cannot be replaced by renaming.
  const fs::file_status status = fs::status(target, error);
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  const fs::path temporary = in_place ? target : temporary_beside(target);
  {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    if (!file) throw_io(path, "cannot be opened for writing");
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
      if (!in_place) fs::remove(temporary, error);
      throw_io(path, "cannot be written: the disk may be full");
    }
  }
  if (in_place) return;
  if (fs::exists(status)) fs::permissions(temporary, status.permissions(), error);
  fs::rename(temporary, target, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    throw_io(path, "cannot be replaced: " + reason);
  }
}

ResourceReader resources_beside(const fs::path& path) {
  const fs::path folder = path.parent_path();
  return [folder](std::string_view uri) {
    const fs::path relative = fs::path(std::string(uri)).lexically_normal();
    if (uri.empty() || uri.find('\0') != std::string_view::npos || relative.is_absolute() || relative.has_root_name() ||
        *relative.begin() == "..") {
      throw Error(ErrorCode::io, "'" + printable(uri) + "' leads out of the folder of the file that names it");
    }
    return read_file(folder / relative);
  };
}

}  // namespace croquis

// SPDX-License-Identifier: MIT
// Source: obj (the Wavefront OBJ specification, version 3.0).
#include "croquis/io/obj.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/file_name.h"

namespace croquis {
namespace {

/// Indices into positions, texture coordinates and normals; -1: none.
using Corner = std::array<int, 3>;

class ObjReader {
 public:
  void read_line(std::string_view line, int number) {
    number_ = number;
    words_.clear();
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t begin = line.find_first_not_of(" \t\r", i);
      if (begin == std::string_view::npos) break;
      const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
      if (line[begin] == '#') break;
      words_.push_back(line.substr(begin, end - begin));
      i = end;
    }
    if (words_.empty()) return;
    const std::string_view key = words_[0];
    if (key == "v")
      positions_.push_back(read_vector<3>(3));
    else if (key == "vn")
      normals_.push_back(read_vector<3>(3));
    else if (key == "vt")
      uvs_.push_back(read_vector<2>(1));
    else if (key == "f")
      read_face();
    else if (key == "o" || key == "g")
      start_part(words_.size() > 1 ? std::string(words_[1]) : std::string());
    else
      known_ = known_ || key == "s" || key == "usemtl" || key == "mtllib" || key == "l" || key == "p";
  }

  std::vector<Part> take_parts() {
    finish_part();
    return std::move(parts_);
  }
  [[nodiscard]] bool has_anything() const { return known_ || !positions_.empty(); }

 private:
  [[noreturn]] void fail(const std::string& text) const { throw_bad_file("line " + std::to_string(number_), text); }

  template <int N>
  Eigen::Matrix<float, N, 1> read_vector(std::size_t least) const {
    if (words_.size() < 1 + least) {
      fail("wanted " + std::to_string(least) + " numbers after '" + printable(words_[0]) + "'");
    }
    Eigen::Matrix<float, N, 1> vector = Eigen::Matrix<float, N, 1>::Zero();
    for (std::size_t i = 0; i < N && 1 + i < words_.size(); ++i) {
      const auto number = parse_double(words_[1 + i]);
      const auto value = static_cast<float>(number.value_or(NAN));
      if (!std::isfinite(value)) fail("'" + printable(words_[1 + i]) + "' is no number");
      vector[static_cast<Eigen::Index>(i)] = value;
    }
    return vector;
  }

  /// 1-based, or counted back from the last one; 0-based comes out.
  int resolve(std::string_view text, std::size_t count, const char* what) const {
    const auto index = parse_int(text);
    const auto size = static_cast<long long>(count);
    if (!index || *index == 0 || *index > size || -static_cast<long long>(*index) > size) {
      fail(std::string(what) + " '" + printable(text) + "' is not there: there are " + std::to_string(count) +
           " so far");
    }
    return static_cast<int>(*index > 0 ? *index - 1 : size + *index);
  }

  std::uint32_t vertex_of(std::string_view text) {
    const std::size_t first = std::min(text.find('/'), text.size());
    const std::size_t second = std::min(text.find('/', std::min(first + 1, text.size())), text.size());
    const std::string_view uv = first < text.size() ? text.substr(first + 1, second - first - 1) : std::string_view();
    const std::string_view normal = second < text.size() ? text.substr(second + 1) : std::string_view();
    const Corner corner = {resolve(text.substr(0, first), positions_.size(), "vertex"),
                           uv.empty() ? -1 : resolve(uv, uvs_.size(), "texture coordinate"),
                           normal.empty() ? -1 : resolve(normal, normals_.size(), "normal")};
    const auto [it, is_new] = vertices_.try_emplace(corner, static_cast<std::uint32_t>(corners_.size()));
    if (is_new) corners_.push_back(corner);
    return it->second;
  }

  void read_face() {
    if (words_.size() < 4) fail("a face wants three corners, it has " + std::to_string(words_.size() - 1));
    const std::uint32_t first = vertex_of(words_[1]);
    std::uint32_t previous = vertex_of(words_[2]);
    for (std::size_t i = 3; i < words_.size(); ++i) {
      const std::uint32_t next = vertex_of(words_[i]);
      triangles_.insert(triangles_.end(), {first, previous, next});
      previous = next;
    }
  }

  void start_part(std::string name) {
    finish_part();
    name_ = std::move(name);
  }

  void finish_part() {
    if (!triangles_.empty()) {
      Part part;
      part.name = name_;
      bool uvs = true, normals = true;
      for (const Corner& corner : corners_) {
        uvs = uvs && corner[1] >= 0;
        normals = normals && corner[2] >= 0;
      }
      for (const Corner& corner : corners_) {
        part.mesh.positions.push_back(positions_[static_cast<std::size_t>(corner[0])]);
        if (uvs) {
          const Vec2f uv = uvs_[static_cast<std::size_t>(corner[1])];
          part.mesh.uvs.emplace_back(uv.x(), 1.0F - uv.y());
        }
        if (normals) {
          const Vec3f normal = normals_[static_cast<std::size_t>(corner[2])];
          const float length = normal.stableNorm();
          part.mesh.normals.push_back(length > 0.0F ? Vec3f(normal / length) : Vec3f::UnitY());
        }
      }
      part.mesh.triangles = std::move(triangles_);
      parts_.push_back(std::move(part));
    }
    triangles_.clear();
    corners_.clear();
    vertices_.clear();
  }

  int number_ = 0;
  bool known_ = false;
  std::vector<std::string_view> words_;
  std::vector<Vec3f> positions_, normals_;
  std::vector<Vec2f> uvs_;
  std::string name_;
  std::map<Corner, std::uint32_t> vertices_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> triangles_;
  std::vector<Part> parts_;
};

}  // namespace

Character read_obj(std::span<const std::byte> bytes, std::string_view file_name) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  ObjReader reader;
  std::string joined;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number;
    begin = end + 1;
    if (!line.empty() && line.back() == '\\') {  // goes on in the next line
      joined += line.substr(0, line.size() - 1);
      joined += ' ';
      continue;
    }
    joined += line;
    reader.read_line(joined, number);
    joined.clear();
  }
  reader.read_line(joined, number);
  if (!reader.has_anything()) throw_bad_file("line 1", "no OBJ: it holds no vertex");

  Character character{.name = file_stem(file_name), .skeleton = Skeleton({Joint{.name = "root"}})};
  character.start = rest_pose(character.skeleton);
  character.parts = reader.take_parts();
  if (character.parts.empty()) character.oddities.emplace_back("The file has no faces.");
  character.oddities.emplace_back("The file has no skeleton: the mesh hangs on one joint.");
  auto source = std::make_shared<SourceFile>();
  source->format = "obj";
  source->name = file_name;
  source->bytes.assign(bytes.begin(), bytes.end());
  character.source = std::move(source);
  try {
    character.check();
  } catch (const Error& error) {
    throw_bad_file("line " + std::to_string(number), error.what());
  }
  return character;
}

}  // namespace croquis

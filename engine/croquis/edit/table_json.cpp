// SPDX-License-Identifier: MIT
#include "croquis/edit/table_json.h"

#include <array>
#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/camera_json.h"
#include "croquis/rig/body_line.h"

namespace croquis {
namespace {

using Json = nlohmann::ordered_json;

std::string pointer(const char* name) { return "/" + std::string(name); }

double finite(const Json& value, const std::string& place) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) throw_bad_file(place, "wanted a finite number");
  return value.get<double>();
}

std::vector<double> numbers(const Json& value, std::size_t count, const std::string& place) {
  if (!value.is_array() || value.size() != count) throw_bad_file(place, "wanted " + std::to_string(count) + " numbers");
  std::vector<double> list;
  for (const Json& element : value) list.push_back(finite(element, place));
  return list;
}

std::string word(const Json& value, const std::string& place) {
  if (!value.is_string()) throw_bad_file(place, "wanted a text");
  return value.get<std::string>();
}

std::vector<int> indices(const Json& value, const std::string& place) {
  if (!value.is_array()) throw_bad_file(place, "wanted a list of whole numbers");
  std::vector<int> list;
  for (const Json& element : value) {
    if (!element.is_number_integer()) throw_bad_file(place, "wanted a list of whole numbers");
    list.push_back(element.get<int>());
  }
  return list;
}

const std::array<std::pair<const char*, std::string StrokeSettings::*>, 7> kWords{
    {{"method", &StrokeSettings::method},
     {"body_line", &StrokeSettings::body_line},
     {"plane", &StrokeSettings::plane},
     {"root", &StrokeSettings::root},
     {"direction", &StrokeSettings::direction},
     {"move", &StrokeSettings::move},
     {"length", &StrokeSettings::length}}};

const std::array<std::pair<const char*, double StrokeSettings::*>, 2> kFactors{
    {{"exaggerate", &StrokeSettings::exaggerate}, {"weight", &StrokeSettings::weight}}};

int count(const Json& value, const std::string& place) {
  if (!value.is_number_integer() || value.get<long long>() < 0 || value.get<long long>() > 1000) {
    throw_bad_file(place, "wanted a whole number from 0 to 1000");
  }
  return value.get<int>();
}

Json to_json(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json describe(const StrokeSettings& settings) {
  Json json;
  for (const auto& [name, member] : kWords) json[name] = settings.*member;
  for (const auto& [name, member] : kFactors) json[name] = settings.*member;
  json["joints"] = settings.joints;
  json["alternative"] = settings.alternative;
  json["depth"] = settings.depth;
  json["live"] = settings.live;
  return json;
}

Json describe(const BodyLine& line) { return {{"name", line.name}, {"joints", line.joints}}; }

Json describe_skeleton(const Character& character) {
  Json joints = Json::array();
  for (int i = 0; i < character.skeleton.joint_count(); ++i) {
    const Joint& joint = character.skeleton.joint(i);
    const std::optional<HumanoidBone> bone = character.humanoid.bone_of(i);
    joints.push_back({{"name", printable(joint.name, 200)},
                      {"parent", joint.parent},
                      {"helper", joint.helper},
                      {"bone", bone ? std::string(to_string(*bone)) : std::string()}});
  }
  return joints;
}

Json describe_parts(const Character& character, int& palette_size) {
  Json parts = Json::array();
  for (const Part& part : character.parts) {
    Json shapes = Json::array();
    for (const BlendShape& shape : part.shapes) shapes.push_back(printable(shape.name, 200));
    const Vec4f& color = part.material.base_color;
    parts.push_back({{"name", printable(part.name, 200)},
                     {"vertices", part.mesh.vertex_count()},
                     {"triangles", part.mesh.triangle_count()},
                     {"influences", part.skin ? part.skin->influences : 1},
                     {"shapes", shapes},
                     {"base_color", Json::array({color.x(), color.y(), color.z(), color.w()})},
                     {"has_image", part.material.base_color_image != nullptr},
                     {"double_sided", part.material.double_sided},
                     {"cut_out", part.material.cut_out},
                     {"palette_offset", palette_size}});
    palette_size += part.skin ? static_cast<int>(part.skin->joints.size()) : 1;
  }
  return parts;
}

Json describe(const Actor& actor) {
  const Character& character = *actor.character;
  Json json{{"id", actor.id}, {"name", printable(character.name, 200)}};
  json["format"] = character.source ? character.source->format : std::string();
  json["joints"] = describe_skeleton(character);
  int palette_size = 0;
  json["parts"] = describe_parts(character, palette_size);
  json["palette_size"] = palette_size;
  json["body_lines"] = Json::array();
  for (const BodyLine& line : standard_body_lines(character.skeleton, character.humanoid)) {
    json["body_lines"].push_back(describe(line));
  }
  json["clips"] = Json::array();
  for (const Clip& clip : character.clips) {
    json["clips"].push_back({{"name", printable(clip.name, 200)}, {"frames", clip.frame_count()}});
  }
  json["front"] = to_json(character.front);
  json["extent"] = character.skeleton.extent();
  json["licence"] = nullptr;
  if (character.licence) {
    Json terms = Json::object();
    for (const auto& [term, value] : character.licence->terms) terms[printable(term)] = printable(value, 300);
    json["licence"] = {{"title", printable(character.licence->title, 200)},
                       {"authors", printable(character.licence->authors, 200)},
                       {"name", printable(character.licence->name, 200)},
                       {"terms", terms}};
  }
  json["oddities"] = character.oddities;
  json["builtin"] = actor.builtin;
  json["proportions"] = actor.proportions.empty() ? Json::object() : Json(actor.proportions);
  json["pins"] = Json::array();
  for (const Pin& pin : actor.pins) {
    Json rotation = nullptr;
    if (pin.rotation)
      rotation = Json::array({pin.rotation->x(), pin.rotation->y(), pin.rotation->z(), pin.rotation->w()});
    json["pins"].push_back({{"joint", pin.joint}, {"position", to_json(pin.position)}, {"rotation", rotation}});
  }
  return json;
}

Json describe(const Project& project, const PlacedStroke& stroke) {
  Json samples = Json::array();
  for (const StrokeSample& s : stroke.stroke.samples) {
    samples.push_back(Json::array({s.position.x(), s.position.y(), s.time, s.pressure}));
  }
  return {{"id", stroke.id},
          {"actor", project.actors[static_cast<std::size_t>(stroke.actor)].id},
          {"camera", Json::parse(write_camera(stroke.camera))},
          {"samples", samples},
          {"settings", describe(stroke.settings)},
          {"hidden", stroke.hidden},
          {"line", describe(stroke.line)}};
}

}  // namespace

TableArguments::TableArguments(std::string_view json) : json_(Json::parse(json, nullptr, false)) {
  if (!json_.is_object()) throw_bad_file("", "wanted a command as a JSON object");
}

bool TableArguments::has(const char* name) const { return json_.contains(name); }

const Json& TableArguments::at(const char* name) const {
  const auto found = json_.find(name);
  if (found == json_.end()) throw_bad_file(pointer(name), "is missing");
  return *found;
}

double TableArguments::number(const char* name) const { return finite(at(name), pointer(name)); }

int TableArguments::integer(const char* name) const {
  if (!at(name).is_number_integer()) throw_bad_file(pointer(name), "wanted a whole number");
  return at(name).get<int>();
}

bool TableArguments::flag(const char* name) const {
  if (!at(name).is_boolean()) throw_bad_file(pointer(name), "wanted true or false");
  return at(name).get<bool>();
}

std::string TableArguments::text(const char* name) const { return word(at(name), pointer(name)); }

std::vector<int> TableArguments::integers(const char* name) const { return indices(at(name), pointer(name)); }

Vec3 TableArguments::point(const char* name) const {
  const std::vector<double> v = numbers(at(name), 3, pointer(name));
  return {v[0], v[1], v[2]};
}

Quat TableArguments::rotation(const char* name) const {
  const std::vector<double> v = numbers(at(name), 4, pointer(name));
  const Quat q(v[3], v[0], v[1], v[2]);
  if (q.norm() < 1e-9) throw_bad_file(pointer(name), "wanted a quaternion that is not zero");
  return q.normalized();
}

std::vector<StrokeSample> TableArguments::samples(const char* name) const {
  if (!at(name).is_array()) throw_bad_file(pointer(name), "wanted a list of samples");
  std::vector<StrokeSample> list;
  for (const Json& element : at(name)) {
    const std::vector<double> v = numbers(element, 4, pointer(name) + "/" + std::to_string(list.size()));
    list.push_back({Vec2(v[0], v[1]), v[2], v[3]});
  }
  return list;
}

Camera TableArguments::camera(const char* name) const {
  const std::string text = at(name).dump();
  return read_camera(std::as_bytes(std::span(text)));
}

StrokeSettings TableArguments::stroke_settings(const char* name, const StrokeSettings& base) const {
  StrokeSettings settings = base;
  const Json& json = at(name);
  for (const auto& [field, member] : kWords) {
    if (json.contains(field)) settings.*member = word(json[field], pointer(name) + "/" + field);
  }
  for (const auto& [field, member] : kFactors) {
    if (json.contains(field)) settings.*member = finite(json[field], pointer(name) + "/" + field);
  }
  if (json.contains("joints")) settings.joints = indices(json["joints"], pointer(name) + "/joints");
  const auto put_count = [&](const char* field, int& value) {
    if (json.contains(field)) value = count(json[field], pointer(name) + "/" + field);
  };
  put_count("alternative", settings.alternative);
  put_count("depth", settings.depth);
  if (json.contains("live")) settings.live = json["live"] == true;
  return settings;
}

TableSettings TableArguments::table_settings(const char* name, const TableSettings& base) const {
  TableSettings settings = base;
  const Json& json = at(name);
  if (json.contains("limits")) settings.limits = word(json["limits"], pointer(name) + "/limits");
  if (json.contains("root")) settings.root = word(json["root"], pointer(name) + "/root");
  const auto put_flag = [&](const char* field, bool& flag) {
    if (!json.contains(field)) return;
    if (!json[field].is_boolean()) throw_bad_file(pointer(name) + "/" + field, "wanted true or false");
    flag = json[field].get<bool>();
  };
  put_flag("floor", settings.floor);
  put_flag("balance", settings.balance);
  return settings;
}

std::map<std::string, double> TableArguments::numbers_by_name(const char* name) const {
  std::map<std::string, double> list;
  if (!has(name)) return list;
  if (!at(name).is_object()) throw_bad_file(pointer(name), "wanted an object of numbers");
  for (const auto& [key, value] : at(name).items()) list[key] = finite(value, pointer(name) + "/" + printable(key));
  return list;
}

StrokeSettings default_stroke_settings(const Project& project) {
  StrokeSettings settings;
  settings.body_line = "auto";
  settings.live = true;
  settings.root = project.settings.root;
  return settings;
}

Proportions read_proportions(const std::map<std::string, double>& by_name) {
  Proportions proportions;
  for (const auto& [key, value] : by_name) {
    bool known = false;
    for (const auto& [name, member] : kProportions) {
      if (key != name) continue;
      proportions.*member = value;
      known = true;
    }
    if (!known) throw_invalid_argument("there is no proportion '" + printable(key) + "'");
  }
  return proportions;
}

Json describe_project(const Project& project) {
  Json json;
  json["actors"] = Json::array();
  for (const Actor& actor : project.actors) json["actors"].push_back(describe(actor));
  json["strokes"] = Json::array();
  for (const PlacedStroke& stroke : project.strokes) json["strokes"].push_back(describe(project, stroke));
  json["settings"] = {{"limits", project.settings.limits},
                      {"floor", project.settings.floor},
                      {"balance", project.settings.balance},
                      {"root", project.settings.root}};
  json["views"] = Json::array();
  for (const NamedView& view : project.views) {
    json["views"].push_back({{"name", printable(view.name, 200)}, {"camera", Json::parse(write_camera(view.camera))}});
  }
  json["poses"] = Json::array();
  for (const NamedPose& pose : project.poses) {
    json["poses"].push_back(
        {{"name", printable(pose.name, 200)}, {"actor", project.actors[static_cast<std::size_t>(pose.actor)].id}});
  }
  return json;
}

Json describe_line(const DrawnStroke& drawn) {
  Json alternatives = Json::array();
  for (const std::string& label : drawn.readings) alternatives.push_back({{"label", label}});
  return {{"status", drawn.report.status},
          {"line", describe(drawn.line)},
          {"alternatives", alternatives},
          {"chosen", drawn.chosen},
          {"solve_ms", drawn.report.solve_ms}};
}

}  // namespace croquis

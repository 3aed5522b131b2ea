// SPDX-License-Identifier: MIT
#include "croquis/rig/joint_name.h"

#include <algorithm>
#include <span>

#include "croquis/base/text.h"

namespace croquis {
namespace {

struct Word {
  std::string_view text;
  NameRole role;
  double certainty;
};

/// Words run together, in lower case, without side and numbers. Several lines for one word: it depends on the rig
/// (Mixamo's LeftLeg is a shin, MMD's a thigh; a shoulder is a clavicle or, in Biovision's files, an upper arm).
constexpr Word kWords[] = {
    // clang-format off
    {"hips", NameRole::hips, 1}, {"hipjoint", NameRole::carrier, 1}, {"hip", NameRole::hips, 0.9}, {"pelvis", NameRole::hips, 1}, {"cog", NameRole::hips, 0.3},
    {"spine", NameRole::spine, 1}, {"abdomen", NameRole::spine, 1}, {"abdomenlower", NameRole::spine, 1},
    {"abdomenupper", NameRole::spine, 1}, {"torso", NameRole::spine, 0.9}, {"waist", NameRole::spine, 0.9},
    {"ab", NameRole::spine, 0.8}, {"belly", NameRole::spine, 0.7}, {"stomach", NameRole::spine, 0.7},
    {"back", NameRole::spine, 0.6}, {"lowerback", NameRole::spine, 1}, {"upperback", NameRole::spine, 1},
    {"chest", NameRole::spine, 1}, {"chestlower", NameRole::spine, 1}, {"chestupper", NameRole::spine, 1},
    {"upperchest", NameRole::spine, 1}, {"lowerchest", NameRole::spine, 1}, {"ribcage", NameRole::spine, 0.9},
    {"thorax", NameRole::spine, 1}, {"lumbar", NameRole::spine, 1}, {"spinelower", NameRole::spine, 1},
    {"spineupper", NameRole::spine, 1}, {"spinemid", NameRole::spine, 1}, {"上半身", NameRole::spine, 1},
    {"下半身", NameRole::hips, 0.7}, {"センター", NameRole::hips, 0.4},
    {"neck", NameRole::neck, 1}, {"lowerneck", NameRole::neck, 1}, {"upperneck", NameRole::neck, 1},
    {"necklower", NameRole::neck, 1}, {"neckupper", NameRole::neck, 1}, {"necktwist", NameRole::neck, 1},
    {"首", NameRole::neck, 1}, {"head", NameRole::head, 1}, {"頭", NameRole::head, 1},
    {"eye", NameRole::eye, 1}, {"eyeball", NameRole::eye, 1}, {"目", NameRole::eye, 1}, {"jaw", NameRole::jaw, 1},
    {"lowerjaw", NameRole::jaw, 1}, {"jawlower", NameRole::jaw, 0.9},
    {"clavicle", NameRole::shoulder, 1}, {"collar", NameRole::shoulder, 1}, {"collarbone", NameRole::shoulder, 1},
    {"shoulder", NameRole::shoulder, 0.8}, {"shoulder", NameRole::upper_arm, 0.6}, {"肩", NameRole::shoulder, 1},
    {"upperarm", NameRole::upper_arm, 1}, {"uparm", NameRole::upper_arm, 1}, {"armupper", NameRole::upper_arm, 1},
    {"shldr", NameRole::upper_arm, 1}, {"shldrbend", NameRole::upper_arm, 1}, {"bicep", NameRole::upper_arm, 0.8},
    {"humerus", NameRole::upper_arm, 1}, {"arm", NameRole::upper_arm, 0.7}, {"arm", NameRole::lower_arm, 0.4},
    {"arm", NameRole::hand, 0.2}, {"腕", NameRole::upper_arm, 1},
    {"lowerarm", NameRole::lower_arm, 1}, {"lowarm", NameRole::lower_arm, 1}, {"loarm", NameRole::lower_arm, 1},
    {"armlower", NameRole::lower_arm, 1}, {"forearm", NameRole::lower_arm, 1}, {"forearmbend", NameRole::lower_arm, 1},
    {"elbow", NameRole::lower_arm, 1}, {"radius", NameRole::lower_arm, 0.8}, {"ulna", NameRole::lower_arm, 0.8},
    {"ひじ", NameRole::lower_arm, 1}, {"hand", NameRole::hand, 1}, {"wrist", NameRole::hand, 0.9},
    {"palm", NameRole::hand, 0.5}, {"palm", NameRole::carrier, 0.5}, {"手首", NameRole::hand, 1},
    {"thigh", NameRole::upper_leg, 1}, {"thighbend", NameRole::upper_leg, 1}, {"upperleg", NameRole::upper_leg, 1},
    {"upleg", NameRole::upper_leg, 1}, {"legupper", NameRole::upper_leg, 1}, {"femur", NameRole::upper_leg, 1},
    {"leg", NameRole::upper_leg, 0.6}, {"leg", NameRole::lower_leg, 0.6}, {"leg", NameRole::foot, 0.2},
    {"leg", NameRole::toes, 0.1}, {"足", NameRole::upper_leg, 1},
    {"lowerleg", NameRole::lower_leg, 1}, {"lowleg", NameRole::lower_leg, 1}, {"loleg", NameRole::lower_leg, 1},
    {"leglower", NameRole::lower_leg, 1}, {"calf", NameRole::lower_leg, 1}, {"shin", NameRole::lower_leg, 1},
    {"knee", NameRole::lower_leg, 1}, {"shank", NameRole::lower_leg, 1}, {"tibia", NameRole::lower_leg, 1},
    {"ひざ", NameRole::lower_leg, 1}, {"foot", NameRole::foot, 1}, {"ankle", NameRole::foot, 0.9},
    {"足首", NameRole::foot, 1}, {"toe", NameRole::toes, 1}, {"toes", NameRole::toes, 1},
    {"toebase", NameRole::toes, 1}, {"ball", NameRole::toes, 0.9}, {"forefoot", NameRole::toes, 1},
    {"つま先", NameRole::toes, 1},
    {"thumb", NameRole::thumb, 1}, {"thumbfinger", NameRole::thumb, 1}, {"親指", NameRole::thumb, 1},
    {"index", NameRole::index, 1}, {"indexfinger", NameRole::index, 1}, {"人指", NameRole::index, 1},
    {"middle", NameRole::middle, 1}, {"middlefinger", NameRole::middle, 1}, {"mid", NameRole::middle, 0.9},
    {"中指", NameRole::middle, 1}, {"ring", NameRole::ring, 1}, {"ringfinger", NameRole::ring, 1},
    {"薬指", NameRole::ring, 1}, {"little", NameRole::little, 1}, {"littlefinger", NameRole::little, 1},
    {"pinky", NameRole::little, 1}, {"pinkie", NameRole::little, 1}, {"pinkyfinger", NameRole::little, 1},
    {"小指", NameRole::little, 1}, {"finger", NameRole::finger, 1}, {"fingers", NameRole::finger, 0.5},
    {"thumbmetacarpal", NameRole::thumb, 1}, {"fingerbase", NameRole::carrier, 1},
    {"inhandindex", NameRole::carrier, 1}, {"inhandmiddle", NameRole::carrier, 1},
    {"inhandring", NameRole::carrier, 1}, {"inhandpinky", NameRole::carrier, 1}, {"scapula", NameRole::shoulder, 0.9},
    {"metatarsal", NameRole::toes, 0.4}, {"metatarsals", NameRole::toes, 0.4}, {"metacarpal", NameRole::carrier, 1}, {"carpal", NameRole::carrier, 1},
    // clang-format on
};

/// A name with one of these words is no part of the body itself, unless all its words together are in the list above.
constexpr std::string_view kIgnored[] = {
    "ik",     "fk",      "pole",  "target", "tgt",   "control", "ctrl",      "twist",    "helper",
    "end",    "tip",     "nub",   "leaf",   "top",   "slot",    "socket",    "weapon",   "prop",
    "hair",   "skirt",   "cloth", "breast", "bust",  "spring",  "tail",      "wing",     "feather",
    "fin",    "beak",    "mouth", "tongue", "teeth", "tooth",   "ear",       "nose",     "front",
    "hind",   "rear",    "paw",   "hoof",   "org",   "mch",     "roll",      "collider", "dummy",
    "site",   "rump",    "cheek", "lip",    "brow",  "eyelid",  "eyebrow",   "buttock",  "muscle",
    "anchor", "holster", "sec",   "null",   "bow",   "volume",  "corrective"};

/// Words that rigs put before (or after) every name.
constexpr std::string_view kNeutral[] = {
    "mixamorig", "def",    "bip", "cc",   "base", "j",        "c",        "b",        "character",  "joint",
    "jnt",       "bone",   "bn",  "sk",   "rig",  "skeleton", "armature", "valve",    "valvebiped", "biped",
    "bind",      "f",      "m",   "jt",   "root", "human",    "body",     "proximal", "distal",     "intermediate",
    "phalanx",   "medial", "hik", "skel", "g",    "cf",       "ref"};

bool contains(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return is_lower(c) || is_upper(c) || static_cast<unsigned char>(c) >= 0x80; }

struct Piece {
  std::string text;  ///< lower case, or the digits
  std::size_t begin, end;
};

/// Words and numbers: apart at every other character, between letters and digits, before a capital that follows a small
/// letter or that small letters follow ("LHipJoint" -> l hip joint).
std::vector<Piece> split_words(std::string_view name) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < name.size();) {
    if (!is_digit(name[i]) && !is_letter(name[i])) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    if (is_digit(name[i])) {
      while (end < name.size() && is_digit(name[end])) ++end;
    } else {
      for (; end < name.size() && is_letter(name[end]); ++end) {
        const bool after_small = !is_upper(name[end - 1]) && is_upper(name[end]);
        const bool before_small = is_upper(name[end]) && end + 1 < name.size() && is_lower(name[end + 1]);
        if (after_small || before_small) break;
      }
    }
    pieces.push_back({to_lower(name.substr(i, end - i)), i, end});
    i = end;
  }
  return pieces;
}

NameSide side_of(std::string_view word) {
  if (word == "left" || word == "l" || word == "lft") return NameSide::left;
  if (word == "right" || word == "r" || word == "rgt") return NameSide::right;
  return NameSide::none;
}

bool is_known(std::string_view text) {
  return std::any_of(std::begin(kWords), std::end(kWords), [&](const Word& word) { return word.text == text; });
}

/// A side glued to a word without a capital ("lhand", "leftarm", "thighl"); the side is cut off `word`.
NameSide cut_glued_side(std::string& word) {
  static constexpr std::string_view kMarks[] = {"left", "right", "l", "r", "左", "右"};
  if (is_known(word)) return NameSide::none;
  for (std::size_t i = 0; i < std::size(kMarks); ++i) {
    const std::string_view mark = kMarks[i];
    const NameSide side = i % 2 == 0 ? NameSide::left : NameSide::right;
    if (word.size() <= mark.size()) continue;
    if (word.starts_with(mark) && is_known(std::string_view(word).substr(mark.size()))) {
      word.erase(0, mark.size());
      return side;
    }
    if (word.ends_with(mark) && is_known(std::string_view(word).substr(0, word.size() - mark.size()))) {
      word.resize(word.size() - mark.size());
      return side;
    }
  }
  return NameSide::none;
}

std::string_view without_namespace(std::string_view name) {
  const std::size_t at = name.find_last_of(":|/");
  return at == std::string_view::npos || at + 1 == name.size() ? name : name.substr(at + 1);
}

/// Reads the longest run of words at the end that stands in the vocabulary; returns where it begins.
std::size_t look_up(const std::vector<std::string>& words, JointName& result) {
  for (std::size_t first = 0; first < words.size(); ++first) {
    std::string together;
    for (std::size_t i = first; i < words.size(); ++i) together += words[i];
    if (!is_known(together)) continue;
    const bool strange = std::any_of(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(first),
                                     [](const auto& w) { return !contains(kNeutral, w) && !is_known(w); });
    for (const Word& word : kWords) {
      if (word.text != together) continue;
      // A hip with a side is where the leg begins.
      const bool leg = word.text == "hip" && result.side != NameSide::none;
      result.roles.emplace_back(leg ? NameRole::upper_leg : word.role, word.certainty * (strange ? 0.6 : 1.0));
    }
    return first;
  }
  return words.size();
}

/// MikuMikuDance numbers its joints with full-width digits (U+FF10 ...).
std::string with_plain_digits(std::string_view name) {
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = [&](std::size_t at) { return at < name.size() ? static_cast<unsigned char>(name[at]) : 0U; };
    if (byte(i) == 0xef && byte(i + 1) == 0xbc && byte(i + 2) >= 0x90 && byte(i + 2) <= 0x99) {
      plain += static_cast<char>('0' + (byte(i + 2) - 0x90));
      i += 2;
    } else {
      plain += name[i];
    }
  }
  return plain;
}

}  // namespace

double JointName::affinity(NameRole role) const {
  if (ignored) return -2.0;
  for (const auto& [may_be, certainty] : roles) {
    if (may_be == role) return certainty;
  }
  return roles.empty() ? 0.0 : -1.0;
}

bool JointName::says_nothing() const { return !ignored && roles.empty(); }

int JointName::number() const { return numbers.empty() ? -1 : parse_int(numbers.front()).value_or(-1); }

JointName read_joint_name(std::string_view name) {
  JointName result;
  std::vector<std::string> words;
  const std::string plain = with_plain_digits(name);
  for (Piece& piece : split_words(without_namespace(plain))) {
    if (is_digit(piece.text.front())) {
      result.numbers.push_back(piece.text);
      continue;
    }
    NameSide side = side_of(piece.text);
    if (side == NameSide::none) {
      side = cut_glued_side(piece.text);
      words.push_back(piece.text);
      result.numbers.clear();
    }
    if (result.side == NameSide::none) result.side = side;
  }
  auto first = static_cast<std::ptrdiff_t>(look_up(words, result));
  for (; result.roles.empty() && words.size() > 1 && contains(kNeutral, words.back());) {
    words.pop_back();
    first = static_cast<std::ptrdiff_t>(look_up(words, result));
  }
  result.ignored =
      name.starts_with("__") ||  // connectors that an exporter has put in
      std::any_of(words.begin(), words.begin() + first, [](const auto& w) { return contains(kIgnored, w); });
  return result;
}

std::pair<NameSide, std::string> split_side(std::string_view name) {
  std::string rest = to_lower(name);
  std::vector<Piece> pieces = split_words(name);
  for (Piece& piece : pieces) {
    NameSide side = side_of(piece.text);
    if (side != NameSide::none) {
      rest.replace(piece.begin, piece.end - piece.begin, "*");
      return {side, rest};
    }
    const std::string whole = piece.text;
    side = cut_glued_side(piece.text);
    if (side != NameSide::none) {
      const bool in_front = whole.ends_with(piece.text);
      rest.replace(piece.begin, piece.end - piece.begin, in_front ? "*" + piece.text : piece.text + "*");
      return {side, rest};
    }
  }
  return {NameSide::none, rest};
}

}  // namespace croquis

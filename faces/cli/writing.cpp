// SPDX-License-Identifier: MIT
#include "cli/writing.h"

#include "croquis/base/error.h"
#include "croquis/edit/frame.h"

namespace croquis::cli {

WrittenFile to_file(const Project& project, const std::string& format, const std::string& file_name,
                    const WriteOptions& options) {
  if (format == "croquis") {
    if (options.form != PoseForm::pose) {
      throw_invalid_argument(file_name + ": a project keeps pose and character apart already; --as is for other files");
    }
    return {write_project(project), {}};
  }
  const Actor& actor = project.actors.front();
  WriteOptions complete = options;
  if (options.form == PoseForm::baked) complete.baked = bake_parts(*actor.character, actor.pose);
  return write_character(*actor.character, actor.pose, format, file_name, complete);
}

std::vector<std::string> notices_for(const Character& character, const std::string& format, PoseForm form) {
  std::vector<std::string> notices;
  if (format == "bvh" || format == "croquis" || form != PoseForm::pose) return notices;
  const bool vrm = character.source && character.source->format == "vrm";
  if (!character.clips.empty()) {
    notices.push_back("the file keeps its " + std::to_string(character.clips.size()) +
                      (character.clips.size() == 1 ? " clip" : " clips") +
                      ": most viewers play that instead of showing the pose; --as clip adds the pose as a clip, --as "
                      "baked leaves nothing to play");
  }
  if (vrm) {
    notices.push_back(
        "programs that open a VRM take its joints for a T-pose; --as clip keeps the T-pose and adds the pose as a "
        "clip");
  }
  return notices;
}

}  // namespace croquis::cli

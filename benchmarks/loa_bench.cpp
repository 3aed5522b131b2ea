// SPDX-License-Identifier: MIT
// The lines-of-action benchmark: takes poses of motion-capture clips, draws the line that a person would see of them
// over the clip's neutral pose, and measures how near each method's answer comes to the pose that was meant.
//   loa_bench --clips DIR [--poses N] [--seed S] [--views N] [--known-line | --unknown-direction | --auto | --live |
//             --spread] [--noise PERCENT] [--json OUT] [--method NAME]
#include "loa/draws.h"
#include "loa/measures.h"
#include "loa/methods.h"
#include "loa/trials.h"
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"

namespace croquis::loa {
namespace {

struct Arguments {
  std::string clips, json, method;
  DrawOptions draws;
  bool direction_known = true, find_line = false, live = false, spread = false;
};

Arguments parse(int count, char** words) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const auto next = [&] {
      if (i + 1 >= count) throw_invalid_argument(word + ": wanted a value");
      return std::string(words[++i]);
    };
    if (word == "--clips")
      arguments.clips = next();
    else if (word == "--poses")
      arguments.draws.poses = std::atoi(next().c_str());
    else if (word == "--seed")
      arguments.draws.seed = static_cast<std::uint64_t>(std::atoll(next().c_str()));
    else if (word == "--views")
      arguments.draws.views = std::atoi(next().c_str());
    else if (word == "--noise")
      arguments.draws.noise_percent = std::atof(next().c_str());
    else if (word == "--unknown-direction")
      arguments.direction_known = false;
    else if (word == "--known-line")
      arguments.direction_known = true;
    else if (word == "--auto")
      arguments.find_line = true;
    else if (word == "--live")
      arguments.live = true;
    else if (word == "--spread")
      arguments.spread = true;
    else if (word == "--json")
      arguments.json = next();
    else if (word == "--method")
      arguments.method = next();
    else
      throw_invalid_argument("unknown argument " + word);
  }
  if (arguments.clips.empty()) throw_invalid_argument("--clips DIR is missing");
  return arguments;
}

struct Row {
  std::vector<double> e2d, tangent, e3d, fit, drift, milliseconds;
  int violating = 0;  // answers that exceed anatomical limits which the start keeps
  std::map<std::string, std::vector<double>> e2d_by_line;
};

Row run(const Method& method, const DrawSet& set) {
  Row row;
  for (const Draw& draw : set.draws) {
    const std::clock_t begin = std::clock();  // processor time
    const Pose answer = method.answer(draw);
    const double taken = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const Measure m = measure(draw, answer);
    row.e2d.push_back(m.e2d);
    row.tangent.push_back(m.tangent);
    row.e3d.push_back(m.e3d);
    row.fit.push_back(m.fit);
    row.drift.push_back(m.drift);
    if (!broken_limits(draw, LimitPreset::anatomical, answer).empty()) ++row.violating;
    row.milliseconds.push_back(taken);
    row.e2d_by_line[draw.line.name].push_back(m.e2d);
  }
  return row;
}

nlohmann::ordered_json to_json(const std::vector<double>& values) {
  const Summary s = summarise(values);
  return {{"mean", s.mean}, {"median", s.median}, {"p90", s.p90}, {"p95", s.p95}};
}

void print_methods(const Arguments& arguments, const DrawSet& set, nlohmann::ordered_json& report) {
  std::printf(
      "| %-16s | e2D, %% H | 90 %% | tangent | e3D, %% H | 90 %% | fit, %% H | outside limits | ms p50 / p95 |\n",
      "method");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  std::map<std::string, Row> rows;
  for (const Method& method : all_methods(arguments.direction_known)) {
    if (!arguments.method.empty() && method.name != arguments.method) continue;
    const Row& row = rows[method.name] = run(method, set);
    const Summary a = summarise(row.e2d), t = summarise(row.tangent), d = summarise(row.e3d), f = summarise(row.fit),
                  ms = summarise(row.milliseconds);
    std::printf(
        "| %-16s | %.2f / %.2f | %.1f | %.1f / %.1f | %.2f / %.2f | %.1f | %.2f / %.2f | %.0f %% | %.2f / %.2f |\n",
        method.name.c_str(), a.mean, a.median, a.p90, t.mean, t.median, d.mean, d.median, d.p90, f.mean, f.median,
        100.0 * row.violating / static_cast<double>(set.draws.size()), ms.median, ms.p95);
    std::fflush(stdout);
    report["methods"][method.name] = {{"e2d", to_json(row.e2d)},        {"tangent", to_json(row.tangent)},
                                      {"e3d", to_json(row.e3d)},        {"fit", to_json(row.fit)},
                                      {"drift", to_json(row.drift)},    {"outside_limits", row.violating},
                                      {"ms", to_json(row.milliseconds)}};
  }
  if (rows.count("line") > 0) {
    std::printf("\nline solver by line (e2D mean / median):\n");
    for (const auto& [name, values] : rows["line"].e2d_by_line) {
      const Summary s = summarise(values);
      std::printf("  %-22s %4zu draws  %.2f / %.2f\n", name.c_str(), values.size(), s.mean, s.median);
    }
  }
}

int main_of(int count, char** words) {
  const Arguments arguments = parse(count, words);
  const DrawSet set = make_draws(arguments.clips, arguments.draws);
  nlohmann::ordered_json report{{"clips", set.clips.size()}, {"draws", set.draws.size()}};
  for (const std::string& note : set.notes) std::printf("left out: %s\n", note.c_str());
  std::printf("%zu clips, %zu draws; left out: %d lines shorter than 0.15 H, %d that ask for less than 0.06 H\n\n",
              set.clips.size(), set.draws.size(), set.too_short, set.too_easy);
  if (arguments.find_line) {
    print_line_trial(set, report);
  } else if (arguments.live) {
    print_live_trial(set, report);
  } else if (arguments.spread) {
    print_spreads(set, report);
  } else {
    print_truths(set, report);
    print_methods(arguments, set, report);
  }
  if (!arguments.json.empty()) std::ofstream(arguments.json) << report.dump(2) << '\n';
  return 0;
}

}  // namespace
}  // namespace croquis::loa

int main(int count, char** words) {
  try {
    return croquis::loa::main_of(count, words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "loa_bench: %s\n", error.what());
    return 2;
  }
}

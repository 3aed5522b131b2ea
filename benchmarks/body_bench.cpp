// SPDX-License-Identifier: MIT
// What it takes to make the built-in characters: the mannequin is what the studio waits for when it opens.
#include <string>

#include <benchmark/benchmark.h>

#include "croquis/body/body.h"
#include "croquis/body/mannequin.h"
#include "croquis/body/polygonize.h"
#include "croquis/body/remesh.h"

namespace croquis {
namespace {

void make_character(benchmark::State& state, const std::string& name) {
  for (auto _ : state) {
    Character character = make_builtin_character(name);
    benchmark::DoNotOptimize(character.parts.front().mesh.positions.data());
  }
}

Limb mannequin_half() {
  const MannequinMeasures measures{Proportions{}};
  const Armature armature = make_mannequin_armature(measures);
  Limb root = make_trunk(measures, armature);
  root.limbs.push_back(make_head(measures, armature));
  root.limbs.push_back(make_arm(measures, armature));
  root.limbs.push_back(make_leg(measures, armature));
  return root;
}

void polygonize_mannequin(benchmark::State& state) {
  const ImplicitSurface surface(mannequin_half(), true);
  for (auto _ : state) benchmark::DoNotOptimize(polygonize(surface).positions.data());
}
BENCHMARK(polygonize_mannequin)->Unit(benchmark::kMillisecond);

void remesh_mannequin(benchmark::State& state) {
  const ImplicitSurface surface(mannequin_half(), true);
  const Triangulation mesh = polygonize(surface);
  for (auto _ : state) benchmark::DoNotOptimize(remesh(surface, mesh).positions.data());
}
BENCHMARK(remesh_mannequin)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace croquis

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const std::string& name : croquis::builtin_character_names()) {
    benchmark::RegisterBenchmark(name.c_str(), [name](benchmark::State& state) {
      croquis::make_character(state, name);
    })->Unit(benchmark::kMillisecond);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

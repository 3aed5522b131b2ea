// SPDX-License-Identifier: MIT
// What `croquis render` of a character of some 55,000 triangles at 1024 x 1024 costs: a renderer of its own, the
// picture, the PNG. Two mannequins in one character stand in for such a one.
#include <benchmark/benchmark.h>

#include "croquis/body/body.h"
#include "croquis/edit/view.h"
#include "croquis/picture/picture.h"

namespace croquis {
namespace {

Character make_crowd() {
  Character character = make_builtin_character("mannequin");
  Part second = character.parts.front();
  for (Vec3f& position : second.mesh.positions) position += Vec3f(0.35F, 0.0F, -0.6F);
  character.parts.push_back(std::move(second));
  return character;
}

struct Table {
  std::vector<Actor> actors;
  Camera camera;
  std::vector<PictureActor> shown;

  Table() {
    Actor actor;
    actor.character = std::make_shared<const Character>(make_crowd());
    actor.pose = actor.character->start;
    actors.push_back(std::move(actor));
    camera = make_named_view(actors, View::three_quarter, 1024, 1024);
    shown.push_back({actors.front().character.get(), &actors.front().pose});
  }
};

const Table& table() {
  static const Table made;
  return made;
}

void render_once(benchmark::State& state) {
  const Table& t = table();
  for (auto _ : state) benchmark::DoNotOptimize(encode_png(render_picture(t.shown, t.camera, {}, {})));
  int triangles = 0;
  for (const Part& part : t.actors.front().character->parts) triangles += part.mesh.triangle_count();
  state.counters["triangles"] = triangles;
}

void render_again(benchmark::State& state) {
  const Table& t = table();
  PictureRenderer renderer;
  for (auto _ : state) benchmark::DoNotOptimize(renderer.render(t.shown, t.camera));
}

void encode(benchmark::State& state) {
  const Image image = render_picture(table().shown, table().camera, {}, {});
  for (auto _ : state) benchmark::DoNotOptimize(encode_png(image));
}

BENCHMARK(render_once)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(render_again)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(encode)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace croquis

// SPDX-License-Identifier: MIT
// Skinning of 100,000 vertices with 4 influences, positions and normals, on one thread. Before Google
// Benchmark's table it prints the ratios that matter: every contender once, in turn, again and again; the ratio of a
// pair is the median over the rounds, so that a machine whose speed wanders does not tilt it.
#include "skinning_plain_loop.h"
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <time.h>
#include <vector>

#include <benchmark/benchmark.h>

#include "croquis/base/random.h"
#include "croquis/skinning/skin_vertices.h"

namespace croquis {
namespace {

constexpr std::size_t kVertices = 100000;
constexpr int kInfluences = 4;
constexpr int kJoints = 64;

struct Scene {
  std::vector<Affine> matrices;
  std::vector<PlainMatrix> plain;
  std::vector<std::uint16_t> indices;
  std::vector<float> weights;
  std::vector<Vec3f> positions, normals, posed_positions, posed_normals;
  // Copying half of what skinning reads and writes moves as many bytes in all: a copy reads and writes each byte.
  std::vector<char> copied_from, copied_to;
};

Vec3 random_direction(Random& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return Vec3(x, y, z).normalized();
}

// Joints turn by up to `most` radians about any axes.
Scene make_scene(double most) {
  Random random(1);
  Scene scene;
  for (int j = 0; j < kJoints; ++j) {
    Affine matrix = Affine::Identity();
    matrix.linear() = Eigen::AngleAxisd(random.uniform(-most, most), random_direction(random)).toRotationMatrix();
    matrix.translation() = random_direction(random);
    scene.matrices.push_back(matrix);
    PlainMatrix plain;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 4; ++c) plain.rows[r][c] = static_cast<float>(matrix(r, c));
    }
    scene.plain.push_back(plain);
  }
  for (std::size_t v = 0; v < kVertices; ++v) {
    float weights[kInfluences], sum = 0.0F;
    for (float& weight : weights) sum += weight = static_cast<float>(random.uniform(0.01, 1.0));
    std::sort(weights, weights + kInfluences, std::greater<>());
    for (const float weight : weights) {
      scene.weights.push_back(weight / sum);
      scene.indices.push_back(static_cast<std::uint16_t>(random.index(kJoints)));
    }
    scene.positions.emplace_back(random_direction(random).cast<float>());
    scene.normals.emplace_back(random_direction(random).cast<float>());
  }
  scene.posed_positions.resize(kVertices);
  scene.posed_normals.resize(kVertices);
  const std::size_t read = kVertices * (2 * sizeof(Vec3f) + kInfluences * (sizeof(float) + sizeof(std::uint16_t)));
  const std::size_t written = kVertices * 2 * sizeof(Vec3f);
  scene.copied_from.assign((read + written) / 2, 1);
  scene.copied_to.assign((read + written) / 2, 0);
  return scene;
}

void skin(Scene& scene, SkinningMethod method, bool unit_normals, const skinning_kernels::KernelSet& kernels) {
  const SkinningPalette palette(scene.matrices, {}, method);
  const SkinningJob job{.joint_indices = scene.indices,
                        .weights = scene.weights,
                        .influences = kInfluences,
                        .positions = scene.positions,
                        .normals = scene.normals,
                        .tangents = {},
                        .posed_positions = scene.posed_positions,
                        .posed_normals = scene.posed_normals,
                        .posed_tangents = {},
                        .unit_normals = unit_normals};
  skin_vertices(palette, job, kernels);
  benchmark::DoNotOptimize(scene.posed_normals.data());
  benchmark::ClobberMemory();
}

void skin_by_plain_loop(Scene& scene, decltype(skin_plainly)* loop) {
  loop(scene.plain.data(), scene.indices.data(), scene.weights.data(), kInfluences, kVertices,
       scene.positions.front().data(), scene.normals.front().data(), scene.posed_positions.front().data(),
       scene.posed_normals.front().data());
  benchmark::ClobberMemory();
}

void copy(Scene& scene) {
  std::memcpy(scene.copied_to.data(), scene.copied_from.data(), scene.copied_from.size());
  benchmark::ClobberMemory();
}

struct Contender {
  std::string name;
  std::function<void(Scene&)> run;
  std::vector<double> milliseconds = {};
};

// Time on the processor: what other programs take of a busy machine does not count.
double thread_milliseconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_ratio(const Contender& a, const Contender& b) {
  std::vector<double> ratios;
  for (std::size_t r = 0; r < a.milliseconds.size(); ++r) ratios.push_back(a.milliseconds[r] / b.milliseconds[r]);
  return median(ratios);
}

std::vector<Contender> make_contenders() {
  std::vector<Contender> contenders = {
      {"plain loop", [](Scene& s) { skin_by_plain_loop(s, skin_plainly); }},
      {"memcpy", copy},
      {"plain loop, fused", [](Scene& s) { skin_by_plain_loop(s, skin_plainly_fused); }},
  };
  const skinning_kernels::KernelList list = skinning_kernels::available_kernels();
  for (int k = 0; k < list.count; ++k) {
    const skinning_kernels::KernelSet& kernels = list.sets[k];
    for (const bool unit : {false, true}) {
      const std::string name = std::string(unit ? ", unit normals (" : " (") + kernels.name + ")";
      for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
        contenders.push_back({(method == SkinningMethod::linear ? "linear" : "dual quaternions") + name,
                              [=, &kernels](Scene& s) { skin(s, method, unit, kernels); }});
      }
    }
  }
  return contenders;
}

void print_ratios(Scene& scene, int repetitions) {
  std::vector<Contender> contenders = make_contenders();
  for (int r = 0; r < repetitions; ++r) {
    for (Contender& contender : contenders) {
      const double start = thread_milliseconds();
      contender.run(scene);
      const double took = thread_milliseconds() - start;
      if (r > 0) contender.milliseconds.push_back(took);
    }
  }
  std::printf("%zu vertices, %d influences, positions and normals, medians of %d interleaved runs:\n", kVertices,
              kInfluences, repetitions - 1);
  std::printf("%-44s %8s %14s %10s %11s\n", "", "ms", "x plain loop", "x memcpy", "x linear");
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const Contender& one = contenders[i];
    std::printf("%-44s %8.3f %14.2f %10.2f", one.name.c_str(), median(one.milliseconds),
                median_ratio(contenders[0], one), median_ratio(one, contenders[1]));
    if (one.name.starts_with("dual")) std::printf(" %11.2f", median_ratio(one, contenders[i - 1]));
    std::printf("\n");
  }
  std::printf("(times faster than the plain loop; times the memcpy's time; times the linear method's time)\n\n");
}

}  // namespace
}  // namespace croquis

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  croquis::Scene wild = croquis::make_scene(croquis::kPi), scene = croquis::make_scene(croquis::kPi / 2);
  std::printf("Joints that turn by any angle (dual quaternions need a choice of signs)\n");
  croquis::print_ratios(wild, 101);
  std::printf("Joints that turn by up to 90 degrees\n");
  croquis::print_ratios(scene, 101);
  for (const croquis::Contender& contender : croquis::make_contenders()) {
    benchmark::RegisterBenchmark(contender.name.c_str(), [&scene, run = contender.run](benchmark::State& state) {
      for (auto _ : state) run(scene);
      state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(croquis::kVertices));
    })->Unit(benchmark::kMillisecond);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

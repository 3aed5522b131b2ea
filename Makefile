# The front door of Croquis. Each target installs what it lacks (Debian packages, npm packages) and says so.

JOBS ?= $(shell nproc 2>/dev/null || echo 2)
FUZZ_SECONDS ?= 600

.PHONY: help demo build studio test bench bench-lines fuzz pictures lint format clean
help:
	@echo 'make demo     build the program; pose the mannequin along a drawn line: out/demo.glb and out/demo.png'
	@echo 'make build    build the program: build/release/croquis'
	@echo 'make test     build and run every test: native, with sanitizers, as WebAssembly, format, lint, fuzz'
	@echo 'make studio   build the drawing table for the browser and serve it on this machine'
	@echo 'make bench    build and run the benchmarks'
	@echo 'make bench-lines  how near the methods of posing come to poses of real people'
	@echo 'make fuzz     fuzz each reader for FUZZ_SECONDS=$(FUZZ_SECONDS) seconds'
	@echo 'make pictures draw the pictures of docs/images anew'
	@echo 'make lint     read every source with clang-tidy'
	@echo 'make format   lay out every source as .clang-format says'
	@echo 'make clean    remove build/ and out/'

build:
	@tools/setup.sh program
	@cmake --preset release -DCROQUIS_TESTS=OFF
	@cmake --build build/release --target croquis -j $(JOBS)
	@echo 'The program is build/release/croquis'

demo: build
	@mkdir -p out
	build/release/croquis pose mannequin --start relaxed --line assets/demo_line.svg -o out/demo.glb --picture out/demo.png
	@echo 'See out/demo.png, and open out/demo.glb in any viewer'

test:
	@tools/setup.sh program tests npm page browser
	@tools/test.sh $(JOBS)

studio:
	@tools/setup.sh program page
	@tools/build_studio.sh $(JOBS)
	@cmake --preset release -DCROQUIS_TESTS=OFF >/dev/null
	@cmake --build build/release --target croquis -j $(JOBS)
	@build/release/croquis studio

bench:
	@tools/setup.sh program bench
	cmake --preset release -DCROQUIS_TESTS=OFF -DCROQUIS_BENCHMARKS=ON
	cmake --build build/release --target benchmarks -j $(JOBS)
	cmake --build build/release --target run_benchmarks

# The lines-of-action benchmark over the clips of CLIPS (BVH files of people).
CLIPS ?= ../shared/data/bvh
bench-lines:
	@tools/setup.sh program bench
	@cmake --preset release -DCROQUIS_TESTS=OFF -DCROQUIS_BENCHMARKS=ON
	@cmake --build build/release --target loa_bench -j $(JOBS)
	build/release/benchmarks/loa_bench --clips $(CLIPS) --poses 136 --views 2 --json build/bench-lines.json

fuzz:
	@tools/setup.sh fuzz
	@tools/fuzz.sh $(JOBS) $(FUZZ_SECONDS)

pictures: build
	@cmake --build build/release --target doc_pictures -j $(JOBS)
	build/release/tools/doc_pictures docs/images

lint:
	@tools/setup.sh program tests
	@tools/lint.sh build $(JOBS)
	@echo 'clang-tidy finds nothing'

format:
	@tools/setup.sh format
	@git ls-files '*.h' '*.cpp' | xargs clang-format-14 -i
	@echo 'Formatted'

clean:
	rm -rf build out

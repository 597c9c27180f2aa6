# The two commands of the README, and the daily ones. Everything else is CMake (CMakePresets.json).
CASE ?= cases/onera-m6/case.toml
BUILD := build/release
JOBS ?= 2
# Lets a compiler cache serve any clone of the project, wherever it lies.
export CCACHE_BASEDIR := $(CURDIR)
export CCACHE_NOHASHDIR := 1

.PHONY: help setup configure program build run test test-slow sanitize clang tidy fuzz bench format format-check install clean

help:                 ## this list
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*##/\t/'

setup:                ## install the Debian packages that are missing (cmake/debian-packages.txt)
	@sh cmake/install-packages.sh

configure: setup
	@[ -f $(BUILD)/build.ninja ] || cmake --preset release --log-level=WARNING

program: configure    ## build the program (Release)
	@cmake --build $(BUILD) --target nearwall -j $(JOBS) -- --quiet

build: configure      ## build everything, tests and benchmarks, too
	@cmake --build $(BUILD) -j $(JOBS) -- --quiet

run: program          ## mesh a case: make run CASE=cases/onera-m6/case.toml
	@sh cmake/install-packages.sh $(notdir $(patsubst %/,%,$(dir $(abspath $(CASE)))))
	@PATH="$(CURDIR)/$(BUILD)/bin:$$PATH" sh cmake/run-case.sh $(CASE)

test: build           ## run all tests but the slow ones
	@ctest --test-dir $(BUILD) -j $(JOBS) -LE slow --no-tests=error --output-on-failure --progress

test-slow:            ## run the slow tests and every case, those from packages, too
	@sh cmake/install-packages.sh slow
	@$(MAKE) --no-print-directory build
	@ctest --test-dir $(BUILD) -j $(JOBS) -L 'slow|case' --no-tests=error --output-on-failure

sanitize: setup       ## all tests under the address and undefined-behaviour sanitizers
	@cmake --workflow --preset asan

clang: setup          ## all tests with clang
	@sh cmake/install-packages.sh clang
	@CC=clang CXX=clang++ cmake --preset release -B build/clang --log-level=WARNING
	@cmake --build build/clang -j $(JOBS) -- --quiet
	@ctest --test-dir build/clang -j $(JOBS) -LE slow --no-tests=error --output-on-failure --progress

tidy: setup           ## clang-tidy over all sources
	@sh cmake/install-packages.sh clang
	@cmake --workflow --preset tidy

fuzz: setup           ## each fuzz target for a minute
	@sh cmake/install-packages.sh clang
	@CC=clang CXX=clang++ cmake --preset release -B build/fuzz -DNEARWALL_BUILD_FUZZERS=ON --log-level=WARNING
	@cmake --build build/fuzz -j $(JOBS) --target run_fuzzers -- --quiet

bench: build          ## run the benchmarks
	@cmake --build $(BUILD) --target run_benchmarks

format:               ## format the C++ sources
	@git ls-files '*.cpp' '*.h' | xargs clang-format -i

format-check:         ## fail if a C++ source is not formatted
	@git ls-files '*.cpp' '*.h' | xargs clang-format --dry-run --Werror

install: build        ## install under PREFIX (default /usr/local)
	@cmake --install $(BUILD) --prefix $(or $(PREFIX),/usr/local)

clean:                ## remove the build
	@rm -rf build

# The two commands of the README, and the daily ones. Everything else is CMake (CMakePresets.json).
CASE ?= cases/onera-m6/case.toml
BUILD := build/release
JOBS ?= 2

.PHONY: help setup configure program build run test test-slow bench format format-check install clean

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

test-slow:            ## run the slow tests, too: every case, sanitizers, fuzzing
	@sh cmake/install-packages.sh slow
	@$(MAKE) --no-print-directory build
	@ctest --test-dir $(BUILD) -j $(JOBS) -L slow --no-tests=error --output-on-failure

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

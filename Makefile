# `make demo` and `make test` set up what they need; see scripts/setup.sh.

SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help

SCENES := seed-spheres shapes seed-models knot
TARGET := $(or $(CARGO_TARGET_DIR),target)
RAYPROOF := $(TARGET)/release/rayproof

# Without a desktop this is not set, and Mesa remarks on it again and again.
export XDG_RUNTIME_DIR ?= /tmp

.PHONY: help setup demo test test-thorough bench-peers bench-kernel

help: ## Lists the targets
	@sed -n 's/^\([a-z-]*\): .*## /\1\t/p' Makefile | expand -t 16

setup: ## Installs a C compiler and a software Vulkan driver, each if there is none
	@scripts/setup.sh rust compiler vulkan

demo: setup ## Builds, renders the four scenes into out/ and compares GPU with CPU
	cargo build --release --locked
	@mkdir -p out
	@for scene in $(SCENES); do \
	    echo; \
	    $(RAYPROOF) render assets/scenes/$$scene.toml -o out/$$scene.png; \
	    echo; \
	    $(RAYPROOF) compare assets/scenes/$$scene.toml; \
	done

# `--lib --examples` makes cargo doc resolve features as cargo test does, so that
# no dependency is checked twice.
test: setup ## Formatting, lints, all tests, documentation
	@scripts/setup.sh lints
	cargo fmt --check
	cargo clippy --locked --all-targets -- -D warnings
	cargo test --locked
	RUSTDOCFLAGS="-D warnings" cargo doc --locked --no-deps --lib --examples

test-thorough: setup ## The tests with the long ones too
	RAYPROOF_THOROUGH=1 cargo test --locked -- --include-ignored

bench-peers: setup ## Closest hits beside the crates obvhs and bvh, on the same rays
	cargo bench --locked --bench peers

bench-kernel: setup ## Each intersection and search by itself
	cargo bench --locked --bench kernel

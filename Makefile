# The one list of commands; .ci/run calls nothing else.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
PEERS := $(VENV)/.peers
ENGINES := $(VENV)/.engines
# Test files run beside each other, on all cores.
SPREAD := -n auto --dist loadfile
SOURCES := pyproject.toml CMakeLists.txt $(shell find src generated -name '*.c' -o -name '*.h')

.PHONY: help derive check-generated latex paper verify figures test verify-long lint bench census clean

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## /{printf "make %-16s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

$(READY): $(SOURCES)
	@$(PYTHON) -c 'import sys; sys.exit("Python 3.11 or newer is needed, this is %d.%d" % sys.version_info[:2] if sys.version_info < (3, 11) else 0)'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	-@$(BIN)/python -c 'import kleinform; print(kleinform.backend())'
	@touch $@

derive: $(READY) ## derive, prove and regenerate generated/
	@$(BIN)/python -m derivations derive
	@$(MAKE) --silent $(READY)

check-generated: $(READY) ## regenerate aside and compare byte by byte
	@$(BIN)/python -m derivations check

latex: derive ## the formulas as .tex files, one document and one HTML page
	@$(BIN)/python -m derivations where

paper: $(READY) ## the paper's numbers beside the computed ones, and docs/audit.md
	@$(BIN)/python -m kleinform.paper docs/audit.md

$(ENGINES): $(READY)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev,verify]'
	@touch $@

verify: $(ENGINES) ## both examples beside Pinocchio and Exudyn, joint by joint
	@$(BIN)/python -m kleinform.verification

figures: $(ENGINES) ## the paper's figures and the robot with its screws, into docs/figures/
	@$(BIN)/python -m kleinform.plots docs/figures

test: $(ENGINES) check-generated ## all tests on both backends, the freshness of generated/ and the wheel
	@KLEINFORM_BACKEND=numpy $(BIN)/python -m pytest $(SPREAD) tests/kernels tests/runtime tests/motion --deselect tests/runtime/test_wheel.py
	@$(BIN)/python -m pytest $(SPREAD)

verify-long: $(ENGINES) ## the searches among the tests with their large counts, on both backends
	@KLEINFORM_LONG=1 KLEINFORM_BACKEND=numpy $(BIN)/python -m pytest $(SPREAD) -m long tests/kernels tests/runtime tests/motion
	@KLEINFORM_LONG=1 $(BIN)/python -m pytest $(SPREAD) -m long

lint: $(READY) ## ruff and mypy
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

$(PEERS): $(READY)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev,bench]'
	@touch $@

bench: $(PEERS) ## measure against peers, side by side; the tables go to benchmarks/results.md
	@$(BIN)/python -m benchmarks

census: $(READY) ## how many assembly modes joint values have, and docs/census.svg
	@$(BIN)/python -m benchmarks.census docs/census.svg

clean: ## remove everything that make created, but for generated/
	rm -rf $(VENV) build dist .pytest_cache .ruff_cache .mypy_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

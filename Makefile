# Everything runs in one environment, .venv, made on first use.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed

export OMP_NUM_THREADS ?= 2
export QT_QPA_PLATFORM ?= offscreen
export CLONER_NODE_MODULES ?= $(CURDIR)/.cache/npm

.PHONY: demo test quick lint types contracts bench fuzz clean environment

environment: $(STAMP)

# PYTHONWARNINGS: setuptools lectures at length on what an editable install is.
$(STAMP): pyproject.toml
	$(PYTHON) -c 'import sys; sys.exit(not (3, 11) <= sys.version_info[:2] < (3, 13) and "Cloner wants Python 3.11 or 3.12: run make PYTHON=python3.11")'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --upgrade "pip>=25"
	PYTHONWARNINGS=ignore $(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[dev]"
	touch $(STAMP)

demo: $(STAMP)
	$(BIN)/cloner doctor --brief
	$(BIN)/cloner clone samples/anna/plain --out demo_out --id anna
	@echo
	@echo "The clone lies in    demo_out/anna (clone.glb, clone.wrl, previews/)"
	@echo "Open the report with a browser: file://$(CURDIR)/demo_out/anna/report.html"

test: lint types
	$(BIN)/python -m pytest

quick: $(STAMP)
	$(BIN)/python -m pytest -q -m "not slow and not golden" tests/unit tests/property

lint: $(STAMP)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports

types: $(STAMP)
	$(BIN)/mypy

bench: $(STAMP)
	$(BIN)/python benchmarks/bench_clone.py

# Parsers against input nobody thought of, ten minutes; what is found is kept in tests/fuzz/findings.
FUZZ_SECONDS ?= 600
fuzz: $(STAMP)
	-$(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[fuzz]"
	$(BIN)/python -m tests.fuzz --seconds $(FUZZ_SECONDS)

clean:
	rm -rf $(VENV) demo_out build *.egg-info .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache

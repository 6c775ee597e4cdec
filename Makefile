# Everything runs in one environment, .venv, made on first use.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed

# Compiled modules are kept, whatever the machine says: the tests start hundreds of processes, and each would compile
# everything it imports anew (3 s of CPU).
export PYTHONDONTWRITEBYTECODE =
export OMP_NUM_THREADS ?= 2
export QT_QPA_PLATFORM ?= offscreen
export CLONER_NODE_MODULES ?= $(CURDIR)/.cache/npm

.PHONY: demo test tests quick lint types docs bench fuzz wheel constraints sbom audit clean environment

environment: $(STAMP)

# Exact versions whose bytes are known (constraints.txt), then this project itself, built with what is there.
# PYTHONWARNINGS: setuptools lectures at length on what an editable install is.
$(STAMP): pyproject.toml constraints.txt
	$(PYTHON) -c 'import sys; sys.exit(not (3, 11) <= sys.version_info[:2] < (3, 14) and "Cloner wants Python 3.11 to 3.13: run make PYTHON=python3.11")'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile --require-hashes -r constraints.txt
	PYTHONWARNINGS=ignore $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
	touch $(STAMP)

demo: $(STAMP)
	$(BIN)/cloner doctor --brief
	$(BIN)/cloner clone samples/anna/plain --out demo_out --id anna
	@echo
	@echo "The clone lies in    demo_out/anna (clone.glb, clone.wrl, previews/)"
	@echo "Open the report with a browser: file://$(CURDIR)/demo_out/anna/report.html"

# Types are checked beside the tests, which leave a core idle now and then.
test: lint
	$(MAKE) --no-print-directory --jobs 2 types tests

# Two processes, a file of tests each: pictures and windows of one file share what they made. In the order of `testpaths`:
# files of few long tests would come last otherwise, with a core idle.
tests: $(STAMP)
	OMP_NUM_THREADS=1 $(BIN)/python -m pytest --numprocesses 2 --dist loadfile --no-loadscope-reorder

quick: $(STAMP)
	$(BIN)/python -m pytest -q -m "not slow" tests/unit tests/property

lint: $(STAMP)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports

types: $(STAMP)
	$(BIN)/mypy

# The pages that are made from the code: commands, Python interface.
docs: $(STAMP)
	$(BIN)/python docs/make_reference.py

bench: $(STAMP)
	$(BIN)/python benchmarks/bench_clone.py

# Parsers against input nobody thought of, ten minutes; what is found is kept in tests/fuzz/findings.
FUZZ_SECONDS ?= 600
fuzz: $(STAMP)
	-$(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[fuzz]"
	$(BIN)/python -m tests.fuzz --seconds $(FUZZ_SECONDS)

# What leaves the house: a wheel that was installed and tried, exact versions, a bill of materials, known weaknesses.
wheel: $(STAMP)
	rm -rf dist
	$(BIN)/python -m build
	$(BIN)/python release/sbom.py > sbom.json
	$(BIN)/python release/add_sbom.py dist/*.whl sbom.json
	$(BIN)/python release/check_wheel.py dist/*.whl

constraints: $(STAMP)
	$(BIN)/uv pip compile --quiet --universal --python-version 3.11 --extra dev --generate-hashes --no-annotate \
		--custom-compile-command "make constraints" --output-file constraints.txt pyproject.toml

sbom: $(STAMP)
	$(BIN)/python release/sbom.py > sbom.json

# Asks the vulnerability service of the package index: needs a network, so CI does not run it.
audit: $(STAMP)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check "pip-audit>=2.7,<3"
	$(BIN)/pip-audit --strict --requirement constraints.txt --no-deps --disable-pip

clean:
	rm -rf $(VENV) demo_out build dist sbom.json *.egg-info .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache

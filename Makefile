# Every target works through .venv, which the first one makes.  `make` alone lists them.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
OUTPUT := output

.DEFAULT_GOAL := help
.PHONY: help solve sweep digits stability test test-long mutants bench bench-kernels generate equations report docs lint dist lowest clean

help:  ## list the targets
	@grep -E '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed 's/:[^#]*## /\t/' | expand -t 12

solve: $(VENV)/ready  ## the limit cycle of the paper by each method, and a picture
	@mkdir -p $(OUTPUT)
	@$(BIN)/nonsmooth solve --order 10 -o $(OUTPUT)/orbit.png

sweep: $(VENV)/ready  ## convergence over the orders 1 to 40, and a picture
	@mkdir -p $(OUTPUT)
	@$(BIN)/nonsmooth sweep --orders 1-40 -o $(OUTPUT)/convergence.png

digits: $(VENV)/ready-all  ## digits kept at the extremes, against high precision, and a picture
	@mkdir -p $(OUTPUT)
	@$(BIN)/nonsmooth digits -o $(OUTPUT)/digits.png

stability: digits  # its old name

# They start Python a hundred times: what it compiles is kept, whatever the shell says.
test: $(VENV)/ready-all  ## the tests, in two processes
	@env -u PYTHONDONTWRITEBYTECODE $(BIN)/python -m pytest -n 2 --dist loadgroup -m 'not long'

# Compiled code looks at no index of its arrays: the second line lets it.
test-long: $(VENV)/ready-all  ## all tests, 100,000 random oscillators among them: most of an hour
	@EXAMPLES=100000 $(BIN)/python -m pytest -n 2 --dist loadgroup
	@NUMBA_BOUNDSCHECK=1 NUMBA_CACHE_DIR=$(CURDIR)/$(OUTPUT)/checked \
	  $(BIN)/python -m pytest -n 2 -m long tests/scenes/test_random_oscillators.py

mutants: $(VENV)/ready-all  ## deliberate mistakes: which of them the tests catch
	@cd tests && ../$(BIN)/python -m mutants

bench: $(VENV)/ready-all  ## time against accuracy, our methods and others
	@OPENBLAS_NUM_THREADS=1 $(BIN)/python -m benchmarks.run -o $(OUTPUT)
	@OPENBLAS_NUM_THREADS=1 $(BIN)/python -m benchmarks.every_scene -o $(OUTPUT)
	@OPENBLAS_NUM_THREADS=1 $(BIN)/python -m benchmarks.branches
	@OPENBLAS_NUM_THREADS=1 $(BIN)/python -m benchmarks.bodies -o $(OUTPUT)

bench-kernels: $(VENV)/ready-all  ## residual, Jacobian and iteration of each kernel
	@$(BIN)/python -m pytest benchmarks/bench_kernels.py --benchmark-columns=median,iqr,rounds

generate: $(VENV)/ready  ## derive the equations and write generated/
	@$(BIN)/nonsmooth generate

equations: $(VENV)/ready  ## the derived equations as a LaTeX document
	@mkdir -p $(OUTPUT)
	@$(BIN)/nonsmooth equations --format latex -o $(OUTPUT)/equations.tex

report: $(VENV)/ready-all  ## the paper recomputed: figures, equations and claims on one page
	@mkdir -p $(OUTPUT)
	@$(BIN)/nonsmooth report -o $(OUTPUT)/report

docs: $(VENV)/ready-docs  ## the documentation as a site: output/docs/index.html
	@echo "running every page: three to five minutes" >&2
	@rm -rf $(OUTPUT)/docs docs/reference/modules
	@$(BIN)/python -m sphinx -q -j auto -W --keep-going -n docs $(OUTPUT)/docs
	@echo "wrote $(OUTPUT)/docs/index.html"

lint: $(VENV)/ready-all  ## formatting, style, types, and whether generated/ is up to date
	@$(BIN)/ruff format --check .
	@$(BIN)/ruff check .
	@$(BIN)/mypy
	@$(BIN)/nonsmooth generate --check

dist:  ## the sdist and the wheel, installed in an environment of its own and run
	@rm -rf dist
	@$(PYTHON) -m venv dist/.venv
	@dist/.venv/bin/python -m pip install --quiet --disable-pip-version-check 'build>=1.2'
	@dist/.venv/bin/python -m build --outdir dist . >/dev/null
	@$(PYTHON) -m venv --clear dist/.venv
	@dist/.venv/bin/python -m pip install --quiet --disable-pip-version-check dist/*.whl
	@cd dist && .venv/bin/nonsmooth solve --tol 1e-8 && .venv/bin/nonsmooth generate impact --check
	@rm -rf dist/.venv && ls dist

lowest:  ## all tests with the lowest versions that pyproject.toml allows, in .venv-lowest
	@$(PYTHON) -m venv --clear .venv-lowest
	@$(PYTHON) .ci/lowest.py > .venv-lowest/constraints
	@.venv-lowest/bin/python -m pip install --quiet --disable-pip-version-check -c .venv-lowest/constraints -e '.[plot,report,precise,netcdf,pandas,xarray,test]'
	@.venv-lowest/bin/python -m pytest

clean:  ## remove the environment and everything made
	rm -rf $(VENV) .venv-lowest $(OUTPUT) docs/reference/modules build dist src/*.egg-info .pytest_cache .mypy_cache .ruff_cache

# What solving needs, and beside it what everything else does.
SOLVING := .[plot]
ALL := .[plot,report,precise,netcdf,pandas,xarray,test,lint,bench]
DOCS := .[plot,report,precise,netcdf,pandas,xarray,docs]

# uv, where it is installed, is only quicker; venv and pip do the same.
define install
if command -v uv >/dev/null 2>&1; then \
  uv pip install --quiet --python $(BIN)/python -e '$(1)'; \
else \
  $(BIN)/python -m pip install --quiet --disable-pip-version-check -e '$(1)'; \
fi
endef

$(VENV)/ready: pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "nonsmooth needs Python 3.11 or newer; set PYTHON=python3.x" >&2; exit 1; }
	@echo "making $(VENV): numpy, scipy, sympy, numba, matplotlib; 650 MB, about a minute" >&2
	@$(PYTHON) -m venv --clear $(VENV) || { \
	  echo "python3-venv is missing: apt-get install python3-venv" >&2; exit 1; }
	@$(call install,$(SOLVING))
	@touch $@

$(VENV)/ready-all: $(VENV)/ready
	@echo "adding what tests, linters and pages need; 170 MB more" >&2
	@$(call install,$(ALL))
	@touch $@

# Sphinx and a notebook kernel are heavy, and for one target only.
$(VENV)/ready-docs: $(VENV)/ready
	@$(call install,$(DOCS))
	@touch $@

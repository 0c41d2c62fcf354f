# The front door. Every goal does its own set-up, and does again only what changed.
#   make run                     reference against CGAL, a table, and build/report/index.html
#   make test                    GoogleTest and pytest, of which a third waits: a process more than cores
#   make test-clang              GoogleTest, all of it compiled by clang
#   make test-flushed            pytest of the module, in threads that flush subnormal numbers
#   make evidence [ONLY="PART PART/STEP ..."] [QUICK=1 | FULL=1] [CHANGED=1]
#   make proofs                 the proofs of oracle/proved, and the checker that comes from them
#   make checker                 oracle/checker/check.py anew from its parts
#   make lint | format
#   make docs                    the documentation as a site, build/site/index.html
#   make wheel | sdist           into dist/ [PYTHON=python3.12] [PROJECT=tools/packaging/minkref-cgal] (docs/packages.md)
#   make sbom                    the software bill of materials, build/sbom.cdx.json
#   make lock [UPGRADE=1]        requirements.txt and those of the site and the adapters, with digests
SHELL := /bin/bash
.DEFAULT_GOAL := run
.PHONY: run test test-clang test-flushed evidence proofs checker lint format docs wheel sdist sbom lock setup environment clean

CXX_SOURCES = $(shell find reference formats certify oracle bindings fuzz tests -name '*.cpp' -o -name '*.hpp')
JAVASCRIPT_SOURCES = docs/site fuzz minkref reports tests
PYTHON_SOURCES = minkref certify degeneracies docs/site fuzz oracle reports tests tools

setup:
	@tools/scripts/set_up.sh

environment:  # PYTHON names the one of a wheel, then, and not that of .venv
	@$(if $(filter wheel sdist,$(MAKECMDGOALS)),env -u PYTHON) tools/scripts/set_up.sh environment

run:
	@tools/scripts/set_up.sh run
	.venv/bin/minkref verify --baseline fuzz/baseline.json --seconds 30 --report build/report $(ARGS)

test: setup
	ctest --preset release -j $$(nproc)
	.venv/bin/python -m pytest -n $$(($$(nproc) + 1)) $(ARGS)

test-clang: environment
	@tools/scripts/require_packages.sh clang
	cmake --preset clang
	cmake --build --preset clang
	ctest --preset clang -j $$(nproc)

test-flushed: setup
	.venv/bin/python -m pytest -n $$(nproc) -p float_environments $(addprefix tests/,api certificates disc formats paper \
	  plane space) $(ARGS)

evidence: setup
	.venv/bin/python reports/evidence/run.py $(ONLY) $(if $(QUICK),--quick) $(if $(FULL),--full) $(if $(CHANGED),--changed)

proofs:
	@tools/scripts/proofs.sh

checker:
	cat oracle/checker/parts/*.py >oracle/checker/check.py

lint: setup
	.venv/bin/clang-format --dry-run -Werror $(CXX_SOURCES)
	.venv/bin/ruff check $(PYTHON_SOURCES)
	.venv/bin/ruff format --check $(PYTHON_SOURCES)
	.venv/bin/mypy
	cd minkref/models && ../../.venv/bin/mypy --strict --explicit-package-bases *.py
	.venv/bin/mypy tools/scripts/*.py tools/packaging/*.py
	MYPYPATH=docs/site .venv/bin/mypy docs/site/*.py
	.venv/bin/python tools/scripts/check_includes.py
	.venv/bin/lint-imports --no-cache pyproject.toml
	.venv/bin/python tools/scripts/check_counts.py
	.venv/bin/oxlint $(JAVASCRIPT_SOURCES)
	tools/scripts/check_types.sh

format: environment
	.venv/bin/clang-format -i $(CXX_SOURCES)
	.venv/bin/ruff check --fix-only --quiet $(PYTHON_SOURCES)
	.venv/bin/ruff format $(PYTHON_SOURCES)

docs: setup
	@tools/scripts/docs.sh

wheel sdist: environment
	.venv/bin/python tools/packaging/wheel.py $(if $(PYTHON),--python $(PYTHON)) $(if $(PROJECT),--project $(PROJECT)) \
	  $(if $(filter sdist,$@),--sdist)

sbom: setup
	.venv/bin/python tools/scripts/sbom.py

lock: environment
	tools/scripts/lock.sh $(if $(UPGRADE),--upgrade)

clean:
	rm -rf build .venv

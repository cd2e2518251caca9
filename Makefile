# Two commands do all the set-up: `make demo` and `make test`. Both keep to their own .venv.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
DEMO := build/demo

.PHONY: demo test bench proofs docs clean

demo: $(VENV)/installed
	mkdir -p $(DEMO)
	$(BIN)/exactmesh examples ireland -o $(DEMO)/ireland.geojson
	$(BIN)/exactmesh mesh $(DEMO)/ireland.geojson -o $(DEMO)/ireland.mesh.json --report $(DEMO)/ireland.report.json --svg $(DEMO)/ireland.svg
	$(BIN)/exactmesh verify $(DEMO)/ireland.geojson $(DEMO)/ireland.mesh.json --max-degradation 45
	@echo "mesh, report and picture are in $(DEMO)"

test: $(VENV)/installed-test
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/python -m pytest -n auto

bench: $(VENV)/installed-peers
	$(BIN)/exactmesh bench -o build/bench

proofs: $(VENV)/installed-proofs
	$(BIN)/exactmesh prove

docs: $(VENV)/installed-test
	$(BIN)/python -m mkdocs build

$(VENV)/installed: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e .
	touch $@

$(VENV)/installed-test: $(VENV)/installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[test]'
	touch $@

$(VENV)/installed-peers: $(VENV)/installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[peers]'
	touch $@

$(VENV)/installed-proofs: $(VENV)/installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[proofs]'
	touch $@

clean:
	rm -rf $(VENV) build

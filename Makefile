# `make run` does all the set-up and the main job; `make test` does all the set-up and the tests.
.PHONY: setup run test bench lint

setup: .venv/.ready

run: .venv/.ready
	.venv/bin/rigtrue run first_drive

test: .venv/.ready .venv/.browser
	.venv/bin/pytest -n auto --dist loadfile

bench: .venv/.ready
	.venv/bin/pytest tests/benchmark -s

lint: .venv/.ready
	.venv/bin/ruff check
	.venv/bin/ruff format --check
	.venv/bin/mypy
	.venv/bin/lint-imports

.venv/.ready: requirements.lock pyproject.toml setup.sh
	./setup.sh
	touch $@

.venv/.browser: .venv/.ready
	./setup.sh browser
	touch $@

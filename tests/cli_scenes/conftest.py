"""A cache of kernels that is a test's own."""

from pathlib import Path

import pytest

from nonsmooth.scene_files import store


@pytest.fixture
def cache(tmp_path: Path, monkeypatch) -> Path:
    """Return the folder of kernels, below a cache of its own."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(store, "_FOR_NOW", {})
    return tmp_path / "cache" / "nonsmooth" / "scenes"

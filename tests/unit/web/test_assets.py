"""The browser's files: vendored ones unmodified, all of them inlined without leftovers."""

import base64
import hashlib
import json
import re
import tomllib
import zlib
from importlib.resources import files

import pytest

from vrts.web.assets import (
    BARE,
    CODEMIRROR,
    THREE,
    asset,
    closure,
    module_name,
    packed,
    served,
    sources,
)

VENDOR = files("vrts.web").joinpath("vendor")
VENDORED = tomllib.loads(VENDOR.joinpath("vendored.toml").read_text())


FILES = {name: file for part in VENDORED.values() for name, file in part["files"].items()}


@pytest.mark.parametrize("name", sorted(FILES))
def test_vendored_files_are_unmodified_and_small(name: str) -> None:
    content = VENDOR.joinpath(name).read_bytes()
    assert hashlib.sha256(content).hexdigest() == FILES[name]["sha256"]
    assert len(content) < 1_000_000


def test_every_vendored_file_is_recorded() -> None:
    for folder in ("three", "codemirror"):
        found = {f"{folder}/{entry.name}" for entry in VENDOR.joinpath(folder).iterdir()}
        assert found <= set(FILES)


def test_every_name_under_which_modules_import_others_is_a_vendored_file() -> None:
    assert {path.removeprefix("vendor/") for path in BARE.values()} <= set(FILES)
    for name, path in BARE.items():
        package = FILES[path.removeprefix("vendor/")].get("package", VENDORED["three"]["source"])
        assert package.endswith(name)


def test_the_editor_needs_nothing_that_is_not_vendored() -> None:
    for path in (path for path in BARE.values() if path.startswith(CODEMIRROR)):
        wanted = re.findall(
            r"""^(?:import|export)\b[^"'\n]*\bfrom\s*["']([^"']+)["']""", asset(path), re.M
        )
        assert set(wanted) <= set(BARE), path
        assert not re.search(r"""^(?:im|ex)port\b.*\bfrom\s*["'][^/.]""", served(path), re.M), path


def test_modules_need_no_others_than_a_page_holds() -> None:
    modules = sources("report/page.js")
    assert module_name(THREE) in modules
    assert module_name("viewer/viewer.js") in modules
    for name, text in modules.items():
        imported = re.findall(r"""\bfrom\s*["']([^"']+)["']""", text)
        needed = [i for i in imported if not i.startswith("three/addons")]  # named in a comment
        assert set(needed) <= set(modules), name


def test_modules_are_packed_as_the_page_unpacks_them() -> None:
    data = json.loads(zlib.decompress(base64.b64decode(packed("report/page.js"))))
    assert data == {"entry": "vrts/report/page.js", "sources": sources("report/page.js")}
    assert len(packed("report/page.js")) < 400_000


def test_our_modules_use_no_path_of_the_page() -> None:
    ours = [path for path in closure("report/page.js") if not path.startswith("vendor/")]
    assert len(ours) > 8
    for path in ours:
        assert not re.search(r"https?://(?!www\.w3\.org/2000/svg)", asset(path)), path
        assert "innerHTML" not in asset(path), path

"""The extension for VS Code: what is in the file, and that everything it names is there."""

import hashlib
import json
import posixpath
import re
import shutil
import subprocess
import tomllib
import zipfile
from importlib.resources import files
from io import BytesIO
from pathlib import Path, PurePosixPath
from urllib.parse import urlsplit
from urllib.request import url2pathname
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner

from vrts.cli.editors.editor_command import command
from vrts.debug.dap.adapter import Adapter
from vrts.editors.vsix import toml_validation, version, vsix
from vrts.lang.dialect import DIALECTS
from vrts.schemas import KINDS

ARCHIVE = zipfile.ZipFile(BytesIO(vsix()))
PACKAGE = json.loads(ARCHIVE.read("extension/package.json"))


def test_it_is_the_same_every_time_and_small() -> None:
    assert vsix() == vsix()
    assert len(vsix()) < 400_000
    assert ARCHIVE.testzip() is None


def test_everything_it_names_is_there() -> None:
    names = set(ARCHIVE.namelist())
    contributed = PACKAGE["contributes"]
    named = [
        PACKAGE["main"],
        contributed["languages"][0]["configuration"],
        contributed["grammars"][0]["path"],
        contributed["snippets"][0]["path"],
        PACKAGE["icon"],
    ]
    for path in named:
        assert f"extension/{path.removeprefix('./')}" in names
    manifest = ElementTree.fromstring(ARCHIVE.read("extension.vsixmanifest"))
    space = "{http://schemas.microsoft.com/developer/vsx-schema/2011}"
    assert all(asset.get("Path") in names for asset in manifest.iter(f"{space}Asset"))
    identity = next(manifest.iter(f"{space}Identity"))
    assert identity.get("Version") == PACKAGE["version"] == version()
    kinds = ElementTree.fromstring(ARCHIVE.read("[Content_Types].xml"))
    known = {default.get("Extension") for default in kinds}
    assert {Path(name).suffix for name in names if name != "[Content_Types].xml"} <= known


def test_files_are_checked_by_their_schemas() -> None:
    named = {
        Path(url2pathname(urlsplit(str(entry["url"])).path)): entry["fileMatch"]
        for entry in PACKAGE["contributes"]["tomlValidation"]
    }
    assert {path.name for path in named} == {f"{kind}.schema.json" for kind in KINDS}
    for path, names in named.items():
        assert json.loads(path.read_text("utf-8"))["type"] == "object"
        assert f"{path.name.removesuffix('.schema.json')}.toml" in names
    odd = toml_validation(Path("/a folder/ö"))
    assert odd[0]["url"] == "file:///a%20folder/%C3%B6/scene.schema.json"


def test_the_grammar_is_that_of_the_vocabulary() -> None:
    grammar = json.loads(ARCHIVE.read("extension/syntaxes/val2.tmLanguage.json"))
    assert grammar["scopeName"] == PACKAGE["contributes"]["grammars"][0]["scopeName"]
    kept = files("vrts.editors").joinpath("val2.tmLanguage.json").read_text("utf-8")
    assert grammar == json.loads(kept)


def test_the_debugger_takes_what_the_extension_offers() -> None:
    offered = PACKAGE["contributes"]["debuggers"][0]
    fields = offered["configurationAttributes"]["launch"]["properties"]
    taken = re.findall(r'\.\w+\("(\w+)"', Path(adapter_source()).read_text())
    assert set(fields) <= set(taken)
    assert set(fields["dialect"]["enum"]) == set(DIALECTS)
    assert offered["type"] == "vrts"


def adapter_source() -> str:
    source = Adapter.__init__.__code__.co_filename
    assert source.endswith("adapter.py")
    return source


def test_what_is_vendored_is_unmodified() -> None:
    told = tomllib.loads(ARCHIVE.read("extension/vendor/vendored.toml").decode())
    data = ARCHIVE.read("extension/vendor/languageclient.js")
    assert hashlib.sha256(data).hexdigest() == told["languageclient"]["sha256"]
    assert b"vscode-languageclient 9.0.1" in ARCHIVE.read("extension/vendor/LICENSES.txt")


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")
def test_the_script_is_sound(tmp_path: Path) -> None:
    ARCHIVE.extractall(tmp_path)
    ours = [path.name for path in (tmp_path / "extension").glob("*.js")]
    assert {"extension.js", "beside.js", "moving.js", "status.js"} <= set(ours)
    for name in (*ours, "vendor/languageclient.js"):
        path = tmp_path / "extension" / name
        checked = subprocess.run(
            ["node", "--check", str(path)], capture_output=True, text=True, check=False
        )
        assert checked.returncode == 0, checked.stderr
    script = (tmp_path / "extension" / "extension.js").read_text()
    commands = {entry["command"] for entry in PACKAGE["contributes"]["commands"]}
    assert set(re.findall(r'registerCommand\("([\w.]+)"', script)) == commands
    assert "exec(" not in script, "no shell reads a name"


def test_the_panel_has_all_that_it_loads_and_may_load_nothing_else() -> None:
    page = ARCHIVE.read("extension/web/beside/page.html").decode()
    names = set(ARCHIVE.namelist())
    loaded = re.findall(r"\{root\}/([\w./]+)", page)
    assert "beside/main.js" in loaded
    assert {f"extension/web/{path}" for path in loaded} <= names
    policy = re.search(r'Content-Security-Policy" content="([^"]+)"', page)
    assert policy is not None
    assert policy[1].startswith("default-src 'none'; script-src 'nonce-{nonce}' {source};")
    assert "unsafe" not in page
    inner = [name for name in names if name.startswith("extension/web/") and name.endswith(".js")]
    for name in inner:
        script = ARCHIVE.read(name).decode()
        folder = PurePosixPath(name).parent
        for path in re.findall(r'from\s*"(\.[^"]+)"', script):
            assert posixpath.normpath(str(folder / path)) in names
        if "/vendor/" not in name:
            assert "innerHTML" not in script, "texts are escaped"


def test_a_workspace_cannot_say_what_is_started() -> None:
    setting = PACKAGE["contributes"]["configuration"]["properties"]["vrts.path"]
    assert setting["scope"] == "machine"


def test_snippets_are_programs() -> None:
    snippets = json.loads(ARCHIVE.read("extension/snippets.json"))
    assert {"Program", "Pick", "Place"} <= set(snippets)


def test_the_command_writes_it_once(tmp_path: Path) -> None:
    path = tmp_path / "vrts.vsix"
    done = CliRunner().invoke(command, ["vscode", "-o", str(path)])
    assert done.exit_code == 0
    assert path.read_bytes() == vsix()
    again = CliRunner().invoke(command, ["vscode", "-o", str(path)])
    assert again.exit_code != 0

"""What sets Kate, Zed and nvim-dap up: read as they read it, and asked of the debugger as it is."""

import json
import re
import shutil
import sys
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import jsonschema
import pytest
from click.testing import CliRunner

from tests.unit.editors.test_highlighting import PROGRAMS, tokens
from tests.unit.editors.test_other_editors import run
from vrts.cli.editors.editor_command import EDITORS, command
from vrts.debug.dap.adapter import Adapter
from vrts.debug.dap.arguments import Fields
from vrts.editors.kate import definition
from vrts.editors.pygments_lexer import TOKENS
from vrts.editors.set_up import SET_UPS, written

NVIM = shutil.which("nvim")
PLUGIN = Path(sys.prefix) / "nvim-dap"  # put there by hand: its licence is the GPL
PROGRAM = ".PROGRAM main()\n x = 1\n x = x+1\n TYPE x\n.END\n"


def called(*words: str) -> str:
    done = CliRunner().invoke(command, list(words))
    assert done.exit_code == 0, done.output
    return done.output


def as_json(editor: str, file: str) -> Any:
    return json.loads(written(editor)[file])


def test_every_editor_is_listed_with_what_to_do() -> None:
    assert tuple(SET_UPS) == EDITORS
    rows = dict(line.split(maxsplit=1) for line in called().splitlines())
    for editor in EDITORS:
        assert f"`vrts editor {editor}" in rows[editor]
    assert "vrts dap" in rows["others"]


@pytest.mark.parametrize("editor", ["kate", "zed"])
def test_files_are_written_once_and_nothing_is_lost(editor: str, tmp_path: Path) -> None:
    folder = tmp_path / "new" / "folder"
    said = called(editor, "-o", str(folder))
    assert f"{folder}/README.txt says what to do" in said.replace("\n", "")
    files = {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}
    assert files == set(written(editor))
    read = (folder / "README.txt").read_text()
    assert all(
        Path(name).name in read
        for name in files
        if "/" not in name and name.endswith((".json", ".xml"))
    )
    (folder / "README.txt").write_text("mine")
    again = CliRunner().invoke(command, [editor, "-o", str(folder)])
    assert again.exit_code == 2
    assert "is there already" in again.output
    assert (folder / "README.txt").read_text() == "mine"
    called(editor, "-o", str(folder), "--overwrite")
    assert (folder / "README.txt").read_text() == read


def test_kate_colours_words_as_the_other_highlighters_do() -> None:
    rules = Kate(definition())
    for text in PROGRAMS:
        for line in text.splitlines():
            expected = [kind for kind, value in tokens(f"{line}\n") for _ in value][: len(line)]
            blank = [letter in " \t" for letter in line]
            found = list(rules.coloured(line))
            same = zip(found, expected, blank, strict=True)
            assert all(a is b or skip for a, b, skip in same), (line, found, expected)


class Kate:
    """Carries a definition out on one line, by the rules that Kate's manual gives."""

    def __init__(self, text: str) -> None:
        root = ElementTree.fromstring(text)
        names = {item.attrib["name"]: item.attrib["defStyleNum"] for item in root.iter("itemData")}
        self.contexts = {c.attrib["name"]: c for c in root.iter("context")}
        for rule in root.iter():
            assert rule.attrib.get("attribute", "blank") in names
            assert rule.attrib.get("context", "#stay") in {"#stay", *self.contexts}

    def coloured(self, line: str) -> Iterator[object]:
        context, at = self.contexts["step"], 0
        while at < len(line):
            for rule in context:
                pattern = rule.attrib.get("String", r"[ \t]+")
                hit = re.compile(pattern, re.IGNORECASE).match(line, at)
                if hit and hit.end() > at:
                    attribute = rule.attrib["attribute"]
                    yield from [TOKENS.get(attribute)] * (hit.end() - at)
                    at = hit.end()
                    context = self.contexts.get(rule.attrib.get("context", ""), context)
                    break
            else:
                assert "fallthroughContext" in context.attrib, (line, at)
                context = self.contexts[context.attrib["fallthroughContext"]]


def test_kate_starts_the_server_for_the_language_of_the_definition() -> None:
    (server,) = as_json("kate", "lspclient.json")["servers"].values()
    language = ElementTree.fromstring(definition()).attrib
    assert server["command"] == ["vrts", "lsp"]
    assert re.search(server["highlightingModeRegex"], language["name"])
    assert language["extensions"].split(";") == ["*.v2", "*.pg", "*.lc"]


def test_zed_has_an_extension_of_one_language_with_its_server_and_adapter() -> None:
    extension = tomllib.loads(written("zed")["extension.toml"].decode())
    language = tomllib.loads(written("zed")["languages/val2/config.toml"].decode())
    package = tomllib.loads(written("zed")["Cargo.toml"].decode())
    (server,), (adapter,) = extension["language_servers"], extension["debug_adapters"]
    assert extension["language_servers"][server]["languages"] == [language["name"]]
    assert language["path_suffixes"] == ["v2", "pg", "lc"]
    assert language["debuggers"] == [adapter]
    assert extension["schema_version"] == 1
    assert package["lib"]["path"] in written("zed")
    assert as_json("zed", "settings.json")["languages"][language["name"]]["language_servers"] == [
        server
    ]
    schema = as_json("zed", extension["debug_adapters"][adapter]["schema_path"])
    jsonschema.Draft7Validator.check_schema(schema)
    (launch,) = as_json("zed", "debug.json")
    assert launch["adapter"] == adapter
    jsonschema.validate(launch, schema)


def kate_launch() -> Mapping[str, Any]:
    (adapter,) = as_json("kate", "dap.json")["dap"].values()
    assert adapter["run"]["command"] == ["vrts", "dap"]
    (configuration,) = adapter["configurations"].values()
    assert configuration["request"]["command"] == "launch"
    return configuration["request"]


def zed_launch() -> Mapping[str, Any]:
    return as_json("zed", "debug.json")[0]


@pytest.mark.parametrize("launch", [kate_launch, zed_launch])
def test_the_debugger_takes_what_they_launch(launch: Any, tmp_path: Path) -> None:
    program = tmp_path / "prog.v2"
    program.write_text(PROGRAM)
    text = json.dumps(launch()).replace("${file}", str(program)).replace("$ZED_FILE", str(program))
    adapter = Adapter(lambda _name, _body: None)
    adapter.answer("initialize", Fields({}))
    adapter.answer("launch", Fields(json.loads(text)))
    told = adapter.answer("configurationDone", Fields({})).events
    assert [body["reason"] for name, body in told if name == "stopped"] == ["entry"]


SESSION = """
local ok, why = pcall(function()
vim.opt.runtimepath:append(PLUGIN)
vim.cmd("luafile init.lua")
vim.cmd("edit prog.v2")
local dap = require("dap")
local stood = {}
local function at(line)
  assert(vim.wait(60000, function()
    local frame = dap.session() and dap.session().current_frame
    return frame ~= nil and frame.line == line
  end, 10), "never at line " .. line)
  table.insert(stood, line)
end
vim.fn.cursor(4, 1)
dap.toggle_breakpoint()
dap.run(dap.configurations.val2[1])
at(2)
dap.continue()
at(4)
dap.step_back()
at(3)
dap.reverse_continue()
at(2)
io.stdout:write("stood at " .. table.concat(stood, " "))
dap.terminate()
end)
if not ok then io.stdout:write(tostring(why)) end
vim.cmd("qa!")
"""


@pytest.mark.skipif(NVIM is None, reason="needs Neovim")
@pytest.mark.skipif(not PLUGIN.is_dir(), reason=f"needs nvim-dap in {PLUGIN}")
def test_nvim_dap_goes_forward_and_back(tmp_path: Path) -> None:
    assert NVIM is not None
    (tmp_path / "init.lua").write_text(called("neovim"))
    (tmp_path / "session.lua").write_text(f"local PLUGIN = {str(PLUGIN)!r}\n{SESSION}")
    (tmp_path / "prog.v2").write_text(PROGRAM)
    words = [NVIM, "--headless", "-u", "NONE", "-c", "luafile session.lua"]
    assert "stood at 2 4 3 2" in run(words, tmp_path)


TOLD = """
package.preload["dap"] = function() return { adapters = {}, configurations = {} } end
vim.cmd("luafile init.lua")
local dap = require("dap")
io.stdout:write(vim.json.encode({ dap.adapters, dap.configurations, vim.lsp.commands ~= nil }))
vim.cmd("qa!")
"""


@pytest.mark.skipif(NVIM is None, reason="needs Neovim")
def test_nvim_dap_is_told_an_adapter_on_stdio_and_a_program_to_launch(tmp_path: Path) -> None:
    assert NVIM is not None
    (tmp_path / "init.lua").write_text(called("nvim-dap"))
    (tmp_path / "told.lua").write_text(TOLD)
    said = run([NVIM, "--headless", "-u", "NONE", "-c", "luafile told.lua"], tmp_path)
    adapters, configurations, _ = json.loads(said)
    assert adapters["vrts"] == {"type": "executable", "command": "vrts", "args": ["dap"]}
    (launch,) = configurations["val2"]
    assert (launch["type"], launch["request"], launch["program"]) == ("vrts", "launch", "${file}")

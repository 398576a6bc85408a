"""A session in a real editor: Neovim without a screen."""

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

NEOVIM = shutil.which("nvim")
TEXT = """.PROGRAM main
        MOVEE part
        MOVE part
.END
.LOCATIONS
part            450 -120 -50 90 90 0
.END
"""
BEGIN = """
local out = {}
local id = vim.lsp.start_client({
  name = "vrts", cmd = vim.fn.json_decode(vim.env.VRTS_COMMAND), root_dir = vim.fn.getcwd(),
})
vim.lsp.buf_attach_client(0, id)
"""
END = """
vim.fn.writefile({vim.fn.json_encode(out)}, "result.json")
vim.lsp.stop_client(id)
vim.wait(2000, function() return vim.lsp.client_is_stopped(id) end, 20)
vim.cmd("qa!")
"""
ASKING = """
local function at(line, column) vim.api.nvim_win_set_cursor(0, {line, column}) end
local function ask(method, more)
  local params = vim.tbl_extend("force", vim.lsp.util.make_position_params(0, "utf-16"), more or {})
  local found = vim.lsp.buf_request_sync(0, method, params, 30000)
  for _, answer in pairs(found or {}) do return answer.result end
end
vim.wait(30000, function() return #vim.diagnostic.get(0) > 0 end, 20)
local found = {}
for _, d in ipairs(vim.diagnostic.get(0)) do
  table.insert(found, {d.lnum, d.col, d.code, d.message})
end
at(3, 14)
local hover = ask("textDocument/hover").contents.value
vim.api.nvim_buf_set_lines(0, 1, 2, false, {"        APP"})
at(2, 10)
vim.cmd("startinsert!")
local items = {}
local asked = {position = {line = 1, character = 11}}
for _, item in ipairs(ask("textDocument/completion", asked).items) do
  table.insert(items, item.label)
end
out = {diagnostics = found, hover = hover, completion = items}
"""
MENDING = """
local function finding(code)
  for _, d in ipairs(vim.diagnostic.get(0)) do if d.code == code then return d end end
end
vim.wait(60000, function() return finding("V302") ~= nil end, 50)
local d = finding("V302")
vim.api.nvim_win_set_cursor(0, {d.lnum + 1, d.col + 1})
local asked = vim.lsp.util.make_range_params(0, "utf-16")
asked.context = {diagnostics = {}}
local actions = {}
vim.wait(60000, function()
  local found = vim.lsp.buf_request_sync(0, "textDocument/codeAction", asked, 30000) or {}
  for _, answer in pairs(found) do actions = answer.result or {} end
  return #actions > 0
end, 200)
vim.lsp.util.apply_workspace_edit(actions[1].edit, "utf-16")
vim.wait(60000, function() return finding("V302") == nil end, 50)
out = {
  source = d.source, gone = finding("V302") == nil,
  lines = vim.api.nvim_buf_get_lines(0, 0, -1, false),
}
"""
TOO_FAST = """.PROGRAM main
        DRIVE 2, 45, 100
        DRIVE 3, 30, 100
        DRIVE 5, 6, 100
        HERE p
        MOVES SHIFT(p BY 0,-400,0)
.END
"""


def session(folder: Path, text: str, script: str) -> dict[str, Any]:
    """Return what a session in Neovim has written."""
    assert NEOVIM is not None
    (folder / "a.v2").write_text(text, "utf-8")
    (folder / "session.lua").write_text(BEGIN + script + END, "utf-8")
    command = json.dumps([sys.executable, "-m", "vrts.cli.main", "lsp"])
    done = subprocess.run(
        [NEOVIM, "--headless", "--clean", "a.v2", "-c", "luafile session.lua"],
        cwd=folder,
        env={"HOME": str(folder), "PATH": "/usr/bin:/bin", "VRTS_COMMAND": command},
        capture_output=True,
        text=True,
        timeout=240,
    )
    result = folder / "result.json"
    assert result.exists(), done.stderr
    return json.loads(result.read_text("utf-8"))


@pytest.mark.skipif(NEOVIM is None, reason="needs Neovim")
def test_diagnostics_hover_and_completion_in_neovim(tmp_path: Path) -> None:
    found = session(tmp_path, TEXT, ASKING)
    ((line, column, code, message),) = found["diagnostics"]
    assert (line, column, code) == (1, 8, "V120")
    assert "did you mean `MOVE`?" in message
    assert "450.00   -120.00    -50.00" in found["hover"]
    assert found["completion"] == ["APPRO", "APPROS"]


@pytest.mark.thorough
@pytest.mark.skipif(NEOVIM is None, reason="needs Neovim")
def test_the_speed_that_would_do_in_neovim(tmp_path: Path) -> None:
    found = session(tmp_path, TOO_FAST, MENDING)
    assert found["source"] == "vrts verify"
    assert found["gone"]
    assert found["lines"][5].startswith("        SPEED ")
    assert found["lines"][6] == "        MOVES SHIFT(p BY 0,-400,0)"

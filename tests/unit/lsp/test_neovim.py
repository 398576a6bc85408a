"""A session in a real editor: Neovim without a screen."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

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
SCRIPT = """
local out = {}
local function at(line, column) vim.api.nvim_win_set_cursor(0, {line, column}) end
local function ask(method, more)
  local params = vim.tbl_extend("force", vim.lsp.util.make_position_params(0, "utf-16"), more or {})
  local found = vim.lsp.buf_request_sync(0, method, params, 30000)
  for _, answer in pairs(found or {}) do return answer.result end
end
local id = vim.lsp.start_client({
  name = "vrts", cmd = vim.fn.json_decode(vim.env.VRTS_COMMAND), root_dir = vim.fn.getcwd(),
})
vim.lsp.buf_attach_client(0, id)
vim.wait(30000, function() return #vim.diagnostic.get(0) > 0 end, 20)
for _, d in ipairs(vim.diagnostic.get(0)) do
  table.insert(out, {d.lnum, d.col, d.code, d.message})
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
local result = vim.fn.json_encode({diagnostics = out, hover = hover, completion = items})
vim.fn.writefile({result}, "result.json")
vim.lsp.stop_client(id)
vim.wait(2000, function() return vim.lsp.client_is_stopped(id) end, 20)
vim.cmd("qa!")
"""


@pytest.mark.skipif(NEOVIM is None, reason="needs Neovim")
def test_diagnostics_hover_and_completion_in_neovim(tmp_path: Path) -> None:
    assert NEOVIM is not None
    (tmp_path / "a.v2").write_text(TEXT, "utf-8")
    (tmp_path / "session.lua").write_text(SCRIPT, "utf-8")
    command = json.dumps([sys.executable, "-m", "vrts.cli.main", "lsp"])
    done = subprocess.run(
        [NEOVIM, "--headless", "--clean", "a.v2", "-c", "luafile session.lua"],
        cwd=tmp_path,
        env={"HOME": str(tmp_path), "PATH": "/usr/bin:/bin", "VRTS_COMMAND": command},
        capture_output=True,
        text=True,
        timeout=120,
    )
    result = tmp_path / "result.json"
    assert result.exists(), done.stderr
    found = json.loads(result.read_text("utf-8"))
    ((line, column, code, message),) = found["diagnostics"]
    assert (line, column, code) == (1, 8, "V120")
    assert "did you mean `MOVE`?" in message
    assert "450.00   -120.00    -50.00" in found["hover"]
    assert found["completion"] == ["APPRO", "APPROS"]

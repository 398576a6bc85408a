"""The lines that set up Neovim and Emacs: in the manual as printed, and in real editors."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.support_programs import ROOT
from vrts.cli.editors.editor_command import command

BAD = ".PROGRAM main()\n MOVEE safe\n.END\n"
NVIM, EMACS = shutil.which("nvim"), shutil.which("emacs")
SECONDS = 150


def printed(editor: str) -> str:
    done = CliRunner().invoke(command, [editor])
    assert done.exit_code == 0
    return done.stdout


def run(words: list[str], folder: Path) -> str:
    """Run an editor that finds our vrts; return what it writes."""
    path = os.pathsep.join((str(Path(sys.executable).parent), os.environ["PATH"]))
    done = subprocess.run(
        words,
        cwd=folder,
        env={**os.environ, "PATH": path, "HOME": str(folder)},
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )
    return done.stdout + done.stderr


@pytest.mark.parametrize("editor", ["neovim", "emacs"])
def test_the_language_takes_three_lines_which_the_manual_shows(editor: str) -> None:
    lines = printed(editor).split("\n\n")[0].splitlines()
    assert len(lines) == 3
    page = (ROOT / "vrts" / "manual" / "learn" / "editors.md").read_text()
    assert all(line in page for line in lines)


ONE_SERVER = """
local ok, why = pcall(function()
local bad = function(buffer) return #vim.diagnostic.get(buffer) > 0 end
vim.cmd("edit b.v2")
local first, second = vim.fn.bufnr("a.v2"), vim.fn.bufnr("b.v2")
vim.wait(60000, function() return bad(first) and bad(second) end, 50)
local clients = vim.lsp.get_active_clients()
local uri = vim.uri_from_bufnr(second)
local asked = { command = "vrts.run", arguments = { uri, "other" } }
local answers = vim.lsp.buf_request_sync(0, "workspace/executeCommand", asked, 60000)
local text = answers[clients[1].id].result.text
vim.lsp.stop_client(clients[1].id)
vim.wait(10000, function() return vim.lsp.client_is_stopped(clients[1].id) end, 20)
vim.cmd("edit c.v2")
vim.wait(10000, function() return #vim.lsp.get_active_clients() > 0 end, 20)
local again = vim.lsp.get_active_clients()[1].id ~= clients[1].id
io.stdout:write(#clients .. " server, " .. text .. " another: " .. tostring(again))
end)
if not ok then io.stdout:write(tostring(why)) end
vim.cmd("qa!")
"""


@pytest.mark.thorough
@pytest.mark.skipif(NVIM is None, reason="needs Neovim")
def test_neovim_has_one_server_for_all_buffers_and_runs_a_program_by_it(tmp_path: Path) -> None:
    assert NVIM is not None
    (tmp_path / "init.lua").write_text(printed("neovim"))
    (tmp_path / "session.lua").write_text(ONE_SERVER)
    (tmp_path / "a.v2").write_text(BAD)
    other = '.PROGRAM main()\n MOVE safe\n.END\n.PROGRAM other()\n TYPE "turned"\n.END\n'
    (tmp_path / "b.v2").write_text(other)
    words = [NVIM, "--headless", "-u", "init.lua", "a.v2", "-c", "luafile session.lua"]
    said = run(words, tmp_path)
    assert "1 server, turned" in said
    assert "another: true" in said


@pytest.mark.skipif(NVIM is None, reason="needs Neovim")
def test_neovim_tells_mistakes(tmp_path: Path) -> None:
    assert NVIM is not None
    (tmp_path / "init.lua").write_text(printed("neovim"))
    (tmp_path / "bad.v2").write_text(BAD)
    wait = "lua vim.wait(30000, function() return #vim.diagnostic.get(0) > 0 end, 50)"
    tell = "lua io.stdout:write(vim.bo.filetype .. ' ' .. vim.diagnostic.get(0)[1].code)"
    commands = [word for line in (wait, tell, "qa!") for word in ("-c", line)]
    said = run([NVIM, "--headless", "-u", "init.lua", "bad.v2", *commands], tmp_path)
    assert "val2 V120" in said


@pytest.mark.skipif(EMACS is None, reason="needs Emacs")
def test_emacs_knows_the_language(tmp_path: Path) -> None:
    assert EMACS is not None
    (tmp_path / "init.el").write_text(printed("emacs"))
    (tmp_path / "bad.v2").write_text(BAD)
    told = '(progn (find-file "bad.v2") (princ major-mode))'
    assert "val2-mode" in run([EMACS, "-Q", "--batch", "-l", "init.el", "--eval", told], tmp_path)

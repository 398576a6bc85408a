"""What sets editors up for VAL-II: lines to print, or files to write, and what to do with them."""

from collections.abc import Mapping, Sequence
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import NamedTuple

from vrts.editors.kate import definition


class SetUp(NamedTuple):
    """How one editor is set up."""

    says: str  # what to do, in one sentence
    printed: Sequence[str] = ()  # files of this room, whose lines are printed
    folder: str = ""  # of this room, which is written


SET_UPS: Mapping[str, SetUp] = {
    "vscode": SetUp("`vrts editor vscode`, then `code --install-extension vrts.vsix`"),
    "neovim": SetUp(
        "`vrts editor neovim >> ~/.config/nvim/init.lua`; its last lines are for nvim-dap",
        ("neovim.lua", "nvim-dap.lua"),
    ),
    "nvim-dap": SetUp(
        "the debugger alone, where Neovim has a language server already:"
        " `vrts editor nvim-dap >> ~/.config/nvim/init.lua`",
        ("nvim-dap.lua",),
    ),
    "emacs": SetUp("`vrts editor emacs >> ~/.emacs`; for eglot", ("emacs.el",)),
    "helix": SetUp(
        "`vrts editor helix >> ~/.config/helix/languages.toml`; without colours", ("helix.toml",)
    ),
    "kate": SetUp("`vrts editor kate`, then do what vrts-kate/README.txt says", (), "kate"),
    "zed": SetUp(
        "`vrts editor zed`, then do what vrts-zed/README.txt says; not tried in Zed itself",
        (),
        "zed",
    ),
}


def listed() -> str:
    """Return all editors, and what to do for each."""
    width = max(map(len, SET_UPS))
    rows = [f"{name:<{width}}  {each.says}" for name, each in SET_UPS.items()]
    rows.append(f"{'others':<{width}}  start `vrts lsp` (language server) and `vrts dap` on stdio")
    return "\n".join(rows)


def printed(name: str) -> str:
    """Return the lines that an editor's set-up takes."""
    room = files("vrts.editors")
    return "\n".join(room.joinpath(file).read_text("utf-8") for file in SET_UPS[name].printed)


def written(name: str) -> dict[str, bytes]:
    """Return the files of an editor's set-up by their paths in its folder."""
    found = dict(_files(files("vrts.editors").joinpath(SET_UPS[name].folder), ""))
    if name == "kate":
        found["val2.xml"] = definition().encode("utf-8")
    return found


def _files(folder: Traversable, before: str) -> list[tuple[str, bytes]]:
    found: list[tuple[str, bytes]] = []
    for item in sorted(folder.iterdir(), key=lambda item: item.name):
        path = f"{before}{item.name}"
        found += _files(item, f"{path}/") if item.is_dir() else [(path, item.read_bytes())]
    return found

"""The browser's files, and modules inlined so that a page needs no server and no network.

A page opened from `file://` may not load other files, so it holds every module, and these become
`data:` URLs in an import map. Relative imports cannot be resolved against a `data:` URL; they are
rewritten to the bare names under which the map holds the modules.
"""

import base64
import json
import posixpath
import re
import zlib
from functools import cache
from importlib.resources import files

THREE = "vendor/three/three.module.min.js"
CODEMIRROR = "vendor/codemirror"
BARE = {  # paths of vendored modules, by the names under which others import them
    "three": THREE,
    **{
        f"@codemirror/{name}": f"{CODEMIRROR}/{name}.js"
        for name in ("autocomplete", "commands", "language", "lint", "search", "state")
    },
    "@codemirror/streamparser": f"{CODEMIRROR}/streamparser.js",
    "@codemirror/view": f"{CODEMIRROR}/view.js",
    **{f"@lezer/{name}": f"{CODEMIRROR}/lezer-{name}.js" for name in ("common", "highlight", "lr")},
    "@marijn/find-cluster-break": f"{CODEMIRROR}/find-cluster-break.js",
    **{name: f"{CODEMIRROR}/{name}.js" for name in ("crelt", "style-mod", "w3c-keyname")},
}

_BARE = "|".join(map(re.escape, BARE))
_IMPORT = re.compile(rf"""(\bfrom\s*|\bimport\s*)(["'])({_BARE}|\.{{1,2}}/[^"'\n]+)\2""")


@cache
def asset(path: str) -> str:
    """Return the text of a file below `vrts/web`, by its path with forward slashes."""
    return files("vrts.web").joinpath(path).read_text(encoding="utf-8")


def module_name(path: str) -> str:
    """Return the bare name of a module in the import map."""
    return f"vrts/{path}"


@cache
def imports(path: str) -> tuple[str, ...]:
    """Return the paths of the modules that a module imports directly."""
    found = (target(path, match[3]) for match in _IMPORT.finditer(asset(path)))
    return tuple(dict.fromkeys(found))


@cache
def closure(path: str) -> tuple[str, ...]:
    """Return a module and all that it needs, each once, in a fixed order."""
    found: list[str] = []
    pending = [path]
    while pending:
        current = pending.pop()
        if current not in found:
            found.append(current)
            pending += reversed(imports(current))
    return tuple(found)


def sources(entry: str) -> dict[str, str]:
    """Return a module and all that it needs, as an import map names them."""
    return {module_name(path): _source(path) for path in closure(entry)}


@cache
def packed(entry: str) -> str:
    """Return the same for `report/unpack.js`: JSON, deflated, in base64."""
    data = {"entry": module_name(entry), "sources": sources(entry)}
    text = json.dumps(data, separators=(",", ":"))
    return base64.b64encode(zlib.compress(text.encode(), 9)).decode("ascii")


def _source(path: str) -> str:
    return _IMPORT.sub(
        lambda match: f"{match[1]}{match[2]}{module_name(target(path, match[3]))}{match[2]}",
        asset(path),
    )


def target(path: str, specifier: str) -> str:
    """Return the path of what a module means by a name or a relative path."""
    if specifier in BARE:
        return BARE[specifier]
    return posixpath.normpath(posixpath.join(posixpath.dirname(path), specifier))


def served(path: str) -> str:
    """Return a module as a server sends it below `/web/`: bare names become paths."""
    return _IMPORT.sub(
        lambda match: (
            f"{match[1]}{match[2]}/web/{BARE[match[3]]}{match[2]}" if match[3] in BARE else match[0]
        ),
        asset(path),
    )

"""A page's modules and style sheets put together, so that few files cross a slow line.

Each answer over HTTP costs a round trip, and a browser has six at a time under way: on a phone
fifty small modules take longer than their bytes. What a page needs at once is one file, what it
loads later one file for each place where it says `import("…")`. A module stands in one bundle only,
so its state is there once; under its own address a browser finds the same module, taken from there.

A page that was opened before an upgrade holds modules of before, and what it loads later is of now.
So a page knows which bundles it belongs to, and what is loaded later begins by looking there: it
runs in no other page.

Nothing is built beforehand and nothing is parsed: our modules keep to one style of imports and
exports (a test looks), and what is met besides raises `ValueError`. Vendored modules stay files of
their own.
"""

import hashlib
import re
from functools import cache, cached_property
from typing import Final, NamedTuple

from vrts.web.assets import asset, closure, imports, target

_COMMENT = re.compile(r"/\*\*(?:[^*]|\*(?!/))*\*/|^[ \t]*//.*\n", re.M)
_IMPORT = re.compile(r"""^import\s+(?:\{([^}]*)\}\s*from\s*)?["']([^"']+)["'];?[ \t]*\n""", re.M)
_EXPORT = re.compile(r"^export (?=(?:async )?function (\w+)|class (\w+)|const (\w+))", re.M)
_LATER = re.compile(r"""\bimport\((["'])(\.{1,2}/[^"']+)\1\)(?=[),;\]])""")
_NOT_FOUND = re.compile(r"""\bimport\(\s*["'`]\..*""")  # an import that `_LATER` does not know
_FOREIGN = re.compile(
    r"^(?:import|export)\b.*|^(?![ \t]|async |\}).*\bawait\b.*|\bimport\.meta\b.*", re.M
)
_SHEET = re.compile(r'[ \t]*<link rel="stylesheet" href="/web/([^"]+)">\n')
_SCRIPT = re.compile(r'<script type="module" src="/web/([^"]+)">')
_LOW: Final = ' fetchpriority="low"'
_VENDOR: Final = "vendor/"
_MADE: Final = "vrts-made"  # name of the page's `meta` that says which bundles it belongs to
_OF_NOW: Final = (  # what is loaded later begins with it
    f"if (document.querySelector('meta[name={_MADE}]')?.content !== \"%s\") "
    'throw new Error("the server has another version of vrts now");\n'
)


class Module(NamedTuple):
    """A module taken apart."""

    taken: tuple[tuple[str, str], ...]  # names as imports write them, path of where from
    body: str
    exports: tuple[str, ...]


class Bundles:
    """The bundles of one page."""

    def __init__(self, page: str) -> None:
        """Put together what a page needs, by its path below `vrts/web`."""
        self.page = page
        self.entries = tuple(_SCRIPT.findall(asset(page)))
        self._owners: dict[str, str] = {}
        for entry in self.entries:
            for path in _ours(entry):
                self._owners.setdefault(path, entry)
        self._share_out()

    def holds(self, path: str) -> bool:
        """Return whether a module stands in a bundle."""
        return path in self._owners

    @property
    def paths(self) -> tuple[str, ...]:
        """The paths of all bundles."""
        return tuple(dict.fromkeys(self._owners.values()))

    def owner(self, path: str) -> str:
        """Return the path of the bundle that a module stands in."""
        return self._owners[path]

    def parts(self, bundle: str) -> tuple[str, ...]:
        """Return the modules of a bundle, each after those that it imports."""
        own = [path for path in _ours(bundle) if self._owners[path] == bundle]
        found: list[str] = []
        for path in own:
            _after_its_imports(path, own, found, ())
        return tuple(found)

    def text(self, path: str) -> str:
        """Return what is served under the address of a module: its bundle, or the module from it.

        Raises:
            ValueError: A module is written in another style than a bundle can take.
        """
        owner = self._owners[path]
        if owner != path:
            exports = ", ".join(_module(path).exports)
            return (
                f'import {{ {_name(path)} }} from "/web/{owner}";\n'
                f"export const {{ {exports} }} = {_name(path)};\n"
            )
        return self._bundle(path)

    def html(self) -> str:
        """Return the page: one style sheet, and every module that it needs is asked for at once.

        The style sheet and the first module come before the others.
        """
        text = asset(self.page)
        first = _SHEET.findall(text)[0]
        one = f'  <link rel="stylesheet" href="/web/{self.sheet}">\n'
        text = _SHEET.sub(lambda match: one if match[1] == first else "", text)
        vendored = (p for e in self.entries for p in closure(e) if p.startswith(_VENDOR))
        first_entry, *rest = dict.fromkeys([*self.entries, *vendored])
        made = f'  <meta name="{_MADE}" content="{self.made}">\n'
        links = [made, _preload(first_entry, ""), *(_preload(path, _LOW) for path in rest)]
        for entry in self.entries[1:]:
            text = text.replace(f'src="/web/{entry}"', f'src="/web/{entry}"{_LOW}')
        return text.replace("</head>", f"{''.join(links)}</head>", 1)

    @property
    def sheet(self) -> str:
        """The path of the style sheet that holds all of the page's."""
        return self.page.removesuffix(".html") + ".css"

    @cached_property
    def made(self) -> str:
        """Tell these bundles from those of another version."""
        every = "\0".join(f"{path}\0{asset(path)}" for path in sorted(self._owners))
        return hashlib.sha256(every.encode()).hexdigest()[:16]

    def css(self) -> str:
        """Return the style sheets of the page, in their order."""
        return "\n".join(asset(path) for path in _SHEET.findall(asset(self.page)))

    def _share_out(self) -> None:
        """Give what is loaded later to who alone loads it; what several load stays by itself."""
        pending, asked = list(self._owners), dict[str, set[str]]()
        later: list[str] = []
        while pending:
            for entry in _later(pending.pop()):
                if entry in later or entry in self._owners:
                    continue
                later.append(entry)
                for path in _ours(entry):
                    asked.setdefault(path, set()).add(entry)
                    pending.append(path)
        for path, by in asked.items():
            if path not in self._owners:
                alone = path not in later and len(by) == 1
                self._owners[path] = next(iter(by)) if alone else path

    def _bundle(self, path: str) -> str:
        parts = self.parts(path)
        wanted = (source for part in parts for _, source in _module(part).taken)
        head = (self._from(source) for source in dict.fromkeys(wanted) if source not in parts)
        pieces = [_closed(part) for part in parts if part != path]
        exports = _module(path).exports  # the bundle has these itself, and all its modules by name
        of_now = "" if path in self.entries else _OF_NOW % self.made
        own = f"const {_name(path)} = {{ {', '.join(exports)} }};\n"
        given = ", ".join([*map(_name, parts), *exports])
        return (
            f"{''.join(head)}{of_now}{''.join(pieces)}{_opened(path)}{own}export {{ {given} }};\n"
        )

    def _from(self, source: str) -> str:
        if source.startswith(_VENDOR):
            return f'import * as {_name(source)} from "/web/{source}";\n'
        return f'import {{ {_name(source)} }} from "/web/{self._owners[source]}";\n'


def _preload(path: str, priority: str) -> str:
    return f'  <link rel="modulepreload" href="/web/{path}"{priority}>\n'


def _closed(path: str) -> str:
    """Return a module as a constant that holds its exports."""
    given = ", ".join(_module(path).exports)
    return f"const {_name(path)} = (() => {{\n{_opened(path)}return {{ {given} }};\n}})();\n"


def _opened(path: str) -> str:
    """Return what a module does, after what it imports."""
    module = _module(path)
    return "".join(_taken(names, source) for names, source in module.taken) + module.body


def _taken(names: str, source: str) -> str:
    """Return what an import of names is within a bundle."""
    fields = (re.sub(r"\s+as\s+", ": ", name.strip()) for name in names.split(","))
    kept = ", ".join(field for field in fields if field)
    return f"const {{ {kept} }} = {_name(source)};\n" if kept else ""


def _name(path: str) -> str:
    """Return the name under which a bundle holds a module."""
    return "$" + re.sub(r"\W", "_", path.removesuffix(".js"))


def _after_its_imports(path: str, own: list[str], found: list[str], above: tuple[str, ...]) -> None:
    if path in found or path not in own:
        return
    if path in above:
        way = " imports ".join((*above[above.index(path) :], path))
        raise ValueError(f"{path} cannot stand in a bundle: {way}")
    for needed in imports(path):
        _after_its_imports(needed, own, found, (*above, path))
    found.append(path)


def _ours(entry: str) -> tuple[str, ...]:
    return tuple(path for path in closure(entry) if not path.startswith(_VENDOR))


@cache
def _later(path: str) -> tuple[str, ...]:
    """Return the modules that a module loads when they are wanted."""
    text = _COMMENT.sub("", asset(path))
    return tuple(dict.fromkeys(target(path, match[2]) for match in _LATER.finditer(text)))


@cache
def _module(path: str) -> Module:
    return taken_apart(path, asset(path))


def taken_apart(path: str, source: str) -> Module:
    """Return what a bundle takes of a module's text.

    Raises:
        ValueError: It is written in another style.
    """
    text = _COMMENT.sub("", source)
    taken = tuple((match[1] or "", target(path, match[2])) for match in _IMPORT.finditer(text))
    exports = tuple(next(filter(None, match.groups())) for match in _EXPORT.finditer(text))
    body = _EXPORT.sub("", _IMPORT.sub("", text))
    foreign = _FOREIGN.search(body)
    if foreign:
        raise ValueError(f"{path} cannot stand in a bundle: {foreign[0]}")
    body = _LATER.sub(lambda match: f'import("/web/{target(path, match[2])}")', body)
    unknown = _NOT_FOUND.search(body)
    if unknown:
        raise ValueError(f"{path} cannot stand in a bundle: {unknown[0]}")
    return Module(taken, body if body.endswith("\n") else f"{body}\n", exports)

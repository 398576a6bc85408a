"""What no document gives and somebody had to decide, found by the mark that stands beside it.

Every such number carries the word *assumed* in its comment, every such rule the word in brackets in
its docstring. This list of decisions is made of those marks, so it cannot fall behind them.
"""

import ast
import io
import re
import tokenize
from collections.abc import Iterator, Mapping
from typing import NamedTuple

MARK = re.compile(r"\bassumed\b")
_BRACKETED = re.compile(r"\s*\[assumed(?:, ([^\]]*))?\]")
_LONGEST = 60  # characters of a value
_Documented = ast.Module | ast.FunctionDef | ast.ClassDef


class Assumption(NamedTuple):
    """One decision."""

    where: str  # module, without `vrts.`
    name: str  # of the constant, field or rule
    value: str  # as the source writes it; empty: a rule
    why: str  # the words beside it
    about: str  # page and rule of the manual, where one is named
    uses: tuple[str, ...] = ()  # functions and classes that read it

    @property
    def what(self) -> str:
        """The name, and the value where there is one."""
        return f"{self.name} = {self.value}" if self.value else self.name


def decisions(sources: Mapping[str, str]) -> list[Assumption]:
    """Return the decisions marked in modules, each with where it is used.

    Args:
        sources: Text of every module, by its name without `vrts.`.
    """
    found = [a for module, text in sources.items() for a in assumptions_in(module, text)]
    names = {n.rpartition(".")[2] for a in found if a.value for n in a.name.split(", ")}
    wanted = re.compile(rf"\b(?:{'|'.join(sorted(map(re.escape, names)))})\b")
    uses: dict[tuple[str, str], list[str]] = {}
    for module, text in sources.items():
        if names and wanted.search(text):
            for key, place in _reads(module, ast.parse(text), names):
                known = uses.setdefault(key, [])
                if place not in known:
                    known.append(place)
    return [_with_uses(assumption, uses) for assumption in found]


def assumptions_in(module: str, text: str) -> list[Assumption]:
    """Return the decisions marked in the source of a module, in its order."""
    if not MARK.search(text):
        return []
    tree = ast.parse(text)
    found = [*_in_comments(module, text, tree), *_in_words(module, tree)]
    return [assumption for _, assumption in sorted(found, key=lambda item: item[0])]


# --- marks ----------------------------------------------------------------------------------------


def _in_comments(module: str, text: str, tree: ast.Module) -> Iterator[tuple[int, Assumption]]:
    lines = text.splitlines()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and MARK.search(token.string):
            line, column = token.start
            alone = not lines[line - 1][:column].strip()  # about the line below
            name, value = _named(tree, line + 1 if alone else line)
            words = token.string.lstrip("# ")
            yield line, _assumption(module, name or module, value, words)


def _in_words(module: str, tree: ast.Module) -> Iterator[tuple[int, Assumption]]:
    """Yield the marks in docstrings, and in texts that stand in tables."""
    docstrings: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, _Documented):
            raw = ast.get_docstring(node, clean=False) or ""
            docstrings.add(raw)
            words = " ".join(raw.split())
            for match in _BRACKETED.finditer(words):
                sentence = re.split(r"(?<=[.;:]) ", words[: match.start()])[-1]
                name = module if isinstance(node, ast.Module) else _title(node)
                line = 0 if isinstance(node, ast.Module) else node.lineno
                yield line, Assumption(module, name, "", sentence.strip(), match[1] or "")
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            for text in node.args:
                words = text.value if isinstance(text, ast.Constant) else None
                if isinstance(words, str) and _BRACKETED.search(words):
                    yield node.lineno, _assumption(module, *_row(node), words)


def _title(node: ast.FunctionDef | ast.ClassDef) -> str:
    return f"{node.name}()" if isinstance(node, ast.FunctionDef) else node.name


def _row(node: ast.Call) -> tuple[str, str]:
    """Return name and value of a row of a table: its first two operands."""
    name, value = (_short(argument) for argument in node.args[:2])
    return name, value


def _named(tree: ast.Module, line: int) -> tuple[str, str]:
    """Return the name that the smallest thing on a line has in its module, and its value."""
    path: list[str] = []
    value: ast.expr | None = None
    node: ast.AST | None = tree
    while node is not None:
        inside = [child for child in ast.iter_child_nodes(node) if _spans(child, line)]
        node = inside[0] if inside else None
        match node:
            case ast.Assign(targets=[target, *_]):
                path.append(_short(target).strip("()"))
                value = node.value
            case ast.AnnAssign(target=target):
                path.append(_short(target))
                value = node.value
            case ast.keyword(arg=str(name)):
                path.append(name)
                value = node.value
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                path.append(name)
            case ast.Call() if path and node.lineno == line and value is None:
                value = node
            case _:
                pass
        if isinstance(node, ast.expr) and node.lineno == line and value is not None:
            break
    return ".".join(path), "" if value is None else _short(value)


def _spans(node: ast.AST, line: int) -> bool:
    first, last = getattr(node, "lineno", None), getattr(node, "end_lineno", None)
    return first is not None and last is not None and first <= line <= last


def _short(node: ast.expr) -> str:
    text = " ".join(ast.unparse(node).split())
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def _assumption(module: str, name: str, value: str, words: str) -> Assumption:
    marked = _BRACKETED.search(words)
    about = (marked[1] or "") if marked is not None else ""
    return Assumption(module, name, value, _BRACKETED.sub("", words).strip(), about)


# --- uses -----------------------------------------------------------------------------------------


def _reads(module: str, tree: ast.Module, names: set[str]) -> Iterator[tuple[tuple[str, str], str]]:
    """Yield what a module reads: the module and name of a constant, or a field, and where."""
    origins = dict.fromkeys(names, module)
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.module:
            origin = node.module.removeprefix("vrts.")
            origins |= {name.name: origin for name in node.names if name.name in names}
    for statement in tree.body:
        named = isinstance(statement, ast.FunctionDef | ast.ClassDef)
        place = f"{module}.{statement.name}" if named else module
        for node in ast.walk(statement):
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in names:
                yield (origins[node.id], node.id), place
            elif isinstance(node, ast.Attribute) and node.attr in names:
                yield ("", node.attr), place


def _with_uses(assumption: Assumption, uses: Mapping[tuple[str, str], list[str]]) -> Assumption:
    """Add where a constant is read by its name, a field as an attribute."""
    owner, _, name = assumption.name.rpartition(".")
    if not assumption.value:
        return assumption
    places = [
        p for n in name.split(", ") for p in uses.get(("" if owner else assumption.where, n), ())
    ]
    return assumption._replace(uses=tuple(dict.fromkeys(places)))


# --- text -----------------------------------------------------------------------------------------


def text_of(found: list[Assumption]) -> str:
    """Return decisions as text, by module."""
    rows: list[str] = []
    module = ""
    for entry in found:
        if entry.where != module:
            module = entry.where
            rows += ["", module] if rows else [module]
        words = "; ".join(part for part in (entry.why, entry.about) if part)
        rows.append(f"  {entry.what}" + (f"  -- {words}" if words else ""))
        if entry.uses:
            field = entry.name.rpartition(".")[2] if "." in entry.name else ""
            how = f"a field `{field}` is read in" if field else "used in"
            rows.append(f"      {how} {', '.join(entry.uses)}")
    return "\n".join(rows)

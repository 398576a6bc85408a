"""The Python interface: public names of `vrts`, read from the source without importing anything."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from vrts.site.generated.markdown import block, code, text

HEAD = """\
# Python

What `import vrts` offers. Names of numbers end in their unit: `_s` seconds, `_mm` millimetres, `_m`
metres.

"""
_SECTION = re.compile(r"^(Args|Returns|Raises|Yields|Attributes|Example|Examples):$")


def python_page(package: Path) -> str:
    """Return the page of all public names, in the order of `__all__`."""
    own, told = package / "__init__.py", package / "__init__.pyi"  # names that are loaded late
    module = ast.parse(own.read_text("utf-8"))
    pieces = [HEAD]
    said = ast.get_docstring(module)
    if said:
        pieces.append(docstring(said))
    for name in _exported(module):
        found = _definition(package, told if told.is_file() else own, name)
        if found is not None:
            pieces.append(_described(found))
    return "\n".join(pieces)


def _exported(module: ast.Module) -> list[str]:
    for node in module.body:
        if isinstance(node, ast.Assign | ast.AnnAssign) and node.value is not None:
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            if any(isinstance(target, ast.Name) and target.id == "__all__" for target in targets):
                listed = ast.literal_eval(node.value)
                return [name for name in listed if not name.startswith("_")]
    return []


Definition = ast.FunctionDef | ast.ClassDef


def _definition(package: Path, path: Path, name: str) -> Definition | None:
    """Return where a name is defined, following what its module imports from others."""
    tree = ast.parse(path.read_text("utf-8"))
    own = [node for node in tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef)]
    for node in reversed(own):  # of several the last: those before it say what types it takes
        if node.name == name:
            return node
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("vrts"):
            for alias in node.names:
                if (alias.asname or alias.name) == name:
                    there = _file(package, node.module)
                    return _definition(package, there, alias.name) if there else None
    return None


def _file(package: Path, module: str) -> Path | None:
    place = package.joinpath(*module.split(".")[1:])
    candidates = (place.with_suffix(".py"), place / "__init__.py")
    return next((path for path in candidates if path.is_file()), None)


def _described(node: Definition) -> str:
    if isinstance(node, ast.FunctionDef):
        return f"(python-{node.name.lower()})=\n## {text(node.name)}\n\n{_function(node)}"
    pieces = [f"(python-class-{node.name.lower()})=\n## {text(node.name)}\n"]
    pieces.append(docstring(ast.get_docstring(node) or ""))
    fields = [
        f"{code(ast.unparse(item.target))}\n: {code(ast.unparse(item.annotation))}\n"
        for item in node.body
        if isinstance(item, ast.AnnAssign) and not ast.unparse(item.target).startswith("_")
    ]
    pieces += fields
    for item in node.body:
        if isinstance(item, ast.FunctionDef) and _public(item):
            pieces.append(f"### {text(node.name)}.{text(item.name)}\n\n{_function(item)}")
    return "\n".join(pieces)


def _public(node: ast.FunctionDef) -> bool:
    return not node.name.startswith("_")


def _function(node: ast.FunctionDef) -> str:
    arguments = ast.unparse(node.args)
    arguments = re.sub(r"^(?:self|cls)(?:, )?", "", arguments)
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    marks = [ast.unparse(mark) for mark in node.decorator_list]
    call = f"{node.name}{returns}" if "property" in marks else f"{node.name}({arguments}){returns}"
    if len(call) > 90 and "property" not in marks:
        call = f"{node.name}(\n    " + ",\n    ".join(_split(arguments)) + f",\n){returns}"
    return block("python", call) + "\n" + docstring(ast.get_docstring(node) or "")


def _split(arguments: str) -> list[str]:
    """Return arguments one by one: commas inside brackets part nothing."""
    found, depth = [""], 0
    for sign in arguments:
        depth += (sign in "([{") - (sign in ")]}")
        if sign == "," and depth == 0:
            found.append("")
        else:
            found[-1] += sign
    return [argument.strip() for argument in found]


def docstring(words: str) -> str:
    """Return a docstring as Markdown: sections as lists of names, doctests as code."""
    return "\n".join(_pieces(words)) + "\n" if words else ""


def _pieces(words: str) -> Iterator[str]:
    section = ""
    for paragraph in re.split(r"\n\s*\n", words):
        lines = paragraph.splitlines()
        if match := _SECTION.match(lines[0].strip()):
            section, lines = match[1], lines[1:]
            yield f"**{section}**\n"
        elif not lines[0].startswith(" "):
            section = ""
        body = "\n".join(lines)
        if body.lstrip().startswith(">>>"):
            yield block("pycon", _flush(body))
        elif section in ("Args", "Raises", "Attributes"):
            yield _named(_flush(body))
        elif not section and all(line.startswith("    ") for line in lines):
            yield block("python", _flush(body))
        elif body.strip():
            yield text(body.removesuffix("::") + (":" if body.endswith("::") else "")) + "\n"


def _flush(body: str) -> str:
    lines = body.splitlines()
    margin = min((len(x) - len(x.lstrip()) for x in lines if x.strip()), default=0)
    return "\n".join(line[margin:] for line in lines)


def _named(body: str) -> str:
    """Return `name: what it is` as a list of names."""
    entries: list[str] = []
    for line in body.splitlines():
        if line.startswith(" ") and entries:
            entries[-1] += " " + line.strip()
        else:
            entries.append(line)
    parted = (entry.partition(": ") for entry in entries)
    return "\n".join(f"{code(name)}\n: {text(says) or text(name)}\n" for name, _, says in parted)

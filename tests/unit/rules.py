"""Which rules there are, by the code: read from the source, and told apart by who finds them."""

import ast
from functools import cache
from pathlib import Path

import vrts

PACKAGE = Path(vrts.__file__).parent


@cache
def rules() -> dict[str, list[tuple[str, Path]]]:
    """Return slug and file of every `Rule("Vnnn", "slug")` in the package, by code."""
    found: dict[str, list[tuple[str, Path]]] = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        text = path.read_text("utf-8")
        for node in ast.walk(ast.parse(text)) if "Rule(" in text else ():
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                values = [a.value for a in node.args if isinstance(a, ast.Constant)]
                if node.func.id == "Rule" and len(values) == 2:
                    rule = str(values[1]), path.relative_to(PACKAGE)
                    found.setdefault(str(values[0]), []).append(rule)
    return found


def of_programs(code: str) -> bool:
    """Say whether the compiler finds it in the text of a program, without a run."""
    return all(file.parts[0] == "lang" and file.parts[1] != "typed" for _, file in rules()[code])


def of_runs(code: str) -> bool:
    """Say whether a run finds it: of the families of names, motion and time, what no text shows."""
    return code[1] in "235" and not of_programs(code)

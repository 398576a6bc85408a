"""Diagnostics of several files in the format that was asked for.

`full` and `concise` are for people, `json` and `sarif` for programs, `github` for the log of a
workflow. Code for a format is imported when it is used.
"""

from collections.abc import Sequence
from typing import Literal, TypeAlias, assert_never, get_args

from vrts.report.formats.checked import Checked

Form: TypeAlias = Literal["full", "concise", "json", "sarif", "github"]
FORMS: tuple[Form, ...] = get_args(Form)


def render(checked: Sequence[Checked], form: Form, *, color: bool = False) -> str:
    """Return what was found; no line end at the end, and empty where there is nothing to say.

    Args:
        checked: The files in the order given.
        form: `json` and `sarif` always give one document for all files.
        color: Whether `full` and `concise` use terminal colours.
    """
    match form:
        case "full":
            from vrts.report.screen.text import diagnostic_text

            rows = [diagnostic_text(d, color=color) for file in checked for d in file.diagnostics]
            return "\n\n".join(rows)
        case "concise":
            from vrts.report.screen.concise import concise

            rows = [
                concise(d, file.name, color=color) for file in checked for d in file.diagnostics
            ]
            return "\n".join(rows)
        case "json":
            from vrts.report.formats.checked_json import checked_json
            from vrts.report.formats.json_text import json_text

            return json_text(checked_json(checked))
        case "sarif":
            from vrts.report.formats.json_text import json_text
            from vrts.report.formats.sarif import sarif

            return json_text(sarif([(f.name, d) for f in checked for d in f.diagnostics]))
        case "github":
            from vrts.report.formats.github import workflow_command

            return "\n".join(workflow_command(d, f.name) for f in checked for d in f.diagnostics)
        case _:
            assert_never(form)

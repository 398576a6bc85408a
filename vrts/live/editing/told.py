"""What of a language server's answers reaches a browser: words and places of the one text.

Everything else is left out: addresses of files of this machine above all.
"""

from typing import Any

import msgspec

from vrts.live.editing.asked import (
    ADDRESS,
    Asked,
    Complete,
    Fix,
    Format,
    Hover,
    Range,
    Signature,
)


class _Where(msgspec.Struct, frozen=True):
    uri: str
    range: Range


class _Related(msgspec.Struct, frozen=True, rename="camel"):
    location: _Where
    message: str


class _Diagnostic(msgspec.Struct, frozen=True, rename="camel"):
    range: Range
    message: str
    severity: int = 1
    code: str = ""
    related_information: list[_Related] | None = None


class _Published(msgspec.Struct, frozen=True):
    diagnostics: list[_Diagnostic]
    version: int | None = None


class _Edit(msgspec.Struct, frozen=True, rename="camel"):
    range: Range
    new_text: str


class _Item(msgspec.Struct, frozen=True, rename="camel"):
    label: str
    kind: int = 0
    detail: str | None = None
    documentation: str | None = None
    sort_text: str | None = None
    text_edit: _Edit | None = None


class _Items(msgspec.Struct, frozen=True, rename="camel"):
    items: list[_Item]
    is_incomplete: bool = False


class _Markup(msgspec.Struct, frozen=True):
    value: str


class _Hover(msgspec.Struct, frozen=True):
    contents: _Markup
    range: Range | None = None


class _Parameter(msgspec.Struct, frozen=True):
    label: str


class _Signature(msgspec.Struct, frozen=True):
    label: str
    documentation: str | None = None
    parameters: list[_Parameter] = []


class _Signatures(msgspec.Struct, frozen=True, rename="camel"):
    signatures: list[_Signature]
    active_parameter: int = 0


class _Changes(msgspec.Struct, frozen=True):
    changes: dict[str, list[_Edit]] = {}


class _Action(msgspec.Struct, frozen=True, rename="camel"):
    title: str
    is_preferred: bool = False
    edit: _Changes | None = None
    diagnostics: list[_Diagnostic] = []


class Answer(msgspec.Struct, frozen=True):
    """A message of a language server, as far as it matters."""

    id: int | str | None = None
    method: str = ""
    params: msgspec.Raw = msgspec.Raw()
    result: msgspec.Raw = msgspec.Raw(b"null")
    error: msgspec.Raw = msgspec.Raw()


answer_of = msgspec.json.Decoder(Answer).decode
as_json = msgspec.json.Encoder().encode
_actions = msgspec.json.Decoder(list[_Action] | None).decode


def diagnostics(params: msgspec.Raw) -> bytes:
    """Return what is wrong with the text, as a message to a browser."""
    found = msgspec.json.decode(params, type=_Published)
    shown = [
        {
            "range": one.range,
            "message": one.message,
            "severity": one.severity,
            "code": one.code,
            "related": [
                {"range": other.location.range, "message": other.message}
                for other in one.related_information or ()
                if other.location.uri == ADDRESS
            ],
        }
        for one in found.diagnostics
    ]
    about = {"method": "textDocument/publishDiagnostics", "version": found.version}
    return as_json({**about, "diagnostics": shown})


def answered(asked: Asked, result: msgspec.Raw) -> bytes:
    """Return the answer to a question, as a message to a browser."""
    match asked:
        case Complete():
            found: Any = msgspec.json.decode(result, type=_Items | None)
        case Hover():
            found = msgspec.json.decode(result, type=_Hover | None)
        case Signature():
            found = msgspec.json.decode(result, type=_Signatures | None)
        case Fix():
            found = _remedies(_actions(result) or [])
        case Format():
            found = msgspec.json.decode(result, type=list[_Edit] | None)
        case _:
            found = None  # a notification has no answer
    return as_json({"id": getattr(asked, "id", 0), "result": found})


def _remedies(actions: list[_Action]) -> list[dict[str, Any]]:
    """Return what changes the one text, and where that is wrong which it mends."""
    return [
        {
            "title": one.title,
            "preferred": one.is_preferred,
            "edits": edits,
            "range": one.diagnostics[0].range if one.diagnostics else None,
        }
        for one in actions
        if one.edit is not None and (edits := one.edit.changes.get(ADDRESS))
    ]

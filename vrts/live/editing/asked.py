"""What a browser may ask of a language server: nothing that is not written here.

A message holds a text, a place in it, and numbers. It names no file, no address, no folder, no
command and no setting: what the language server is told of these is made here.
"""

from typing import Annotated, Any, Final, TypeAlias

import msgspec
from msgspec import Meta

ADDRESS: Final = "vrts:/program.v2"  # of the one text; it is in no file
LONGEST: Final = 200_000  # characters of a text

Place: TypeAlias = Annotated[int, Meta(ge=0, le=LONGEST)]
Id: TypeAlias = Annotated[int, Meta(ge=1, le=2**31)]
Text: TypeAlias = Annotated[str, Meta(max_length=LONGEST)]


class _Strict(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="method"):
    pass


class Position(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A place in the text: line from 0, UTF-16 units from the line's begin."""

    line: Place
    character: Place


class Range(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """From a place up to another."""

    start: Position
    end: Position


class Open(_Strict, frozen=True, tag="textDocument/didOpen"):
    """The text as it is when the help begins."""

    version: Id
    text: Text


class Change(_Strict, frozen=True, tag="textDocument/didChange"):
    """The text as it is now, whole."""

    version: Id
    text: Text


class Complete(_Strict, frozen=True, tag="textDocument/completion"):
    """What may stand here."""

    id: Id
    position: Position


class Hover(_Strict, frozen=True, tag="textDocument/hover"):
    """What this is."""

    id: Id
    position: Position


class Signature(_Strict, frozen=True, tag="textDocument/signatureHelp"):
    """What this step or function takes."""

    id: Id
    position: Position


class Fix(_Strict, frozen=True, tag="textDocument/codeAction"):
    """What would mend this."""

    id: Id
    range: Range


class Format(_Strict, frozen=True, tag="textDocument/formatting"):
    """The text in the canonical layout."""

    id: Id


Asked: TypeAlias = Open | Change | Complete | Hover | Signature | Fix | Format

asked = msgspec.json.Decoder(Asked).decode


def initialize() -> dict[str, Any]:
    """Return the first request to a language server: no folder, no settings, little ability."""
    able = {
        "general": {"positionEncodings": ["utf-16"]},
        "textDocument": {
            "hover": {"contentFormat": ["markdown"]},
            "publishDiagnostics": {"relatedInformation": True, "versionSupport": True},
            "codeAction": {
                "codeActionLiteralSupport": {"codeActionKind": {"valueSet": ["quickfix"]}},
                "isPreferredSupport": True,
            },
        },
    }
    return {
        "id": 0,
        "method": "initialize",
        "params": {"processId": None, "rootUri": None, "capabilities": able},
    }


def request(message: Asked) -> dict[str, Any]:
    """Return what the language server is asked."""
    document = {"uri": ADDRESS}
    match message:
        case Open():
            opened = {**document, "languageId": "val2"}
            opened |= {"version": message.version, "text": message.text}  # type: ignore[dict-item]
            return _named(message, {"textDocument": opened})
        case Change():
            changed = {**document, "version": message.version}
            whole = [{"text": message.text}]
            return _named(message, {"textDocument": changed, "contentChanges": whole})
        case Complete() | Hover() | Signature():
            params = {"textDocument": document, "position": message.position}
        case Fix():
            known: dict[str, Any] = {"diagnostics": []}
            params = {"textDocument": document, "range": message.range, "context": known}
        case Format():
            layout = {"tabSize": 2, "insertSpaces": True}
            params = {"textDocument": document, "options": layout}
    return {**_named(message, params), "id": message.id}


def _named(message: Asked, params: dict[str, Any]) -> dict[str, Any]:
    return {"method": message.__struct_config__.tag, "params": params}

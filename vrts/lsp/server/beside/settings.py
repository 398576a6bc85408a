"""TOML files of vrts in an editor: what is wrong, keys, what they mean, the scene to show."""

from typing import Any

from lsprotocol import types

from vrts.base.diagnostic import Severity
from vrts.lsp.server.background.settings import Looked, SettingFile
from vrts.lsp.server.diagnostics import SEVERITIES, page_of
from vrts.lsp.server.places import Places
from vrts.lsp.settings.completing import Written, complete_setting, explain_setting


def published(looked: Looked, places: Places) -> types.PublishDiagnosticsParams:
    """Return what is wrong with a file, as the protocol has it."""
    shown = [
        types.Diagnostic(
            places.range(start, max(end, start + 1)),
            message,
            SEVERITIES[Severity(severity)],
            code=code or None,
            code_description=page_of(code) if code else None,
            source="vrts",
        )
        for start, end, severity, code, message in looked.rows
    ]
    return types.PublishDiagnosticsParams(looked.of.uri, shown, looked.of.version)


def shown(looked: Looked) -> dict[str, Any]:
    """Return what a client is told that shows more beside the text."""
    return {
        "uri": looked.of.uri,
        "version": looked.of.version,
        "whole": True,
        "scene": {"reads": looked.recording is not None},
    }


def last_scene(file: SettingFile, good: Looked | None) -> dict[str, Any] | None:
    """Return the last scene of a buffer that could be read; None: none could."""
    if good is None:
        return None
    old = good.of is not file
    text = "The file has errors, or is being read: this is the last scene that could be read."
    now = "The scene as the text has it."
    return {
        "recording": good.recording,
        "version": good.of.version,
        "still": True,
        "old": old,
        "text": text if old else now,
    }


def completed(
    file: SettingFile, places: Places, position: types.Position, bodies: tuple[str, ...]
) -> types.CompletionList:
    """Return what may be written at a place."""
    found = complete_setting(file.source.text, file.kind, places.offset(position), bodies)
    replaced = places.range(found.start, found.end)
    return types.CompletionList(
        is_incomplete=False, items=[_item(one, replaced) for one in found.proposals]
    )


def explained(file: SettingFile, places: Places, position: types.Position) -> types.Hover | None:
    """Return what the word at a place means."""
    found = explain_setting(file.source.text, file.kind, places.offset(position))
    if found is None:
        return None
    content = types.MarkupContent(types.MarkupKind.Markdown, found.text)
    return types.Hover(content, places.range(found.start, found.end))


def _item(one: Written, replaced: types.Range) -> types.CompletionItem:
    kinds = types.CompletionItemKind
    return types.CompletionItem(
        one.label,
        kind=kinds.Value if one.is_value else kinds.Property,
        detail=one.detail or None,
        documentation=one.about or None,
        sort_text=f"{0 if one.first else 1}{one.label}",
        filter_text=one.label.strip("[]"),
        text_edit=types.TextEdit(replaced, one.text),
    )

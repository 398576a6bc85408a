"""A bundle planned again, of the files that it came with; and in what that is another bundle.

Everything is made anew: programs and data as the controller prints them, runs, certificates, the
proof over every future, margins, dry run, sheet. The same vrts makes the same bytes on every
machine. Another version may say it in other words, so then the parts are compared.
"""

from collections.abc import Iterator
from typing import NamedTuple, cast

import msgspec

from vrts import __version__
from vrts.base.diagnostic import Diagnostic
from vrts.base.workers import ALONE, Workers
from vrts.dispatch.bundle import Bundle, bundle_bytes, read_bundle
from vrts.dispatch.manifest import Manifest
from vrts.dispatch.planning.asked import wish_of
from vrts.dispatch.planning.plan import plan

MOST_DIFFERENCES = 10
# what another version may say in other words, or count in another way
_SENTENCES = ("summary", "sentence", "refused", "statements")
_WORDING = ("schema", "vrts", "files", "asked", "executed", "first_to_fail")


class Again(NamedTuple):
    """What came of planning it again."""

    refused: tuple[Diagnostic, ...]  # why there would be no bundle now
    differences: tuple[str, ...]  # in what it would be another one
    same_bytes: bool

    @property
    def is_same(self) -> bool:
        """Whether everything is proven again."""
        return not self.refused and not self.differences


def planned_again(bundle: Bundle, data: bytes, workers: Workers = ALONE) -> Again:
    """Plan a bundle again.

    Args:
        bundle: It has to say what it was planned from.
        data: Its file.
        workers: Who looks at worlds.

    Raises:
        Refused: What it was planned from cannot be read.
    """
    found = plan(wish_of(bundle, workers))
    if found.bundle is None:
        return Again(found.refused, (), same_bytes=False)
    if bundle_bytes(found.bundle) == data:
        return Again((), (), same_bytes=True)
    return Again((), tuple(_differences(bundle, found.bundle)), same_bytes=False)


def _differences(ours: Bundle, made: Bundle) -> Iterator[str]:
    """Yield what two bundles of the same wish say differently."""
    found: list[str] = []
    for name in sorted(ours.programs.keys() | made.programs.keys()):
        if ours.programs.get(name) != made.programs.get(name):
            found.append(f"program `{name}` is another")
    for what in ("locations", "reals", "strings"):
        if getattr(ours, what) != getattr(made, what):
            found.append(f"the {what} are others")
    found += _of_manifests(ours.manifest, made.manifest)
    if not found and ours.manifest.vrts == __version__:
        found = [f"`{name}` is another" for name in _other_files(ours.manifest, made)]
        found = found or ["its files are packed in another way"]
    yield from found[:MOST_DIFFERENCES]


def _of_manifests(ours: Manifest, made: Manifest) -> Iterator[str]:
    """Yield the parts that differ; for another version those that are facts."""
    same_version = ours.vrts == made.vrts
    for name in Manifest.__struct_fields__:
        if name == "files" or (name in _WORDING and not same_version):
            continue
        said, is_now = (_of(getattr(one, name), same_version) for one in (ours, made))
        if said != is_now:
            yield f"`{name}` of the manifest is another"


def _of(value: object, same_version: bool) -> object:
    """Return what is compared: without sentences, where another version wrote them."""
    plain = msgspec.to_builtins(value)
    return plain if same_version else _facts(plain)


def _facts(plain: object) -> object:
    if isinstance(plain, dict):
        named = cast("dict[str, object]", plain)
        return {name: _facts(each) for name, each in named.items() if name not in _SENTENCES}
    if isinstance(plain, list | tuple):
        return [_facts(each) for each in cast("list[object]", plain)]
    return plain


def _other_files(manifest: Manifest, made: Bundle) -> list[str]:
    """Return the names of files of which there would be others."""
    there = {member.name: member.sha256 for member in manifest.files}
    now = {member.name: member.sha256 for member in read_bundle(bundle_bytes(made)).manifest.files}
    return sorted(name for name in there.keys() | now.keys() if there.get(name) != now.get(name))

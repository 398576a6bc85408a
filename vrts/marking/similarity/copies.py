"""Pages of later markings that show programs of one that is purged: found beside it, and told."""

from collections.abc import Collection, Iterator
from itertools import islice
from pathlib import Path

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.base.safe_names import safe
from vrts.marking.layout import Layout
from vrts.marking.similarity.corpus import digest_of
from vrts.marking.similarity.kept import place_of

COPIES = Rule("V780", "copies-elsewhere")
PURGE = "purge {} too"
DATA = "similarity.json"
LARGEST = 64_000_000  # bytes of it
MOST_FOLDERS = 2_000  # beside a marking, that are looked at


class Corpus(msgspec.Struct, frozen=True):
    """What a marking was compared with."""

    name: str
    sha256: str = ""  # of what a marking keeps; "": of programs that nobody marked


class _Data(msgspec.Struct):
    corpus: tuple[Corpus, ...] = ()


def copies_told(folder: Path, going: Collection[Path], remedy: str = PURGE) -> Iterator[Diagnostic]:
    """Yield a warning for each marking beside a folder whose pages may show programs of it.

    Args:
        folder: That is to be purged, and is still whole.
        going: Folders that are purged as well.
        remedy: What else may be done than comparing again, with `{}` for the other marking.
    """
    gone = {one.resolve() for one in going}
    place = place_of(Layout(folder))
    sha256 = digest_of(place) if place.is_file() and not place.is_symlink() else ""
    name = safe(folder.resolve().name)
    for other in beside(folder):
        if other.resolve() in gone:
            continue
        for corpus in corpora_of(other):
            sure = bool(sha256) and corpus.sha256 == sha256
            if sure or corpus.name == name:  # of another sum: somebody was forgotten since
                yield _told(folder, other, remedy, sure=sure)
                break


def beside(folder: Path) -> Iterator[Path]:
    """Yield the folders beside one, in which other markings may be."""
    home = folder.resolve().parent
    try:
        found = (path for path in home.iterdir() if path.resolve() != folder.resolve())
        yield from sorted(islice(found, MOST_FOLDERS))
    except OSError:  # nobody may list it: nothing is known
        return


def corpora_of(folder: Path) -> tuple[Corpus, ...]:
    """Return what a marking was compared with; nothing where it does not say."""
    path = Layout(folder).staff / DATA
    try:
        if path.is_symlink() or path.stat().st_size > LARGEST:
            return ()
        return msgspec.json.decode(path.read_bytes(), type=_Data).corpus
    except (OSError, msgspec.MsgspecError):  # it is no marking, or is damaged
        return ()


def _told(folder: Path, other: Path, remedy: str, *, sure: bool) -> Diagnostic:
    may = "show" if sure else "may show"
    headline = f"pages of `{other}` {may} programs of `{folder}`, and stay"
    note = f"`{other}` was compared with it: see `{Layout(other).staff / 'similarity'}`"
    again = f"compare it again without: `vrts grade similarity {other}`"
    help_ = f"{remedy.format(f'`{other}`')}, or {again}"
    return warning(COPIES, headline, notes=(note,), help=(help_,))

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
DATA = "similarity.json"
LARGEST = 64_000_000  # bytes of it
MOST_FOLDERS = 2_000  # beside a marking, that are looked at


class _Corpus(msgspec.Struct):
    name: str
    sha256: str = ""


class _Data(msgspec.Struct):
    corpus: tuple[_Corpus, ...] = ()


def copies_told(folder: Path, going: Collection[Path]) -> Iterator[Diagnostic]:
    """Yield a warning for each marking beside a folder whose pages may show programs of it.

    Args:
        folder: That is to be purged, and is still whole.
        going: Folders that are purged as well.
    """
    gone = {one.resolve() for one in going}
    place = place_of(Layout(folder))
    sha256 = digest_of(place) if place.is_file() and not place.is_symlink() else ""
    name = safe(folder.resolve().name)
    for other in _beside(folder):
        if other.resolve() in gone:
            continue
        for corpus in _corpora(other):
            same = corpus.sha256 == sha256 if corpus.sha256 else corpus.name == name
            if same:
                yield _told(folder, other, sure=bool(corpus.sha256))
                break


def _beside(folder: Path) -> Iterator[Path]:
    home = folder.resolve().parent
    try:
        found = (path for path in home.iterdir() if path.resolve() != folder.resolve())
        yield from sorted(islice(found, MOST_FOLDERS))
    except OSError:  # nobody may list it: nothing is known
        return


def _corpora(folder: Path) -> tuple[_Corpus, ...]:
    path = Layout(folder).staff / DATA
    try:
        if path.is_symlink() or path.stat().st_size > LARGEST:
            return ()
        return msgspec.json.decode(path.read_bytes(), type=_Data).corpus
    except (OSError, msgspec.MsgspecError):  # it is no marking, or is damaged
        return ()


def _told(folder: Path, other: Path, *, sure: bool) -> Diagnostic:
    may = "show" if sure else "may show"
    headline = f"pages of `{other}` {may} programs of `{folder}`, and stay"
    note = f"`{other}` was compared with it: see `{Layout(other).staff / 'similarity'}`"
    help_ = f"purge `{other}` too, or compare it again without: `vrts grade similarity {other}`"
    return warning(COPIES, headline, notes=(note,), help=(help_,))

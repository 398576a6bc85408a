"""Programs that seem to be made for the variant of somebody else.

Two things tell: a comment that names another variant, and given or taught places that are exactly
those of another variant, all of them, or more than are those of the own one. Neither changes a
mark: a person looks at it.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

import msgspec

from vrts.assignments.variants.handed_out import tags_in
from vrts.assignments.variants.places import Values, shown, taught
from vrts.marking.layout import Layout
from vrts.marking.marking import Done, Entry, write_marks
from vrts.marking.result import OfVariant, Result
from vrts.marking.submission.marker import Marks
from vrts.marking.variants.class_list import shown_names
from vrts.marking.variants.of_class import MarkerOfClass
from vrts.scene.handling.withheld import all_locations

NOBODY = "it is by nobody in the list of the class: marked by the task as it is written"
THEIRS = "its places are those of"
FEWEST = 2  # places of another variant that tell, whatever else a program has


class Other(NamedTuple):
    """Another variant that a program seems to be made for."""

    tag: str
    why: str  # "it names", "its places are those of"


class Places(NamedTuple):
    """Locations of the scenes of a class, as programs show them."""

    by_name: Mapping[str, Mapping[str, Values]]  # by tag and name
    by_value: Mapping[Values, tuple[str, ...]]  # whose they are, by tags

    def special(self, value: Values) -> tuple[str, ...]:
        """Return the tags of the variants that have a value; none where all have it."""
        tags = self.by_value.get(value, ())
        return () if len(tags) == len(self.by_name) else tags


def doubts_of(
    marker: MarkerOfClass,
    entries: Sequence[Entry],
    mark: Callable[[Sequence[Entry]], Iterable[Done]],
    *,
    nameless: bool = False,
) -> dict[str, str]:
    """Return why a program may be marked by the wrong variant, by identifier.

    What seems to be made for somebody else is marked by that variant too: its mark there is told,
    and changes nothing.

    Args:
        marker: That knows whose is whose.
        entries: Of the class.
        mark: Marks programs without writing anything.
        nameless: Whether students are not to be named.
    """
    places = known({tag: places_of(marker, tag) for tag in marker.places})
    found: dict[str, str] = {}
    others: dict[str, Other] = {}
    for entry in entries:
        if entry.data is None:
            continue
        own = marker.tags.get(entry.identifier, "")
        if not own:
            found[entry.identifier] = NOBODY
            continue
        other = other_variant(entry.data, own, places)
        if other is not None:
            others[entry.identifier] = other
    there = _marks_there(marker, entries, others, mark)
    for identifier, other in others.items():
        own = marker.tags[identifier]
        words = f"{other.why} the variant `{other.tag}`, which nobody in the class has"
        if other.tag in marker.owners:
            whose = "somebody else" if nameless else shown_names(marker.owners[other.tag])
            words = f"{other.why} the variant `{other.tag}`, of {whose}"
        more = f", where it would earn {there[identifier]:g}" if identifier in there else ""
        found[identifier] = f"{words}{more}; marked by the student's own, `{own}`"
    for entry in entries:
        doubtful = marker.doubtful.get(entry.identifier)
        if doubtful is not None and entry.data is not None:
            before = found.get(entry.identifier)
            found[entry.identifier] = f"{before}; {doubtful}" if before else doubtful
    return found


def other_variant(program: bytes, own: str, places: Places) -> Other | None:
    """Return which other variant a program is made for, as far as it tells; None: its own.

    Args:
        program: What was handed in.
        own: Tag of the student's variant.
        places: Of the class.
    """
    named = [tag for tag in tags_in(program) if tag != own]
    if named:
        return Other(named[0], "it names")
    given = taught(program)
    mostly = _mostly(set(given.values()), own, places)
    if mostly is not None:
        return mostly
    mine = places.by_name[own]
    same = {name: values for name, values in given.items() if name in mine}
    if not same:
        return _by_values(set(given.values()), own, places)
    if all(values == mine[name] for name, values in same.items()):
        return None
    for tag, scene in places.by_name.items():
        if tag != own and all(values == scene.get(name) for name, values in same.items()):
            return Other(tag, THEIRS)
    return None


def known(by_name: Mapping[str, Mapping[str, Values]]) -> Places:
    """Return the places of scenes, to be found by their values too.

    Args:
        by_name: Locations of the scene of each variant, by tag and name.
    """
    by_value: dict[Values, list[str]] = {}
    for tag, scene in by_name.items():
        for value in set(scene.values()):
            by_value.setdefault(value, []).append(tag)
    return Places(by_name, {value: tuple(tags) for value, tags in by_value.items()})


def _mostly(given: set[Values], own: str, places: Places) -> Other | None:
    """Return whose places a program has, if it has several, and more than of the own variant.

    Places that are the same in all variants, and those that nobody has, tell nothing.
    """
    shared, mine = Counter[str](), 0
    for value in given:
        tags = places.special(value)
        if own in tags:
            mine += 1
        else:
            shared.update(tags)
    if not shared:
        return None
    count = max(shared.values())
    tag = min(tag for tag, number in shared.items() if number == count)
    enough = count > max(mine, FEWEST - 1)
    return Other(tag, f"{count} of its places are those of") if enough else None


def _by_values(given: set[Values], own: str, places: Places) -> Other | None:
    """Return whose places a program has that gives other names to them; the most decide."""
    if given & set(places.by_name[own].values()):
        return None
    shared = Counter(tag for value in given for tag in places.by_value.get(value, ()))
    if not shared:
        return None
    tag = max(places.by_name, key=lambda one: shared[one])
    return Other(tag, THEIRS)


def places_of(marker: MarkerOfClass, tag: str) -> dict[str, Values]:
    """Return the locations of the scene of a variant, as programs show them."""
    scene = marker.by(tag).whole.scene
    return {name: shown(X_WT) for name, X_WT in all_locations(scene).items()}


def with_doubt(done: Done, doubts: Mapping[str, str], layout: Layout | None) -> Done:
    """Return a result that tells its variant and what is doubtful; written where it is another."""
    doubt = doubts.get(done.entry.identifier, "")
    staff = _with(done.result, doubt)
    if staff == done.result:
        return done
    if layout is not None:
        write_marks(Marks(staff, done.student), layout)
    return done._replace(result=staff)


def _with(result: Result, doubt: str) -> Result:
    tag = "" if result.variant is None else result.variant.tag
    variant = OfVariant(tag, doubt) if tag or doubt else None
    return msgspec.structs.replace(result, variant=variant)


def _marks_there(
    marker: MarkerOfClass,
    entries: Sequence[Entry],
    others: Mapping[str, Other],
    mark: Callable[[Sequence[Entry]], Iterable[Done]],
) -> dict[str, float]:
    """Return what programs would earn by the variants that they seem to be made for."""
    asked: list[Entry] = []
    names: dict[str, str] = {}
    for entry in entries:
        other = others.get(entry.identifier)
        if other is None or other.tag not in marker.places:
            continue
        name = f"other {len(names)}"  # a blank: no student is called that
        names[name] = entry.identifier
        marker.tags[name] = other.tag
        asked.append(entry._replace(identifier=name, whose=""))
    found = mark(asked) if asked else ()
    return {
        names[done.entry.identifier]: done.result.mark
        for done in found
        if done.result.mark is not None
    }

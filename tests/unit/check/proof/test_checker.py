"""The checker: its kinematics, its bounds, what it has to cover, and what it refuses."""

import ast
import json
import math
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

import vrts
from tests.places import TESTS
from tests.support_proofs import Case, case
from vrts.base.oat import pose_from_components
from vrts.base.units import DEG, MM
from vrts.check.collision.of_run import plan_of
from vrts.check.proof import checker, given, parting, record, tables
from vrts.check.proof.checker import Check, Moments, check, frames, least
from vrts.check.proof.given import (
    BOXES,
    DIRECTION,
    EXCUSED,
    KEEPS,
    NEAR,
    Claims,
    Evidence,
    Meeting,
    Wrong,
)
from vrts.check.proof.look import Look
from vrts.check.proof.record import certified
from vrts.geometry.coal_engine import pair, transform
from vrts.geometry.proposing.choose import here
from vrts.robots.catalog import arm as any_arm

ROOM = Path(checker.__file__).parent
CASES = ("free", "contact", "fall", "again", "serial")
VALUES = json.loads((TESTS / "data" / "puma_check_values.json").read_text("utf-8"))

# Universal Robots' table of Denavit and Hartenberg for the UR5 (support.universal-robots.com,
# "DH Parameters for calculations of kinematics and dynamics"): a and d in m, alpha in degrees
UR5 = (
    (0.0, 0.089159, 90.0),
    (-0.425, 0.0, 0.0),
    (-0.39225, 0.0, 0.0),
    (0.0, 0.10915, 90.0),
    (0.0, 0.09465, -90.0),
    (0.0, 0.0823, 0.0),
)


# --- the files ------------------------------------------------------------------------------------


def test_the_checker_is_small() -> None:
    assert len((ROOM / "checker.py").read_text().splitlines()) <= 300
    assert len((ROOM / "covered.py").read_text().splitlines()) <= 120


def imported(file: Path) -> set[str]:
    found: set[str] = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            found |= {node.module, *(f"{node.module}.{name.name}" for name in node.names)}
        elif isinstance(node, ast.Import):
            found |= {name.name for name in node.names}
    return found


def test_the_checker_knows_no_distance_library_and_nothing_of_the_search() -> None:
    root = Path(vrts.__file__).parent
    known, pending = set[str](), ["vrts.check.proof.checker", "vrts.check.proof.certificate"]
    while pending:
        module = pending.pop()
        file = root.joinpath(*module.split(".")[1:]).with_suffix(".py")
        if module not in known and file.exists():
            known.add(module)
            pending += imported(file)
        elif not file.exists():
            known.add(module)
    for word in ("coal", "fcl", "scipy", "pinocchio", "trimesh"):
        assert not [name for name in known if word in name.split(".")], word
    for room in ("vrts.check.collision", "vrts.geometry.proposing", "vrts.geometry.proving"):
        assert not [name for name in known if name.startswith(room)], room
    assert not [name for name in known if name.startswith("vrts.robots.kinematics")]
    assert "vrts.check.proof.record" not in known


# --- kinematics, against values that others computed ----------------------------------------------


def test_frames_reproduce_the_check_values() -> None:
    for name, rows in VALUES.items():
        arm = any_arm(name.lower())
        q = np.array([row["joints_deg"] for row in rows]) * DEG
        rotations, origins = frames(arm, q)
        for k, row in enumerate(rows):
            x, y, z = row["xyz_mm"]
            wanted = pose_from_components(x, y, z, *row["oat_deg"])
            flange = rotations[6, k] @ np.array(arm.X_LF.translation) + origins[6, k]
            assert flange == pytest.approx(wanted.translation, abs=1e-3 * MM)
            assert rotations[6, k].ravel() == pytest.approx(wanted.rotation, abs=1e-5)


def test_frames_of_a_ur5_are_those_of_its_table() -> None:
    arm = any_arm("ur5")
    numbers = np.random.default_rng(5)
    q = numbers.uniform(-3.0, 3.0, (20, 6))
    rotations, origins = frames(arm, q)
    turned = rotations[6] @ np.array(arm.X_LF.rotation).reshape(3, 3)
    flange = origins[6] + rotations[6] @ np.array(arm.X_LF.translation)
    for k in range(1, len(q)):  # the bases of table and model may be turned and moved
        ours = turned[0].T @ turned[k], turned[0].T @ (flange[k] - flange[0])
        first, other = by_table(q[0]), by_table(q[k])
        wanted = first[0].T @ other[0], first[0].T @ (other[1] - first[1])
        assert np.linalg.norm(ours[1]) == pytest.approx(np.linalg.norm(wanted[1]), abs=1e-5)
        assert np.trace(ours[0]) == pytest.approx(np.trace(wanted[0]), abs=1e-6)


def by_table(q: "np.ndarray[tuple[int], np.dtype[np.float64]]"):  # type: ignore[no-untyped-def]
    rotation, origin = np.eye(3), np.zeros(3)
    for angle, (a, d, alpha) in zip(q.tolist(), UR5, strict=True):
        c, s, ca, sa = (
            math.cos(angle),
            math.sin(angle),
            math.cos(alpha * DEG),
            math.sin(alpha * DEG),
        )
        origin = origin + rotation @ np.array([a * c, a * s, d])
        rotation = rotation @ np.array([[c, -s * ca, s * sa], [s, c * ca, -c * sa], [0, sa, ca]])
    return rotation, origin


# --- bounds ---------------------------------------------------------------------------------------


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["free", "fall", "serial"])
@pytest.mark.parametrize("length", [0.02, 0.1, 0.4])
def test_no_bound_is_more_than_the_distance(name: str, length: float) -> None:
    one = case(name)
    it = Check(one.scene, one.run, one.certified.claims, one.certified.evidence)
    numbers = np.random.default_rng(int(1000 * length))
    row = numbers.choice(len(it.a), 60)
    start, end = it.rows.start_s[row], it.rows.end_s[row]
    first = start + numbers.uniform(0, 1, len(row)) * np.maximum(end - start - length, 0)
    last = np.minimum(first + length, end)
    at, k = Moments(it.arm, it.move, first, last), np.arange(len(row))
    look = Look(it.arm, it.move, it.all_of)
    a, b = it.a[row], it.b[row]
    normal = look.met(a, b, at.time_s).normal
    along = least(it.all_of, at, a, b, k, normal)
    boxed = least(it.all_of, at, a, b, k, np.zeros_like(normal))
    tight = 0
    for share in np.linspace(0.0, 1.0, 9):
        now = Moments(
            it.arm, it.move, first + share * (last - first), first + share * (last - first)
        )
        Ra, oa, _ = now.place(it.all_of, a, k)
        Rb, ob, _ = now.place(it.all_of, b, k)
        for i in range(len(row)):
            function = pair(it.all_of.shapes[int(a[i])], it.all_of.shapes[int(b[i])])
            distance = function.distance(transform(Ra[i], oa[i]), transform(Rb[i], ob[i]))
            assert max(along[i], boxed[i]) <= distance + 3e-6
            tight += abs(distance - along[i]) < 0.01
    assert tight > 0  # bounds that say nothing would pass


# --- what has to be covered -----------------------------------------------------------------------


@pytest.mark.thorough
@pytest.mark.parametrize("name", CASES)
def test_what_has_to_be_covered_is_what_the_search_looks_at(name: str) -> None:
    one = case(name)
    near_miss = one.report.near_miss_m
    assert near_miss is not None
    todo = plan_of(one.scene, one.run, here(), near_miss, clearance=not one.report.contacts)
    searched: Counter[tuple[str, str, float, float, float, bool]] = Counter()
    for pairs in (todo.pairs, todo.rigid):
        for k in range(len(pairs.first)):
            first, second = (todo.solids.parts[int(side[k])] for side in pairs[:2])
            start_s, end_s = round(float(pairs.start_s[k]), 6), round(float(pairs.end_s[k]), 6)
            tolerance = float(pairs.tolerance[k])
            if tolerance < np.inf or not one.report.contacts:
                searched[first, second, start_s, end_s, tolerance, bool(pairs.counts[k])] += 1
    it = Check(one.scene, one.run, one.certified.claims, one.certified.evidence)
    ours: Counter[tuple[str, str, float, float, float, bool]] = Counter()
    for d in it.todo.demands:
        parts = it.all_of.parts[d.first[0]], it.all_of.parts[d.second[0]]
        row = round(d.start_s, 6), round(d.end_s, 6), d.tolerance, d.counts
        ours[*parts, *row] += len(d.first) * len(d.second)
    if one.report.contacts:  # nothing counts then, and windows are those of contacts alone
        assert times_of(searched) == times_of(ours)
    else:
        assert searched == ours


def times_of(rows: "Counter[tuple[str, str, float, float, float, bool]]") -> dict[object, float]:
    """How long pairs of parts are tested under each tolerance."""
    found: dict[object, float] = {}
    for (first, second, start_s, end_s, tolerance, _), count in rows.items():
        key = (first, second, tolerance)
        found[key] = round(found.get(key, 0.0) + count * (end_s - start_s), 4)
    return found


def test_the_rules_of_a_run_that_was_counted_by_hand() -> None:
    """A can stands on a table, is lifted, let go, and lies there again; beside it is a post."""
    one = case("fall")
    it = Check(one.scene, one.run, one.certified.claims, one.certified.evidence)
    of = it.all_of.parts
    seen = [
        (of[d.first[0]], of[d.second[0]], round(1e3 * d.tolerance, 3), d.sides)
        for d in it.todo.demands
    ]
    assert ("upper arm", "table", 0.2, ("robot", "table")) in seen
    assert ("base", "table", 0.2, ("robot", "table")) not in seen  # neither of them moves
    assert ("base", "can1", 0.2, ("robot", "can1")) in seen  # while it is carried, and falls
    assert ("left finger", "can1", 1.0, ("robot", "can1")) in seen  # a pad that holds it
    assert ("left finger", "can1", 0.2, ("robot", "can1")) in seen  # before and afterwards
    assert ("left finger", "post", 1.0, ("robot", "post")) not in seen
    assert ("can1", "post", 0.2, ("robot", "post")) in seen  # carried
    assert ("can1", "post", 0.2, ("can1", "post")) in seen  # falling
    assert ("flange", "base", 0.2, ("robot", "robot")) in seen
    low = [d for d in it.todo.demands if of[d.first[0]] == "can1" and of[d.second[0]] == "table"]
    places = {round(float(it.all_of.origin[d.second[0], 2]), 6) for d in low}
    assert places == {-0.321}  # what it stands on is 1 mm lower


# --- refusals -------------------------------------------------------------------------------------


def refused(one: Case, claims: Claims | None = None, by: Evidence | None = None) -> str:
    """Return why an altered certificate is refused; it has to be."""
    with pytest.raises(Wrong) as problem:
        check(one.scene, one.run, claims or one.certified.claims, by or one.certified.evidence)
    return problem.value.what


@pytest.mark.thorough
def test_certificates_hold() -> None:
    for name in CASES:
        one = case(name)
        assert check(one.scene, one.run, *one.certified[:2]) == one.certified.proven


def kind_of(one: Case, kind: int) -> "np.ndarray[tuple[int], np.dtype[np.int64]]":
    return np.flatnonzero(one.certified.evidence.leaves.kind == kind)


def leaves(one: Case, **columns: object) -> Evidence:
    by = one.certified.evidence
    return by._replace(leaves=by.leaves._replace(**columns))  # type: ignore[arg-type]


def points(one: Case, **columns: object) -> Evidence:
    by = one.certified.evidence
    return by._replace(points=by.points._replace(**columns))  # type: ignore[arg-type]


@pytest.mark.parametrize("name", CASES)
def test_every_leaf_is_needed(name: str) -> None:
    one = case(name)
    x = one.certified.evidence.leaves
    for k in np.linspace(0, len(x.row) - 1, 12).astype(int).tolist():
        rest = {field: np.delete(getattr(x, field), k, axis=0) for field in x._fields}
        refused(one, by=leaves(one, **rest))


@pytest.mark.parametrize("name", CASES)
def test_every_column_of_leaves_counts(name: str) -> None:
    one = case(name)
    x = one.certified.evidence.leaves
    for field in ("row", "root", "depth", "part"):
        column = getattr(x, field)
        for k in np.linspace(0, len(x.row) - 1, 5).astype(int).tolist():
            for by in (1, -1):
                other = column.copy()
                other[k] += by
                refused(one, by=leaves(one, **{field: other}))
    directed = kind_of(one, DIRECTION)
    for k in directed[:: max(1, len(directed) // 5)].tolist():
        other = x.normal.copy()
        other[k] = -other[k]
        refused(one, by=leaves(one, normal=other))
        other[k] = 0.0
        assert refused(one, by=leaves(one, normal=other)) == "a direction is missing"
        kind = x.kind.copy()
        kind[k] = BOXES
        refused(one, by=leaves(one, kind=kind, normal=other))
        kind[k] = EXCUSED
        assert refused(one, by=leaves(one, kind=kind, normal=other)) == "no contact excuses it"
        kind[k] = EXCUSED + 1
        refused(one, by=leaves(one, kind=kind))


@pytest.mark.parametrize("name", CASES)
def test_root_intervals_are_those_of_the_run(name: str) -> None:
    one = case(name)
    by = one.certified.evidence
    for k in (0, len(by.edges) // 2, len(by.edges) - 1):
        refused(one, by=by._replace(edges=np.delete(by.edges, k)))
    other = by.edges.copy()
    other[0] += 1e-4
    assert refused(one, by=by._replace(edges=other)) == "its intervals are not those of the run"
    refused(one, by=by._replace(edges=by.edges[::-1].copy()))


def test_points_have_to_lie_in_their_solids() -> None:
    for name in ("free", "contact", "fall"):
        one = case(name)
        p = one.certified.evidence.points
        for side in (0, 1):
            other = p.corners.copy()
            other[0, side] *= 1.5
            wrong = refused(one, by=points(one, corners=other))
            assert wrong == "a point does not lie in its solid"
        other = p.weights.copy()
        other[0, 0] += 0.01
        assert "weights" in refused(one, by=points(one, weights=other))
        other = p.weights.copy()
        other[0, :2] += (-2.0, 2.0)
        assert "weights" in refused(one, by=points(one, weights=other))


@pytest.mark.parametrize("name", ["contact", "fall"])
def test_witnesses_show_a_contact_from_its_start_to_its_end(name: str) -> None:
    one = case(name)
    p = one.certified.evidence.points
    use, witness = p.use, np.flatnonzero(p.use == given.WITNESS)
    assert len(witness) >= 8
    refused(one, by=points(one, use=np.where(use == given.WITNESS, NEAR, use)))
    middle = witness[4 * (len(witness) // 8) :][:4]
    moved = p.corners.copy()
    moved[witness] = moved[witness] * 0.0 + moved[witness][:, :, :1]  # all four are one point
    weights = p.weights
    assert (
        refused(one, by=points(one, corners=moved, weights=weights)) == "nothing shows the contact"
    )
    other = p.solids.copy()
    other[witness] = other[witness][:, ::-1]
    refused(one, by=points(one, solids=other))
    times = p.time_s.copy()
    times[witness] += 20.0
    refused(one, by=points(one, time_s=times))
    for some in (witness[4:], middle[:1]):
        rest = {field: np.delete(getattr(p, field), some, axis=0) for field in p._fields}
        refused(one, by=points(one, **rest))


def test_contacts_are_those_that_are_claimed() -> None:
    for name in ("contact", "fall"):
        one = case(name)
        claims = one.certified.claims
        first, *rest = claims.meetings
        assert refused(one, claims._replace(meetings=tuple(rest))) == "no contact excuses it"
        more = first._replace(from_s=first.to_s + 1.0, to_s=first.to_s + 1.2)
        assert (
            refused(one, claims._replace(meetings=(first, more, *rest)))
            == "nothing shows the contact"
        )
        for other in (
            first._replace(first="floor"),
            first._replace(second="floor"),
            first._replace(from_s=first.from_s + 0.005),
            first._replace(to_s=first.to_s - 0.005),
            first._replace(from_s=first.from_s - 0.6),
            first._replace(to_s=first.to_s + 0.6),
        ):
            refused(one, claims._replace(meetings=(other, *rest)))
        middle = 0.5 * (first.from_s + first.to_s)
        halves = first._replace(to_s=middle), first._replace(from_s=middle)
        refused(one, claims._replace(meetings=(*halves, *rest)))
        refused(one, claims._replace(meetings=(first, first, *rest)))
        refused(one, claims._replace(clearance_m=0.001))


def test_a_contact_that_is_none_cannot_be_claimed() -> None:
    one = case("free")
    claims = one.certified.claims._replace(clearance_m=None, parted=())
    meeting = Meeting("robot", "base1", 1.0, 1.2)
    assert refused(one, claims._replace(meetings=(meeting,)))


def test_the_smallest_distance_is_neither_larger_nor_smaller() -> None:
    for name in ("free", "serial"):
        one = case(name)
        claims = one.certified.claims
        assert claims.clearance_m is not None
        for by in (1e-3, 1e-4 + 2e-5):
            wrong = refused(one, claims._replace(clearance_m=claims.clearance_m + by))
            assert wrong == "nothing shows that they keep apart"
        wrong = refused(one, claims._replace(clearance_m=claims.clearance_m - 1e-3))
        assert wrong == "nothing shows that something comes as near as is claimed"
        p = one.certified.evidence.points
        use = np.where(p.use == given.NEAREST, NEAR, p.use)
        refused(one, by=points(one, use=use))


def test_fingers_let_go_when_they_do() -> None:
    one = case("free")
    claims = one.certified.claims
    assert len(claims.let_go) == 2
    first, second = claims.let_go
    for other in (
        first._replace(body="can2"),
        first._replace(finger=1),
        first._replace(grip=1),
        first._replace(apart_s=first.apart_s + 0.014),
        first._replace(apart_s=first.apart_s + 5.0),
        first._replace(apart_s=first.apart_s - 0.014),
        first._replace(away_s=first.away_s + 0.1),
        first._replace(away_s=first.away_s - 0.05),
    ):
        refused(one, claims._replace(let_go=(other, second)))
    refused(one, claims._replace(let_go=()))
    p = one.certified.evidence.points
    assert (p.use == NEAR).any()
    for column in (np.where(p.use == NEAR, given.NEAREST, p.use),):
        refused(one, by=points(one, use=column))
    times = np.where(p.use == NEAR, p.time_s + 0.002, p.time_s)
    assert refused(one, by=points(one, time_s=times)) == "nothing shows that they are not yet apart"


def test_points_of_other_things_show_nothing() -> None:
    one = case("free")
    p = one.certified.evidence.points
    near = p.use == NEAR
    solids = np.where(near[:, None], p.solids[:, ::-1], p.solids)
    corners = np.where(near[:, None, None, None], p.corners[:, ::-1], p.corners)
    other = points(one, solids=solids, corners=corners)
    assert refused(one, by=other) == "nothing shows that they are not yet apart"


def test_fingers_that_are_apart_have_let_go(monkeypatch: pytest.MonkeyPatch) -> None:
    one = case("free")
    monkeypatch.setattr(parting, "APART", 2e-3)  # whoever writes it says that they have not
    with pytest.raises(Wrong, match="not yet apart"):
        certified(one.scene, one.run, one.report)


@pytest.mark.thorough
def test_what_is_far_apart_counts_again(monkeypatch: pytest.MonkeyPatch) -> None:
    one = case("free")
    monkeypatch.setattr(parting, "AWAY", 1.0)  # whoever writes it says that it does not yet
    with pytest.raises(Wrong, match="not yet apart") as problem:
        certified(one.scene, one.run, one.report)
    assert problem.value.parts == ("left finger", "can1")

    def late(*_: object) -> tuple[given.LetGo, ...]:
        return one.certified.claims.let_go

    monkeypatch.setattr(record, "let_go", late)
    with pytest.raises(Wrong, match="not yet apart") as problem:
        certified(one.scene, one.run, one.report)
    assert problem.value.parts == ("can1", "table")


AGAIN = "nothing shows that they do not come near again"


@pytest.mark.thorough
def test_what_comes_near_again_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    one = case("again")
    assert one.report.clearance is not None
    assert one.report.clearance.distance_m == pytest.approx(0.007, abs=1e-6)
    monkeypatch.setattr(parting, "SHRUNK", 1.0)  # whoever writes it says that it does not
    with pytest.raises(Wrong, match=AGAIN) as problem:
        certified(one.scene, one.run, one.report)
    assert problem.value.parts == ("left finger", "can1")

    def late(*_: object) -> tuple[given.LetGo, ...]:
        return one.certified.claims.let_go

    monkeypatch.setattr(record, "let_go", late)
    with pytest.raises(Wrong, match=AGAIN) as problem:
        certified(one.scene, one.run, one.report)
    assert problem.value.parts == ("can1", "table")
    honest = one.certified.claims.parted[0]
    for forged in (honest._replace(from_s=honest.from_s + 0.3), honest._replace(to_s=0.6)):

        def other(*_: object, said: given.Parted = forged) -> tuple[given.Parted, ...]:
            return (said,)

        monkeypatch.setattr(record, "near_on_purpose", other)
        with pytest.raises(Wrong, match=AGAIN) as problem:
            certified(one.scene, one.run, one.report)
        assert problem.value.parts == ("can1", "table")


def test_nothing_counts_again_without_what_a_near_miss_is() -> None:
    one = case("again")
    claims = one.certified.claims
    assert claims.near_miss_m == 5e-3
    assert refused(one, claims._replace(near_miss_m=None)) == "it does not say what a near miss is"
    assert refused(one, claims._replace(near_miss_m=0.0)) == AGAIN  # more would have to be shown
    assert check(one.scene, one.run, claims._replace(near_miss_m=5.1e-3), one.certified.evidence)


def test_directions_show_that_nothing_comes_near_again() -> None:
    one = case("again")
    p = one.certified.evidence.points
    keeps = p.use == KEEPS
    assert keeps.sum() >= 8
    for k in np.flatnonzero(keeps).tolist()[::3]:
        other = {name: getattr(p, name).copy() for name in ("use", "time_s", "corners")}
        other["use"][k] = NEAR
        other["time_s"][k] += 0.01
        other["corners"][k] *= 0.3  # still in their solids, and askew
        for name, column in other.items():
            assert refused(one, by=points(one, **{name: column})) == AGAIN
    rest = {field: np.delete(getattr(p, field), keeps, axis=0) for field in p._fields}
    assert refused(one, by=points(one, **rest)) == AGAIN
    use = np.where(keeps, KEEPS + 1, p.use)
    assert refused(one, by=points(one, use=use)) == "it is about something that is not there"


def test_the_end_of_carrying_is_looked_at_as_its_beginning(monkeypatch: pytest.MonkeyPatch) -> None:
    one = case("free")
    before, after = one.certified.claims.parted
    assert (before.other, after.other) == ("table", "base2")
    early = after._replace(to_s=after.to_s - 3.0)  # it hangs high above the base then

    def forged(*_: object) -> tuple[given.Parted, ...]:
        return before, early

    monkeypatch.setattr(record, "near_on_purpose", forged)
    with pytest.raises(Wrong, match="not yet apart") as problem:
        certified(one.scene, one.run, one.report)
    assert problem.value.parts == ("can1", "base2")


def test_only_what_it_stood_on_is_near_at_first_and_what_it_will_stand_on_in_the_end() -> None:
    one = case("free")
    claims = one.certified.claims
    before, after = claims.parted
    forged = before._replace(to_s=before.from_s + 0.1), after._replace(from_s=after.to_s - 0.1)
    assert check(one.scene, one.run, claims._replace(parted=forged), one.certified.evidence)


def test_instants_before_and_after_a_time() -> None:
    assert given.steps(1.0, 1.03, 0.014) == pytest.approx([1.0, 1.014, 1.028])
    assert given.steps(2.0, 1.944, 0.056) == [2.0]
    assert given.steps(2.0, 1.9, 0.056) == pytest.approx([2.0, 1.944])
    assert given.steps(1.0, 1.0, 0.056) == given.steps(1.0, 1.0 + 1e-10, 0.056) == []


def test_writing_a_certificate_comes_to_an_end(monkeypatch: pytest.MonkeyPatch) -> None:
    one = case("free")
    monkeypatch.setattr(record, "MOST_OPEN", 10)
    with pytest.raises(Wrong, match="more intervals than a certificate may list"):
        certified(one.scene, one.run, one.report)


def test_what_is_near_on_purpose_is_so_when_it_is_said() -> None:
    one = case("free")
    claims = one.certified.claims
    first, *rest = claims.parted
    for other in (
        first._replace(body="can2"),
        first._replace(other="floor"),
        first._replace(stay=first.stay + 1),
        first._replace(from_s=first.from_s - 0.1),
        first._replace(from_s=first.from_s + 0.01),
    ):
        refused(one, claims._replace(parted=(other, *rest)))
    (last,) = rest
    for by_s in (0.1, -0.1):
        refused(one, claims._replace(parted=(first, last._replace(to_s=last.to_s + by_s))))


def test_a_refusal_names_the_first_thing_with_time_and_parts() -> None:
    one = case("contact")
    with pytest.raises(Wrong) as problem:
        check(
            one.scene, one.run, one.certified.claims._replace(meetings=()), one.certified.evidence
        )
    assert problem.value.time_s == pytest.approx(one.report.contacts[0].start_s, abs=0.31)
    assert "base1" in problem.value.parts


def test_another_run_is_not_proven_by_it() -> None:
    one, other = case("free"), case("contact")
    with pytest.raises(Wrong):
        check(one.scene, other.run, *one.certified[:2])
    with pytest.raises(Wrong):
        check(other.scene, one.run, *other.certified[:2])


def test_a_tetrahedron_holds_the_ball_that_it_holds() -> None:
    corners = np.array([(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)])
    assert tables.depth(corners) == pytest.approx(1 / math.sqrt(3))
    assert tables.depth(corners + 1.0) < 0.0
    assert tables.depth(corners[[0, 0, 1, 2]]) <= 0.0


def test_the_manual_lists_the_files_that_have_to_be_believed() -> None:
    page = (Path(vrts.__file__).parent / "manual" / "understand" / "proofs.md").read_text("utf-8")
    believed, proposed = page.split("You need **not** believe:")
    for name in ("checker.py", "covered.py", "given.py", "tables.py", "certificate.py"):
        assert f"`vrts/check/proof/{name}`" in believed
    for file in ("solids.py", "pose.py"):
        assert file in believed
    lines = sum(
        len((ROOM / name).read_text().splitlines())
        for name in ("given.py", "tables.py", "certificate.py")
    )
    assert abs(lines - 830) <= 50, "the page says how many lines they have"
    trusted = {"checker.py", "covered.py", "given.py", "tables.py", "certificate.py", "__init__.py"}
    for file in ROOM.glob("*.py"):
        if file.name not in trusted:  # what only writes certificates is no part of it
            for name in trusted - {"__init__.py"}:
                known = imported(ROOM / name)
                assert not [module for module in known if module.split(".")[-1] == file.stem]
            assert f"`{file.name}`" in proposed

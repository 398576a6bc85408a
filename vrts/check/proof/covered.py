"""The list of what is looked at, by the rules alone: which pieces may not touch, when, how deep."""

from collections.abc import Iterator, Sequence
from math import inf, isfinite

from vrts.base.pose import rotate, translation
from vrts.check.proof import given
from vrts.check.proof.given import Claims, Covered, Near, Records, Span, Stay, Told, Window, common
from vrts.engine.memory.records import Lie, Placement
from vrts.robots.model import flange_in_hand
from vrts.scene.model import Mobility, Scene

HAND = 6  # frame of the flange
DEEP, PRESSED = 2e-4, 1e-3  # [m] deeper is a contact: of all things; of pads in what they hold
HERE, LOWERED = translation(0.0, 0.0, 0.0), translation(0.0, 0.0, -1e-3)  # of what stands under it
APART, FINE = 2e-4, 14e-3  # [m] a finger farther off has let go; [s] between looks at that
AWAY, COARSE = 50e-3, 56e-3  # [m] what is farther off counts again; [s] between looks at that
ROBOT, STILL = ("robot", "robot"), (Lie.RESTING, Lie.TOPPLED)


def covered(scene: Scene, run: Records, moves: Span, claims: Claims) -> Covered:
    """Return what must be shown of a run whose arm moves within a span of time."""
    todo, arm, hand = Covered([], [], [], [], []), scene.robot.arm, scene.robot.gripper
    ends = [p.end_s for own in run.placements.values() for p in own if isfinite(p.end_s)]
    whole = (moves[0], max([moves[1], *ends]))
    links = [(x.joint, x.name, todo.add(x.pieces, x.joint, HERE, x.name)) for x in arm.links]
    palm = todo.add(hand.body, HAND, flange_in_hand(arm), "palm")
    fingers: list[Sequence[int]] = []
    for finger in hand.fingers:
        slide = rotate(flange_in_hand(arm).rotation, (0.0, 0.5 * finger.side, 0.0))
        fingers.append(todo.add(finger.pieces, HAND, flange_in_hand(arm), finger.name, slide))
    # the arm against itself: all but neighbours, and what cannot meet by construction
    for joint, name, part in links:
        for other, its_name, its_part in links:
            if other > joint + 1 and frozenset((name, its_name)) not in arm.skipped_pairs:
                todo.keep(ROBOT, its_part, part, whole, DEEP, False)
        for its_part in (palm, *fingers) if joint < HAND - 1 else ():
            todo.keep(ROBOT, its_part, part, whole, DEEP, False)
    # the arm against every body: pads may press into what they hold
    todo.stays.extend(stays := list(_stays(todo, scene, run, whole)))
    for body in scene.bodies:
        sides, own = ("robot", body.name), [stay for stay in stays if stay.body == body.name]
        for stay in own:
            for joint, _, part in (*links, (HAND, "palm", palm)):
                if joint > 0 or stay.lie in (Lie.HELD, Lie.FALLING):
                    todo.keep(sides, part, stay.solids, stay.span, DEEP)
        grips, during = given.grips_of(body.name, run.events), (own[0].span[0], own[-1].span[1])
        for number, finger in enumerate(fingers):
            told = {x.grip: x for x in claims.let_go if (x.body, x.finger) == (body.name, number)}
            for window in _windows(during, grips, told):
                todo.releases.append(given.Release(finger, own, window, number))
                if window.open_s < window.until_s:
                    step_s, far = (FINE, APART) if window.depth_m > DEEP else (COARSE, AWAY)
                    times = given.steps(window.open_s, window.span[1], step_s)
                    todo.near.append(Near(finger, own, times, far))
                for stay in own:
                    span = common(window.span, stay.span)
                    todo.keep(sides, finger, stay.solids, span, window.depth_m, window.counts)
    # what is carried or falls against the rest; what it stood or will stand on is lowered
    parted = {(p.body, p.stay, p.other): (p.from_s, p.to_s) for p in claims.parted}
    for stay, other in ((a, b) for a in stays for b in stays if a.body != b.body):
        both, held = common(stay.span, other.span), stay.lie is Lie.HELD
        sides = ("robot" if held else stay.body, other.body)
        if stay.lie is Lie.FALLING and other.lie is Lie.HELD:  # it drops past what is still held
            counts, sides = stay.before != other.body, ("robot", stay.body)
            todo.keep(sides, other.solids, stay.solids, both, DEEP, counts)
        elif stay.lie in STILL or other.lie not in STILL:
            continue
        elif other.body not in stay.partners:
            todo.keep(sides, stay.solids, other.solids, both, DEEP)
        else:
            todo.keep(sides, stay.solids, other.lowered, both, DEEP, False)
            if held and claims.clearance_m is not None:
                # near on purpose: first what it stood on, in the end what it will stand on
                from_s, to_s = parted.get((stay.body, stay.number, other.body), both)
                low = min(max(from_s, both[0]), both[1]) if other.body == stay.before else both[0]
                high = max(min(to_s, both[1]), both[0]) if other.body == stay.after else both[1]
                todo.keep(sides, stay.solids, other.solids, (low, high), inf)
                for way in ((both[0], low), (both[1], high)):
                    todo.near.append(Near(stay.solids, [other], given.steps(*way, COARSE), AWAY))
    return todo


def _stays(todo: Covered, scene: Scene, run: Records, whole: Span) -> Iterator[Stay]:
    """Yield every body in each of its placements."""
    supports = {p.support for own in run.placements.values() for p in own}
    supports |= {body.rests_on for body in scene.bodies}
    for body in scene.bodies:
        known = run.placements.get(body.name, ()) if body.mobility is Mobility.MOVABLE else ()
        own = tuple(known) or (Placement(body.name, -inf, inf, Lie.RESTING, body.X_WO, None),)
        before = body.rests_on
        for number, p in enumerate(own):
            span, held, lowered = common((p.start_s, p.end_s), whole), p.lie is Lie.HELD, range(0)
            if span[1] > span[0]:
                X = flange_in_hand(scene.robot.arm) @ p.X if held else p.X
                falls = p.start_s if p.lie is Lie.FALLING else None
                solids = todo.add(body.pieces, HAND if held else 0, X, body.name, falls=falls)
                if body.name in supports and p.lie in STILL:
                    lowered = todo.add(body.pieces, 0, LOWERED @ X, body.name)
                after = given.next_support(own[number + 1 :])
                yield Stay(body.name, number, span, p.lie, before, after, solids, lowered)
            before = p.support


def _windows(whole: Span, grips: Sequence[Span], told: Told) -> Iterator[Window]:
    """Yield the rules between one finger and one body."""
    at = whole[0]
    for k, (close_s, open_s) in enumerate(grips):
        until_s = grips[k + 1][0] if k + 1 < len(grips) else whole[1]
        apart_s = away_s = min(open_s, until_s)
        if open_s < until_s and k in told:
            apart_s = min(max(told[k].apart_s, open_s), until_s)
            away_s = min(max(told[k].away_s, apart_s), until_s)
        yield Window((at, max(close_s, at)), DEEP, True)
        yield Window((max(close_s, at), apart_s), PRESSED, False, open_s, until_s, k)
        yield Window((apart_s, away_s), DEEP, False, open_s, until_s)
        at = away_s
    yield Window((at, whole[1]), DEEP, True)

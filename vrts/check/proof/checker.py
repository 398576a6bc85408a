"""Does a certificate prove what it claims of a run? No distance library, nothing of the search.

A leaf is a pair of solids in an interval of time. It holds when they stay farther apart than their
tolerance allows: the gap of their boxes, or the gap along a direction, at the middle of the
interval, less the most by which they can come nearer before its ends. That is what joints turn
times the distance from their axes, or along a direction |v.n| h + |n x w| r h + a h^2 / 2, of the
velocities v, w of the outer solid as seen from the inner one, its radius r, half the interval h,
and the largest acceleration a. In a contact nothing is looked for: points in both show that it is.
"""

from collections.abc import Iterator

import numpy as np

from vrts.check.curves.timeline_arrays import Curves, curves
from vrts.check.proof import given, tables
from vrts.check.proof.covered import covered
from vrts.check.proof.given import Array, Claims, Evidence, Indices, Proven, Records, Wrong
from vrts.check.proof.tables import dot, turned
from vrts.geometry.solids import Solids, solids
from vrts.robots.model import Arm, SphericalWristArm
from vrts.scene.model import Scene

GRAVITY = 9.81  # [m/s^2]
ROUNDING = 1e-6  # [m] of double precision, taken from every bound
EVENT_GAP = 0.5  # [s] contacts less than this apart are one event
UNSHOWN = "nothing shows that they keep apart"
SLACK = 3e-4  # [m] by which two points may be farther apart than the smallest distance claimed
SHRUNK = 1e-5  # [m] what is nearer by less than at the look before is no nearer


def at_zero(arm: Arm) -> list[tuple[Array, Array]]:
    """Return rotation and origin of each L_k in L_(k-1) while joint k is at zero."""
    real = arm.built or arm
    if not isinstance(real, SphericalWristArm):
        return [(np.reshape(X.rotation, (3, 3)), np.array(X.translation)) for X in real.joints]
    turns = ((1, 0), (0, -1), (1, 0), (0, 1), (0, -1), (0, 1))  # about x: cosine and sine
    along = (0, 0), (0, 0), (real.a2, real.d2), (real.a3, 0), (0, real.d4), (0, 0)  # x and z [m]
    return [
        (np.array([[1, 0, 0], [0, c, -s], [0, s, c]]), np.array([x, 0, z]))
        for (c, s), (x, z) in zip(turns, along, strict=True)
    ]


def frames(arm: Arm, q: Array) -> tuple[Array, Array]:
    """Return rotations (7, n, 3, 3) and origins (7, n, 3) of L_0 .. L_6 in W, for q (n, 6)."""
    rotations, origins = [np.tile(np.eye(3), (len(q), 1, 1))], [np.zeros((len(q), 3))]
    for j, (rotation, origin) in enumerate(at_zero(arm)):
        turned = np.tile(np.eye(3), (len(q), 1, 1))
        turned[:, 0, 0] = turned[:, 1, 1] = np.cos(q[:, j])
        turned[:, 1, 0] = np.sin(q[:, j])
        turned[:, 0, 1] = -turned[:, 1, 0]
        origins.append(origins[-1] + rotations[-1] @ origin)
        rotations.append(rotations[-1] @ rotation @ turned)
    return np.array(rotations), np.array(origins)


class Moments:
    """Intervals of time: where the arm is in their middles, and how it moves within them."""

    def __init__(self, arm: Arm, move: Curves, start_s: Array, end_s: Array) -> None:
        """Take intervals, both of shape (n,)."""
        self.time_s, self.half_s = 0.5 * (start_s + end_s), 0.5 * (end_s - start_s)
        q, within = move.values(self.time_s), move.spread(start_s, end_s)
        self.rotations, self.origins = frames(arm, q[:, :6])
        self.opening, self.velocity = q[:, 6], move.velocities(self.time_s)
        self.speed, self.turn = within.speed, np.maximum(within.upper - q, q - within.lower)
        steps = move.steps(start_s, end_s)  # of the velocity; they act like acceleration
        longer = np.where(self.half_s > 0, self.half_s, 1)[:, None]
        self.acceleration = within.acceleration + 2 * steps / longer

    def place(self, of: Solids, solid: Indices, k: Indices) -> tuple[Array, Array, Array]:
        """Return rotations, origins, and the middles of the boxes of solids at intervals k."""
        link = self.rotations[of.frame[solid], k]
        local = of.origin[solid] + of.slide[solid] * self.opening[k, None]
        origin = self.origins[of.frame[solid], k] + turned(link, local)
        origin[:, 2] -= 0.5 * GRAVITY * self.fallen(of, solid, k) ** 2
        rotation = link @ of.rotation[solid]
        return rotation, origin, origin + turned(rotation, of.middle[solid])

    def fallen(self, of: Solids, solid: Indices, k: Indices) -> Array:
        """Return for how long solids have been falling [s]."""
        since = np.maximum(self.time_s[k] - of.falls_from[solid], 0)
        return np.where(of.falls[solid], since, 0)

    def travel(self, of: Solids, solid: Indices, k: Indices, centre: Array) -> tuple[Array, Array]:
        """Return the largest distances from each axis (6, m), and how far solids get at most.

        The second, (7, m), is as seen from each of the frames L_0 .. L_6.
        """
        later = self.fallen(of, solid, k) + 0.5 * self.half_s[k]
        got = np.where(of.falls[solid], GRAVITY * self.half_s[k] * later, 0)
        got = got + self.turn[k, 6] * of.slides[solid]
        far, seen = np.zeros((6, len(solid))), np.zeros((7, len(solid)))
        seen[6] = got
        for j in range(5, -1, -1):
            out, axis = centre - self.origins[j + 1, k], self.rotations[j + 1, k][:, :, 2]
            out = out - axis * dot(out, axis)[:, None]
            reach = np.linalg.norm(out, axis=1) + of.ball[solid] + got
            far[j] = np.where(of.frame[solid] > j, reach, 0)
            got = got + far[j] * self.turn[k, j]
            seen[j] = got
        return far, seen

    def along(
        self, of: Solids, pair: given.Pair, k: Indices, c: Array, n: Array, far: Array
    ) -> Array:
        """Return by how much outer solids, middles c, come nearer to inner ones along n at most."""
        a, b = pair
        v, w, curve = np.zeros((len(a), 3)), np.zeros((len(a), 3)), np.zeros(len(a))
        inner = np.zeros(len(a))  # speeds of the joints further in
        for j in range(6):
            on = (of.frame[b] <= j) & (of.frame[a] > j)
            axis = self.rotations[j + 1, k][:, :, 2] * np.where(on, self.velocity[k, j], 0)[:, None]
            speed = np.where(on, self.speed[k, j], 0)
            v += np.cross(axis, c - self.origins[j + 1, k])
            w += axis
            # |d2x/dq_i dq_j| is at most the distance from the outer of the two axes
            curve += far[j] * (on * self.acceleration[k, j] + speed * (2 * inner + speed))
            inner = inner + speed
        v += turned(self.rotations[6, k], of.slide[a]) * self.velocity[k, 6, None]
        curve += of.slides[a] * (self.acceleration[k, 6] + 2 * inner * self.speed[k, 6])
        for solid, sign in ((a, 1), (b, -1)):
            v[:, 2] -= sign * GRAVITY * self.fallen(of, solid, k)
            curve += np.where(of.falls[solid], GRAVITY, 0)
        turning = np.linalg.norm(np.cross(n, w), axis=1) * of.ball[a]
        half_s = self.half_s[k]
        return (np.abs(dot(v, n)) + turning) * half_s + 0.5 * curve * half_s**2


def least(of: Solids, at: Moments, a: Indices, b: Indices, k: Indices, n: Array) -> Array:
    """Return how far solids keep apart throughout intervals k at least; n zero: by boxes."""
    count, still = len(at.time_s), (of.frame[b] == 0) & ~of.falls[b]
    keys = np.concatenate([a * count + k, b * count + np.where(still, 0, k)])
    known, where = np.unique(keys, return_inverse=True)
    solid, moment = np.divmod(known, count)
    rotation, origin, centre = at.place(of, solid, moment)
    far, seen = at.travel(of, solid, moment, centre)
    at_a, at_b = where[: len(a)], where[len(a) :]
    nearer = seen[of.frame[b], at_a] + np.where(of.falls[b], seen[6, at_b], 0)
    size, found = np.linalg.norm(n, axis=1), np.empty(len(a))
    x = np.flatnonzero(size == 0)
    low, high = tables.boxes(of, solid, rotation, origin)
    found[x] = tables.between(low[at_a[x]], high[at_a[x]], low[at_b[x]], high[at_b[x]]) - nearer[x]
    y = np.flatnonzero(size > 0)
    a, b, k, n, at_a, at_b = a[y], b[y], k[y], n[y] / size[y, None], at_a[y], at_b[y]
    gap = dot(origin[at_b] - origin[at_a], n)
    gap -= of.reach(a, rotation[at_a], n) + of.reach(b, rotation[at_b], -n)
    along = at.along(of, (a, b), k, centre[at_a], n, far[:, at_a])
    found[y] = gap - np.minimum(nearer[y], along)
    return found - ROUNDING


def check(scene: Scene, run: Records, claims: Claims, by: Evidence) -> Proven:
    """Return what a certificate rests on. Raises `Wrong` when it does not prove what it claims."""
    it = Check(scene, run, claims, by)
    listed, margin_m = it.leaves()
    it.rest(listed)
    it.near()
    it.meetings()
    return Proven(len(it.a), len(by.leaves.row), margin_m, it.nearest())


class Check:
    """A certificate beside the rows that it has to cover."""

    def __init__(self, scene: Scene, run: Records, claims: Claims, by: Evidence) -> None:
        self.arm, self.claims, self.by = scene.robot.arm, claims, by
        self.move = curves(run.timeline.segments)
        self.todo = covered(scene, run, (self.move.start_s, self.move.end_s), claims)
        of, rows = solids(self.todo.solids), tables.rows_of(self.todo, claims)
        self.all_of, self.rows = of, rows
        tables.check_places(by, rows, len(of.shapes))
        self.a, self.b = a, b = tables.ordered(of, rows.first, rows.second)
        self.rigid = (of.frame[a] == of.frame[b]) & ~of.falls[a] & (of.slides[a] == 0)
        p, k = by.points, np.arange(len(by.points.time_s))
        at, self.spots = Moments(self.arm, self.move, p.time_s, p.time_s), np.empty((len(k), 2, 3))
        for side, solid in enumerate(p.solids.T):
            rotation, origin, _ = at.place(of, solid, k)
            inside = tables.inside(of, solid, p.corners[:, side], p.weights)
            self.spots[:, side] = origin + turned(rotation, inside)
        self.apart = np.linalg.norm(self.spots[:, 0] - self.spots[:, 1], axis=1)

    def require(self, good: given.Flags, what: str, row: Indices, time_s: Array) -> None:
        """Go on where something is so of rows at times; else tell the first that is not."""
        wrong = np.flatnonzero(~good)
        if len(wrong):
            k = wrong[np.argmin(time_s[wrong])]
            parts = [self.all_of.parts[int(side[row[k]])] for side in (self.a, self.b)]
            raise Wrong(what, float(time_s[k]), parts)

    def leaves(self) -> tuple[Indices, float]:
        """Look at the leaves; return which rows they list in which roots, and the least margin."""
        x, rows = self.by.leaves, self.rows
        start_s, end_s = tables.spans_of(x, self.by.edges)
        key = x.row * len(self.by.edges) + x.root
        self.require(tables.whole(x, key), "some time is left out", x.row, start_s)
        moments, k = np.unique(np.stack([start_s, end_s], axis=1), axis=0, return_inverse=True)
        at = Moments(self.arm, self.move, *moments.T)
        own = np.flatnonzero(x.kind != given.EXCUSED)
        row, k = x.row[own], k.ravel()[own]
        margin = least(self.all_of, at, self.a[row], self.b[row], k, x.normal[own])
        margin -= rows.least[row]
        self.require(margin > 0, UNSHOWN, row, start_s[own])
        # what moves together does so all the time as in its first interval
        rigid, excused = self.rigid[x.row], x.kind != given.EXCUSED
        start_s = np.where(rigid, rows.start_s[x.row], start_s)
        end_s = np.where(rigid, rows.end_s[x.row], end_s)
        for m in self.claims.meetings:
            sides = np.array([d.sides == (m.first, m.second) for d in self.todo.demands])
            excused |= sides[rows.demand[x.row]] & (start_s >= m.from_s) & (end_s <= m.to_s)
        self.require(excused, "no contact excuses it", x.row, start_s)
        return np.unique(key), float(margin.min(initial=np.inf))

    def unsettled(self) -> Iterator[tuple[Indices, Indices]]:
        """Yield rows, and root intervals of them, that boxes of unions of solids do not settle."""
        of, rows, edges = self.all_of, self.rows, self.by.edges
        count, still = len(edges) - 1, (of.frame == 0) & ~of.falls
        at = Moments(self.arm, self.move, edges[:-1], edges[1:])
        solid, k, place = tables.once(still, count)
        rotation, origin, centre = at.place(of, solid, k)
        low, high = (x[place] for x in tables.boxes(of, solid, rotation, origin))
        seen = at.travel(of, solid, k, centre)[1][:, place]
        # whole unions of solids first: most are far apart in most intervals
        members, starts, sides = tables.unions_of(self.todo)
        low = np.minimum.reduceat(low[members], starts, axis=0)
        high = np.maximum.reduceat(high[members], starts, axis=0)
        seen = np.maximum.reduceat(seen[:, members], starts, axis=1)
        head = rows.begin
        A, B = np.where(self.a[head] == rows.first[head], sides, sides[::-1])
        inner, falls = of.frame[self.b[head]], of.falls[self.b[head]][:, None]
        begin = np.searchsorted(edges, rows.start_s[head])
        end = np.where(self.rigid[head], begin + 1, np.searchsorted(edges, rows.end_s[head]))
        for d in np.array_split(np.arange(len(head)), len(head) // 128 + 1):
            gap = np.maximum(low[B[d]] - high[A[d]], low[A[d]] - high[B[d]]).max(axis=-1)
            gap -= seen[inner[d], A[d]] + np.where(falls[d], seen[6, B[d]], 0) + ROUNDING
            now = (np.arange(count) >= begin[d, None]) & (np.arange(count) < end[d, None])
            which, k = np.nonzero(now & (gap <= rows.least[head[d], None]))
            row, of_which = tables.within(head[d[which]], rows.size[d[which]])
            yield row, k[of_which]

    def rest(self, listed: Indices) -> None:
        """Look at all that is not listed: boxes are to keep it apart, in whole root intervals."""
        edges = self.by.edges
        at = Moments(self.arm, self.move, edges[:-1], edges[1:])
        for row, k in self.unsettled():
            new = ~np.isin(row * len(edges) + k, listed)
            row, k = row[new], k[new]
            far = least(self.all_of, at, self.a[row], self.b[row], k, np.zeros((len(k), 3)))
            self.require(far > self.rows.least[row], UNSHOWN, row, edges[k])

    def near(self) -> None:
        """Before things are said to be apart, two points are not, nor do they come near again."""
        p, beyond_m, again = self.by.points, tables.beyond_m(self.claims), list[given.Apart]()
        for one in self.todo.near:
            before_m = 0.0
            for t in one.times:
                shown, pairs = tables.looked(one, t, p)
                apart = self.apart[shown & (self.apart <= one.most_m)]
                if not len(apart):
                    parts = (self.all_of.parts[one.first[0]], one.stays[0].body)
                    raise Wrong("nothing shows that they are not yet apart", t, parts)
                if before_m > beyond_m:
                    again += [given.Apart(i, j, t, before_m - SHRUNK) for i, j in pairs]
                before_m = float(apart.min())
        a, b, times, least_m, n = tables.columns_of(again, p, self.spots)
        at = Moments(self.arm, self.move, times, times)
        wrong = np.flatnonzero(least(self.all_of, at, a, b, np.arange(len(a)), n) < least_m)
        for k in wrong[:1].tolist():
            parts = (self.all_of.parts[int(a[k])], self.all_of.parts[int(b[k])])
            raise Wrong("nothing shows that they do not come near again", float(times[k]), parts)

    def meetings(self) -> None:
        """Points deep inside both show that there is contact, from its start to its end."""
        p, across = self.by.points, self.spots[:, 0] - self.spots[:, 1]
        fours = np.flatnonzero(p.use == given.WITNESS).reshape(-1, 4)
        for number, m in enumerate(self.claims.meetings):
            times = [m.from_s, m.to_s]
            for four in fours:
                t, deep = float(p.time_s[four[0]]), tables.depth(across[four])
                for d in tables.demands_of(self.todo, p, four):
                    inside = m.from_s <= t <= m.to_s and d.sides == m[:2]
                    times += [t] if inside and deep > d.tolerance + ROUNDING else []
            others = [x for x in self.claims.meetings[:number] if x[:2] == m[:2]]
            apart = [max(x.from_s - m.to_s, m.from_s - x.to_s) for x in others]
            near = min(apart, default=EVENT_GAP) < 0.9 * EVENT_GAP
            if near or len(times) == 2 or np.diff(sorted(times)).max() >= EVENT_GAP:
                raise Wrong("nothing shows the contact", m.from_s, (m.first, m.second))

    def nearest(self) -> float | None:
        """Return the distance of two points that come as near as the smallest distance claimed."""
        if self.claims.clearance_m is None:
            return None
        shown = np.flatnonzero(self.by.points.use == given.NEAREST)[:, None]
        demands = ((k, tables.demands_of(self.todo, self.by.points, k)) for k in shown)
        counting = [k for k, those in demands if any(d.counts for d in those)]
        found = min((float(self.apart[k[0]]) for k in counting), default=np.inf)
        if self.claims.meetings or found > self.claims.clearance_m + SLACK:
            raise Wrong("nothing shows that something comes as near as is claimed")
        return found

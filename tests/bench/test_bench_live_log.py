"""The log of a server: entries a second with signs and without, and how fast it is verified.

Run by hand: `python -m pytest tests/bench/test_bench_live_log.py -s`. The time is that of the
processor, of all threads; what a disk takes is the same with signs as without.
"""

import resource
import time
from pathlib import Path

import pytest

from vrts.live.store import log
from vrts.live.store.accounts import add_account
from vrts.live.store.database import Database
from vrts.live.store.log import Entry
from vrts.live.store.rooms import KeptRoom, keep_room
from vrts.live.store.verifying import findings

ENTRIES = 12_000
TEXT = '{"action":{"type":"line","line":"EXECUTE pick,1"},"result":{"accepted":true}}' * 3


def filled(path: Path, key: Path, rooms: int, together: int, *, signs: bool) -> float:
    """Append entries to all rooms in turn; return processor time of one [s]."""
    database = Database(path, key, signs=signs)
    ids = [f"room{number:04d}" for number in range(rooms)]
    for number, id_ in enumerate(ids):
        kept = KeptRoom(id_, f"Group {number}", "cans-on-bases", number, True, 0.0, 120.0)
        database.submit(lambda c, kept=kept: keep_room(c, kept)).result()
    account = database.submit(lambda c: add_account(c, "Anna", 0.0).id).result()
    begun = time.process_time()
    for first in range(0, ENTRIES, together):
        futures = [
            database.submit(lambda c, entry=entry: log.append_now(c, entry))
            for entry in (
                Entry(ids[n % rooms], 1, 0.02 * n, 1e9 + n, "line", True, account, "Anna", TEXT)
                for n in range(first, first + together)
            )
        ]
        for future in futures:
            future.result()
    spent = time.process_time() - begun
    database.close()
    return spent / ENTRIES


@pytest.mark.parametrize(("rooms", "together"), [(1, 1), (30, 1), (64, 1), (64, 20), (1000, 1)])
def test_entries_a_second(rooms: int, together: int, tmp_path: Path) -> None:
    spent: dict[bool, float] = {}
    for signs in (False, True):
        folder = tmp_path / str(signs)
        folder.mkdir()
        key = tmp_path / f"key-{signs}"
        spent[signs] = filled(folder / "live.sqlite", key, rooms, together, signs=signs)
    more = spent[True] - spent[False]
    print(
        f"\n{rooms} rooms, {together} entries a transaction: {1 / spent[False]:,.0f} entries a"
        f" second without signs, {1 / spent[True]:,.0f} with; a sign costs {more * 1e6:.0f} us"
    )
    assert more < (1e-3 if rooms > 64 else 3e-4)


def test_verifying_takes_time_in_proportion(tmp_path: Path) -> None:
    path, key = tmp_path / "live" / "live.sqlite", tmp_path / "key"
    path.parent.mkdir()
    print()
    spent: list[float] = []
    for times in (1, 2, 3, 4):
        filled(path, key, 8, 20, signs=True) if times == 1 else again(path, key)
        begun = time.process_time()
        assert not [one for one in findings(path, key) if one.wrong]
        spent.append(time.process_time() - begun)
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3
        count = times * ENTRIES
        print(
            f"{count} records: {spent[-1]:.2f} s, {count / spent[-1]:,.0f} a second;"
            f" {memory:.0f} MB at most"
        )
    assert spent[3] < 6.0 * spent[0]


def again(path: Path, key: Path) -> None:
    """Append as many entries once more."""
    database = Database(path, key, signs=True)
    for n in range(ENTRIES):
        entry = Entry(f"room{n % 8:04d}", 1, 0.02 * n, 1e9 + n, "line", True, 1, "Anna", TEXT)
        database.submit(lambda c, entry=entry: log.append_now(c, entry))
    database.close()

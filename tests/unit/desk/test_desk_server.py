"""The desk as a process: who may ask, what is answered, and that nothing is lost."""

from pathlib import Path

import pytest

from tests.support_desk import HOSTILE, write_desk_class
from tests.support_desk_server import DeskServer
from vrts.marking.layout import Layout

CHANGE = {"does": "change", "students": ["s0003"], "delta": "-1/2", "reason": "the grip is late"}


@pytest.fixture
def layout(tmp_path: Path) -> Layout:
    return write_desk_class(tmp_path, hostile=True)


def test_only_who_has_the_address_on_this_machine_comes_in(layout: Layout) -> None:
    with DeskServer(layout.root) as desk:
        header = desk.entered.headers["set-cookie"]
        assert {"HttpOnly", "SameSite=strict"} <= set(header.split("; "))
        assert desk.token not in header + desk.entered.body.decode(), "and not in any history"
        assert desk.get("/").status == 200
        for cookie in ("", f"vrts_desk_{desk.port}={desk.token}", "vrts_desk_1=é"):
            for path in ("/", "/web/desk/index.html", "/api/class", "/api/events", "/nothing"):
                assert desk.get(path, cookie=cookie).status == 401, path
        assert desk.get("/?token=wrong", cookie="").status == 401
        assert desk.get("/api/class", host="evil.example").status == 421
        body = {"records": [CHANGE], "expect": desk.whole["revision"]}
        for origin in ("https://evil.example", "null", "", f"http://127.0.0.1:{desk.port + 1}"):
            refused = desk.request("POST", "/api/records", body, origin=origin)
            assert refused.status == 403, origin
            assert "access-control-allow-origin" not in refused.headers
        assert desk.request("POST", "/api/records", body, content_type="text/plain").status == 415
        assert desk.request("POST", "/api/records", b" " * 1_000_001).status == 413
        for wrong in (b"{", b"[" * 100_000, b'{"records": [], "expect": ""}', b"\xff"):
            assert desk.request("POST", "/api/records", wrong).status == 422
        assert not (layout.decisions / "r-huber.jsonl").exists()
        assert "-1/2" not in (layout.decisions / "huber.jsonl").read_text().split("\n", 3)[3]


@pytest.mark.thorough
def test_files_are_those_of_the_class_and_run_in_a_sandbox(layout: Layout) -> None:
    (layout.grader("s0001") / "result.json").write_text("{}")
    (layout.grader("s0002") / "report.html").unlink()
    (layout.grader("s0002") / "report.html").symlink_to("/etc/hostname")
    with DeskServer(layout.root) as desk:
        row = desk.row("s0000")
        report = desk.get(row["report"])
        assert report.status == 200
        policy = report.headers["content-security-policy"]
        assert policy.startswith("sandbox allow-scripts; default-src 'none'")
        assert "frame-ancestors 'self'" in policy
        assert "allow-same-origin" not in policy
        assert desk.get(row["sent"]).status == 200
        alike = ("/files/staff/similarity.html", "/files/staff/similarity/pair-001.html")
        for path in alike:  # runs nothing, and its links lead on with the desk's cookie
            answer = desk.get(path)
            assert answer.status == 200, path
            policy = answer.headers["content-security-policy"]
            assert policy.startswith("default-src 'none'; style-src 'unsafe-inline'; img-src data:")
            assert "script-src" not in policy
        overview = desk.get("/files/staff/index.html")
        assert (overview.status, overview.headers["location"]) == (303, "/")
        page = desk.get("/").headers["content-security-policy"]
        assert "script-src 'self'; " in page
        assert "unsafe" not in page
        for path in (
            "/files/staff/results.json",
            "/files/staff/similarity.html/../results.json",
            "/files/staff/similarity/programs.zip",
            "/files/staff/similarity/..%2fpair-001.html",
            "/files/staff/..%2fsimilarity.html",
            "/files/staff/students/s0001/result.json",
            "/files/staff/students/s0002/report.html",
            "/files/staff/students/..%2f..%2fstudents%2fs0001/report.html",
            "/files/staff/students/../staff/report.html",
            "/files/staff/students/%2e%2e/report.html",
            "/files/staff/students/nobody/report.html",
            "/web/../pyproject.toml",
            "/web/%2e%2e/py.typed",
            "/api/row/..",
            "/api/row/nobody",
        ):
            assert desk.get(path).status == 404, path
        assert HOSTILE in row["source"]["lines"][0], "as it was handed in, as text"
        assert row["row"]["name"] == HOSTILE
        assert desk.get("/api/row/s0000").headers["content-type"] == "application/json"


def test_decisions_are_written_all_or_none_about_what_was_shown(layout: Layout) -> None:
    with DeskServer(layout.root) as desk, DeskServer(layout.root, "S. Mayr") as other:
        before = desk.whole
        assert [one["id"] for one in before["graders"]] == ["huber", "mayr"]
        assert before["me"] == {"id": "huber", "name": "R. Huber"}
        item = {"does": "item", "id": "late-grip", "title": "The grip is late", "points": "-1"}
        give = {"does": "give", "item": "late-grip", "students": ["s0002", "s0003"], "line": 7}
        with other.events() as events:
            added = desk.add(item, give, CHANGE)
            assert added.status == 200
            assert added.json["added"] == ["huber:9", "huber:10", "huber:11"]
            assert next(events)[0] == "revision"
        seen = other.row("s0003")
        assert [one["item"] for one in seen["given"]] == ["late-grip"]
        assert [one["record"] for one in seen["changes"]] == ["huber:11"]
        stale = other.add({**give, "does": "give"}, expect=before["revision"])
        assert stale.status == 409, "the other desk never showed that"
        late = desk.add(CHANGE, {**CHANGE, "students": ["s0005"]}, expect=before["revision"])
        assert (late.status, set(late.json)) == (409, {"error", "revision"})
        assert "`s0003`" in late.json["error"]
        words = {"does": "comment", "student": "s0003", "text": "well \u202edone"}
        assert desk.add(words, expect=before["revision"]).status == 200, "words rest on no mark"
        for wrong in (
            {**CHANGE, "students": ["nobody"]},
            {**CHANGE, "mark": "7"},
            {**CHANGE, "sneaked": 1},
            {**CHANGE, "delta": "1e9"},
            {**CHANGE, "delta": "-75"},
            {"does": "give", "item": "nothing", "students": ["s0001"]},
        ):
            refused = desk.add(words, wrong)
            assert refused.status == 422, wrong
            assert refused.json["diagnostics"], wrong
        (said,) = desk.row("s0003")["comments"]  # nothing of what was refused
        assert said["text"] == "well �done"
        undone = desk.add({"does": "undo", "records": ["huber:11"]})
        assert undone.status == 200
        history = {one["record"]: one["undone_by"] for one in desk.row("s0003")["history"]}
        assert history["huber:11"] == undone.json["added"][0]


@pytest.mark.thorough
def test_what_was_acknowledged_survives_kill_9(layout: Layout) -> None:
    desk = DeskServer(layout.root)
    names = [
        name
        for number in range(20)
        for name in desk.add(
            {"does": "comment", "student": "s0001", "text": f"number {number}"}
        ).json["added"]
    ]
    desk.kill()
    with DeskServer(layout.root) as again:
        found = {one["record"]: one["text"] for one in again.row("s0001")["comments"]}
    assert [found[name] for name in names] == [f"number {number}" for number in range(20)]

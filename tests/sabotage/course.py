"""Faults planted in what a course adds to the live server."""

from tests.sabotage.patch import Patch

BOARD = "tests/unit/course/board/test_board.py"
BOARD_PAGES = "tests/unit/course/board/test_board_pages.py"

COURSE: tuple[Patch, ...] = (
    Patch(
        "everybody who is logged in sees the board of a course",
        "vrts/course/front/board_pages.py",
        "return account if account is not None and account.leads_in(ALL_ROOMS) else None",
        "return account",
        (BOARD_PAGES,),
    ),
    Patch(
        "a page that follows the board is told nothing of new attempts",
        "vrts/live/store/course/attempts.py",
        "SELECT count(*), total(state='waiting'), max(at), total(length(causes)),",
        "SELECT 0, 0, 0, 0,",
        (BOARD_PAGES,),
    ),
    Patch(
        "who has mended what cost points is still called stuck",
        "vrts/course/board/causes.py",
        "        for key, cost in lost(own[-1]).items():",
        "        for key, cost in lost(own[0]).items():",
        (BOARD,),
    ),
    Patch(
        "the board shows the last mark where the best counts",
        "vrts/course/board/board.py",
        "if best else marked[-1]",
        "if not best else marked[-1]",
        (BOARD,),
    ),
)

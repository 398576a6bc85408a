"""Faults planted in what a course adds to the live server."""

from tests.sabotage.patch import Patch

BOARD = "tests/unit/course/board/test_board.py"
TAKING = "tests/unit/course/handing/test_taking.py"
HANDING_RULES = "tests/unit/course/handing/test_rules.py"
WORK = "tests/unit/course/handing/test_work_over_http.py"
PUBLISHED = "tests/unit/course/handing/test_published.py"
BOARD_PAGES = "tests/unit/course/board/test_board_pages.py"
FOLLOWING = "tests/unit/course/people/test_following.py"
RIGHTS = "tests/unit/course/people/test_rights.py"
CHECKS = "tests/unit/live/entrance/test_provider_checks.py"
PROVIDER = "tests/unit/course/people/test_provider.py"
OWN_SLEEP = "tests/unit/live/rooms/test_own_sleep.py"
VARIANTS = "tests/unit/course/variants/test_variants_of_course.py"
SLOTS = "tests/unit/course/robots/test_slots.py"

COMMENTS = "tests/browser/test_comments_page.py"
HAND_IN = "tests/browser/test_hand_in_page.py"
PAGES = "tests/browser/test_course_pages.py"

COURSE: tuple[Patch, ...] = (
    Patch(
        "the board exports final marks to whoever is in the course",
        "vrts/course/front/board_pages.py",
        "            return refused(*REFUSED)\n        wanted = await read_body(request, Wanted",
        "            pass\n        wanted = await read_body(request, Wanted",
        ("tests/unit/course/board/test_grade_book.py",),
    ),
    Patch(
        "the board exports unsafe marks though nobody takes them",
        "vrts/course/board/grade_book.py",
        "        if wanted.despite:\n",
        "        if True:\n",
        ("tests/unit/course/board/test_grade_book.py",),
    ),
    Patch(
        "on a phone the list of people goes on beyond the edge",
        "vrts/web/course/people/people.css",
        "@media (max-width: 760px) {",
        "@media (max-width: 76px) {",
        (PAGES,),
    ),
    Patch(
        "the room hands in what is saved, not what is in the editor",
        "vrts/web/live/editor/workbench.js",
        '?? "", text(), opened.name',
        '?? "", saved, opened.name',
        (HAND_IN,),
    ),
    Patch(
        "what graders say of a moment does not come up when the replay passes it",
        "vrts/web/report/comments.js",
        "passed >= -BEFORE && passed <=",
        "passed >= 0 && passed <= 0 *",
        (COMMENTS,),
    ),
    Patch(
        "what graders say of a line stands at no line of the program",
        "vrts/web/report/comments.js",
        "      line?.append(/** @type {HTMLElement} */ (box));\n",
        "",
        (COMMENTS,),
    ),
    Patch(
        "somebody who is still on the list is forgotten, and has an account a second later",
        "vrts/course/personal/still_listed.py",
        "if one.key in keys or one.email in emails",
        "if one.key in keys and one.email not in emails",
        ("tests/unit/cli/course/test_course_commands.py",),
    ),
    Patch(
        "a hand-in that a crash has left half done is not finished at the next start",
        "vrts/course/handing/taking.py",
        "in await asyncio.to_thread(lambda: list(deposit.unfinished(home))):",
        "in []:",
        (TAKING,),
    ),
    Patch(
        "a program is taken at a price that nobody agreed to",
        "vrts/course/handing/taking.py",
        "            if seen != (used + 1, stands.late):",
        "            if seen[0] != used + 1:",
        (TAKING,),
    ),
    Patch(
        "the many hand-ins of one keep all others waiting",
        "vrts/course/handing/queue.py",
        "    return sorted(found, key=lambda job: (*found[job], job))",
        "    return sorted(found, key=lambda job: (found[job][1], job))",
        (HANDING_RULES,),
    ),
    Patch(
        "the page marks by hidden checks, too",
        "vrts/course/handing/public_marker.py",
        "            marked = mark(order, self.public, self.wanted, by)",
        "            marked = mark(order, Marker(self.place, self.wanted).whole, self.wanted, by)",
        (WORK,),
    ),
    Patch(
        "marks that are unsafe are published, asked or not",
        "vrts/course/handing/publishing.py",
        "    if unsafe:\n",
        "    if unsafe and not rows:\n",
        (PUBLISHED,),
    ),
    Patch(
        "others enter a robot of somebody's own who know its address",
        "vrts/live/rooms/hub.py",
        "    return room.shared and account.room in (None, room.id)",
        "    return room.branch is None and account.room in (None, room.id)",
        (OWN_SLEEP,),
    ),
    Patch(
        "who leads sees somebody's own robot without being in it",
        "vrts/live/rooms/hub.py",
        "    return any(member.account.id == account.id for member in room.members.values())",
        "    return may_enter(account, room)",
        (OWN_SLEEP,),
    ),
    Patch(
        "a robot falls asleep while a program waits in it",
        "vrts/live/rooms/own/sleeping.py",
        'type=_Mode).mode in ("idle", "stopped")',
        'type=_Mode).mode in ("idle", "stopped", "waiting")',
        (OWN_SLEEP,),
    ),
    Patch(
        "a program that is left running in a robot of one's own runs for ever",
        "vrts/live/rooms/own/sleeping.py",
        "        elif unused > limits.program_s and",
        "        elif unused > 1e9 and",
        (OWN_SLEEP,),
    ),
    Patch(
        "two people have the same time of a shared robot",
        "vrts/live/store/course/slots.py",
        '        return "taken"',
        "        pass",
        (SLOTS,),
    ),
    Patch(
        "slots follow the clock on the wall where clocks change",
        "vrts/course/slot_rules.py",
        "        return local.timestamp()",
        "        return local.replace(hour=0, minute=0).timestamp() + 60.0 * minutes",
        (SLOTS,),
    ),
    Patch(
        "who has booked a time waits behind the others",
        "vrts/course/robots/slots.py",
        "        room.control.hand_over(member.id, steady)\n",
        "        room.control.request(member.id, steady)\n",
        (SLOTS,),
    ),
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
    Patch(
        "an assistant leads every room",
        "vrts/live/store/accounts.py",
        "return self.supervisor or not self.leads.isdisjoint((room, ALL_ROOMS))",
        "return self.supervisor or bool(self.leads)",
        (FOLLOWING,),
    ),
    Patch(
        "an assistant does in all rooms what is for all rooms",
        "vrts/live/rooms/supervising.py",
        "    account = member.account\n    if account.supervisor:\n        return\n",
        "    account = member.account\n    if account.leads_any:\n        return\n",
        (RIGHTS,),
    ),
    Patch(
        "who is taken off the list of a course comes in with the cookie of before",
        "vrts/live/store/accounts.py",
        "person.account=account.id AND NOT listed)",
        "person.account=account.id AND NOT 1)",
        (FOLLOWING,),
    ),
    Patch(
        "a personal link works again and again",
        "vrts/live/store/course/letters.py",
        '    connection.execute("DELETE FROM letter WHERE account=?", (person.account,))\n',
        "",
        (RIGHTS,),
    ),
    Patch(
        "a token for another log-in is taken",
        "vrts/live/entrance/provider/checking.py",
        '        "nonce": expected.nonce,\n',
        "",
        (CHECKS,),
    ),
    Patch(
        "an address that the provider has not verified opens an account",
        "vrts/course/front/login_pages.py",
        "        if not identity.verified:",
        "        if False:",
        (PROVIDER,),
    ),
    Patch(
        "the board does not tell of hands that are raised in robots of their own",
        "vrts/course/front/board_pages.py",
        "            for one in raised\n",
        "            for one in raised[:0]\n",
        ("tests/unit/course/robots/test_own_robots.py",),
    ),
    Patch(
        "a variant is drawn again whenever somebody asks for it",
        "vrts/course/variants/giving.py",
        "        before = was.get(names[0])\n",
        "        before = None\n",
        (VARIANTS,),
    ),
    Patch(
        "each of a team has another variant of the task",
        "vrts/course/variants/giving.py",
        "        handed = dict.fromkeys(names, handed_to(varied.variants, variant))",
        "        handed = dict.fromkeys(names[:1], handed_to(varied.variants, variant))",
        (VARIANTS,),
    ),
    Patch(
        "the same program is marked once for people who have other variants",
        "vrts/course/handing/queue.py",
        "        job = Job(one.assignment, one.digest, one.variant)",
        "        job = Job(one.assignment, one.digest)",
        (HANDING_RULES,),
    ),
    Patch(
        "everybody has the later deadline that was given to one",
        "vrts/course/handing/granted.py",
        "        return known[1].get(folder, NOTHING)",
        "        return known[1].get(folder, next(iter(known[1].values()), NOTHING))",
        (PUBLISHED,),
    ),
)

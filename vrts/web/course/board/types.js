// What the board is told; see vrts/course/board/told.py. Fields at their default are left out.

/**
 * @typedef {{id: string, title: string, opens: number, due: number, total: number, counts: "best" | "latest", begun: number,
 *   full: number, mean: number | null, marked?: boolean}} Column
 * @typedef {{tries?: number, mark?: number, last?: number, at?: number, state?: string, late?: string, cause?: string, same?: number}} Cell
 * @typedef {{id: number, name: string, key: string, team: string, listed: boolean, room: string, cells: Cell[]}} Student
 * @typedef {{key: string, assignment: string, words: string, points: number, students: number[], stuck: number}} Cause
 * @typedef {{id: number, name: string, why: "hand" | "marking", since: number, room: string, text: string}} Wait
 * @typedef {{title: string, now: number, columns: Column[], students: Student[], causes: Cause[], waits: Wait[]}} Board
 * @typedef {{now: number, students?: Student[], gone?: number[], columns?: Column[], causes?: Cause[], waits?: Wait[]}} Changed
 * @typedef {{assignment: string, number: number, at: number, state: string, mark: number | null, total: number, late: string,
 *   losses: [string, number][]}} Attempt
 * @typedef {{id: number, name: string, attempts: Attempt[]}} Work
 */

export const STUCK = 3; // attempts in a row that lose by the same, as in causes.py

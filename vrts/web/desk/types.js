// What the desk's server says, as types: nothing is executed here.

/** @typedef {{reason: string, sentence: string}} Doubt */
/** @typedef {{who: string, mark: number | null, stale: boolean}} Finished */
/** @typedef {{group: string, strength: string, with: string[], score: number}} Likeness */

/**
 * @typedef {{id: string, name: string, final: number | null, computed: number | null, total: number, kind: string, unsafe: Doubt[], ready: boolean | null,
 *   cause: string | null, line: number | null, time_s: number | null, causes: string[], late: string, deduction: number, due: string | null,
 *   likeness: Likeness | null, assigned: string[], finished: Finished[], comments: number, items: string[], change: string | number | null,
 *   excused: boolean | string | null, conflict: boolean | string | null, report: boolean, order: number, why_next: string, set_by?: string[], own?: number | null, alone?: boolean, otherwise?: string, pending?: boolean}} Row
 */

/** @typedef {{record: string, who: string, name: string, at: string, title: string, points: number, withdrawn: boolean, undone_by: string | null}} Version */
/** @typedef {{id: string, title: string, points: number | string, version: string, students: string[], withdrawn: boolean, versions: Version[]}} Item */
/** @typedef {{key: string, kind: string, check: string | null, sentence: string, points: number | string, count: number, students: string[]}} Cause */
/** @typedef {{record: string, who: string, at: string, sentence: string}} Side */
/** @typedef {{id: string, about: string, student: string | null, sentence: string, sides: Side[]}} Conflict */
/** @typedef {{id: string, name: string}} Grader */
/** @typedef {{running: boolean, done: number, all: number, problem: string | null}} Marking */

/**
 * @typedef {{title: string, total: number, revision: string, me: Grader, graders: Grader[], rows: Row[], items: Item[], causes: Cause[],
 *   conflicts: Conflict[], marking: Marking, retrieved?: string, problems?: string[]}} ClassData
 */

/** @typedef {{points: number | string, kind: string, sentence: string, hint: string | null, line: number | null, time_s: number | null, cause?: string}} Loss */
/** @typedef {{id: string, title: string, kind: string, points: number, most: number, answer: string, message: string, hidden: boolean}} Check */
/** @typedef {{code: string, slug: string, severity: string, headline: string, line: number | null, time_s: number | null, help: string[]}} Finding */
/** @typedef {{points: number | string | null, title: string, sentence: string | null}} Step */
/** @typedef {{record: string, who: string, name: string, at: string, line: number | null, time_s: number | null, text: string, private: boolean, stale: boolean, mine: boolean}} Comment */
/** @typedef {{record: string, item: string, who: string, at: string, line: number | null, time_s: number | null, students: string[]}} Given */
/** @typedef {{record: string, who: string, at: string, delta: number | string | null, mark: number | string | null, reason: string}} Change */
/** @typedef {{record: string, who: string, name: string, at: string, sentence: string, undone_by: string | null, students: number, at_once: string[], undone: number}} Past */
/** @typedef {{at: string | null, mark: number | null, file: string | null}} Attempt */

/**
 * @typedef {{row: Row, source: {name: string, lines: string[]} | null, source_problem: string | null, losses: Loss[], checks: Check[], findings: Finding[], steps: Step[], comments: Comment[],
 *   given: Given[], changes: Change[], history: Past[], report: string | null, sent: string | null, attempts: Attempt[]}} Detail
 */

/** @typedef {{from: number, to: number, count: number}} Bin */
/**
 * @typedef {{id: string, title: string, most: number, count: number, mean: number | null, full: number, none: number, discrimination: number | null, histogram: Bin[]}} CheckStatistics
 */
/**
 * @typedef {{marks: Bin[], mean: number | null, median: number | null, checks: CheckStatistics[], causes: Cause[],
 *   attempts: {number: number, count: number, mean: number | null, median: number | null}[],
 *   progress: {number: number, count: number, mean: number | null, median: number | null}[],
 *   graders: {who: string, rows: number, finished: number, mean: number | null}[],
 *   double: {student: string, marks: Record<string, number | null>, difference: number | null}[]}} Statistics
 */

/** A record as the page sends it. @typedef {{does: string} & Record<string, any>} Said */

export {};

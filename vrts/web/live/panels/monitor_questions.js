// What the monitor's line is for now: a command, or the answer to what it asks.

const COMMAND = "WHERE, DO MOVE …, EXECUTE …  (Tab completes)";

/** Questions by what their prompt looks like, and how they are answered. @type {[RegExp, string][]} */
const ANSWERS = [
  [/^Change\?\s*$/, "Up to six numbers, such as 700,,250; Enter alone keeps it"],
  [/\(Y\/N\)\?\s*$/, "Y to do it; anything else leaves all as it is"],
  [/^\s*\d+.?\?\s*$/, "A step; Enter alone goes on, E ends the editor"],
  [/^\s*\d+.?I\s*$/, "A step to insert; Enter alone ends inserting"],
  [/:\s*$/, "R records where the arm is; Enter alone ends it"],
];

/**
 * Return what stands in the empty line.
 * @param {string} prompt what the monitor shows before it @param {boolean} asked whether a session has told its prompt
 */
export function hintFor(prompt, asked) {
  if (!asked) return "The session is being prepared";
  if ([".", ">", "*"].includes(prompt.trim())) return COMMAND;
  const found = ANSWERS.find(([looks]) => looks.test(prompt));
  return found ? found[1] : "The program waits for an answer";
}

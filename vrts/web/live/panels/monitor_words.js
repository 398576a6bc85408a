// What a line of the monitor may go on with: commands and names that are in memory.

const COMMANDS = (
  "ABORT BASE BPT CALIBRATE COMPRESS COPY CYCLE.END DELETE DELETEL DELETEP DELETER DELETES DIRECTORY DISABLE DO DPOINT " +
  "EDIT ENABLE ERASE EXECUTE FCOPY FDELETE FDIRECTORY FLIST FREE FRENAME HELP HERE ID IO KILL LISTF LISTL LISTP LISTR LISTS " +
  "LOAD LOADL LOADP NEXT PANIC PARAMETER PCABORT PCEND PCEXECUTE PCPROCEED PCRETRY PCSTATUS POINT PRIME PROCEED RENAME " +
  "RESET RETRY SIGNAL SPEED SSTEP STATUS STORE STOREL STOREP STORER STORES SWITCH TEACH TIME TOOL WATCH WHERE XSTEP ZERO"
).split(" ");
const INSTRUCTIONS = (
  "MOVE MOVES MOVET MOVEST APPRO APPROS DEPART DEPARTS OPEN OPENI CLOSE CLOSEI DRIVE DELAY READY SPEED SIGNAL SET HERE " +
  "TOOL BASE BREAK RELAX LEFTY RIGHTY ABOVE BELOW FLIP NOFLIP"
).split(" ");
const OF_PROGRAMS = new Set(["EXECUTE", "EDIT", "LISTP", "DIRECTORY", "DELETE", "DELETEP", "COPY", "RENAME", "PCEXECUTE"]);

/**
 * Return the words that the last one of a line may become, in order.
 * @param {string} line @param {string[]} programs names in memory @param {Iterable<string>} names used before
 */
export function completions(line, programs, names) {
  const start = /[#$]?[A-Za-z0-9_.]*$/.exec(line)?.[0] ?? "";
  const before = line.slice(0, line.length - start.length).trim().toUpperCase();
  if (!before) return starting(start.toUpperCase(), COMMANDS);
  const [command, ...rest] = before.split(/\s+/);
  if (OF_PROGRAMS.has(command)) return starting(start.toLowerCase(), programs);
  const found = starting(start.toLowerCase(), [...names, ...programs]);
  return command === "DO" && !rest.length && start ? [...starting(start.toUpperCase(), INSTRUCTIONS), ...found] : found;
}

/** Return the names of locations and variables that lines speak of. @param {string[]} lines */
export function namesIn(lines) {
  const known = new Set([...COMMANDS, ...INSTRUCTIONS]);
  const words = lines.flatMap((line) => line.match(/#?[A-Za-z][A-Za-z0-9_.]*/g) ?? []);
  return new Set(words.filter((word) => !known.has(word.toUpperCase())).map((word) => word.toLowerCase()));
}

/** @param {string} start @param {Iterable<string>} words */
function starting(start, words) {
  return [...new Set(words)].filter((word) => word.startsWith(start)).sort();
}

/** Return what all words begin with. @param {string[]} words */
export function common(words) {
  let [shared = ""] = words;
  for (const word of words) while (!word.startsWith(shared)) shared = shared.slice(0, -1);
  return shared;
}

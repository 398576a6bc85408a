// Numbers and times for people, and back again.

/** Return a number that the server wrote: a number, or a fraction such as "-3/2". @param {number | string | null | undefined} value */
export function amount(value) {
  if (value === null || value === undefined || value === "") return null;
  if (typeof value === "number") return value;
  const [top, below] = value.split("/").map(Number);
  return below === undefined ? top : top / below;
}

/** Return a number as a record has it: "-3/2" and the like. @param {number} value */
export function exact(value) {
  const scale = 1000;
  let [top, below] = [Math.round(value * scale), scale];
  const common = divisor(Math.abs(top), below);
  [top, below] = [top / common, below / common];
  return below === 1 ? String(top) : `${top}/${below}`;
}

/** @param {number} a @param {number} b @returns {number} */
function divisor(a, b) {
  return b ? divisor(b, a % b) : a || 1;
}

/** Return what somebody typed as a number, with a comma or a full stop; null where it is none, or has more than the three decimals that are kept. @param {string} text */
export function typed(text) {
  const plain = text.trim().replace("−", "-").replace(",", ".");
  return /^[+-]?(\d{1,6}(\.\d{0,3})?|\.\d{1,3})$/.test(plain) ? Number(plain) : null;
}

/** Return a mark as text. @param {number | string | null | undefined} value */
export function mark(value) {
  const number = amount(value);
  return number === null ? "–" : number.toFixed(1);
}

/** Return points with their sign. @param {number | string | null | undefined} value */
export function points(value) {
  const number = amount(value);
  if (number === null) return "";
  const size = String(Math.round(Math.abs(number) * 1000) / 1000);
  return number < 0 ? `−${size}` : number > 0 ? `+${size}` : "±0";
}

/** Return points that were lost, whichever sign they came with, in hundredths: an earlier vrts did not round them. @param {number | string | null | undefined} value */
export function lost(value) {
  const number = amount(value);
  return number === null ? "" : points(-Math.round(Math.abs(number) * 100) / 100);
}

/** Return "1 student", "12 students". @param {number} count @param {string} one @param {string} many */
export function counted(count, one, many = `${one}s`) {
  return `${count.toLocaleString("en")} ${count === 1 ? one : many}`;
}

/** Return a sentence with its first letter in upper case. @param {string} text */
export function capital(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** Return a moment of a run. @param {number} time_s */
export function moment(time_s) {
  return `${time_s.toFixed(2)} s`;
}

/** Return when something was written, as people here write times. @param {string | null} at */
export function when(at) {
  const time = at ? new Date(at) : null;
  if (!time || Number.isNaN(time.getTime())) return at ?? "";
  return time.toLocaleString("en-GB", { day: "numeric", month: "short", hour: "2-digit", minute: "2-digit" });
}

/** Return a local time of an input with its offset from Greenwich, as records have times. @param {string} local such as 2026-11-26T18:00 */
export function withOffset(local) {
  const time = new Date(local);
  if (!local || Number.isNaN(time.getTime())) return null;
  const away = -time.getTimezoneOffset();
  const two = (/** @type {number} */ value) => String(Math.floor(Math.abs(value))).padStart(2, "0");
  return `${local.length === 16 ? `${local}:00` : local}${away < 0 ? "-" : "+"}${two(away / 60)}:${two(away % 60)}`;
}

/** Return an identifier made of a title, which no other has. @param {string} title @param {Set<string>} taken */
export function identifier(title, taken) {
  const plain = title.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-+|-+$/g, "").slice(0, 32) || "item";
  for (let k = 1; ; k += 1) {
    const id = k === 1 ? plain : `${plain.replace(/-+$/, "")}-${k}`;
    if (!taken.has(id)) return id;
  }
}

/** Return a mark after points, within what is possible. @param {number | null} before @param {number} change @param {number} total */
export function after(before, change, total) {
  return before === null ? null : Math.min(Math.max(Math.round((before + change) * 10) / 10, 0), total);
}

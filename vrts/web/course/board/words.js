// How the board says numbers and times.

/** @param {number} value */
export function points(value) {
  return (Math.round(value * 100) / 100).toString().replace("-", "−");
}

/** @param {number} count @param {string} one @param {string} many */
export function counted(count, one, many = `${one}s`) {
  return `${count} ${count === 1 ? one : many}`;
}

/** @param {number} at Unix time [s] @returns {string} day and time, as people of the page's language write it */
export function when(at) {
  return new Date(at * 1000).toLocaleString([], { weekday: "short", day: "numeric", month: "short", hour: "2-digit", minute: "2-digit" });
}

/** How long ago something was. @param {number} since Unix time [s] @param {number} now */
export function ago(since, now) {
  const minutes = Math.max(0, Math.round((now - since) / 60));
  if (minutes < 1) return "just now";
  if (minutes < 60) return `${minutes} min`;
  const hours = Math.floor(minutes / 60);
  return hours < 48 ? `${hours} h ${minutes % 60} min` : `${Math.floor(hours / 24)} days`;
}

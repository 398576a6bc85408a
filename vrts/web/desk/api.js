// What is asked of the desk's server. Every failure has a kind, so that the page can say what happened.

import { capital } from "./words.js";

/** Something was not done, and why. */
export class NotDone extends Error {
  /** @param {"offline" | "changed" | "refused" | "ended"} kind @param {string} words @param {string[]} details */
  constructor(kind, words, details = []) {
    super(words);
    this.kind = kind;
    this.details = details;
  }
}

/** @template T @param {string} path @returns {Promise<T>} */
export function get(path) {
  return ask(path, {});
}

/** @template T @param {string} path @param {unknown} body @returns {Promise<T>} */
export function post(path, body) {
  return ask(path, { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(body) });
}

/** @template T @param {string} path @returns {Promise<T>} */
export function cancel(path) {
  return ask(path, { method: "DELETE" });
}

/** @template T @param {string} path @param {RequestInit} options @returns {Promise<T>} */
async function ask(path, options) {
  /** @type {Response} */
  let answer;
  try {
    answer = await fetch(path, options);
  } catch {
    throw new NotDone("offline", "The desk does not answer: is `vrts grade desk` still running?");
  }
  const told = await answer.json().catch(() => null);
  if (answer.ok && told !== null) return told;
  const words = typeof told?.error === "string" ? capital(told.error) : `The desk answered ${answer.status}.`;
  if (answer.status === 409) throw new NotDone("changed", words);
  if (answer.status === 401) throw new NotDone("ended", "This page is no longer let in: open the address that `vrts grade desk` prints.");
  const details = (told?.diagnostics ?? []).map((/** @type {{headline?: string, help?: string}} */ one) =>
    [one.headline === told.error ? "" : capital(one.headline ?? ""), capital(one.help ?? "")].filter(Boolean).join(". "));
  throw new NotDone("refused", words, details.filter(Boolean));
}

/**
 * Listen to what the server says by itself.
 * @param {(revision: string | null) => void} onRevision @param {(marking: any) => void} onMarking @param {(open: boolean) => void} onLink
 */
export function listen(onRevision, onMarking, onLink) {
  const events = new EventSource("/api/events");
  events.addEventListener("revision", (event) => onRevision(parsed(event.data)?.revision ?? null));
  events.addEventListener("marking", (event) => onMarking(parsed(event.data)));
  events.addEventListener("open", () => onLink(true));
  events.addEventListener("error", () => onLink(false));
}

/** @param {string} text */
function parsed(text) {
  try {
    return JSON.parse(text);
  } catch {
    return null; // an event without data
  }
}

// Programs in memory with the line at work lit; upload; what was done, as a program.

import { COMMANDING, allow, whyNoCommand } from "../allowed.js";
import { byId, button, download, make, onSubmit, write } from "../dom.js";
import { settle } from "../focus.js";
import { isLive } from "../looking.js";
import { leadBack, ofNow } from "../past/shown.js";
import { LONGEST_PROGRAM } from "../protocol.js";

/** @param {import("../pages/room.js").App} app */
export function mountPrograms({ store, connection, command, act, toasts }) {
  const panel = byId("panel-programs");
  let chosen = "";
  const names = make("div", { class: "names", role: "group", "aria-label": "Programs in memory" });
  const none = make("p", { class: "soft", text: "No program is in memory. Upload one, or type EDIT at the monitor." });
  const fault = make("p", { class: "problem", role: "status" });
  const other = make("p", { class: "soft then" });
  const source = make("ol", { class: "source", "aria-label": "Lines of the program", tabindex: "0" });
  const type = (/** @type {string} */ line) => act({ type: "line", line });
  /** What goes on from what one sees: not from the past. @param {string} line */
  const begin = (line) => {
    const why = leadBack();
    if (why) toasts.warn(why);
    else type(line);
  };
  const run = button("Execute", () => begin(`EXECUTE ${chosen}`), { class: "main" });
  const stop = button("Abort", () => type("ABORT"));
  const proceed = button("Proceed", () => begin("PROCEED"));
  const keep = button("Download", () => {
    const program = store.now.programs.find(({ name }) => name === chosen);
    if (program) download(`${program.name}.v2`, `.PROGRAM ${program.name}\n${program.lines.join("\n")}\n.END\n`);
  });
  const file = make("input", { type: "file", id: "upload", accept: ".v2,.pg,.lc,.txt,.val,text/plain", change: upload });
  const name = make("input", { id: "save-name", maxlength: 64, value: "session", spellcheck: "false", autocapitalize: "off", required: true });
  const save = make("button", { text: "Save as program" });
  const saving = make("form", { class: "row" }, make("label", { text: "Name " }, name), save,
    button("Preview", preview, { id: "save-preview" }));
  const text = make("pre", { class: "preview", id: "preview", tabindex: "0", "aria-label": "What was done, as a program" });
  const fetched = button("Download", () => download(`${name.value}.v2`, text.textContent ?? ""));
  const shown = make("div", { hidden: true }, text, fetched);

  panel.append(
    make("div", { class: "names-head" }, names, ofNow()), none, fault, source, other,
    make("div", { class: "row" }, run, stop, proceed, keep),
    make("div", { class: "block" }, make("h2", { text: "Upload a file" }), make("label", { class: "unseen", for: "upload", text: "VAL-II file" }), file),
    make("div", { class: "block" }, make("h2", {}, "What was done, as a program ", ofNow()), saving, shown),
  );
  onSubmit(saving, () => {
    command({ type: "save", name: name.value.trim() })
      .then((done) => told(done.text, `saved as ${name.value.trim()}, in memory and in your folder`)).catch((error) => toasts.warn(error.message));
  });

  async function preview() {
    try {
      const program = await connection.ask("program", { name: name.value.trim() });
      text.textContent = program.text;
      shown.hidden = false;
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
  }

  async function upload() {
    const picked = file.files?.[0];
    if (!picked) return;
    try {
      if (picked.size > 4 * LONGEST_PROGRAM) throw new Error(`${picked.name} is too long for a program`);
      const content = await picked.text();
      if (content.length > LONGEST_PROGRAM) throw new Error(`${picked.name} is too long for a program`);
      if (/[\0\ufffd]/.test(content)) throw new Error(`${picked.name} is not a text file`);
      const done = await command({ type: "upload", name: picked.name.slice(0, 64), text: content });
      told(done.text, `${picked.name} is loaded`);
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
    file.value = "";
  }

  /** Show the program that has come, and say so. @param {string} said by the monitor @param {string} words */
  function told(said, words) {
    chosen = /^\.PROGRAM\s+([\w.]+)/m.exec(said)?.[1] ?? chosen;
    draw();
    toasts.tell(words);
  }

  /** @type {import("../protocol.js").Program | undefined} */
  let listed;
  store.on(["programs"], draw);
  function draw() {
    const { programs, status } = store.now;
    if (!programs.some((program) => program.name === chosen)) {
      chosen = status?.program || programs.find((program) => program.main)?.name || programs[0]?.name || "";
    }
    settle(names, programs.map((program) => button(program.name, () => { chosen = program.name; draw(); }, {
      "aria-pressed": String(program.name === chosen), class: program.fault ? "faulty" : "",
    })));
    const program = programs.find((one) => one.name === chosen);
    none.hidden = programs.length > 0;
    source.hidden = keep.hidden = !program;
    write(fault, program?.fault ?? "");
    fault.hidden = !program?.fault;
    if (program !== listed) source.replaceChildren(...(program?.lines ?? []).map((line) => make("li", {}, make("code", { text: line || " " }))));
    listed = program;
    light();
    may();
  }

  let running = "";
  store.on(["status"], may);
  store.on(["shown"], ({ shown }) => {
    if (shown && shown.program !== running) {
      running = shown.program;
      if (running && running !== chosen && store.now.programs.some((one) => one.name === running)) {
        chosen = running;
        draw();
      }
    }
    light();
  });
  store.on(COMMANDING, may);

  function light() {
    const { shown } = store.now;
    const own = shown && shown.program === chosen && shown.line ? shown : null;
    const line = own && source.children[own.line - 1];
    const same = own && (isLive() || plain(line?.textContent ?? "").includes(plain(own.text))); // it may be another program there
    write(other, own && !isLive() && !same ? `In the picture line ${own.line} of ${chosen} is: ${own.text}` : "");
    const next = same ? line : null;
    const before = source.querySelector(".lit");
    if (next === before) return;
    before?.classList.remove("lit");
    before?.removeAttribute("aria-current");
    if (!(next instanceof HTMLElement)) return;
    next.classList.add("lit");
    next.setAttribute("aria-current", "step");
    const above = next.offsetTop - source.offsetTop - source.scrollTop;
    if (above < 30 || above > source.clientHeight - 50) source.scrollTop = next.offsetTop - source.offsetTop - source.clientHeight / 2;
  }

  function may() {
    const why = whyNoCommand(store.now);
    const mode = store.now.status?.mode ?? "";
    const runs = ["running", "waiting"].includes(mode);
    allow(run, why || (runs ? "A program runs already." : chosen ? "" : "There is no program in memory yet."));
    allow(stop, why || (runs ? "" : "No program runs."));
    allow(proceed, why || (mode === "stopped" ? "" : "No program is stopped."));
    for (const one of [save, file]) allow(one, why);
  }
}

/** Return a line without what does not count. @param {string} line */
function plain(line) {
  return line.trim().replace(/\s+/g, " ").toUpperCase();
}

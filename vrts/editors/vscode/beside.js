// The arm beside the text: a panel with the viewer of the reports, bound to cursor and debugger.
//
// Without a debugger the panel shows what the language server's verification recorded; with one, the
// run that is debugged. Whoever moves (a click on a line, the time bar, a step) moves the others.

"use strict";

const vscode = require("vscode");
const crypto = require("node:crypto");
const fs = require("node:fs");
const path = require("node:path");
const { Moving } = require("./moving.js");

const LANGUAGE = "val2";
const SCENES = /(^|[\\/])(scene|task)\.toml$/; // files whose scene is shown while they are written

/** Whether the panel shows something of a document. @param {any} document */
function shows(document) {
  return document.languageId === LANGUAGE || SCENES.test(document.uri.fsPath);
}

const lit = { isWholeLine: true, backgroundColor: new vscode.ThemeColor("editor.rangeHighlightBackground"), overviewRulerColor: new vscode.ThemeColor("editorOverviewRuler.rangeHighlightForeground") };

/** One panel, about one program or scene at a time. */
class Beside {
  /**
   * @param {any} context of the extension
   * @param {(method: string, params: unknown) => Promise<any>} ask the language server
   */
  constructor(context, ask) {
    this.ask = ask;
    this.root = vscode.Uri.joinPath(context.extensionUri, "web");
    this.light = vscode.window.createTextEditorDecorationType(lit);
    /** @type {any} */ this.panel = undefined;
    /** @type {any} */ this.uri = undefined; // of what is shown
    /** @type {any} */ this.session = undefined; // that debugs it
    this.future = 0; // of the debugger that the panel holds; 0: a recording of the language server
    this.seeking = false;
    this.keeps = false; // the keys, at the next stop
    this.own = 0; // stops to be told of that are the panel's own wish
    /** @type {number | undefined} */ this.wanted = undefined; // time [s] to go to next
    /** @type {any[]} */ this.waiting = []; // messages, until the panel is ready
    this.ready = false;
    this.moving = new Moving(ask, (message) => this.post(message));
    context.subscriptions.push(
      this.light,
      vscode.window.onDidChangeTextEditorSelection((/** @type {any} */ event) => this.selected(event)),
      vscode.window.onDidChangeActiveTextEditor((/** @type {any} */ editor) => this.turnedTo(editor)),
      vscode.workspace.onDidChangeTextDocument((/** @type {any} */ event) => this.changed(event)),
      vscode.debug.onDidTerminateDebugSession((/** @type {any} */ session) => this.over(session)),
    );
  }

  /** Open the panel about a program. @param {any} uri */
  async show(uri) {
    this.uri = uri;
    if (this.panel) this.panel.reveal(undefined, true);
    else this.open();
    this.panel.title = `Arm: ${path.basename(uri.fsPath)}`;
    const session = vscode.debug.activeDebugSession;
    if (session && session.type === "vrts") await this.stopped(session);
    else await this.refresh();
  }

  open() {
    const options = { enableScripts: true, localResourceRoots: [this.root], retainContextWhenHidden: true };
    const place = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    this.panel = vscode.window.createWebviewPanel("vrts.arm", "Arm", place, options);
    this.panel.onDidDispose(() => this.closed());
    this.panel.onDidChangeViewState(() => this.keepKeys());
    this.panel.webview.onDidReceiveMessage((/** @type {any} */ message) => this.heard(message));
    this.panel.webview.html = page(this.panel.webview, this.root);
  }

  closed() {
    this.panel = undefined;
    this.ready = false;
    this.waiting = [];
    this.future = 0;
    this.unlight();
  }

  /** @param {any} message */
  post(message) {
    if (!this.panel) return;
    if (this.ready) void this.panel.webview.postMessage(message);
    else this.waiting.push(message);
  }

  /** A stop brings the text to the front, keys and all: after a scrub they stay with the time bar. */
  keepKeys() {
    if (!this.panel || this.panel.active || !this.keeps) return;
    this.keeps = false;
    this.panel.reveal(undefined, false);
  }

  /** What the panel says. @param {any} message */
  heard(message) {
    if (message.kind === "ready") {
      this.ready = true;
      for (const one of this.waiting.splice(0)) this.post(one);
    }
    if (message.kind === "leave") void this.leave();
    if (message.kind === "reach" && this.uri) void this.moving.reach(this.uri, message);
    if (message.kind === "move" && this.uri) void this.moved(message);
    if (message.kind === "other") void this.other(message.number);
    if (message.kind === "undo" || message.kind === "redo") void this.moving.again(message.kind, this.uri);
    if (message.kind !== "at") return;
    if (this.session) void this.seek(message.t);
    else this.lightUp(message.line);
  }

  /** A location was dragged: the text changes, and with it what is debugged. @param {any} message */
  async moved(message) {
    const document = await this.moving.move(this.uri, message);
    if (document && this.session) await this.takeUp(document);
  }

  /** Let the debugger go on with a text as it is now. @param {any} document */
  async takeUp(document) {
    try {
      await this.session.customRequest("vrts/edit", { path: document.uri.fsPath, text: document.getText() });
    } catch (problem) {
      this.post({ kind: "note", text: `The debugger goes on with the text before: ${told(problem)}`, old: true });
    }
  }

  /** Give the keys back to the text. */
  async leave() {
    const editor = this.editors()[0];
    if (editor) await vscode.window.showTextDocument(editor.document, { viewColumn: editor.viewColumn, preserveFocus: false });
    else await vscode.commands.executeCommand("workbench.action.focusActiveEditorGroup");
  }

  // --- without a debugger ---

  /** Show the newest recording of the language server. */
  async refresh() {
    if (!this.panel || !this.uri || this.session) return;
    const uri = this.uri;
    const found = await this.ask("vrts/recording", { uri: uri.toString() });
    if (!this.panel || this.session || String(uri) !== String(this.uri)) return;
    if (!found) this.post({ kind: "note", text: waitingFor(uri), old: true });
    else if (found.still) this.post({ kind: "recording", recording: found.recording, still: true, text: found.text, old: found.old });
    else this.post({ kind: "recording", recording: found.recording, text: "Click a line, and the arm stands there." });
    this.future = 0;
  }

  /** The text is another one: what is shown is of the text before. @param {any} event */
  changed({ document, reason }) {
    if (!this.panel) return;
    if (this.session && reason && String(document.uri) === String(this.moving.last)) void this.takeUp(document); // a drag undone
    if (this.session || String(document.uri) !== String(this.uri)) return;
    if (shows(document)) this.post({ kind: "note", text: waitingFor(this.uri), old: true });
  }

  /** @param {any} event of a selection */
  selected(event) {
    const document = event.textEditor.document;
    if (!this.panel || document.languageId !== LANGUAGE || String(document.uri) !== String(this.uri)) return;
    const mouse = event.kind === vscode.TextEditorSelectionChangeKind.Mouse;
    const keys = event.kind === vscode.TextEditorSelectionChangeKind.Keyboard;
    if (mouse) this.keeps = false; // the reader went there
    if (!mouse && !(keys && !this.session)) return;
    const line = event.selections[0].active.line + 1;
    this.post({ kind: "line", line });
    if (!this.session) this.lightUp(line, false);
  }

  /** Follow the reader to another program. @param {any} editor */
  turnedTo(editor) {
    if (!this.panel || this.session || !editor || !shows(editor.document)) return;
    if (String(editor.document.uri) === String(this.uri)) return;
    this.unlight();
    void this.show(editor.document.uri);
  }

  /** Mark the line at work. @param {number} line @param {boolean} reveal */
  lightUp(line, reveal = true) {
    for (const editor of this.editors()) {
      if (!line || line > editor.document.lineCount) editor.setDecorations(this.light, []);
      else {
        const range = editor.document.lineAt(line - 1).range;
        editor.setDecorations(this.light, [range]);
        if (reveal) editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
      }
    }
  }

  unlight() {
    for (const editor of vscode.window.visibleTextEditors) editor.setDecorations(this.light, []);
  }

  editors() {
    return vscode.window.visibleTextEditors.filter((/** @type {any} */ editor) => String(editor.document.uri) === String(this.uri));
  }

  // --- with a debugger ---

  /** The debugger stands still: so does the arm. @param {any} session */
  async stopped(session) {
    this.session = session;
    if (!this.panel) return;
    this.unlight();
    try {
      const where = await this.where(session);
      this.post({ kind: "time", t: where.time, text: `The debugger stands at ${where.time.toFixed(3)} s${where.line ? `, line ${where.line}` : ""}.` });
    } catch (problem) {
      if (told(problem) === "cancelled") return; // it went on meanwhile: the next stop shows more
      this.post({ kind: "note", text: `The debugger does not say where it stands: ${told(problem)}`, old: true });
    }
  }

  /** Return where the debugger stands, after the panel holds its run. @param {any} session */
  async where(session) {
    const about = { path: this.uri && this.uri.fsPath };
    const where = await session.customRequest("vrts.where", about);
    if (where.future !== this.future) {
      const found = await session.customRequest("vrts.recording", about);
      this.future = found.future;
      this.post({ kind: "recording", recording: found.recording, t: where.time });
      const { branches } = await session.customRequest("vrts/branches");
      this.post({ kind: "futures", rows: branches });
    }
    return where;
  }

  /** Show another future beside the present one. @param {number} number 0: none */
  async other(number) {
    const session = this.session;
    if (!session || !number) return;
    try {
      const other = await session.customRequest("vrts.other", { number });
      this.post({ kind: "other", other });
      const { branches } = await session.customRequest("vrts/branches");
      const present = branches.find((/** @type {any} */ one) => one.current);
      const { rows } = await session.customRequest("vrts/compare", { one: String(present.number), other: String(number) });
      this.post({ kind: "compared", rows });
    } catch (problem) {
      this.post({ kind: "note", text: `The other future is not shown: ${told(problem)}`, old: true });
    }
  }

  /** Go to a time; what is wanted meanwhile comes next, and only the newest. @param {number} t [s] */
  async seek(t) {
    this.wanted = t;
    if (this.seeking) return;
    this.seeking = true;
    try {
      while (this.wanted !== undefined && this.session) {
        const next = this.wanted;
        this.wanted = undefined;
        this.own += 1;
        this.keeps = true;
        const found = await this.session.customRequest("vrts.seek", { time: next }).then(undefined, (/** @type {any} */ problem) => {
          this.own -= 1;
          throw problem;
        });
        this.post({ kind: "note", text: `The debugger stands at ${found.time.toFixed(3)} s.` });
      }
    } catch (problem) {
      this.post({ kind: "note", text: `The debugger does not go there: ${told(problem)}`, old: true });
    } finally {
      this.wanted = undefined;
      this.seeking = false;
    }
  }

  /** @param {any} session that is over */
  over(session) {
    if (this.session !== session) return;
    this.session = undefined;
    this.future = this.own = 0;
    this.post({ kind: "futures", rows: [] });
    void this.refresh();
  }

  /** Return who listens to a debugger. @param {any} session */
  listener(session) {
    return (/** @type {any} */ message) => {
      if (message.type !== "event") return;
      if (message.event === "stopped" && this.own > 0) this.own -= 1;
      else if (message.event === "stopped" || message.event === "invalidated") setTimeout(() => void this.stopped(session), 0);
    };
  }
}

/** @param {any} uri */
function waitingFor(uri) {
  if (SCENES.test(uri.fsPath)) return "The file is being read …";
  const errors = vscode.languages.getDiagnostics(uri).some((/** @type {any} */ one) => one.severity === vscode.DiagnosticSeverity.Error && one.source === "vrts");
  return errors ? "The program has errors: the picture is of the text before." : "The program is being verified …";
}

/** @param {any} problem */
function told(problem) {
  return problem && problem.message ? problem.message : String(problem);
}

/** Return the page of the panel; it may load what lies in one folder of the extension, and nothing else. @param {any} webview @param {any} root */
function page(webview, root) {
  const read = (/** @type {string[]} */ ...names) => fs.readFileSync(vscode.Uri.joinPath(root, ...names).fsPath, "utf8");
  /** @type {Record<string, string>} */
  const filled = {
    nonce: crypto.randomBytes(16).toString("base64"),
    source: webview.cspSource,
    root: String(webview.asWebviewUri(root)),
    stage: read("report", "replay.html"),
  };
  return read("beside", "page.html").replace(/\{(nonce|source|root|stage)\}/g, (_, name) => filled[name]);
}

module.exports = { Beside, shows };

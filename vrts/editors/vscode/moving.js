// Locations dragged beside the text: the server says whether the arm gets there, and the text changes.

"use strict";

const vscode = require("vscode");

const TRIES = 3; // the text may change while the server thinks

/** Between the panel, the language server and the text. */
class Moving {
  /**
   * @param {(method: string, params: unknown) => Promise<any>} ask the language server
   * @param {(message: any) => void} post to the panel
   */
  constructor(ask, post) {
    this.ask = ask;
    this.post = post;
    /** @type {any} */ this.last = undefined; // address of the text that was changed last
  }

  /** Say whether the arm reaches a location at another place. @param {any} uri of the program @param {any} message */
  async reach(uri, message) {
    const { name, at } = message;
    let found = undefined;
    try {
      found = await this.ask("vrts/reach", question(uri, message));
    } catch (problem) {
      found = { reached: null, text: told(problem) };
    }
    this.post({ kind: "reach", name, at, reached: found ? found.reached : null, text: found ? found.text : "vrts does not answer" });
  }

  /**
   * Write a location's new numbers into the text, as one edit; return the document, or nothing.
   * @param {any} uri of the program @param {any} message
   */
  async move(uri, message) {
    const { name } = message;
    try {
      const { document, numbers, line } = await this.write(uri, message);
      const [x, y, z] = numbers;
      const where = String(document.uri) === String(uri) ? `line ${line}` : `${vscode.workspace.asRelativePath(document.uri)}, line ${line}`;
      this.post({ kind: "moved", name, text: `${where}: ${name} at X ${x}  Y ${y}  Z ${z}. Ctrl+Z takes it back.` });
      return document;
    } catch (problem) {
      this.post({ kind: "moved", name, why: told(problem) });
      return undefined;
    }
  }

  /** @param {any} uri @param {any} message */
  async write(uri, message) {
    for (let k = 0; k < TRIES; k++) {
      const found = await this.ask("vrts/moved", question(uri, message));
      if (!found) throw new Error("vrts does not answer");
      if (found.why !== undefined) throw new Error(found.why);
      const document = await vscode.workspace.openTextDocument(vscode.Uri.parse(found.uri));
      if (found.version != null && found.version !== document.version) continue;
      if (!found.edits.length) return { document, ...found };
      const edit = new vscode.WorkspaceEdit();
      for (const { range, newText } of found.edits) {
        const { start, end } = range;
        edit.replace(document.uri, new vscode.Range(start.line, start.character, end.line, end.character), newText);
      }
      if (!(await vscode.workspace.applyEdit(edit))) throw new Error("the editor does not change this file");
      this.last = document.uri;
      return { document, ...found };
    }
    throw new Error("the text changed meanwhile");
  }

  /** Take back, or do again, what was done last to the text. @param {"undo" | "redo"} command @param {any} uri of the program */
  async again(command, uri) {
    const wanted = this.last || uri;
    if (!wanted) return;
    const document = await vscode.workspace.openTextDocument(wanted);
    const seen = vscode.window.visibleTextEditors.find((/** @type {any} */ one) => String(one.document.uri) === String(wanted));
    await vscode.window.showTextDocument(document, { viewColumn: seen ? seen.viewColumn : vscode.ViewColumn.One, preserveFocus: false });
    await vscode.commands.executeCommand(command);
  }
}

/** @param {any} uri @param {any} message */
function question(uri, { of, subscripts, file, at }) {
  return { uri: uri.toString(), name: of, subscripts, file, at };
}

/** @param {any} problem */
function told(problem) {
  return problem && problem.message ? problem.message : String(problem);
}

module.exports = { Moving };

// The part of CodeMirror that the editor uses, for the type checker: `python -m tests browser-types`.
// Written by hand after the reference manual of CodeMirror 6; all its modules in one.

export type Extension = unknown;

export class Line {
  from: number;
  to: number;
  number: number;
  text: string;
}

export class Text {
  length: number;
  lines: number;
  line(number: number): Line;
  lineAt(at: number): Line;
  eq(other: Text): boolean;
  toString(): string;
}

export class ChangeSet {
  mapPos(at: number, side?: number): number;
  compose(after: ChangeSet): ChangeSet;
  invertedDesc: { mapPos(at: number, side?: number): number };
  iterChanges(told: (from: number, to: number, fromNow: number, toNow: number, inserted: Text) => void): void;
}

export class StateEffect<Value> {
  value: Value;
  is<Other>(type: EffectType<Other>): this is StateEffect<Other>;
  static define<Value = any>(spec?: { map?: (value: Value, changes: ChangeSet) => Value }): EffectType<Value>;
}
interface EffectType<Value> {
  of(value: Value): StateEffect<Value>;
}

export interface Transaction {
  changes: ChangeSet;
  docChanged: boolean;
  startState: EditorState;
  newDoc: Text;
  effects: StateEffect<any>[];
}

export class StateField<Value> {
  static define<Value = any>(spec: {
    create: () => Value;
    update: (value: Value, change: Transaction) => Value;
    provide?: (field: StateField<Value>) => Extension;
  }): StateField<Value>;
}

interface Range {}

interface Facet<Value> {
  of(value: Value): Extension;
  from(field: StateField<any>): Extension;
  compute(of: StateField<any>[], made: (state: EditorState) => Value): Extension;
}

interface Selection {
  head: number;
  from: number;
  to: number;
  empty: boolean;
}

export class EditorState {
  doc: Text;
  selection: { main: Selection };
  static create(spec: { doc: string; extensions: Extension }): EditorState;
  static allowMultipleSelections: Facet<boolean>;
  field<Value>(field: StateField<Value>, required?: boolean): Value;
  facet<Value>(facet: Facet<Value>): Value[];
  update(...specs: object[]): Transaction;
  replaceSelection(text: string): object;
}

export const Prec: { high(extension: Extension): Extension };

type InputHandler = (view: EditorView, from: number, to: number, text: string, insert: () => Transaction) => boolean;

export class EditorView {
  constructor(config: { state: EditorState; parent: ShadowRoot; root: ShadowRoot });
  state: EditorState;
  composing: boolean;
  hasFocus: boolean;
  dispatch(spec: object): void;
  focus(): void;
  static theme(spec: Record<string, object>): Extension;
  static decorations: Facet<Decoration>;
  static contentAttributes: Facet<Record<string, string>>;
  static inputHandler: Facet<InputHandler>;
  static updateListener: Facet<(update: any) => void>;
  static domEventHandlers(handlers: { beforeinput: (event: InputEvent, view: EditorView) => boolean }): Extension;
  static announce: EffectType<string>;
  static scrollIntoView(at: number, options: { y: string; yMargin: number }): StateEffect<any>;
}

export class Decoration {
  static none: Decoration;
  static line(spec: { class: string; attributes: Record<string, string> }): Decoration;
  static widget(spec: { widget: WidgetType; side: number }): Decoration;
  static set(ranges: Range[], sort?: boolean): Decoration;
  range(from: number): Range;
  map(changes: ChangeSet): Decoration;
}

export class WidgetType {
  toDOM(): HTMLElement;
  eq(other: WidgetType): boolean;
}

export class GutterMarker {
  eq(other: GutterMarker): boolean;
  toDOM(): HTMLElement;
}

export function gutter(config: {
  class: string;
  renderEmptyElements: boolean;
  lineMarker: (view: EditorView, line: { from: number }) => GutterMarker | null;
  lineMarkerChange: (update: { startState: EditorState; state: EditorState }) => boolean;
  domEventHandlers: Record<string, (view: EditorView, line: { from: number }, event: any) => boolean>;
}): Extension;

export const ViewPlugin: { fromClass(plugin: new (view: EditorView) => object): Extension };
export const keymap: Facet<object[]>;
export const showTooltip: Facet<object | null>;
export const closeHoverTooltips: StateEffect<null>;
export function activateHover(view: EditorView, at: number, side: number, options: { until: (update: any) => boolean }): void;
export function drawSelection(): Extension;
export function highlightActiveLine(): Extension;
export function highlightActiveLineGutter(): Extension;
export function highlightSpecialChars(): Extension;
export function hoverTooltip(source: (view: EditorView, at: number) => Promise<object | null>, options: object): Extension;
export function lineNumbers(): Extension;

export type Command = (view: EditorView) => boolean;
export const acceptCompletion: Command;
export const closeBracketsKeymap: object[];
export const completionKeymap: object[];
export function autocompletion(config: object): Extension;
export function closeBrackets(): Extension;

export const defaultKeymap: object[];
export const historyKeymap: object[];
export const indentLess: Command;
export const insertTab: Command;
export function history(): Extension;

export const indentUnit: Facet<string>;
export const HighlightStyle: { define(looks: object[]): object };
export const StreamLanguage: { define(parser: object): Extension };
export function bracketMatching(): Extension;
export function syntaxHighlighting(style: object): Extension;
export const Tag: { define(): object };

interface Found {
  actions?: readonly { name: string; apply: (view: EditorView, from: number, to: number) => void }[];
}
export const lintKeymap: object[];
export const openLintPanel: Command;
export function forEachDiagnostic(state: EditorState, told: (found: Found, from: number, to: number) => void): void;
export function lintGutter(): Extension;
export function setDiagnostics(state: EditorState, found: readonly object[]): object;

export const searchKeymap: object[];
export function highlightSelectionMatches(): Extension;

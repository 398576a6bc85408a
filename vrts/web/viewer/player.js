// A clock for a replay: plays forward and backward at any speed, and can be set to any time.

/** Drives a callback with the time to show. */
export class Player {
  /**
   * @param {number} end last time [s]
   * @param {(t: number, player: Player) => void} show called whenever the time or the state changes
   */
  constructor(end, show) {
    this.end = end;
    this.show = show;
    this.t = 0;
    this.speed = 1; // simulated seconds per second
    this.direction = 1; // or -1
    this.playing = false;
    /** @type {number | null} */
    this.before = null;
  }

  /** @param {number} t [s]; kept within the run */
  seek(t) {
    this.t = Math.min(Math.max(t, 0), this.end);
    this.show(this.t, this);
  }

  /** @param {number} direction 1 or -1; from the far end it starts over */
  play(direction) {
    this.direction = direction;
    if (direction > 0 && this.t >= this.end) this.t = 0;
    if (direction < 0 && this.t <= 0) this.t = this.end;
    if (!this.playing) {
      this.playing = true;
      this.before = null;
      requestAnimationFrame((now) => this.tick(now));
    }
    this.show(this.t, this);
  }

  /** Stand still at the present time. */
  pause() {
    this.playing = false;
    this.show(this.t, this);
  }

  /** @param {number} direction 1 or -1 */
  toggle(direction) {
    if (this.playing && this.direction === direction) this.pause();
    else this.play(direction);
  }

  /** @param {number} now of the browser's clock [ms] */
  tick(now) {
    if (!this.playing) return;
    const passed = this.before === null ? 0 : (now - this.before) / 1000;
    this.before = now;
    this.t = Math.min(Math.max(this.t + this.direction * this.speed * passed, 0), this.end);
    if (this.direction > 0 ? this.t >= this.end : this.t <= 0) this.playing = false;
    this.show(this.t, this);
    if (this.playing) requestAnimationFrame((later) => this.tick(later));
  }
}

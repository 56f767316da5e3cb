// The program in its worker: requests with answers, and channels on which only the latest request counts.

/**
 * Work on one request, in milliseconds, after which the page shows that it waits, and which is ended if nothing needs it any more.
 * A start of the program takes as long.
 */
const LONG = 400;

/** The error of a request that was ended because its room was left. */
export class Left extends Error {}

/**
 * @typedef {{ value: any, buffers: Uint8Array[], milliseconds: number }} Answer
 * @typedef {{ resolve: (answer: Answer) => void, reject: (error: Error) => void }} Waiting
 */

export class Program {
  constructor() {
    /** @type {Map<number, Waiting>} */
    this.waiting = new Map();
    /** @type {Map<string, { busy: boolean, next: (() => void) | null, drop: (() => void) | null }>} */
    this.channels = new Map();
    this.count = 0;
    /** When the worker began with its present request. */
    this.since = 0;
    this.timer = 0;
    /** Called when requests begin and end to take long. @type {(isWaiting: boolean) => void} */
    this.onwaiting = () => {};
    /** Called after a restart: the program no longer has the user's file. */
    this.onrestart = () => {};
    /** Whether the program has ever answered: one that cannot start is not started over and over. */
    this.works = false;
    this.start();
  }

  start() {
    const source = document.getElementById('worker')?.textContent ?? '';
    const address = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
    this.worker = new Worker(address);
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = (event) => this.fail(event.message);
    this.worker.postMessage({ program: document.getElementById('program')?.textContent });
  }

  /** @param {any} data */
  receive(data) {
    if (data.failed) {
      this.fail(data.failed);
      return;
    }
    this.works = true;
    const waiting = this.waiting.get(data.id);
    this.waiting.delete(data.id);
    this.watch();
    const value = JSON.parse(data.answer);
    if (value && value.error !== undefined) waiting?.reject(new Error(value.error));
    else waiting?.resolve({ value, buffers: data.buffers, milliseconds: data.milliseconds });
  }

  /** @param {string} message */
  fail(message) {
    const works = this.works;
    this.works = false;
    this.restart(works, new Error(`the program stopped: ${message}`));
  }

  /** Ends the work on a long request, and drops those behind it: what asked for them is no longer shown. */
  leave() {
    if (!this.works || !this.waiting.size || performance.now() - this.since < LONG) return;
    for (const channel of this.channels.values()) {
      channel.drop?.();
      channel.next = channel.drop = null;
    }
    this.restart(true, new Left());
  }

  /** @param {boolean} starts @param {Error} error that of the requests which wait */
  restart(starts, error) {
    this.worker?.terminate();
    const all = [...this.waiting.values()];
    this.waiting.clear();
    this.watch();
    if (starts) {
      this.start();
      this.onrestart();
    }
    all.forEach(({ reject }) => reject(error));
  }

  /** Begins to wait for the first of the requests, if there are any. */
  watch() {
    clearTimeout(this.timer);
    this.since = performance.now();
    if (this.waiting.size) this.timer = window.setTimeout(() => this.onwaiting(true), LONG);
    else this.onwaiting(false);
  }

  /**
   * Asks the program; errors are those of the library, in words.
   * @param {object} request
   * @param {Uint8Array} [bytes]
   * @returns {Promise<Answer>}
   */
  ask(request, bytes) {
    const id = ++this.count;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      if (this.waiting.size === 1) this.watch();
      this.worker?.postMessage({ id, request: JSON.stringify(request), bytes });
    });
  }

  /**
   * As `ask`, but of several requests on a channel that wait, only the latest is sent; the others give `null`, as one that was left does.
   * @param {string} name
   * @param {object} request
   * @returns {Promise<Answer | null>}
   */
  latest(name, request) {
    const channel = this.channels.get(name) ?? { busy: false, next: null, drop: null };
    this.channels.set(name, channel);
    return new Promise((resolve, reject) => {
      const send = () => {
        channel.busy = true;
        this.ask(request).then(resolve, (error) => (error instanceof Left ? resolve(null) : reject(error))).finally(() => {
          channel.busy = false;
          const next = channel.next;
          channel.next = channel.drop = null;
          next?.();
        });
      };
      if (!channel.busy) {
        send();
        return;
      }
      channel.drop?.();
      channel.next = send;
      channel.drop = () => resolve(null);
    });
  }
}

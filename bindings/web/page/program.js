// The program in its worker: requests with answers, and channels on which only the latest request counts.

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
    const value = JSON.parse(data.answer);
    if (value && value.error !== undefined) waiting?.reject(new Error(value.error));
    else waiting?.resolve({ value, buffers: data.buffers, milliseconds: data.milliseconds });
  }

  /** @param {string} message */
  fail(message) {
    this.worker?.terminate();
    const all = [...this.waiting.values()];
    this.waiting.clear();
    if (this.works) {
      this.works = false;
      this.start();
      this.onrestart();
    }
    all.forEach(({ reject }) => reject(new Error(`the program stopped: ${message}`)));
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
      this.worker?.postMessage({ id, request: JSON.stringify(request), bytes });
    });
  }

  /**
   * As `ask`, but of several requests on a channel that wait, only the latest is sent; the others give `null`.
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
        this.ask(request).then(resolve, reject).finally(() => {
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

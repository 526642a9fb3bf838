// The saved data: the same files that carrom keeps in a folder on other systems, here under their
// paths in a database of the browser. Everything is read and written in transactions with a number
// that counts the changes, so two tabs never overwrite each other: a tab that finds a number other
// than its own reads the other tab's files first.

const keeper = (() => {
  // The number of changes that the program knows of; unknown before it has received the files.
  const UNKNOWN = -1;
  let base = null;
  let known = UNKNOWN;
  let busy = false, safe = 0;
  let opened = connect();

  // Opens the browser's database; there is none if the browser saves no data for this page.
  function connect() {
    return new Promise((resolve) => {
      let opening;
      try {
        opening = indexedDB.open("carrom", 1);
      } catch {
        return resolve();
      }
      opening.onupgradeneeded = () => opening.result.createObjectStore("files");
      opening.onsuccess = () => {
        const found = opening.result;
        base = found;
        // The browser closes the database if the user clears site data, or if the disk fails.
        found.onclose = () => base === found && (base = null);
        resolve();
      };
      opening.onerror = opening.onblocked = () => resolve();
      setTimeout(resolve, 3000);
    });
  }

  // Reads everything in a transaction and passes it on: [path, bytes] pairs and the number.
  function read(transaction, then) {
    const files = transaction.objectStore("files");
    const paths = files.getAllKeys();
    const contents = files.getAll();
    contents.onsuccess = () => {
      let number = 0;
      const all = [];
      paths.result.forEach((path, i) => {
        if (path === "") number = contents.result[i];
        else all.push([path, contents.result[i]]);
      });
      then(all, number);
    };
  }

  // The files in one buffer, and their lengths.
  function packed(all) {
    const files = all.map(([path, bytes]) => ({ path, bytes: bytes.length }));
    const bytes = new Uint8Array(all.reduce((sum, [, bytes]) => sum + bytes.length, 0));
    let at = 0;
    for (const [, content] of all) {
      bytes.set(content, at);
      at += content.length;
    }
    return { files, bytes };
  }

  // Returns the files once any save in progress has ended.
  async function files() {
    await opened;
    while (busy) await new Promise((later) => setTimeout(later, 10));
    // If the files cannot be read now, the next change is added to them and does not replace them.
    known = UNKNOWN;
    try {
      const transaction = base.transaction("files", "readonly");
      return await new Promise((resolve, reject) => {
        transaction.onabort = reject;
        read(transaction, (all, number) => {
          known = number;
          resolve(all);
        });
      });
    } catch {
      return [];
    }
  }

  // Whether another tab has saved something since this tab last read or wrote.
  async function isBehind() {
    try {
      if (busy) return false;
      const number = base.transaction("files", "readonly").objectStore("files").get("");
      await new Promise((resolve, reject) => {
        number.onsuccess = resolve;
        number.onerror = reject;
      });
      return !busy && (number.result || 0) !== known;
    } catch {
      return false;
    }
  }

  // Saves the changes in the browser's database; calls `slow` if this takes a long time, and `done`
  // at the end, with the reason if it failed. The program decides when to try again.
  async function keep(done, slow = () => {}) {
    if (busy) return;
    busy = true;
    const patience = setTimeout(slow, 500);
    let failed = null;
    try {
      await opened;
      if (!base) await (opened = connect());
      if (!base) throw "this browser does not save data for this page";
      await write();
      known += 1;
      safe += 1;
    } catch (error) {
      failed = reason(error);
      // Stays busy until the browser's next task, or the program would repeat its request at once.
      await new Promise((later) => setTimeout(later, 0));
    }
    clearTimeout(patience);
    busy = false;
    done(failed);
  }

  // One transaction for all changes; an error aborts it, and none of them is saved.
  function write() {
    return new Promise((resolve, reject) => {
      const transaction = base.transaction("files", "readwrite", { durability: "strict" });
      let fault = null;
      transaction.oncomplete = resolve;
      transaction.onabort = () => reject(fault || transaction.error);
      const guarded = (step) => {
        try {
          step();
        } catch (error) {
          fault = error;
          transaction.abort();
        }
      };
      const number = transaction.objectStore("files").get("");
      number.onsuccess = () => guarded(() => {
        if ((number.result || 0) === known) return put(transaction);
        read(transaction, (all, other) => guarded(() => {
          const { files, bytes } = packed(all);
          program.call({ do: "files", files }, bytes);
          known = other;
          put(transaction);
        }));
      });
    });
  }

  function put(transaction) {
    const files = transaction.objectStore("files");
    const changed = program.call({ do: "changed" });
    if (changed.fault) throw changed.fault;
    let at = 0;
    for (const { path, bytes } of changed.files) {
      files.put(changed.bytes.slice(at, at + bytes), path);
      at += bytes;
    }
    for (const path of changed.gone) files.delete(path);
    files.put(known + 1, "");
  }

  // The reason why saving failed, in words; an error that is a string is returned unchanged.
  function reason(error) {
    if (typeof error === "string") return error;
    const name = error?.name;
    // The browser has closed the database without an event.
    if (name === "InvalidStateError") base = null;
    if (name === "QuotaExceededError") return "the browser's storage is full";
    return `the browser cannot save it (${name || "no reason given"})`;
  }

  return { opened, files, isBehind, keep, packed, kept: () => safe };
})();

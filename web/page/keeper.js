// What is kept: files by their paths in a database of the browser's, as a carrom with a
// folder has them. All is read and written in transactions with a number that counts the
// changes, so two tabs never overwrite each other: who finds another number than its own
// takes the other's files in first.

const keeper = (() => {
  let base = null;
  let known = 0;
  let busy = false, safe = 0;

  const opened = new Promise((resolve) => {
    let opening;
    try {
      opening = indexedDB.open("carrom", 1);
    } catch {
      return resolve(null);
    }
    opening.onupgradeneeded = () => opening.result.createObjectStore("files");
    opening.onsuccess = () => resolve(opening.result);
    opening.onerror = opening.onblocked = () => resolve(null);
    setTimeout(() => resolve(null), 3000);
  });

  // Reads everything in a transaction, then goes on with it: [path, bytes] and the number.
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

  // The files there are, all behind each other, with their lengths.
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

  // The files there are, once all that is being kept is.
  async function files() {
    base = await opened;
    while (busy) await new Promise((later) => setTimeout(later, 10));
    if (!base) return [];
    return new Promise((resolve) => {
      try {
        const transaction = base.transaction("files", "readonly");
        transaction.onabort = transaction.onerror = () => resolve([]);
        read(transaction, (all, number) => {
          known = number;
          resolve(all);
        });
      } catch {
        base = null;
        resolve([]);
      }
    });
  }

  // Brings what has changed into the browser's database; calls `slow` if that takes long, and
  // `done` with the reason if it could not be kept. When it is tried again is the program's.
  function keep(done, slow = () => {}) {
    if (busy) return;
    busy = true;
    const patience = setTimeout(slow, 500);
    const end = (failed) => {
      clearTimeout(patience);
      busy = false;
      done(failed);
    };
    // Never before this is left: who is told at once would ask for the same again.
    const refuse = (failed) => void setTimeout(end, 0, failed);
    if (!base) return refuse("this browser keeps nothing for this page");
    let transaction;
    try {
      transaction = base.transaction("files", "readwrite", { durability: "strict" });
    } catch (error) {
      return refuse(reason(error));
    }
    let ended = false;
    const once = (failed) => ended || ((ended = true), end(failed));
    transaction.oncomplete = () => {
      known += 1;
      safe += 1;
      once(null);
    };
    let fault = null;
    transaction.onabort = () => once(fault || reason(transaction.error));
    // What goes wrong in here ends the transaction, and nothing of it is kept.
    const guarded = (step) => {
      try {
        step();
      } catch (error) {
        fault = error instanceof DOMException ? reason(error) : error.message;
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
  }

  function put(transaction) {
    const files = transaction.objectStore("files");
    const changed = program.call({ do: "changed" });
    if (changed.fault) throw new Error(changed.fault);
    let at = 0;
    for (const { path, bytes } of changed.files) {
      files.put(changed.bytes.slice(at, at + bytes), path);
      at += bytes;
    }
    for (const path of changed.gone) files.delete(path);
    files.put(known + 1, "");
  }

  function reason(error) {
    if (error && error.name === "QuotaExceededError") return "this browser has no more room for it";
    return `this browser does not keep it (${(error && error.name) || "no reason given"})`;
  }

  return { opened, files, keep, packed, kept: () => safe };
})();

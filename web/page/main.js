// The page: opens carrom, passes it the time while something moves, and carries out its requests.

const page = (() => {
  const body = document.body;
  const words = document.getElementById("words");
  const game = document.getElementById("game");
  const menu = document.getElementById("menu");
  const chooser = document.getElementById("file");
  const typing = document.getElementById("typing");
  let colours = "", drawn = 0, ready = false, lived = 0, frame = 0, timer = 0, outdated = true, isPlain = false, failedOnce = false;

  // The largest size of an opened file in bytes. A progress.db has about 200 bytes per answer.
  const LARGEST = 64 * 2 ** 20;

  // The preferences of the player's system.
  const LIGHT = matchMedia("(prefers-color-scheme: light)");
  const STILL = matchMedia("(prefers-reduced-motion: reduce)");

  // For tests: the time of the first frame, the number of frames, and how many times the page woke.
  const seen = { first: 0, frames: 0, wakes: 0 };

  async function start() {
    if (!isAble()) return tooOld();
    try {
      await Promise.all([keeper.opened, program.load()]);
      await open();
    } catch (error) {
      return fail(error);
    }
    ready = true;
    const warning = platform.warning();
    if (warning) tell(warning);
    input.start(speak);
    panels.start({ copy });
    classroom.start(speak);
    addEventListener("resize", fit);
    (self.visualViewport || self).addEventListener("resize", fit);
    address.start({ back, reopen });
    addEventListener("dragover", (event) => event.preventDefault());
    addEventListener("drop", (event) => {
      event.preventDefault();
      for (const file of event.dataTransfer.files) take(file);
    });
    chooser.addEventListener("change", () => {
      for (const file of chooser.files) take(file);
      chooser.value = "";
    });
    menu.addEventListener("click", chosen);
    for (const query of [LIGHT, STILL]) {
      query.addEventListener("change", () => speak({ do: "prefer", light: LIGHT.matches, still: STILL.matches }));
    }
    addEventListener("focus", async () => {
      isBehind ||= await keeper.isBehind();
      catchUp();
    });
    // Data that could not be saved is lost with the page.
    addEventListener("beforeunload", (event) => {
      if (!last.unsaved) return;
      event.preventDefault();
      event.returnValue = true;
    });
  }

  // Whether this browser has everything that carrom needs.
  function isAble() {
    // A module with one function that uses vector instructions.
    const simd = new Uint8Array([
      0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253,
      15, 253, 98, 11,
    ]);
    return self.WebAssembly && WebAssembly.validate(simd) && self.DecompressionStream;
  }

  const reopen = () => open().catch(fail);

  // Called when the browser goes back in its history.
  function back() {
    if (menu.open) menu.close();
    else if (isPlain) speak({ do: "line", text: "back" });
    else input.back();
  }

  async function open() {
    const kept = await keeper.files();
    const own = kept.filter(([path]) => path.startsWith("own/") || path === "settings.toml");
    const given = JSON.parse(document.getElementById("own").textContent);
    const encoder = new TextEncoder();
    for (const [path, text] of platform.start(given)) own.push([path, encoder.encode(text)]);
    const packed = keeper.packed(own);
    measure();
    const reply = program.call({
      do: "open", fragment: classroom.fragment(), ...room(), own: packed.files,
      seed: crypto.getRandomValues(new Uint32Array(1))[0] % 1000000,
      light: LIGHT.matches, still: STILL.matches,
    }, packed.bytes);
    const all = keeper.packed(kept);
    program.tellTime();
    program.call({ do: "files", files: all.files }, all.bytes);
    say("");
    isPlain = /(^|[#&])plain/.test(location.hash);
    game.hidden = isPlain;
    document.getElementById("plain").hidden = !isPlain;
    body.style.overflow = isPlain ? "auto" : "";
    body.classList.toggle("plain", isPlain);
    outdated = true;
    if (isPlain) plain.begin(speak);
    heed(reply);
    if (isPlain) return schedule();
    draw();
    // Measures again, because the head and the foot now have their heights.
    fit();
  }

  // An on-screen keyboard leaves less room than the window's size suggests.
  function measure() {
    const height = self.visualViewport && Math.round(visualViewport.height * visualViewport.scale);
    game.style.height = height && height < innerHeight - 1 ? `${height}px` : "";
  }

  // The number of cells, and the size of pictures in cells.
  const room = () => painter.fit(innerWidth, innerHeight - foot());

  // The height of the page's head and foot.
  function foot() {
    const of = (name) => game.querySelector(name).offsetHeight;
    return game.hidden ? 120 : of("header") + of("nav");
  }

  let fitted = "";
  function fit() {
    if (game.hidden) return;
    measure();
    const now = room();
    if (JSON.stringify(now) === fitted) return;
    fitted = JSON.stringify(now);
    speak({ do: "resize", ...now });
  }

  // Sends a command to the program and carries out the reply; returns the reply unless the
  // program has stopped.
  function speak(command, bytes) {
    try {
      pass();
      program.tellTime();
      const reply = program.call(command, bytes);
      heed(reply);
      outdated = true;
      schedule();
      catchUp();
      return reply;
    } catch (error) {
      fail(error);
      return null;
    }
  }

  let last = { wake_ms: null };

  // Screens that show saved data and lose nothing when they are reopened.
  const SHOWS_SAVED = /^(|learn|levels|progress|quiz)$/;

  // Whether another tab has saved, or an opened file has added, something that this tab does not
  // show.
  let isBehind = false;

  async function catchUp() {
    if (!isBehind || isPlain || menu.open || last.unsaved || !SHOWS_SAVED.test(last.address)) return;
    isBehind = false;
    await reopen();
  }

  function heed(reply) {
    if (reply.fault) throw new Error(reply.fault);
    last = reply;
    address.show(reply);
    platform.show(reply.address);
    for (const { name, content } of reply.downloads) give(name, content);
    for (const call of reply.calls) classroom.does(call);
    if (isPlain) plain.show(reply.lines);
    if (reply.keep) {
      keeper.keep(kept, () => speak({ do: "slow" }));
    }
    // A page cannot quit: plain mode accepts no more lines; otherwise carrom opens again.
    if (reply.quit && isPlain) plain.over();
    else if (reply.quit) reopen();
  }

  function kept(failed) {
    // Without this a browser may delete the data when the disk is full.
    if (!failed && !isAsked) navigator.storage?.persist?.()?.catch?.(() => {});
    isAsked = true;
    speak({ do: "kept", failed });
  }
  let isAsked = false;

  // Passes the elapsed time to the program while something moves.
  function pass() {
    const now = performance.now();
    const ms = now - lived;
    lived = now;
    if (last.wake_ms === null) return;
    heed(program.call({ do: "pass", ms }));
    outdated = true;
  }

  // Wakes only if there is something to draw or something moves.
  function schedule() {
    if (frame) return;
    const soon = outdated || (last.wake_ms !== null && last.wake_ms <= 17);
    if (soon) {
      clearTimeout(timer);
      frame = requestAnimationFrame(tick);
    } else if (last.wake_ms !== null) {
      clearTimeout(timer);
      timer = setTimeout(tick, last.wake_ms);
    }
  }

  function tick() {
    frame = 0;
    seen.wakes += 1;
    try {
      pass();
      if (outdated) draw();
      schedule();
    } catch (error) {
      fail(error);
    }
  }

  function draw() {
    outdated = false;
    if (game.hidden) return schedule();
    const { painted } = program.call({ do: "paint", since: drawn });
    drawn = painted.number;
    if (String(painted.colours) !== colours) {
      colours = String(painted.colours);
      const [ink, paper] = painted.colours.map((it) => "#" + it.toString(16).padStart(6, "0"));
      body.style.setProperty("--ink", ink);
      body.style.setProperty("--paper", paper);
    }
    if (painted.inks) panels.colour(painted.inks);
    painter.paint(painted);
    if (painted.sheets) panels.show(painted.sheets);
    panels.settle();
    if (painted.keys || painted.sheets) input.show(painted.keys || undefined);
    seen.frames += 1;
    seen.first ||= performance.now();
    if (last.wake_ms === null) lived = performance.now();
    schedule();
  }

  const tell = (words) => void speak({ do: "tell", words });

  async function take(file) {
    if (file.size > LARGEST) {
      const size = Math.ceil(file.size / 2 ** 20);
      const most = LARGEST / 2 ** 20;
      return tell(`${file.name} cannot be opened: its size is ${size} MiB, and carrom opens files of up to ${most} MiB.`);
    }
    let content;
    try {
      content = new Uint8Array(await file.arrayBuffer());
    } catch {
      return tell(`${file.name} cannot be read.`);
    }
    const renewed = speak({ do: "file", name: file.name }, content)?.renewed;
    if (!renewed) return;
    isBehind = true;
    await catchUp();
    tell(renewed);
  }

  function give(name, content) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([content]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  function chosen(event) {
    const { does, key } = event.target.dataset || {};
    if (!does && !key) return;
    menu.close();
    if (key) input.key(key);
    if (does === "open") chooser.click();
    if (does === "type") typing.focus();
    if (does === "single-keys") input.switchSingleKeys();
    if (does === "plain") location.hash = "plain";
    if (does === "copy") copy(address.link());
    if (does === "share") navigator.share({ title: document.title, url: address.link() }).catch(() => {});
    if (does === "take") {
      const { fault, files, bytes } = program.call({ do: "progress" });
      if (fault) tell(`Your progress cannot be read: ${fault}.`);
      else if (files.length) give("progress.db", bytes);
      else tell("There is no progress to download yet: answer a question first.");
    }
  }

  // Copies text; where the Clipboard API fails, with the older command.
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      const field = panels.make("textarea");
      field.value = text;
      document.body.append(field);
      field.select();
      const isCopied = document.execCommand("copy");
      field.remove();
      if (!isCopied) return tell(`Copying to the clipboard failed. Copy this yourself: ${text}`);
    }
    tell("Copied to the clipboard.");
  }

  const say = (text) => (words.textContent = text);

  function fail(error) {
    console.error(error);
    if (failedOnce) return;
    failedOnce = true;
    game.hidden = true;
    say("Something went wrong, and carrom has stopped.\nYour answers are saved. Reload the page to continue.");
  }

  // For tests: lets a time in milliseconds pass and draws the result.
  function step(ms) {
    program.call({ do: "pass", ms });
    draw();
  }

  return { start, step, isReady: () => ready, seen: () => ({ ...seen }) };
})();

// For tests, which drive carrom with these functions.
window.carrom = {
  call: program.call, cells: program.cells, isReady: page.isReady, seen: page.seen,
  step: page.step, show: panels.show,
  told: () => keeper.kept(),
};

page.start();

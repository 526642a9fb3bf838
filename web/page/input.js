// Input: keys, the mouse and fingers, and the current keys as buttons.

const input = (() => {
  const NAMED = {
    ArrowUp: "Up", ArrowDown: "Down", ArrowLeft: "Left", ArrowRight: "Right", Enter: "Enter",
    Escape: "Escape", Backspace: "Backspace", Delete: "Delete", PageUp: "PageUp",
    PageDown: "PageDown", Home: "Home", End: "End", F1: "F1", " ": "Space",
  };
  const ARROWS = { Up: "▲", Left: "◀", Right: "▶", Down: "▼" };
  const screen = document.getElementById("screen");
  const bar = document.getElementById("keys");
  const layer = document.getElementById("layer");
  const typing = document.getElementById("typing");
  let say = () => {};
  // The content of the field for the menu's "Show the keyboard", so that there is something to delete.
  const FILLER = "\u200b";
  let digits = false, shown = "", likely = null, last = [], own = [], composed = "";

  function start(speak) {
    say = speak;
    addEventListener("keydown", pressed);
    addEventListener("resize", markEdge);
    addEventListener("paste", (event) => {
      const text = event.clipboardData.getData("text");
      if (text && isOurs(event)) say({ do: "paste", text });
    });
    screen.addEventListener("pointerdown", down);
    screen.addEventListener("pointermove", moved);
    screen.addEventListener("pointerup", lifted);
    screen.addEventListener("pointercancel", lifted);
    screen.addEventListener("wheel", wheel, { passive: false });
    screen.addEventListener("beforeinput", (event) => {
      if (!/^insert(LineBreak|Paragraph)$/.test(event.inputType)) return;
      event.preventDefault();
      leave("Enter");
    });
    typing.addEventListener("focus", () => (typing.value = FILLER));
    typing.addEventListener("input", typed);
    typing.addEventListener("compositionend", typed);
    panels.start({ key, press });
    layer.addEventListener("cancel", (event) => {
      event.preventDefault();
      key("Escape");
    });
  }

  const key = (name) => say({ do: "key", key: name });

  // Keys of one character can be turned off, because speech recognition software would press them.
  const SINGLE_KEYS = "carrom-single-keys";
  let hasSingleKeys = true;
  try {
    hasSingleKeys = localStorage.getItem(SINGLE_KEYS) !== "off";
  } catch {
    // The browser saves nothing.
  }

  function switchSingleKeys() {
    hasSingleKeys = !hasSingleKeys;
    try {
      localStorage.setItem(SINGLE_KEYS, hasSingleKeys ? "on" : "off");
    } catch {
      // The setting applies until the page is left.
    }
  }

  // Carries out the action of a key that leaves a field, and moves the focus accordingly.
  function leave(name) {
    panels.follow();
    key(name);
  }

  // Input from a phone's keyboard outside the screen's fields. The keyboard deletes only existing
  // text, and may change a word until it is complete.
  function typed({ type, isComposing }) {
    const now = typing.value;
    if (now.startsWith(FILLER)) panels.retype(composed, now.slice(FILLER.length));
    else key("Backspace");
    composed = now.slice(FILLER.length);
    if (isComposing && type === "input") return;
    composed = "";
    typing.value = FILLER;
  }

  // A click on a cell.
  function press([x, y]) {
    for (const kind of ["down", "up"]) say({ do: "mouse", kind, x: x + 0.5, y: y + 0.5 });
  }

  // The menu, with the settings that every screen has.
  function openMenu() {
    const sets = ({ id }) => /^everywhere\.(charset|theme|motion)$/.test(id);
    const choices = own.filter(sets).map(({ keys, help }) => {
      const node = panels.make("button", "", panels.capital(help));
      node.dataset.key = keys[keys.length - 1];
      return node;
    });
    document.getElementById("choices").replaceChildren(...choices);
    document.querySelector("[data-does=share]").hidden = !navigator.share;
    document.querySelector("[data-does=single-keys]").textContent = `Turn single-letter keys ${hasSingleKeys ? "off" : "on"}`;
    document.getElementById("menu").showModal();
  }

  const isTyped = (node) => node.localName === "input";
  const isOurs = (event) => {
    const open = document.querySelector("dialog[open]");
    if (document.getElementById("game").hidden || (open && open !== layer)) return false;
    return event.target === document.body || event.target === typing || !isTyped(event.target);
  };

  function pressed(event) {
    if (event.ctrlKey !== event.altKey || event.metaKey) return;
    // A keyboard that composes a word handles its own keys, except an Enter that it passes on.
    if (event.keyCode === 229 || (event.isComposing && event.key !== "Enter")) return;
    const letter = [...event.key].length === 1 && event.key !== " " ? event.key : null;
    // While the player types in a field, the field handles every key except those that leave it.
    if (event.target.closest?.("#screen") && isTyped(event.target)) {
      if (!["Enter", "ArrowUp", "ArrowDown"].includes(event.key)) return;
      event.preventDefault();
      return leave(NAMED[event.key]);
    }
    if (!isOurs(event)) return;
    const name = event.key === "Tab" ? (event.shiftKey ? "Shift+Tab" : "Tab") : NAMED[event.key];
    // The browser handles Tab, unless this screen has an action for it and nothing has the focus.
    if (event.key === "Tab") {
      const isNamed = last.some((row) => row.name && row.keys[0] === name);
      if (!isNamed || event.target !== document.body) return;
    }
    const onButton = event.target.closest?.("button, a, summary");
    if (onButton && ["Enter", " "].includes(event.key)) return;
    if (letter && (event.target === typing || !hasSingleKeys)) return;
    if (!name && !letter) return;
    event.preventDefault();
    key(name || letter);
  }

  // Presses and drags on a picture, with the mouse or a finger, are reported. Where nothing is
  // dragged up or down, a finger may also scroll, so it acts only when it has moved sideways or is
  // lifted.
  let hand = null;

  function tell(kind, canvas, event) {
    const [x, y] = painter.cellsAt(canvas, event.clientX, event.clientY);
    say({ do: "mouse", kind, x, y });
  }

  function down(event) {
    const canvas = event.target;
    if (event.button !== 0 || hand || canvas.localName !== "canvas") return;
    event.preventDefault();
    document.activeElement?.blur?.();
    canvas.setPointerCapture(event.pointerId);
    const mayScroll = event.pointerType === "touch" && canvas.style.touchAction === "pan-y";
    hand = { id: event.pointerId, canvas, first: mayScroll ? event : null };
    if (!mayScroll) tell("down", canvas, event);
  }

  function touched() {
    if (hand.first) tell("down", hand.canvas, hand.first);
    hand.first = null;
  }

  // How far a finger that only taps may move, in CSS pixels.
  const TAP = 8;

  function moved(event) {
    if (!hand || event.pointerId !== hand.id) return;
    if (hand.first && Math.abs(event.clientX - hand.first.clientX) < TAP) return;
    touched();
    tell("drag", hand.canvas, event);
  }

  function lifted(event) {
    if (!hand || event.pointerId !== hand.id) return;
    const isScrolling = hand.first && event.type === "pointercancel";
    if (!isScrolling) touched();
    const { canvas } = hand;
    hand = null;
    if (!isScrolling) tell("up", canvas, event);
  }

  // Over a picture the game uses the wheel; with Ctrl the wheel zooms, and elsewhere it scrolls.
  let turned = 0;
  function wheel(event) {
    if (event.target.localName !== "canvas" || event.ctrlKey) return;
    event.preventDefault();
    const rows = event.deltaMode === 0 ? event.deltaY / 40 : event.deltaY;
    if (Math.sign(rows) !== Math.sign(turned)) turned = 0;
    turned += rows;
    for (; Math.abs(turned) >= 1; turned -= Math.sign(turned)) {
      tell(turned > 0 ? "scroll-down" : "scroll-up", event.target, event);
    }
  }

  // Shows the current keys if they, or the screen's elements, have changed.
  function show(rows = last) {
    last = rows;
    const state = panels.state();
    if (state.isCovered) return answers(rows);
    own = rows;
    const told = JSON.stringify([rows, state, digits]);
    if (told !== shown) {
      bar.replaceChildren(...layout(rows, state));
      markEdge();
    }
    shown = told;
    panels.leaveOut(likely);
  }

  // Fades the edge of the row while more buttons are hidden behind it.
  function markEdge() {
    const row = bar.querySelector(".row");
    if (!row) return;
    const fade = () => row.classList.toggle("more", row.scrollLeft + row.clientWidth < row.scrollWidth - 2);
    row.addEventListener("scroll", fade, { passive: true });
    fade();
  }

  // A button for a key; what the key does is shown below or beside its name.
  function button(name, label, help, below = "") {
    const node = panels.make("button", "", label);
    node.type = "button";
    node.dataset.key = name;
    named(node, help || label, below);
    if (below) node.append(" ", panels.make("small", "", below));
    if (below || name in ARROWS) panels.repeats(node, () => key(name));
    else {
      panels.pressed(node, () => {
        panels.seek(name);
        key(name);
      });
    }
    return node;
  }

  // The accessible name of a button is its text if it contains words; the help is its description.
  // Otherwise the name contains what can be read on the button.
  function named(node, help, below = "") {
    const isWords = /\p{L}{2}/u.test(node.textContent);
    if (isWords && !below) node.title = help;
    else {
      const sign = /[\p{L}\p{N}]/u.test(node.textContent) ? node.textContent : "";
      const seen = `${sign} ${below}`.trim();
      node.setAttribute("aria-label", help.includes(seen) ? help : `${seen}: ${help}`);
    }
  }

  function doing(kind, label, help, act) {
    const node = panels.make("button", kind, label);
    node.type = "button";
    named(node, help);
    panels.pressed(node, act);
    return node;
  }

  // The buttons of a layer over the screen.
  function answers(rows) {
    const named = rows.filter(({ name }) => name && name !== "scroll");
    const isHelp = layer.className === "help";
    const label = (name) => (isHelp && !["glossary", "rules"].includes(name) ? "Back" : panels.capital(name));
    const nodes = named.map(({ keys, name, help }) => button(keys[0], label(name), help));
    layer.querySelector(".answers").replaceChildren(...nodes);
  }

  // One button for the likeliest action, and a row of small ones. Actions of elements on the
  // screen (fields, choices, other prompts) have no button here. Nor does q, because the browser
  // has its own ways to leave a page.
  function layout(rows, state) {
    const { prompt, prompts, hasFields, hasNumber, hasChoices } = state;
    const row = panels.make("div", "row");
    const arrows = new Map();
    const numbers = [], rest = [];
    let back = null, explain = null;
    likely = prompt;
    for (const { id = "", keys, name, help, words = [] } of rows) {
      if (id === "everywhere.help") explain = doing("", "?", "help", () => key(keys[0]));
      if (id === "everywhere.back" || keys[0] === "Escape") {
        back = doing("", "⟵", name || "back", () => key(keys[0]));
        continue;
      }
      if (id.startsWith("everywhere.") || id.endsWith(".quit")) continue;
      if (keys.some((it) => /^[0-9]$/.test(it)) && keys.length > 5) {
        if (!hasNumber && !hasChoices) numbers.push(...keys.filter((it) => it.length === 1));
        continue;
      }
      const isArrow = keys.every((it) => it in ARROWS);
      if (isArrow) {
        if (!name) continue;
        const isDone = keys[0] === "Up" || keys[0] === "Down" ? hasFields || hasChoices : hasFields;
        if (isDone) continue;
        // The pair keeps its place in the screen's order.
        if (!arrows.has(keys.join())) rest.push(keys.join());
        arrows.set(keys.join(), { keys, name, help });
        continue;
      }
      if (!name) continue;
      if (["Enter", "Space"].includes(keys[0])) {
        // The screen itself has buttons for the steps of a value.
        if (hasFields && /value|change/.test(name)) continue;
        const isPrompt = prompt && prompt.key === keys[0];
        if (likely && ["Enter", "Space"].includes(likely.key)) {
          if (!isPrompt) rest.push(button(keys[0], name, help || name));
        } else likely = isPrompt ? prompt : { is: "prompt", words: name, key: keys[0] };
        continue;
      }
      // The choices on the screen can be tapped.
      if (hasChoices && keys.every((it) => /^[0-9a-h]$/.test(it)) && keys.length > 1) continue;
      const letters = keys.filter((it) => !(it in ARROWS));
      if (letters.some((it) => prompts.includes(it))) continue;
      if (letters.length < 2) rest.push(button(letters[0] || keys[0], name, help || name));
      else {
        const pair = panels.make("span", "pair");
        const isNamed = words.length === letters.length;
        const signs = isNamed ? words : letters.length === 2 ? ["‹", "›"] : letters;
        const said = (i) => (isNamed ? `${words[i]} ${name}` : help || name);
        pair.append(...letters.map((it, i) => button(it, signs[i], said(i), name)));
        rest.push(pair);
      }
    }
    for (const [at, { keys, name, help }] of arrows) {
      const pair = panels.make("span", "pair");
      pair.append(...keys.map((it) => button(it, ARROWS[it], help || name, name)));
      rest[rest.indexOf(at)] = pair;
    }
    if (numbers.length) {
      rest.push(doing("", digits ? "123 ▾" : "123", "digits", () => {
        digits = !digits;
        show();
      }));
      if (digits) rest.push(...[...numbers, "Backspace"].map((it) => button(it, it === "Backspace" ? "⌫" : it, it)));
    }
    const menu = doing("menu", "☰", "menu", openMenu);
    row.append(menu, ...[explain, back].filter(Boolean), ...rest);
    if (!likely) return [row];
    const item = likely;
    const primary = doing("primary", panels.capital(likely.words.replace(/\.$/, "")), likely.words, () => {
      // If the action goes on to another field, what is typed next belongs there.
      panels.follow();
      panels.does(item);
    });
    return [primary, row];
  }

  // Goes back, or closes the layer over the screen.
  function back() {
    const row = last.find(({ id, keys }) => id === "everywhere.back" || keys[0] === "Escape");
    key(row ? row.keys[0] : "Escape");
  }

  return { start, show, key, back, switchSingleKeys };
})();

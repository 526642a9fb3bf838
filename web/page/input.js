// What hands do: keys, the mouse, fingers, and the keys of the moment as buttons.

const input = (() => {
  const NAMED = {
    ArrowUp: "Up", ArrowDown: "Down", ArrowLeft: "Left", ArrowRight: "Right", Enter: "Enter",
    Escape: "Escape", Backspace: "Backspace", Delete: "Delete", PageUp: "PageUp",
    PageDown: "PageDown", Home: "Home", End: "End", F1: "F1", " ": "Space",
  };
  const ARROWS = { Up: "▲", Left: "◀", Right: "▶", Down: "▼" };
  const canvas = painter.canvas;
  const bar = document.getElementById("keys");
  const typing = document.getElementById("typing");
  let say = () => {};
  let began = false, digits = false, shown = "", last = [];

  function start(speak) {
    say = speak;
    addEventListener("keydown", pressed);
    addEventListener("paste", (event) => {
      const text = event.clipboardData.getData("text");
      if (text && isOurs(event)) say({ do: "paste", text });
    });
    canvas.addEventListener("pointerdown", down);
    canvas.addEventListener("pointermove", moved);
    canvas.addEventListener("pointerup", lifted);
    canvas.addEventListener("pointercancel", lifted);
    canvas.addEventListener("wheel", wheel, { passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    typing.addEventListener("input", () => {
      for (const letter of typing.value) key(letter);
      typing.value = "";
    });
    // Not by clicks alone: a browser leaves out a click that follows a swipe.
    let held = null;
    bar.addEventListener("pointerdown", (event) => (held = event.target.closest("button")));
    bar.addEventListener("pointercancel", () => (held = null));
    bar.addEventListener("pointerup", (event) => {
      const button = event.target.closest("button");
      if (button && button === held) use(button);
      held = null;
    });
    bar.addEventListener("click", (event) => {
      const button = event.target.closest("button");
      if (button && event.detail === 0) use(button);
    });
  }

  function use(button) {
    const { key: name, does } = button.dataset;
    if (name) key(name);
    if (does === "digits") {
      digits = !digits;
      show();
    }
    if (does === "type") typing.focus();
    if (does === "menu") openMenu();
  }

  // The menu, with what can be set on every screen.
  function openMenu() {
    const sets = ({ id }) => /^everywhere\.(charset|theme|motion)$/.test(id);
    const choices = last.filter(sets).map(({ keys, help }) =>
      button(keys[keys.length - 1], help[0].toUpperCase() + help.slice(1), help));
    document.getElementById("choices").innerHTML = choices.join("");
    document.getElementById("menu").showModal();
  }

  const key = (name) => say({ do: "key", key: name });
  const isOurs = (event) =>
    !document.getElementById("game").hidden && !document.querySelector("dialog[open]") &&
    (event.target === document.body || event.target === typing || event.target.closest?.("#keys"));

  function pressed(event) {
    if (!isOurs(event) || event.ctrlKey !== event.altKey || event.metaKey) return;
    if (event.isComposing) return;
    // The first Tab of all goes to the link to plain text.
    if (event.key === "Tab" && !began) return;
    const onButton = event.target.closest?.("#keys");
    if (onButton && ["Tab", "Enter", " "].includes(event.key)) return;
    const letter = [...event.key].length === 1 && event.key !== " " ? event.key : null;
    if (event.target === typing && letter) return;
    const name = event.key === "Tab" ? (event.shiftKey ? "Shift+Tab" : "Tab") : NAMED[event.key];
    if (!name && !letter) return;
    began = true;
    event.preventDefault();
    key(name || letter);
  }

  // The mouse is told as it is. A finger on a picture drags, beside one it scrolls or taps.
  const HAND = 0.8;
  let hand = null;

  function tell(kind, event) {
    const [x, y] = painter.cellsAt(event.clientX, event.clientY);
    say({ do: "mouse", kind, x, y });
  }

  function down(event) {
    if (event.button !== 0 || hand) return;
    event.preventDefault();
    document.activeElement?.blur?.();
    began = true;
    canvas.setPointerCapture(event.pointerId);
    const [x, y] = painter.cellsAt(event.clientX, event.clientY);
    const drags = event.pointerType === "mouse" || painter.isPicture(x, y);
    hand = { id: event.pointerId, drags, x, y, scrolled: false };
    if (drags) tell("down", event);
  }

  function moved(event) {
    if (!hand || event.pointerId !== hand.id) return;
    if (hand.drags) return tell("drag", event);
    const [, y] = painter.cellsAt(event.clientX, event.clientY);
    while (Math.abs(y - hand.y) >= HAND) {
      const way = y > hand.y ? 1 : -1;
      hand.y += way;
      hand.scrolled = true;
      say({ do: "mouse", kind: way > 0 ? "scroll-up" : "scroll-down", x: hand.x, y: hand.y });
    }
  }

  function lifted(event) {
    if (!hand || event.pointerId !== hand.id) return;
    const { drags, scrolled } = hand;
    hand = null;
    if (!drags && !scrolled && event.type === "pointerup") tell("down", event);
    if (drags || !scrolled) tell("up", event);
  }

  let turned = 0;
  function wheel(event) {
    event.preventDefault();
    const rows = event.deltaMode === 0 ? event.deltaY / 40 : event.deltaY;
    if (Math.sign(rows) !== Math.sign(turned)) turned = 0;
    turned += rows;
    for (; Math.abs(turned) >= 1; turned -= Math.sign(turned)) {
      tell(turned > 0 ? "scroll-down" : "scroll-up", event);
    }
  }

  // Shows the keys of the moment: others than before, or the same in another place.
  function show(rows = last) {
    last = rows;
    const buttons = layout(rows);
    if (buttons === shown) return;
    shown = buttons;
    bar.innerHTML = buttons;
  }

  const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);
  const button = (name, label, help, kind = "key", below = "") =>
    `<button data-${kind}="${escaped(name)}" aria-label="${escaped(help || label)}">${escaped(label)}` +
    `${below ? `<small>${escaped(below)}</small>` : ""}</button>`;

  // The buttons for keys. Digits are folded away, arrows are a pad, and q has no button:
  // a page is left as pages are.
  function layout(rows) {
    if (document.body.classList.contains("fine")) return button("menu", "☰ menu", "menu", "does");
    const arrows = new Set();
    const numbers = [];
    const first = [], rest = [], last = [];
    let explain = "<span></span>";
    for (const { id = "", keys, name, help } of rows) {
      if (id === "everywhere.help") explain = button(keys[0], "?", "help");
      if ((id.startsWith("everywhere.") && id !== "everywhere.back") || id.endsWith(".quit")) continue;
      const isNumber = keys.some((key) => /^[0-9]$/.test(key)) && keys.length > 5;
      const both = [];
      for (const key of keys) {
        if (key in ARROWS) arrows.add(key);
        else if (isNumber && key.length === 1) numbers.push(button(key, key, key));
        else if (id === "everywhere.back" || key === "Esc") last.push(button(key, "⟵", name || "back"));
        else if (name) {
          // Answers are on the screen to be tapped; "likewise" says so beside the keys alone.
          const below = keys.length > 1 && name !== "likewise" && name;
          const made = button(key, keys.length > 1 ? key : name, help || name, "key", below);
          if (key === "Enter") first.unshift(made);
          else if (key === "Space") first.push(made);
          else if (below) both.push(made);
          else rest.push(made);
        }
      }
      // What goes one way and the other stands side by side.
      while (both.length) rest.push(`<span class="pair">${both.splice(0, 2).join("")}</span>`);
    }
    // The menu and the help are in the corners of the pad, or where there is none, last.
    const menu = button("menu", "☰", "menu", "does");
    const arrow = (key) => arrows.has(key) ? button(key, ARROWS[key], key) : "<span></span>";
    const pad = [menu, arrow("Up"), explain, arrow("Left"), arrow("Down"), arrow("Right")];
    if (!arrows.size) last.push(explain, menu);
    const parts = [];
    if (arrows.size) parts.push(`<div class="pad">${pad.join("")}</div>`);
    if (numbers.length) rest.push(button("digits", digits ? "123 ▾" : "123", "digits", "does"));
    if (numbers.length && digits) rest.push(...numbers, button("Backspace", "⌫", "take back"));
    rest.push(...last, button("type", "abc", "a keyboard for letters", "does"));
    parts.push(`<div class="rest">${[...first, ...rest].join("")}</div>`);
    return parts.join("");
  }

  return { start, show, key };
})();

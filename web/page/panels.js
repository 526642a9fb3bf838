// The text of the screen as elements: the program's description becomes headings, tables, choices,
// fields and buttons. A node is reused for an item of the same kind, and only changed nodes are
// touched.

const panels = (() => {
  const screen = document.getElementById("screen");
  const layer = document.getElementById("layer");
  const act = { key() {}, press() {}, copy() {} };
  let sheets = [], wasAt = "", prompt = null;

  // A number, perhaps still incomplete, and its unit.
  const NUMBER = /^([−-]?[\d.,]*_?)(?: ?(.*))?$/;

  function make(name, kind, ...inside) {
    const node = document.createElement(name);
    if (kind) node.className = kind;
    node.append(...inside);
    return node;
  }

  // A teacher's own question may run from right to left.
  const anyWay = (node) => Object.assign(node, { dir: "auto" });
  const write = (node, text) => node.textContent === text || (node.textContent = text);
  const mark = (node, kind, is) => node.classList.toggle(kind, Boolean(is));
  const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

  // Updates the children of a node from a list. Nodes of the same `kind` can be reused; `fresh`
  // makes one with a function `update`.
  function sync(parent, list, kind, fresh) {
    list.forEach((it, i) => {
      let node = parent.children[i];
      // A section that has not changed is the same object as before.
      if (node?.carromItem === it) return;
      const told = JSON.stringify(it);
      if (!node || node.carromKind !== kind(it)) {
        const made = fresh(it);
        made.carromKind = kind(it);
        if (node) node.replaceWith(made);
        else parent.append(made);
        node = made;
      }
      node.carromItem = it;
      if (node.carromTold === told) return;
      node.carromTold = told;
      node.update(it);
    });
    while (parent.children.length > list.length) parent.lastElementChild.remove();
  }

  // Runs of text in their colours.
  function runs(node, list) {
    const told = JSON.stringify(list);
    if (node.carromRuns === told) return;
    node.carromRuns = told;
    node.replaceChildren(...list.map(({ text, role }) => {
      if (role === "text") return document.createTextNode(text);
      return make("span", `ink-${role}`, text);
    }));
  }

  // Carries out the action at an item's cell, or that of its key.
  const does = (item) => {
    if (item.key) seek(item.key);
    if (item.is === "prompt" && item.key) act.key(item.key);
    else if (item.press) act.press(item.press);
    else if (item.key) act.key(item.key);
  };

  function button(kind, click) {
    const node = make("button", kind);
    node.type = "button";
    pressed(node, () => click(node.item));
    return node;
  }

  // Acts when a button is pressed. Clicks alone are not enough: a browser omits a click after a
  // swipe, and after a change sends a click to whatever element is there by then.
  function pressed(node, act) {
    let held = false;
    node.addEventListener("click", (event) => {
      // Return the keyboard to the game after a click.
      if (event.detail > 0) node.blur();
      act();
    });
    node.addEventListener("pointerdown", () => (held = true));
    // The finger scrolls instead of pressing.
    node.addEventListener("pointercancel", () => (held = false));
    node.addEventListener("touchend", (event) => {
      const isPressed = held && isLifted(node, event);
      held = false;
      if (isPressed) act();
    });
  }

  // Repeats an action while a button is held. With a finger, which may be about to scroll, the
  // first step waits until the finger is lifted or has rested.
  function repeats(node, step) {
    let timer = 0, isWaiting = false;
    const end = () => clearTimeout(timer);
    const again = (ms) => {
      timer = setTimeout(() => {
        isWaiting = false;
        step();
        if (node.isConnected) again(70);
      }, ms);
    };
    node.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      isWaiting = event.pointerType === "touch";
      if (!isWaiting) step();
      again(400);
    });
    for (const kind of ["pointerup", "pointercancel", "pointerleave"]) node.addEventListener(kind, end);
    node.addEventListener("pointercancel", () => (isWaiting = false));
    node.addEventListener("touchend", (event) => {
      if (isWaiting && isLifted(node, event)) step();
      isWaiting = false;
    });
    node.addEventListener("contextmenu", (event) => event.preventDefault());
    node.addEventListener("click", (event) => event.detail === 0 && step());
  }

  // Whether a finger was on a button when it was lifted. If so, the browser sends no click
  // afterwards.
  function isLifted(node, event) {
    const { clientX, clientY } = event.changedTouches[0];
    const isOn = node.contains(document.elementFromPoint(clientX, clientY));
    if (!isOn || !event.cancelable) return false;
    event.preventDefault();
    return true;
  }

  // A chosen button has its own colour, so its text needs none.
  const plain = (run) => (run.role === "selected" ? { ...run, role: "text" } : run);

  // HTML shows several spaces as one.
  const spaced = (text) => text.replace(/ {2,}/g, " · ");

  // Items that belong together if they follow each other: values, rows of a table, choices.
  const isChoice = (item) => item.chosen !== null && ["text", "pair", "large"].includes(item.is);
  function kindOf(item) {
    if (item.is === "pair" && !isChoice(item)) return "facts";
    if (item.is === "text" && !isChoice(item)) return item.mark ? "list" : "text";
    return isChoice(item) ? "choices" : item.is;
  }

  function groups(items) {
    const all = [];
    let apart = false;
    for (const item of items) {
      if (item.is === "gap") {
        apart = true;
        continue;
      }
      const kind = kindOf(item);
      const last = all[all.length - 1];
      const joins = ["facts", "columns", "choices", "field", "text-field", "list", "tab", "prompt"];
      // Choices or fields remain one group, whatever the space between them.
      const near = !apart || ["choices", "field", "text-field"].includes(kind);
      if (last && last.kind === kind && near && joins.includes(kind)) last.items.push(item);
      else all.push({ kind, apart, items: [item] });
      apart = false;
    }
    return all;
  }

  const KINDS = {
    picture: () => {
      const node = make("div", "picture");
      const hint = make("p", "hint");
      return [make("figure", "", node, hint), ([{ number, shows = [], drag }]) => {
        write(hint, drag || "");
        hint.hidden = !drag;
        const canvas = painter.canvas(number);
        canvas.carromShows = shows.join(" ");
        canvas.style.touchAction = typeof drag === "string" ? "none" : "pan-y";
        if (canvas.parentNode !== node) node.replaceChildren(canvas);
      }];
    },
    text: () => {
      let node = null;
      return [make("div", "text"), function ([{ runs: list }]) {
        const is = list.every(({ role }) => role === "title") ? "h3" : "p";
        if (!node || node.localName !== is) this.replaceChildren((node = anyWay(make(is))));
        runs(node, list);
      }];
    },
    list: () => [make("ul", "list"), function (items) {
      sync(this, items, () => "li", () => {
        const [sign, words] = [make("span", "mark"), anyWay(make("span", "words"))];
        const node = make("li", "", sign, words);
        node.update = (item) => {
          write(sign, item.mark);
          runs(words, item.runs);
        };
        return node;
      });
    }],
    equation: () => [make("p", "equation"), function ([item]) {
      runs(this, item.runs);
    }],
    large: () => [make("p", "large"), function ([item]) {
      runs(this, item.runs);
    }],
    facts: () => [make("dl", "facts"), function (items) {
      sync(this, items, () => "fact", () => {
        const [name, value] = [make("dt"), make("dd")];
        const node = make("div", "", name, value);
        node.update = (item) => {
          runs(name, [item.name]);
          runs(value, [item.value]);
          mark(node, "alone", !item.value.text);
        };
        return node;
      });
    }],
    columns: () => {
      const body = make("tbody");
      const table = make("table", "columns", body);
      // Explicit roles, because a narrow screen lays out a row as lines, which removes the implicit ones.
      table.setAttribute("role", "table");
      return [table, (items) => {
        sync(body, items, (row) => `${row.chosen !== null}/${row.values.length}`, (row) => {
          const name = make("th");
          name.scope = "row";
          name.setAttribute("role", "rowheader");
          const values = row.values.map(() => make("td"));
          for (const cell of values) cell.setAttribute("role", "cell");
          const node = make("tr", "", name, ...values);
          node.setAttribute("role", "row");
          const pick = row.chosen !== null && button("choice", () => does(node.item));
          if (pick) {
            name.append(pick);
            node.addEventListener("click", (event) => event.target.closest("button") || does(node.item));
          }
          node.update = (item) => {
            node.item = item;
            mark(node, "chosen", item.chosen);
            if (pick) pick.setAttribute("aria-pressed", Boolean(item.chosen));
            runs(pick || name, [pick ? plain(item.name) : item.name]);
            values.forEach((cell, i) => runs(cell, [item.values[i]]));
          };
          return node;
        });
        // On a narrow screen each value of a long row is shown with the name of its column.
        const isList = items.some((row) => row.chosen !== null);
        const head = items.find((row) => row.chosen === null && (isList || !row.name.text));
        const isWide = Boolean(head) && head.values.length > 4;
        mark(table, "wide", isWide);
        for (const row of isWide ? body.rows : []) {
          [...row.cells].slice(1).forEach((cell, i) => (cell.dataset.name = head.values[i]?.text || ""));
          mark(row, "head", row === body.rows[items.indexOf(head)]);
        }
      }];
    },
    choices: () => [make("div", "choices"), function (items) {
      sync(this, items, (item) => item.is, () => {
        const [name, side] = [anyWay(make("span", "name")), make("span", "side")];
        const node = button("choice", does);
        node.append(name, side);
        node.update = (item) => {
          node.item = item;
          mark(node, "chosen", item.chosen);
          mark(node, "large", item.is === "large");
          node.setAttribute("aria-pressed", Boolean(item.chosen));
          const list = item.is === "pair" ? [item.name] : item.runs;
          const sign = item.mark ? [{ text: `${item.mark} `, role: "title" }] : [];
          runs(name, [...sign, ...list.map(plain)]);
          runs(side, item.is === "pair" ? [plain(item.value)] : []);
        };
        return node;
      });
    }],
    field: () => [make("div", "fields"), function (items) {
      const kind = (item) => (item.locked ? "locked" : isNumber(item) ? "number" : "switch");
      sync(this, items, kind, (item) => FIELDS[kind(item)]());
    }],
    "text-field": () => [make("div", "fields"), function (items) {
      sync(this, items, () => "typed", () => typedField());
    }],
    prompt: () => [make("div", "prompts"), function (items) {
      sync(this, items, () => "prompt", () => {
        const node = button("prompt", does);
        node.update = (item) => {
          node.item = item;
          node.dataset.key = item.key || "";
          write(node, capital(item.words.replace(/\.$/, "")));
        };
        return node;
      });
    }],
    code: () => {
      const text = make("span");
      const link = make("a");
      const copy = make("button", "", "");
      copy.type = "button";
      let before = "";
      pressed(copy, () => act.copy(before + link.href));
      return [make("p", "code", text, link, copy), ([item]) => {
        before = item.is_result ? `${item.text}: ` : "";
        write(copy, item.is_result ? "Copy the result" : "Copy the link");
        write(text, `${item.text}: `);
        link.href = `#${item.address}`;
        write(link, item.address.replace(/^.*=/, ""));
      }];
    },
    tab: () => {
      const node = make("div", "tabs");
      return [node, (items) => {
        sync(node, items, () => "tab", () => {
          const tab = button("tab", does);
          tab.update = (item) => {
            tab.item = item;
            write(tab, item.name);
            mark(tab, "chosen", item.chosen);
            tab.setAttribute("aria-pressed", Boolean(item.chosen));
          };
          return tab;
        });
      }];
    },
    meter: () => {
      const [name, value] = [make("span"), make("span", "value")];
      const bar = make("progress");
      bar.max = 1;
      return [make("div", "meter", name, bar, value), function ([item]) {
        write(name, item.name);
        write(value, item.value);
        bar.value = item.share;
        bar.className = `ink-${item.role}`;
        bar.setAttribute("aria-label", item.name || "share");
      }];
    },
  };

  // "15.0 mm right" is a number; "15 g on 5.5 g" is one of a few values.
  const isNumber = ({ value }) => /^[−-]?[\d.,]*_|^[−-]?\d[\d.,]*\D*$/.test(value);

  // Chooses a field, unless it is already chosen or was pressed since the last frame.
  let justChosen = null;
  function choose(item) {
    if (item.chosen || !item.press || item === justChosen) return;
    justChosen = item;
    act.press(item.press);
  }

  const FIELDS = {
    locked() {
      const [name, value] = [make("span", "name"), make("span", "value")];
      const node = make("div", "field locked", name, value);
      node.update = (item) => {
        write(name, item.name);
        write(value, item.value);
      };
      return node;
    },
    // A field with a few values: each press sets the next.
    switch() {
      const name = make("span", "name");
      const value = button("value", (item) => {
        // Otherwise the phone's keyboard would stay open after typing into another field.
        document.activeElement?.closest("#screen input")?.blur();
        does(item);
      });
      const node = make("div", "field", name, value);
      node.update = (item) => {
        value.item = item;
        mark(node, "chosen", item.chosen);
        write(name, item.name);
        write(value, `${item.value} ›`);
        value.setAttribute("aria-label", `${item.name}: ${item.value}`);
      };
      return node;
    },
    number() {
      const [name, unit] = [make("label", "name"), make("span", "unit")];
      const input = make("input");
      const [less, more] = [make("button", "", "−"), make("button", "", "+")];
      const node = make("div", "field number", name, less, input, unit, more);
      Object.assign(input, { inputMode: "decimal", autocomplete: "off", enterKeyHint: "done" });
      // The part of a typed number that the game has received.
      let typed = "", shown = "", isTyped = false, item = null;
      for (const [way, key] of [[less, "Left"], [more, "Right"]]) {
        way.type = "button";
        repeats(way, () => {
          choose(item);
          act.key(key);
        });
      }
      input.addEventListener("focus", () => {
        choose(item);
        input.select();
      });
      // A tap on a field that already has the focus would put the caret into the number.
      input.addEventListener("click", () => typed || input.select());
      input.addEventListener("input", () => {
        const wanted = input.value.replace(/[^\d.,−-]/g, "");
        choose(item);
        retype(typed, wanted);
        typed = wanted;
      });
      node.settle = () => {
        typed = isTyped ? shown : "";
        // An empty field remains empty, because a number is about to be typed there.
        if (input.value && input.value !== shown) input.value = shown;
      };
      node.update = (told) => {
        item = told;
        const [, number, rest] = NUMBER.exec(item.value) || [null, item.value, ""];
        isTyped = number.endsWith("_");
        shown = isTyped ? number.slice(0, -1) : number;
        typed = isTyped ? shown : "";
        mark(node, "chosen", item.chosen);
        write(name, item.name);
        write(unit, rest || "");
        less.setAttribute("aria-label", `less ${item.name}`);
        more.setAttribute("aria-label", `more ${item.name}`);
        name.htmlFor = input.id = input.id || `field-${(count += 1)}`;
        input.style.width = shown.length > 6 ? `${shown.length + 3}ch` : "";
        if (input.value === shown) return;
        input.value = shown;
        if (document.activeElement === input && !isTyped) input.select();
      };
      return node;
    },
  };
  let count = 0;

  // A field for typed text: a name, a code.
  function typedField() {
    const name = make("label", "name");
    const input = make("input");
    const node = make("div", "field typed", name, input);
    Object.assign(input, { autocomplete: "off", spellcheck: false, enterKeyHint: "next" });
    for (const kind of ["autocapitalize", "autocorrect"]) input.setAttribute(kind, "off");
    // The text sent to the game, which it may not show yet.
    let item = null, sent = "", isComposing = false;
    // A phone's keyboard composes each word, and a tap on a button does not complete the word, so
    // the word being composed is sent too.
    const send = () => {
      if (input.value === sent) return;
      choose(item);
      act.key("End");
      retype(sent, input.value);
      sent = input.value;
    };
    input.addEventListener("focus", () => choose(item));
    input.addEventListener("input", send);
    input.addEventListener("compositionstart", () => (isComposing = true));
    input.addEventListener("compositionend", () => {
      isComposing = false;
      send();
    });
    node.settle = () => {
      sent = item.value;
      // A word that is being composed must not be changed.
      if (!isComposing && input.value !== sent) input.value = sent;
    };
    node.update = (told) => {
      item = told;
      mark(node, "chosen", item.chosen);
      write(name, item.name);
      name.htmlFor = input.id = input.id || `field-${(count += 1)}`;
      node.settle();
    };
    return node;
  }

  // Types the difference between two strings, which is at their ends.
  function retype(old, wanted) {
    const [from, to] = [[...old], [...wanted]];
    let same = 0;
    while (same < from.length && from[same] === to[same]) same += 1;
    for (const _ of from.slice(same)) act.key("Backspace");
    for (const letter of to.slice(same)) act.key(letter === " " ? "Space" : letter);
  }

  // After each frame, shows the game's text in the focused field: the game may accept less than
  // was typed.
  function settle() {
    justChosen = null;
    document.activeElement?.closest(".field")?.settle?.();
  }

  // Moves the focus to the field that the game chooses next, or away if it chooses none.
  const follow = () => (isFollowing = true);
  let isFollowing = false;

  function moveFocus() {
    const focused = document.activeElement;
    if (!isFollowing || !screen.contains(focused)) return;
    const next = screen.querySelector(".field.chosen input");
    if (next) next.focus();
    else focused.blur();
  }

  function drawItems(node, items) {
    sync(node, groups(items), ({ kind }) => kind, ({ kind }) => {
      const [made, update] = (KINDS[kind] || KINDS.text)();
      made.update = (group) => {
        mark(made, "apart", group.apart);
        update.call(made, group.items);
      };
      return made;
    });
  }

  function section() {
    const [title, body] = [make("h2"), make("div", "body")];
    const node = make("section", "", title, body);
    node.update = (told) => {
      const isMarked = told.title.startsWith("> ");
      write(title, spaced(isMarked ? told.title.slice(2) : told.title));
      mark(node, "marked", isMarked);
      title.hidden = !told.title;
      mark(node, "pictured", told.items.some(({ is }) => is === "picture"));
      mark(node, "tabbed", told.items.every(({ is }) => is === "tab"));
      drawItems(body, told.items);
      for (const canvas of body.querySelectorAll("canvas")) {
        // A picture without a description of its own is described by the words beside it.
        const words = canvas.carromShows || `Picture: ${title.textContent}. The text beside it describes it.`;
        canvas.setAttribute("aria-label", words);
      }
    };
    return node;
  }

  // Shows the program's description; the program does not repeat unchanged sections.
  function show(told) {
    sheets = told.map((sheet, at) => ({
      ...sheet,
      sections: sheet.sections.map((it, i) => it || sheets[at].sections[i]),
    }));
    const [under, ...over] = sheets;
    write(document.getElementById("title"), under.title);
    write(document.getElementById("status"), spaced(under.status));
    write(document.querySelector("title"), `${under.title} · carrom`);
    const prompts = under.sections.flatMap(({ items }) => items.filter(({ is }) => is === "prompt"));
    prompt = prompts.find(({ key }) => ["Enter", "Space"].includes(key)) || prompts[0] || null;
    const hasPicture = under.sections.some(({ items }) => items.some(({ is }) => is === "picture"));
    mark(screen, "pictures", hasPicture);
    mark(screen, "two", under.sections.length === 2);
    screen.dataset.title = under.title;
    const fresh = () => section();
    // Sections with pictures or tabs go into the left part, the others into the right part.
    const isPicture = ({ items }) => items.some(({ is }) => is === "picture" || is === "tab");
    const [left, right] = [screen.firstElementChild, screen.lastElementChild];
    sync(left, under.sections.filter((it) => isPicture(it)), () => "section", fresh);
    sync(right, under.sections.filter((it) => !isPicture(it)), () => "section", fresh);
    // A title that shows the passing time does not make a new screen.
    const titles = under.sections.map(({ title }) => title.replace(/^[\d.]+ s\b/, ""));
    const at = [under.title, ...titles].join("\n");
    const isNew = at !== wasAt;
    if (isNew) for (const node of [screen, left, right]) node.scrollTop = 0;
    wasAt = at;
    const chosen = screen.querySelector(".field.chosen, .choice.chosen, tr.chosen");
    // A new screen is read from its top; a list scrolls to its selected item. A finger that turns
    // rays in a picture should find the picture where it was.
    const isCalm = chosen?.matches(".field") && (isNew || isTouched);
    const isSought = chosen && chosen !== lastChosen && !isCalm;
    if (isSought && !isSeen(chosen)) chosen.scrollIntoView({ block: "nearest" });
    lastChosen = chosen;
    const next = sought && [...screen.querySelectorAll(".prompt")].find(({ item }) => item.key === sought);
    if (next && !isNew && !isSeen(next)) next.scrollIntoView({ block: "nearest" });
    sought = null;
    moveFocus();
    isFollowing = false;
    announce(under);
    showLayer(over[over.length - 1]);
  }
  let lastChosen = null, isTouched = false;
  addEventListener("pointerdown", ({ pointerType }) => (isTouched = pointerType === "touch"), true);
  addEventListener("keydown", () => (isTouched = false), true);

  // If a prompt offers a pressed key again, such as the key for the rest of a hint, the prompt is
  // scrolled into view with the words above it.
  const seek = (key) => (sought = /^(Enter|Space)$/.test(key) ? null : key);
  let sought = null;

  // Announces to screen readers what is new: the name of a new screen, and new sentences. A number
  // that changes in a sentence, such as in a countdown, is not announced.
  const news = document.getElementById("news");
  let known = new Set(), fresh = [], called = "", timer = 0;
  function announce({ title, sections }) {
    const items = sections.flatMap((it) => it.items).filter((it) => it.is === "text" && it.chosen === null);
    const sentences = items.map((it) => it.runs.map(({ text }) => text).join("").trim()).filter((text) => text.length > 2);
    const shape = (text) => text.replace(/[\d.,]+/g, "0");
    if (title !== called) fresh = [capital(title) + (/[.!?]$/.test(title) ? "" : ".")];
    called = title;
    fresh.push(...sentences.filter((text) => !known.has(shape(text))));
    known = new Set(sentences.map(shape));
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (fresh.length) write(news, fresh.join(" ").slice(0, 600));
      fresh = [];
    }, 500);
  }

  // Scrolling to a visible element would change where Tab continues.
  function isSeen(node) {
    const [own, round] = [node.getBoundingClientRect(), screen.getBoundingClientRect()];
    return own.top >= round.top && own.bottom <= round.bottom;
  }

  // The layer over the screen, as a dialog: everything below it is inert.
  function showLayer(sheet) {
    if (!sheet) {
      if (layer.open) layer.close();
      return;
    }
    const [title, body] = [layer.querySelector("h2"), layer.querySelector(".body")];
    write(title, sheet.sections[0]?.title || sheet.title);
    layer.className = sheet.kind;
    drawItems(body, sheet.sections.flatMap(({ items }) => items));
    if (!layer.open) {
      layer.showModal();
      body.scrollTop = 0;
    }
  }

  const colour = (inks) => {
    for (const [role, ink] of inks) {
      document.body.style.setProperty(`--${role}`, "#" + ink.toString(16).padStart(6, "0"));
    }
  };

  // Hides the prompt that the foot shows.
  function leaveOut(item) {
    for (const node of screen.querySelectorAll(".prompt")) {
      node.hidden = Boolean(item) && node.item.words === item.words && node.item.key === item.key;
    }
  }

  // The likeliest prompt, and whether the screen has fields and choices.
  const state = () => ({
    prompt,
    prompts: [...screen.querySelectorAll(".prompt")].map(({ item }) => item.key),
    isCovered: sheets.length > 1,
    hasFields: Boolean(screen.querySelector(".field.number, .field .value")),
    hasNumber: Boolean(screen.querySelector(".field.number")),
    hasChoices: Boolean(screen.querySelector(".choice")),
  });

  const start = (acts) => Object.assign(act, acts);

  return {
    start, show, colour, state, leaveOut, does, pressed, repeats, make, capital, retype, settle, follow, seek,
  };
})();

// carrom in plain lines, as ordinary HTML.

const plain = (() => {
  const log = document.getElementById("log");
  const form = document.getElementById("answer");
  const line = document.getElementById("line");

  // Shows plain mode; `say` sends a line to the program.
  function begin(say) {
    log.textContent = "";
    form.hidden = false;
    form.onsubmit = (event) => {
      event.preventDefault();
      const text = line.value;
      write(text || "(Enter)", "said");
      line.value = "";
      say({ do: "line", text });
    };
  }

  // Shows lines from the program.
  function show(lines) {
    if (!lines.length) return;
    lines.forEach((text) => write(text));
    const all = document.getElementById("plain");
    all.scrollTop = all.scrollHeight;
    line.focus();
  }

  function over() {
    form.hidden = true;
    show(["You have left carrom. The link above opens it again."]);
  }

  function write(text, kind) {
    const paragraph = document.createElement("p");
    paragraph.textContent = text;
    if (kind) paragraph.className = kind;
    log.append(paragraph);
  }

  return { begin, show, over };
})();

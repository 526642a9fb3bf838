// The quiz and the lessons in plain lines, as ordinary HTML.

const plain = (() => {
  const log = document.getElementById("log");
  const form = document.getElementById("answer");
  const line = document.getElementById("line");
  let said = [];
  let count = 0;

  function begin() {
    const asked = /quiz|learn|lesson/.test(location.hash);
    form.hidden = !asked;
    log.textContent = "";
    [said, count] = [[], 0];
    form.onsubmit = (event) => {
      event.preventDefault();
      said.push(line.value);
      write(line.value || "(nothing)", "said");
      line.value = "";
      go();
    };
    if (asked) go();
    else document.querySelector("#ways a").focus();
  }

  // Holds the talk once more with all lines so far, and shows what is new. What was answered
  // is kept before anything is said about it.
  function go() {
    program.tellTime();
    const reply = program.call({ do: "talk", lines: said });
    const show = (failed) => {
      if (failed) write(`What you do cannot be kept: ${failed}.`);
      reply.lines.slice(count).forEach((text) => write(text));
      count = reply.lines.length;
      form.hidden = reply.over;
      if (reply.over) write("The talk is over. Choose a way above.");
      else line.focus();
    };
    if (!reply.keep) return show(null);
    keeper.keep((failed) => {
      program.call({ do: "kept", failed });
      show(failed);
    });
  }

  function write(text, kind) {
    const paragraph = document.createElement("p");
    paragraph.textContent = text;
    if (kind) paragraph.className = kind;
    log.append(paragraph);
    const all = document.getElementById("plain");
    all.scrollTop = all.scrollHeight;
  }

  return { begin };
})();

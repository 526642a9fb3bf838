// The quiz and the lessons in plain lines, as ordinary HTML.

const plain = (() => {
  const log = document.getElementById("log");
  const form = document.getElementById("answer");
  const line = document.getElementById("line");
  let speak = () => null, said = [], count = 0, newest = null, isTold = false;

  // Begins a talk, in which `say` says something to the program.
  function begin(say) {
    speak = say;
    const asked = /quiz|learn|lesson/.test(location.hash);
    form.hidden = !asked;
    log.textContent = "";
    [said, count, newest, isTold] = [[], 0, null, false];
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
    newest = speak({ do: "talk", lines: said });
    if (newest && !newest.keep) show();
  }

  // What was done is kept, or why not; `goes on` if more is being kept.
  function kept(failed, goesOn) {
    if (failed && !isTold) {
      write(`What you do cannot be kept for now: ${failed}. It is kept as soon as that is possible.`);
    }
    if (!failed && isTold) write("What you did is kept now.");
    isTold = Boolean(failed);
    if (newest && (failed || !goesOn)) show();
  }

  function show() {
    const { lines, over } = newest;
    newest = null;
    lines.slice(count).forEach((text) => write(text));
    count = lines.length;
    form.hidden = over;
    if (over) write("The talk is over. Choose a way above.");
    else line.focus();
  }

  function write(text, kind) {
    const paragraph = document.createElement("p");
    paragraph.textContent = text;
    if (kind) paragraph.className = kind;
    log.append(paragraph);
    const all = document.getElementById("plain");
    all.scrollTop = all.scrollHeight;
  }

  return { begin, kept };
})();

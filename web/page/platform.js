// Reports one round to a learning platform that has opened the page as a SCORM 1.2 package.

const platform = (() => {
  // The path of the added file that contains the code of the round.
  const ROUND = "scorm/round";
  // The largest number of windows around this one that are searched for the platform's functions,
  // which SCORM calls the API.
  const MOST_WINDOWS = 30;
  let api = null, place = "", code = "", reported = "", answered = 0, begun = 0, since = 0, isForReview = false, isDone = false;

  const pad = (number) => String(number).padStart(2, "0");
  const span = (ms) => {
    const s = Math.floor(ms / 1000);
    return `${pad(Math.floor(s / 3600)).padStart(4, "0")}:${pad(Math.floor(s / 60) % 60)}:${pad(s % 60)}`;
  };
  // A platform that fails must not stop the round.
  const ask = (name, ...values) => {
    try {
      return String(api[name](...values));
    } catch (error) {
      console.error(error);
      return "";
    }
  };
  const get = (name) => ask("LMSGetValue", `cmi.${name}`);
  const set = (name, value) => ask("LMSSetValue", `cmi.${name}`, String(value));

  function find() {
    const around = (first) => {
      for (let at = first, count = 0; at && count < MOST_WINDOWS; count += 1) {
        try {
          if (at.API) return at.API;
        } catch {
          // The window belongs to another site, so its functions cannot be used.
        }
        if (at.parent === at) return null;
        at = at.parent;
      }
      return null;
    };
    return around(self) || around(self.opener) || around(self.top.opener);
  }

  // Takes the code of the round out of the files added to the page, and opens the round where the
  // pupil left it; returns the other files.
  function start(files) {
    const own = files.find(([path]) => path === ROUND);
    if (!own) return files;
    if (!place) begin(own[1]);
    return files.filter((it) => it !== own);
  }

  function begin(round) {
    code = round;
    place = `quiz=${code}`;
    api = find();
    let said = "";
    if (api) {
      connect();
      said = get("suspend_data");
      reported = said;
      answered = count(said);
    }
    // After a reload the history knows the address and the answers.
    if (location.hash) return;
    try {
      history.replaceState(said ? { said } : null, "", `#${place}`);
    } catch {
      location.hash = place;
    }
  }

  function connect() {
    ask("LMSInitialize", "");
    begun = since = Date.now();
    // A platform that does not state the mode or the status leaves them empty.
    if (/^(review|browse)$/.test(get("core.lesson_mode"))) return void (isForReview = true);
    isDone = /^(completed|passed|failed)$/.test(get("core.lesson_status"));
    if (!isDone) set("core.lesson_status", "incomplete");
    addEventListener("pagehide", finish, { once: true });
    addEventListener("pageshow", ({ persisted }) => persisted && connect(), { once: true });
  }

  const count = (said) => said.split(";").filter(Boolean).length;

  // Reports the answers given since the last report. Once all questions of a round have been
  // answered, playing the round again changes nothing. Before that, a round that is played again
  // changes nothing until it contains at least as many answers as before.
  function show(address) {
    if (!api || isForReview || isDone) return;
    const [where, said = ""] = address.split("&said=");
    if (where !== place || said === reported || count(said) < answered) return;
    const { round } = program.call({ do: "round", code, said });
    if (!round) return;
    const first = Number(get("interactions._count")) || 0;
    round.answers.slice(answered).forEach((answer, i) => {
      const put = (name, value) => set(`interactions.${first + i}.${name}`, value);
      put("id", answer.id);
      put("type", answer.kind);
      put("time", new Date().toTimeString().slice(0, 8));
      put("correct_responses.0.pattern", answer.truth);
      put("student_response", answer.said);
      put("result", answer.right ? "correct" : "wrong");
      put("weighting", 1);
      put("latency", span(Date.now() - since));
      since = Date.now();
    });
    set("core.score.min", 0);
    set("core.score.max", 100);
    set("core.score.raw", round.score);
    isDone = round.done;
    if (isDone) set("core.lesson_status", "completed");
    set("core.exit", isDone ? "" : "suspend");
    // The last semicolon stands for the explanation of the last answer; a finished round opens with
    // its result.
    set("suspend_data", isDone ? said.replace(/;$/, "") : said);
    set("core.session_time", span(Date.now() - begun));
    // If this fails, the next commit or the end of the session saves the values.
    ask("LMSCommit", "");
    reported = said;
    answered = round.answers.length;
  }

  function finish() {
    set("core.session_time", span(Date.now() - begun));
    ask("LMSFinish", "");
  }

  // What the pupil should know about the platform; empty if everything is working.
  const warning = () => {
    if (!place || (api && !isForReview)) return "";
    return api
      ? "Your learning platform shows this round for review only: answers are not reported."
      : "carrom found no learning platform around this page, so answers are not reported.";
  };

  return { start, show, warning };
})();

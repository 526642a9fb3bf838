// Connects a pupil to the class whose host has served this page, by one WebSocket to the page's
// own address. The program decides when to reconnect; the token that returns a pupil to their
// seat is kept here.

const classroom = (() => {
  const KEY = "carrom-seat";
  let line = null, number = 0, say = () => {}, hidden = 0;

  function does(call) {
    if (call.do === "dial") dial();
    if (call.do === "say" && line && line.readyState === WebSocket.OPEN) line.send(call.text);
    if (call.do === "remember") keep(call);
    if (call.do === "hang-up") hangUp();
  }

  function hangUp() {
    number += 1;
    if (line) line.close();
    line = null;
  }

  function dial() {
    hangUp();
    const own = number;
    const tell = (news) => own === number && say({ do: "joined", news });
    const lost = () => tell({ is: "lost" });
    const seat = kept();
    if (seat) setTimeout(() => tell({ is: "remembered", seat: seat.seat, name: seat.name }));
    try {
      line = new WebSocket(`ws://${location.host}/class`);
    } catch {
      return void setTimeout(lost);
    }
    line.onopen = () => setTimeout(() => tell({ is: "reached" }));
    line.onmessage = ({ data }) => tell({ is: "heard", text: String(data) });
    line.onclose = lost;
  }

  // Some browsers store nothing for some pages.
  function kept() {
    try {
      return JSON.parse(localStorage.getItem(KEY));
    } catch {
      return null;
    }
  }

  function keep({ seat, name, code }) {
    try {
      localStorage.setItem(KEY, JSON.stringify({ seat, name, code }));
    } catch {}
  }

  // The link that this page opens; a pupil who was in this class before need not enter a name again.
  function fragment() {
    const given = address.fragment();
    if (!isHere()) return given;
    if (/^plain(&|$)/.test(given)) {
      return `plain&${placeHere(given.replace(/^plain&?/, ""))}`;
    }
    return placeHere(given);
  }

  // The part of the address after "#" with which a page served by a class's host opens.
  function placeHere(given) {
    const before = kept();
    const link = /(^|&)code=([^&]*)/.exec(given);
    if (before && (!given || given === "join" || (link && link[2].toUpperCase() === before.code))) {
      return `player=${encodeURIComponent(before.name)}&code=${before.code}&again`;
    }
    return given || "join";
  }

  // A phone that was asleep may not know that its connection is lost.
  function awake() {
    const slept = performance.now() - hidden;
    if (line && (line.readyState > WebSocket.OPEN || slept > 3000)) {
      say({ do: "joined", news: { is: "awake" } });
    }
  }

  function start(speak) {
    say = speak;
    document.addEventListener("visibilitychange", () => {
      if (document.hidden) hidden = performance.now();
      else awake();
    });
    addEventListener("pageshow", (event) => event.persisted && awake());
  }

  // Whether this page comes from a class's host, rather than from a disk or a school's server.
  const isHere = () => "class" in document.documentElement.dataset;

  return { does, start, fragment };
})();

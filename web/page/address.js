// Where one is, in the page's address and the browser's history: each screen that is opened is
// an entry, so Back goes back, a reload stays, and what the address says can be given to others.

const address = (() => {
  // What a link says beside where to go, and what stays while one goes elsewhere.
  const STAYS = /^(plain|player|charset|color|palette)(=|$)/;
  // What has been answered in a round stands in the entry, not in what others are given.
  const ANSWERS = "&said=";
  // Browsers allow some hundred changes of an address in half a minute, and none is made while a
  // page is being opened or left.
  const PAUSE = 400;
  let entry = { index: 0, depths: [] };
  let stays = [], told = { address: "", depth: 1 }, written = "", timer = 0;
  let back = () => {}, reopen = () => {}, isMoving = false;

  function start(acts) {
    ({ back, reopen } = acts);
    addEventListener("popstate", moved);
  }

  // What the page opens with: what a link says, and what was answered before a reload.
  function fragment() {
    const given = location.hash.slice(1);
    const parts = given.split("&");
    stays = parts.filter((part) => STAYS.test(part));
    const state = history.state;
    // How many screens are open here is another matter after each opening.
    if (state?.depths) entry = { index: state.index, depths: state.depths.slice(0, state.index) };
    else entry = { index: entry.depths.length, depths: entry.depths };
    written = "";
    const said = state?.said;
    return said ? `${given}${ANSWERS}${said}` : given;
  }

  // Takes what the program says after each call.
  function show(reply) {
    const before = told;
    told = reply;
    if (isMoving) return;
    // The first that is said of an entry.
    entry.depths[entry.index] ??= told.depth;
    const was = entry.depths[entry.index];
    if (told.depth === was) {
      timer ||= setTimeout(write, PAUSE);
    } else if (told.depth > was) {
      if (timer) put("replaceState", before);
      clearTimeout(timer);
      timer = 0;
      entry = { index: entry.index + 1, depths: [...entry.depths.slice(0, entry.index + 1), told.depth] };
      put("pushState");
    } else {
      let index = entry.index;
      while (index > 0 && entry.depths[index] > told.depth) index -= 1;
      if (index === entry.index) return put("replaceState");
      isMoving = true;
      history.go(index - entry.index);
    }
  }

  // Brings the entry up to date, if it is still of the same screen.
  function write() {
    clearTimeout(timer);
    timer = 0;
    if (!isMoving && entry.depths[entry.index] === told.depth) put("replaceState");
  }

  function put(way, { address, depth } = told) {
    const [place, said] = address.split(ANSWERS);
    const hash = [place, ...stays].filter(Boolean).join("&");
    const now = JSON.stringify([hash, said, depth]);
    if (way === "replaceState" && now === written) return;
    written = now;
    const depths = [...entry.depths.slice(0, entry.index), depth];
    entry = { index: entry.index, depths };
    const url = hash ? `#${hash}` : location.href.replace(/#.*/s, "");
    try {
      history[way]({ ...entry, said }, "", url);
    } catch {
      // A browser that allows no more for now: the next change brings it.
      written = "";
    }
  }

  function moved({ state }) {
    // An address that was typed, or a link in the page.
    if (!state?.depths) {
      entry = { index: entry.index + 1, depths: entry.depths.slice(0, entry.index + 1) };
      return reopen();
    }
    const before = entry.index;
    entry = { index: state.index, depths: state.depths };
    written = "";
    if (isMoving) {
      isMoving = false;
      return show(told);
    }
    if (state.index > before) return reopen();
    // Not all can be left: a round asks first. Then its entry is made anew.
    back();
    show(told);
  }

  // What others can be given, to see the same.
  const link = () => {
    write();
    return location.href;
  };

  return { start, fragment, show, link };
})();

// Keeps the page's address and the browser's history in step with the program: each screen that is
// opened is an entry, so Back goes back, a reload shows the same screen, and the address can be
// shared.

const address = (() => {
  // The parts of a link that are kept when another screen is opened.
  const STAYS = /^(plain|player|charset|color|palette)(=|$)/;
  // The answers given in a round are kept in the history's entry, not in the address.
  const ANSWERS = "&said=";
  // Browsers limit how often an address changes: Safari to 100 times in 30 s. The pause also keeps
  // the address from changing while the page is being opened or left.
  const PAUSE = 400;
  let entry = { index: 0, depths: [] };
  let stays = [], told = { address: "", depth: 1 }, written = "", timer = 0;
  let back = () => {}, reopen = () => {}, isMoving = false;

  function start(acts) {
    ({ back, reopen } = acts);
    addEventListener("popstate", moved);
  }

  // The link that the page opens, with the answers given before a reload.
  function fragment() {
    const given = location.hash.slice(1);
    const parts = given.split("&");
    stays = parts.filter((part) => STAYS.test(part));
    const state = history.state;
    // The program may open a different number of screens than before the reload.
    if (state?.depths) entry = { index: state.index, depths: state.depths.slice(0, state.index) };
    else entry = { index: entry.depths.length, depths: entry.depths };
    written = "";
    const said = state?.said;
    return said ? `${given}${ANSWERS}${said}` : given;
  }

  // Takes the address and the number of open screens that the program reports after each call.
  function show(reply) {
    const before = told;
    told = reply;
    if (isMoving) return;
    // The first report for an entry.
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

  // Writes the entry, unless another screen has been opened since.
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
      // The browser's limit was reached: the next change writes the entry.
      written = "";
    }
  }

  function moved({ state }) {
    // The address was typed, or a link in the page was followed.
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
    // A round asks for confirmation before it is left; in the meantime its entry is pushed again.
    back();
    show(told);
  }

  // The link to the current screen.
  const link = () => {
    write();
    return location.href;
  };

  return { start, fragment, show, link };
})();

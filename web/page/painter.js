// The painter: changed cells on a canvas, and pictures as vectors in their place.

const painter = (() => {
  const VECTOR = 1 << 16, BOLD = 1, ITALIC = 4, UNDERLINED = 8;
  const MONO = "'DejaVu Sans Mono', Menlo, Consolas, 'Cascadia Mono', 'Roboto Mono', 'Liberation Mono', monospace";
  const SANS = "'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', Roboto, 'DejaVu Sans', sans-serif";
  const canvas = document.getElementById("screen");
  const pen = canvas.getContext("2d", { alpha: false });
  // A cell in pixels of the device, the font that fits it, and where its letters stand.
  let cell = { width: 9, height: 18, size: 15, base: 14 };
  let grid = [0, 0];
  let before = null, picturesBefore = [];
  const shapes = new Map(), widths = new Map();

  const hex = (colour) => "#" + colour.toString(16).padStart(6, "0");

  // How many cells there is room for, and how large they are: in width and height of CSS
  // pixels. A cell is twice as high as wide, so that what is round is round.
  function fit(width, height) {
    const ratio = window.devicePixelRatio || 1;
    const upright = height >= width && width < 700;
    const wanted = upright ? [61, 20] : height < 500 ? [80, 22] : [104, 32];
    const room = [width * ratio, height * ratio];
    const wide = Math.max(3, Math.floor(Math.min(room[0] / wanted[0], room[1] / (2 * wanted[1]))));
    const columns = Math.min(300, Math.floor(room[0] / wide));
    const rows = Math.min(150, Math.floor(room[1] / (2 * wide)));
    pen.font = `100px ${MONO}`;
    const size = (100 * wide) / pen.measureText("0").width;
    pen.font = `${size}px ${MONO}`;
    const box = pen.measureText("Hg");
    const [up, down] = [box.fontBoundingBoxAscent, box.fontBoundingBoxDescent];
    cell = { width: wide, height: 2 * wide, size, base: (2 * wide - up - down) / 2 + up };
    grid = [columns, rows];
    [canvas.width, canvas.height] = [columns * cell.width, rows * cell.height];
    canvas.style.width = `${canvas.width / ratio}px`;
    canvas.style.height = `${canvas.height / ratio}px`;
    before = null;
    widths.clear();
    return grid;
  }

  // Paints what has changed.
  function paint(painted) {
    const [columns, rows] = painted.size;
    const count = columns * rows;
    const cells = program.cells(count);
    const all = !before || before.length !== cells.length;
    const fresh = new Uint8Array(count);
    for (let i = 0, k = 0; i < count; i++, k += 4) {
      const same = !all && cells[k] === before[k] && cells[k + 1] === before[k + 1] &&
        cells[k + 2] === before[k + 2] && cells[k + 3] === before[k + 3];
      if (same) continue;
      fresh[i] = 1;
      if (!(cells[k + 3] & VECTOR)) paintCell(cells, i, i % columns, Math.floor(i / columns));
    }
    painted.pictures.forEach((picture, at) => {
      const [x, y, w, h] = picture.area;
      let stale = picturesBefore[at] !== picture.svg;
      for (let row = y; row < y + h && !stale; row++) {
        stale = fresh.subarray(row * columns + x, row * columns + x + w).includes(1);
      }
      if (stale && picture.svg) paintPicture(picture, painted.colours[1], cells, columns);
    });
    picturesBefore = painted.pictures.map((picture) => picture.svg);
    if (all) before = cells.slice();
    else before.set(cells);
  }

  function paintCell(cells, i, column, row) {
    const [code, ink, paper, bits] = cells.subarray(4 * i, 4 * i + 4);
    const [x, y] = [column * cell.width, row * cell.height];
    pen.fillStyle = hex(paper);
    pen.fillRect(x, y, cell.width, cell.height);
    const letter = String.fromCodePoint(code);
    pen.fillStyle = hex(ink);
    if (bits & UNDERLINED) {
      const thick = Math.max(1, cell.height / 18);
      pen.fillRect(x, y + cell.height - 2 * thick, cell.width, thick);
    }
    if (letter === " ") return;
    const shape = shapeOf(letter);
    if (shape) {
      pen.save();
      pen.globalAlpha = shape.strength;
      pen.translate(x, y);
      pen.scale(cell.width / 9, cell.height / 18);
      pen.fill(shape.path);
      pen.restore();
      return;
    }
    const font = `${bits & ITALIC ? "italic " : ""}${bits & BOLD ? "bold " : ""}${cell.size}px ${MONO}`;
    if (pen.font !== font) pen.font = font;
    // What another font lends may be wider than its cell.
    const key = letter + (bits & (BOLD | ITALIC));
    if (!widths.has(key)) widths.set(key, pen.measureText(letter).width);
    const width = widths.get(key);
    if (width > 1.05 * cell.width && code < 0x1100) {
      pen.save();
      pen.translate(x, y + cell.base);
      pen.scale(cell.width / width, 1);
      pen.fillText(letter, 0, 0);
      pen.restore();
    } else {
      pen.fillText(letter, x, y + cell.base);
    }
  }

  // Braille, blocks and box lines are shapes, so that no font spoils what is made of them.
  function shapeOf(letter) {
    if (letter < "\u2500" || letter > "\u28ff") return null;
    if (!shapes.has(letter)) {
      const [path, strength] = program.call({ do: "glyph", letter }).lines;
      shapes.set(letter, path ? { path: new Path2D(path), strength: Number(strength) } : null);
    }
    return shapes.get(letter);
  }

  // Paints a picture where its cells show nothing else.
  function paintPicture(picture, paper, cells, columns) {
    const [x, y, w, h] = picture.area;
    const own = new Path2D();
    const isOwn = (column, row) => (cells[4 * (row * columns + column) + 3] & VECTOR) !== 0;
    let whole = true;
    for (let row = y; row < y + h && whole; row++) {
      for (let column = x; column < x + w && whole; column++) whole = isOwn(column, row);
    }
    if (whole) own.rect(x * cell.width, y * cell.height, w * cell.width, h * cell.height);
    for (let row = y; row < y + h && !whole; row++) {
      for (let start = x, column = x; column <= x + w; column++) {
        if (column < x + w && isOwn(column, row)) continue;
        if (column > start) {
          own.rect(start * cell.width, row * cell.height, (column - start) * cell.width, cell.height);
        }
        start = column + 1;
      }
    }
    pen.save();
    pen.fillStyle = hex(paper);
    pen.fill(own);
    pen.clip(own);
    pen.scale(cell.width / 9, cell.height / 18);
    pen.lineCap = "round";
    pen.lineJoin = "bevel";
    for (const [, name, attributes, text] of picture.svg.matchAll(/<(\w+)([^>]*)>([^<]*)/g)) {
      const of = {};
      for (const [, key, value] of attributes.matchAll(/([\w-]+)="([^"]*)"/g)) of[key] = value;
      element(name, of, text);
    }
    pen.restore();
  }

  // The colour of the disc drawn last: a letter on it needs no rim of that colour.
  let disc = "";

  // Draws an element of SVG, of those that carrom writes.
  function element(name, of, text) {
    const number = (key, otherwise = 0) => (key in of ? Number(of[key]) : otherwise);
    if (name === "text") return writing(of, text, number);
    const path = name === "path" ? new Path2D(of.d) : null;
    const [filled, stroked] = [of.fill, of.stroke].map((colour) => colour && colour !== "none");
    const wide = number("stroke-width", 1);
    const circle = (radius) => {
      pen.beginPath();
      pen.arc(number("cx"), number("cy"), Math.max(0, radius), 0, 2 * Math.PI);
    };
    if (name === "circle") {
      if (filled) disc = of.fill;
      if (filled && stroked) {
        // A rim lies under its disc: to fill is less work than to stroke.
        pen.fillStyle = of.stroke;
        circle(number("r") + wide / 2);
        pen.fill();
        pen.fillStyle = of.fill;
        circle(number("r") - wide / 2);
        pen.fill();
        return;
      }
      circle(number("r"));
    } else if (name === "rect") {
      pen.beginPath();
      pen.rect(number("x"), number("y"), number("width"), number("height"));
    } else if (!path) return;
    if (filled) {
      pen.fillStyle = of.fill;
      if (path) pen.fill(path);
      else pen.fill();
    }
    if (stroked) {
      pen.strokeStyle = of.stroke;
      pen.lineWidth = wide;
      const dashes = of["stroke-dasharray"];
      pen.setLineDash(dashes ? dashes.split(/[ ,]+/).map(Number) : []);
      if (path) pen.stroke(path);
      else pen.stroke();
    }
  }

  const SIGNS = { "&amp;": "&", "&lt;": "<", "&gt;": ">", "&quot;": '"' };

  function writing(of, text, number) {
    text = text.replace(/&\w+;/g, (sign) => SIGNS[sign] || sign);
    pen.font = `${number("font-size", 14)}px ${SANS}`;
    pen.textAlign = { middle: "center", end: "right" }[of["text-anchor"]] || "left";
    pen.setLineDash([]);
    if (of.stroke && of.stroke !== disc) {
      pen.strokeStyle = of.stroke;
      pen.lineWidth = number("stroke-width", 1);
      pen.strokeText(text, number("x"), number("y"));
    }
    pen.fillStyle = of.fill;
    pen.fillText(text, number("x"), number("y"));
    pen.textAlign = "left";
  }

  // The place in cells of a point of the window.
  function cellsAt(clientX, clientY) {
    const box = canvas.getBoundingClientRect();
    return [((clientX - box.left) / box.width) * grid[0], ((clientY - box.top) / box.height) * grid[1]];
  }

  const isPicture = (x, y) => {
    const i = 4 * (Math.floor(y) * grid[0] + Math.floor(x)) + 3;
    return before && (before[i] & VECTOR) !== 0;
  };

  return { canvas, fit, paint, cellsAt, isPicture };
})();

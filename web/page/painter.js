// The painter: draws pictures as vectors, each on a canvas of its own; a picture that consists
// only of cells is drawn cell by cell.

const painter = (() => {
  const VECTOR = 1 << 16, BOLD = 1, ITALIC = 4, UNDERLINED = 8;
  const MONO = "'DejaVu Sans Mono', Menlo, Consolas, 'Cascadia Mono', 'Roboto Mono', 'Liberation Mono', monospace";
  const SANS = "'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', Roboto, 'DejaVu Sans', sans-serif";
  // The smallest width of a column in CSS pixels: letters in a picture must be at least 14 pixels high.
  const LEAST = 9;
  // The columns and rows of the panel's cells, which are not shown: enough that no block is dropped.
  const PANEL = 62, ROWS = 100;
  // Whether picture and panel are side by side.
  const BESIDE = matchMedia("(min-width: 44.5rem) and (min-aspect-ratio: 5/6), (min-width: 40rem) and (max-height: 26rem)");
  const AIR = 16;
  let pen = null;
  // A cell in pixels of the device, the font that fits it, and the baseline of its letters.
  let cell = { width: 9, height: 18, size: 15, base: 14 };
  let ratio = 1;
  // The pictures, indexed by number; each has a canvas, an area, vectors and cells.
  const all = [];
  const shapes = new Map(), widths = new Map();
  // The greatest height of the window for each width: an on-screen keyboard hides a part of it.
  const heights = new Map();

  const hex = (colour) => "#" + colour.toString(16).padStart(6, "0");

  // Sizes, in cells, for an area of this width and height in CSS pixels: the size of the program's
  // screen, of pictures that fill the room for them, and of square pictures. A cell is twice as
  // high as wide, so circles are round.
  function fit(width, height) {
    ratio = window.devicePixelRatio || 1;
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    heights.set(width, Math.max(height, heights.get(width) || 0));
    height = heights.get(width);
    // There is a title above a picture, and there may be a line below it.
    const room = BESIDE.matches
      ? [Math.max(360, Math.min(width - 22 * rem, 0.68 * width) - 2 * AIR), height - 4.5 * rem]
      : [width - AIR, Math.min(0.78 * width, 0.46 * height)];
    const square = BESIDE.matches
      ? Math.min(...room)
      : Math.min(width - AIR, 0.62 * height);
    const wide = Math.round(ratio * Math.max(LEAST, Math.min(16, room[0] / 76)));
    const count = (pixels, each) => Math.max(6, Math.floor((pixels * ratio) / each));
    const any = [count(room[0], wide), count(room[1], 2 * wide)];
    const rows = count(square, 2 * wide);
    const pen = (all.find(Boolean)?.canvas || document.createElement("canvas")).getContext("2d");
    pen.font = `100px ${MONO}`;
    const size = (100 * wide) / pen.measureText("0").width;
    pen.font = `${size}px ${MONO}`;
    const box = pen.measureText("Hg");
    const [up, down] = [box.fontBoundingBoxAscent, box.fontBoundingBoxDescent];
    cell = { width: wide, height: 2 * wide, size, base: (2 * wide - up - down) / 2 + up };
    for (const drawn of all) if (drawn) drawn.svg = null;
    widths.clear();
    return {
      columns: Math.min(300, Math.max(any[0], 2 * rows) + 2 + PANEL),
      rows: Math.max(ROWS, any[1] + 4, rows + 4),
      pictures: { any, square: [2 * rows, rows] },
    };
  }

  // The canvas of a picture.
  function canvas(number) {
    const drawn = (all[number] = all[number] || {});
    if (!drawn.canvas) {
      drawn.canvas = document.createElement("canvas");
      drawn.canvas.setAttribute("role", "img");
      drawn.canvas.carromPicture = number;
    }
    return drawn.canvas;
  }

  // Paints the changes.
  function paint(painted) {
    const [columns, rows] = painted.size;
    const cells = program.cells(columns * rows);
    painted.pictures.forEach((picture, number) => {
      canvas(number);
      const drawn = all[number];
      const [x, y, w, h] = picture.area;
      const own = new Uint32Array(4 * w * h);
      for (let row = 0; row < h; row++) {
        const from = 4 * ((y + row) * columns + x);
        own.set(cells.subarray(from, from + 4 * w), 4 * row * w);
      }
      const svg = picture.svg === null ? drawn.told : picture.svg;
      const same = drawn.svg === svg && drawn.cells.length === own.length &&
        String(drawn.area) === String(picture.area) && own.every((it, i) => it === drawn.cells[i]);
      drawn.told = svg;
      if (same) return;
      Object.assign(drawn, { svg, cells: own, area: picture.area });
      redraw(drawn, hex(painted.colours[1]));
    });
  }

  function redraw({ canvas, area: [x, y, w, h], svg, cells }, paper) {
    const [width, height] = [w * cell.width, h * cell.height];
    if (canvas.width !== width || canvas.height !== height) {
      [canvas.width, canvas.height] = [width, height];
      canvas.style.width = `${width / ratio}px`;
      canvas.style.aspectRatio = `${width} / ${height}`;
    }
    pen = canvas.getContext("2d", { alpha: false });
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.fillStyle = paper;
    pen.fillRect(0, 0, width, height);
    if (svg) paintPicture(svg, [x, y]);
    for (let i = 0; i < w * h; i++) {
      if (!(cells[4 * i + 3] & VECTOR)) paintCell(cells, i, i % w, Math.floor(i / w));
    }
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
    // A glyph from a fallback font may be wider than its cell.
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

  // Braille, blocks and box lines are drawn as shapes, because fonts leave gaps between them.
  function shapeOf(letter) {
    if (letter < "\u2500" || letter > "\u28ff") return null;
    if (!shapes.has(letter)) {
      const [path, strength] = program.call({ do: "glyph", letter }).lines;
      shapes.set(letter, path ? { path: new Path2D(path), strength: Number(strength) } : null);
    }
    return shapes.get(letter);
  }

  // Paints the vectors of a picture whose upper left cell on the screen is (x, y).
  function paintPicture(svg, [x, y]) {
    pen.save();
    pen.scale(cell.width / 9, cell.height / 18);
    pen.translate(-9 * x, -18 * y);
    pen.lineCap = "round";
    pen.lineJoin = "bevel";
    for (const [, name, attributes, text] of svg.matchAll(/<(\w+)([^>]*)>([^<]*)/g)) {
      const of = {};
      for (const [, key, value] of attributes.matchAll(/([\w-]+)="([^"]*)"/g)) of[key] = value;
      element(name, of, text);
    }
    pen.restore();
  }

  // The colour of the last disc drawn: a letter on it needs no rim of that colour.
  let disc = "";

  // Draws an SVG element of a kind that carrom writes.
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
        // A rim is drawn as a larger disc behind the disc: filling is faster than stroking.
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

  // The position in cells of a point of the window, on a canvas or beside it.
  function cellsAt(canvas, clientX, clientY) {
    const box = canvas.getBoundingClientRect();
    const [x, y, w, h] = all[canvas.carromPicture].area;
    return [x + ((clientX - box.left) / box.width) * w, y + ((clientY - box.top) / box.height) * h];
  }

  return { fit, paint, canvas, cellsAt };
})();

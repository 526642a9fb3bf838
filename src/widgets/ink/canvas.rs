//! The cells that a picture is drawn on.

use std::f64::consts::TAU;

use glam::{DVec2, dvec2};
use ratatui::{
    buffer::Buffer,
    layout::Position,
    style::{Color, Modifier, Style},
};

use super::{
    cell::Cell,
    gallery,
    glyphs::{ascii, block},
    grid,
    label::PlacedLabel,
    shades::Shades,
    stroke::StrokeSamples,
};
use crate::widgets::picture::{Dash, DrawLayer, Mark, Pen, Picture, View};
use crate::widgets::text::blocks::braille;
use crate::widgets::{Blocks, Charset, Look, Role, Theme};

/// A cell of the canvas: column and row.
pub(super) type CellPlace = (i32, i32);

/// The cell that contains a point on paper.
pub(super) fn cell_of(paper: DVec2) -> CellPlace {
    (paper.x.floor() as i32, (paper.y / 2.0).floor() as i32)
}

/// The cells in which strokes, discs and labels in world coordinates are collected, before
/// [`Canvas::draw`] copies the cells that are not empty into a buffer.
#[derive(Debug, Clone)]
pub(in crate::widgets) struct Canvas {
    view: View,
    pub(super) charset: Charset,
    /// The block elements for discs.
    pub(super) blocks: Blocks,
    /// Whether the terminal has colours between a disc's colour and the background.
    pub(super) has_shades: bool,
    /// Whether the terminal has no colours at all.
    pub(super) is_mono: bool,
    pub(super) cells: Vec<Cell>,
    pub(in crate::widgets) labels: Vec<PlacedLabel>,
    /// The cells of labels' anchors, from which other labels keep away, counted from the corner of
    /// the area.
    pub(super) expected: Vec<CellPlace>,
    pub(super) stroke: StrokeSamples,
}

impl Canvas {
    /// An empty canvas over the area of `view`.
    pub(super) fn new(view: View, charset: Charset) -> Self {
        let area = view.area();
        let size: (usize, usize) = (area.width.into(), area.height.into());
        Self {
            view,
            charset,
            blocks: Blocks::default(),
            has_shades: false,
            is_mono: false,
            cells: vec![Cell::EMPTY; size.0 * size.1],
            labels: Vec::new(),
            expected: Vec::new(),
            stroke: StrokeSamples::new(grid(charset), size),
        }
    }

    /// A canvas on which a whole picture has been drawn.
    pub(in crate::widgets) fn of(picture: &Picture, look: &Look) -> Self {
        let mut canvas = Self::new(*picture.view(), look.charset);
        let is_hidden = look.charset == Charset::Unicode && gallery::hides_cells();
        canvas.blocks = look.blocks;
        canvas.has_shades = look.theme.has_shades() && !is_hidden;
        canvas.is_mono = look.theme.is_mono();
        // A board's surface never blocks a label, so it is not needed if vectors hide the cells.
        let is_needed = |mark: &&Mark| !(is_hidden && matches!(mark, Mark::Ground { .. }));
        for mark in picture.marks.iter().filter(is_needed) {
            canvas.mark(mark);
        }
        canvas.write(&picture.labels);
        canvas
    }

    fn mark(&mut self, mark: &Mark) {
        match mark {
            Mark::Line { from, to, pen } => self.line(*from, *to, *pen),
            Mark::Curve { points, pen } => self.through(points.iter().copied(), *pen, true),
            Mark::Arc { circle, turn, pen } => self.arc(*circle, *turn, *pen),
            Mark::Arrow { from, to, pen } => self.arrow(*from, *to, *pen),
            Mark::Dot { at, pen } => self.dot(*at, *pen),
            Mark::Disc(body) => self.disc(body),
            Mark::Ring { body, letter } => self.ring(body, *letter),
            Mark::Discs(bodies) => self.discs(bodies),
            Mark::Ground {
                region,
                role,
                outline,
            } => self.ground(*region, *role, *outline),
            Mark::Area { low, high, .. } => self.reserve_area(*low, *high),
            Mark::Text { at, text, .. } => self.reserve_text(*at, text),
            Mark::Reserved(at) => self.reserve(*at),
            Mark::Axes(_) => self.reserve_axes(),
        }
    }

    /// The mapping from the world to this canvas.
    pub(super) const fn view(&self) -> &View {
        &self.view
    }

    /// Draws a straight line. A horizontal or vertical line is shifted to the middles of its cells
    /// (in Unicode, of its dots), so that it looks the same wherever it is.
    pub(super) fn line(&mut self, from: DVec2, to: DVec2, pen: impl Into<Pen>) {
        let pen = pen.into();
        let (from, to) = self.snapped(self.paper(from), self.paper(to), pen);
        self.stroke.piece(from, to, pen);
        self.stroke.end(to, pen);
        self.commit(pen);
    }

    /// Draws a line through many points; an open line includes its last point. The line is
    /// interrupted at points that are not finite.
    fn through(&mut self, points: impl IntoIterator<Item = DVec2>, pen: Pen, open: bool) {
        let mut last: Option<DVec2> = None;
        for point in points {
            let here = self.paper(point);
            if let Some(last) = last {
                self.stroke.piece(last, here, pen);
            }
            last = Some(here);
        }
        if let Some(last) = last
            && open
        {
            self.stroke.end(last, pen);
        }
        self.commit(pen);
    }

    pub(super) fn dot(&mut self, at: DVec2, pen: impl Into<Pen>) {
        let (at, pen) = (self.paper(at), pen.into());
        self.stroke.dot(at, pen);
        self.commit(pen);
    }

    /// Draws an arc from one angle to another (in radians, anticlockwise from +x; clockwise if to <
    /// from). An arc of a full turn or more becomes a circle.
    fn arc(&mut self, (centre, radius): (DVec2, f64), [from, to]: [f64; 2], pen: Pen) {
        let turn = (to - from).clamp(-TAU, TAU);
        let reach = radius.abs() / self.view.per_column();
        if !(turn.is_finite() && reach.is_finite()) {
            return;
        }
        // Each piece is about half a column long, so its distance from the true arc is too small to
        // see.
        let pieces = (turn.abs() * reach * 2.0).ceil().clamp(4.0, 720.0) as u32;
        let step = DVec2::from_angle(turn / f64::from(pieces));
        let mut arm = DVec2::from_angle(from) * radius;
        let points = (0..=pieces).map(move |_| {
            let point = centre + arm;
            arm = step.rotate(arm);
            point
        });
        self.through(points, pen, turn.abs() < TAU);
    }

    pub(super) fn circle(&mut self, centre: DVec2, radius: f64, pen: impl Into<Pen>) {
        self.arc((centre, radius), [0.0, TAU], pen.into());
    }

    /// Keeps the cell at a point in the world free of labels.
    pub(super) fn reserve(&mut self, at: DVec2) {
        if let Some(cell) = self.cell_at(self.paper(at)) {
            cell.reserved = true;
        }
    }

    /// Draws the canvas into `buffer`. Cells on which nothing was drawn keep their contents.
    pub(super) fn draw(&self, buffer: &mut Buffer, theme: &Theme) {
        let inside = self.view.area().intersection(buffer.area);
        for at in inside.positions() {
            if let Some(cell) = self.on_screen(at).filter(|cell| !cell.is_empty()) {
                let (symbol, style) = self.look(cell, theme);
                buffer[at].set_char(symbol).set_style(style);
            }
        }
        for label in &self.labels {
            label.draw(buffer, theme);
        }
    }

    /// The final character and style of a cell on this canvas.
    fn look(&self, cell: &Cell, theme: &Theme) -> (char, Style) {
        let (symbol, style) = self.look_on_paper(cell, theme);
        match cell.ground_role().filter(|_| style.bg.is_none()) {
            Some(role) => (symbol, style.bg(theme.colour(role))),
            None => (symbol, style),
        }
    }

    /// The character and style of a cell, before [`Canvas::look`] adds a board's colour as the
    /// background where there is none.
    fn look_on_paper(&self, cell: &Cell, theme: &Theme) -> (char, Style) {
        let is_faint = cell.cover() != 0 && cell.is_faint();
        if let Some(glyph) = cell.glyph {
            let upon = glyph.upon && self.charset == Charset::Unicode;
            let mut style = match upon {
                true if is_faint => theme.style(glyph.role).bg(self.paper_of(cell, theme)),
                true if self.has_shades => theme.on(glyph.role).bg(self.paper_of(cell, theme)),
                true => theme.on(glyph.role),
                false => theme.style(glyph.role),
            };
            if glyph.reversed {
                style = style.add_modifier(Modifier::REVERSED);
            }
            return (glyph.symbol, style);
        }
        let pen = cell.pen;
        let mut stroke = theme.faded(pen.role, pen.age);
        if pen.bold {
            stroke = stroke.add_modifier(Modifier::BOLD);
        }
        match self.charset {
            Charset::Ascii if cell.ink != 0 => (ascii::nearest(cell.ink), stroke),
            Charset::Ascii => (' ', Style::new()),
            Charset::Unicode if is_faint && cell.ink != 0 => {
                (braille(cell.ink), stroke.bg(self.paper_of(cell, theme)))
            }
            Charset::Unicode if cell.discs[0].bits == u64::MAX && cell.ink != 0 => {
                let disc = cell.discs[0].role;
                let upon = if pen.layer < DrawLayer::Vector {
                    theme.faintly_on(disc)
                } else {
                    theme.on(disc)
                };
                (braille(cell.ink), upon)
            }
            // A stroke is interrupted at a disc's edge, so that the disc looks round.
            Charset::Unicode if cell.ink != 0 && !cell.has_edge() => (braille(cell.ink), stroke),
            Charset::Unicode if cell.is_flat() => (' ', Style::new()),
            Charset::Unicode => self.disc_look(cell, theme),
        }
    }

    /// The mean colour of everything below the strokes of a cell.
    fn paper_of(&self, cell: &Cell, theme: &Theme) -> Color {
        theme.reduced(Shades::of(cell, theme).mean(u64::MAX))
    }

    fn disc_look(&self, cell: &Cell, theme: &Theme) -> (char, Style) {
        let mono = theme.is_mono();
        let [disc, beside] = cell.discs;
        if disc.bits == u64::MAX && !disc.faint {
            let hollow = theme.is_hollow(disc.role);
            return (if hollow { ' ' } else { '█' }, theme.fill(disc.role));
        }
        if self.has_shades {
            let (symbol, [ink, paper]) = Shades::of(cell, theme).fitted(self.blocks);
            let style = Style::new().fg(theme.reduced(ink)).bg(theme.reduced(paper));
            return (symbol, style);
        }
        let block = block::nearest(self.blocks, disc.bits, !mono);
        if mono {
            return (block.symbol, theme.style(disc.role));
        }
        // If another disc fills at least half of the remaining part of the cell, that disc's colour
        // is the background of the edge.
        let others = beside.bits.count_ones();
        let is_beside = others > 0 && 2 * others >= (!disc.bits).count_ones();
        let rest = if is_beside {
            beside.role
        } else {
            Role::Background
        };
        let (disc, rest) = (theme.colour(disc.role), theme.colour(rest));
        let (ink, paper) = match block.inverse {
            true => (rest, disc),
            false => (disc, rest),
        };
        (block.symbol, Style::new().fg(ink).bg(paper))
    }

    /// Converts a point in the world to paper coordinates.
    pub(super) fn paper(&self, world: DVec2) -> DVec2 {
        let area = self.view.area();
        let cell = self.view.to_cell(world) - dvec2(f64::from(area.x), f64::from(area.y));
        dvec2(cell.x, 2.0 * cell.y)
    }

    /// Whether anything has been drawn in a cell of the screen.
    pub(super) fn is_drawn(&self, at: Position) -> bool {
        let cell = self.on_screen(at);
        cell.is_some_and(|cell| cell.layer().is_some())
    }

    /// The contents of a cell of the screen, if the cell is on this canvas.
    fn on_screen(&self, at: Position) -> Option<&Cell> {
        let area = self.view.area();
        let (x, y) = (at.x.checked_sub(area.x)?, at.y.checked_sub(area.y)?);
        self.cell((x.into(), y.into()))
    }

    /// The index of a cell, if the cell is on this canvas.
    pub(super) fn index(&self, (column, row): CellPlace) -> Option<usize> {
        let (columns, rows) = self.size();
        let inside = (0..columns).contains(&column) && (0..rows).contains(&row);
        inside.then(|| (row * columns + column) as usize)
    }

    pub(super) fn cell(&self, place: CellPlace) -> Option<&Cell> {
        self.cells.get(self.index(place)?)
    }

    /// A cell of the canvas, for drawing.
    pub(super) fn cell_mut(&mut self, place: CellPlace) -> Option<&mut Cell> {
        let index = self.index(place)?;
        self.cells.get_mut(index)
    }

    /// The cell at a point on paper.
    pub(super) fn cell_at(&mut self, paper: DVec2) -> Option<&mut Cell> {
        let place = paper.is_finite().then(|| cell_of(paper));
        self.cell_mut(place?)
    }

    /// The ends of a line on paper. If the line is horizontal or vertical, both ends are shifted to
    /// the nearest samples: the middles of cells in ASCII, otherwise the dots.
    pub(super) fn snapped(&self, mut from: DVec2, mut to: DVec2, pen: Pen) -> (DVec2, DVec2) {
        let step = match self.charset {
            Charset::Ascii => dvec2(1.0, 2.0),
            Charset::Unicode => dvec2(0.5, 0.5),
        };
        // A bold line runs between two dots.
        let shift = if pen.bold && self.charset == Charset::Unicode {
            0.0
        } else {
            0.5
        };
        let snap = |at: f64, step: f64| ((at / step - shift).round() + shift) * step;
        let along = (to - from).abs();
        if along.y < 0.2 && along.x >= 1.0 {
            let middle = snap((from.y + to.y) / 2.0, step.y);
            (from.y, to.y) = (middle, middle);
        } else if along.x < 0.2 && along.y >= 1.0 {
            let middle = snap((from.x + to.x) / 2.0, step.x);
            (from.x, to.x) = (middle, middle);
        }
        (from, to)
    }

    /// Ends a stroke and copies its samples into the cells.
    pub(super) fn commit(&mut self, pen: Pen) {
        let (cells, charset) = (&mut self.cells, self.charset);
        self.stroke.take(|order, index, samples| {
            let inked = charset == Charset::Unicode
                || match pen.dash {
                    Dash::Solid => true,
                    Dash::Dashed => order % 3 != 2,
                    Dash::Dotted => order % 2 == 0,
                };
            if inked && let Some(cell) = cells.get_mut(index) {
                cell.stroke(samples, pen, charset);
            }
        });
    }

    /// The numbers of columns and rows of the canvas.
    pub(super) fn size(&self) -> (i32, i32) {
        let area = self.view.area();
        (i32::from(area.width), i32::from(area.height))
    }
}

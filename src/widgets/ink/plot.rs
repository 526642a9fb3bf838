//! Marks that fill whole cells: axes, bars and signs.

use glam::{DVec2, dvec2};
use ratatui::{buffer::Buffer, style::Style};

use super::canvas::Canvas;
use super::gallery;
use crate::widgets::picture::{Axes, Mark, Picture};
use crate::widgets::text::{self, blocks::LOWER};
use crate::widgets::{Charset, Look, Role};

impl Canvas {
    /// Reserves the cells of the axes, so that no label covers them.
    pub(super) fn reserve_axes(&mut self) {
        let view = *self.view();
        let paper = view.area();
        for column in paper.left()..paper.right() {
            self.reserve(view.world_at(column, paper.bottom().saturating_sub(1)));
        }
        for row in paper.top()..paper.bottom() {
            self.reserve(view.world_at(paper.x, row));
        }
    }

    /// Reserves the cells of text centred on a point, so that no label covers them.
    pub(super) fn reserve_text(&mut self, at: DVec2, text: &str) {
        let width = self.view().per_column() * text::width(text) as f64;
        let half = (width - self.view().per_column()) / 2.0 * DVec2::X;
        self.reserve_area(at - half, at + half);
        self.reserve(at);
    }

    /// Reserves the cells that a filled area touches, so that no label covers them.
    pub(super) fn reserve_area(&mut self, low: DVec2, high: DVec2) {
        let view = *self.view();
        let half = dvec2(view.per_column(), view.per_row()) / 2.0;
        for cell in view.area().positions() {
            let at = view.world_at(cell.x, cell.y);
            if (at + half).cmpgt(low).all() && (at - half).cmplt(high).all() {
                self.reserve(at);
            }
        }
    }
}

impl Picture {
    /// Draws the picture into cells.
    pub fn draw(&self, buf: &mut Buffer, look: &Look) {
        let canvas = Canvas::of(self, look);
        let cells = Cells {
            canvas: &canvas,
            picture: self,
            look,
        };
        cells.areas(buf);
        for mark in &self.marks {
            if let Mark::Axes(axes) = mark {
                cells.axes(axes, buf);
            }
        }
        canvas.draw(buf, &look.theme);
        for mark in &self.marks {
            if let Mark::Text { at, text, role } = mark
                && let Some((column, row)) = self.view().cell_at(*at)
            {
                let text = look.charset.text(text);
                let start = column.saturating_sub((text::width(&text) as u16 - 1) / 2);
                cells.write(buf, (start, row), &text, look.theme.style(*role));
            }
        }
        gallery::note(self, &canvas, buf, look);
    }
}

/// Draws the marks that fill whole cells.
struct Cells<'a> {
    canvas: &'a Canvas,
    picture: &'a Picture,
    look: &'a Look,
}

impl Cells<'_> {
    /// Draws filled areas: every column except the axis's column shows the area that contains the
    /// middle of the column. If the axis would hide the first bar, the bar is drawn in the next
    /// column.
    fn areas(&self, buf: &mut Buffer) {
        let view = self.canvas.view();
        let paper = view.area();
        let areas = self.picture.marks.iter().filter_map(|mark| match mark {
            Mark::Area { low, high, pen } => Some((*low, *high, pen.role)),
            _ => None,
        });
        let areas: Vec<_> = areas.collect();
        let first = paper.left() + 1;
        for column in first..paper.right() {
            let x = view.world_at(column, paper.y).x;
            let over = |(low, high, _): &&(DVec2, DVec2, Role)| low.x <= x && x < high.x;
            let lost = areas.first().filter(|(_, high, _)| high.x <= x);
            let narrow = lost.filter(|_| column == first);
            let Some((low, high, role)) = narrow.or_else(|| areas.iter().find(over)) else {
                continue;
            };
            // Positions in cells; the last row is the axis.
            let [top, foot] = [high, low].map(|end| view.to_cell(dvec2(x, end.y)).y);
            for row in paper.top()..paper.bottom().saturating_sub(1) {
                let filled = f64::from(row) + 1.0 - top;
                if filled > 0.0 && f64::from(row) + 0.5 < foot {
                    self.fill(buf, (column, row), filled.min(1.0), *role);
                }
            }
        }
    }

    /// Fills a cell from below: in Unicode to the nearest eighth, in ASCII either completely or not
    /// at all. Under a curve, too, a cell is filled completely or not at all, because only its
    /// background can be filled.
    fn fill(&self, buf: &mut Buffer, at: (u16, u16), share: f64, role: Role) {
        let theme = &self.look.theme;
        let share = match self.canvas.is_drawn(at.into()) {
            true => share.round(),
            false => share,
        };
        let eighths = (share * 8.0).round() as usize;
        let Some(part) = eighths.checked_sub(1) else {
            return;
        };
        let (symbol, style) = match (self.look.charset, LOWER.get(part)) {
            (Charset::Ascii, _) if share < 0.5 => return,
            (Charset::Ascii, _) => (':', theme.style(role)),
            (Charset::Unicode, Some(part)) => (*part, theme.style(role)),
            (Charset::Unicode, None) if theme.is_mono() => ('░', theme.style(role)),
            // The cell's background is filled, so that a curve can be drawn over it.
            (Charset::Unicode, None) => (' ', theme.fill(role)),
        };
        self.write(buf, at, symbol.encode_utf8(&mut [0; 4]), style);
    }

    fn axes(&self, axes: &Axes, buf: &mut Buffer) {
        let view = self.canvas.view();
        let (paper, area) = (view.area(), self.picture.area());
        if area.is_empty() {
            return;
        }
        let charset = self.look.charset;
        let named = self.look.theme.style(Role::Text);
        let [x, y] = axes.names.each_ref().map(|name| charset.text(name));
        self.write(buf, (area.x, area.y), &y, named);
        let spare = paper.width.saturating_sub(text::width(&x) as u16);
        let last = area.bottom() - 1;
        if last > paper.bottom() {
            self.write(buf, (paper.x + spare / 2, last), &x, named);
        }
        if paper.is_empty() {
            return;
        }
        let style = self.look.theme.style(Role::Axis);
        let [upright, level, corner, y_tick, x_tick] = match charset {
            Charset::Ascii => ["|", "-", "+", "+", "+"],
            Charset::Unicode => ["│", "─", "└", "┤", "┬"],
        };
        let foot = paper.bottom() - 1;
        for row in paper.top()..foot {
            self.write(buf, (paper.x, row), upright, style);
        }
        for column in paper.left() + 1..paper.right() {
            self.write(buf, (column, foot), level, style);
        }
        self.write(buf, (paper.x, foot), corner, style);
        let numbers = self.look.theme.style(Role::Dim);
        let origin = view.world_at(paper.x, foot);
        let mut free = area.x;
        for (place, text) in &axes.ticks[0] {
            let Some((column, row)) = view.cell_at(dvec2(*place, origin.y)) else {
                continue;
            };
            if column > paper.x {
                self.write(buf, (column, row), x_tick, style);
            }
            let text = charset.text(text);
            let width = text::width(&text) as u16;
            let start = column.saturating_sub(width.saturating_sub(1) / 2).max(free);
            if start + width <= area.right() {
                self.write(buf, (start, row + 1), &text, numbers);
                free = start + width + 1;
            }
        }
        for (place, text) in &axes.ticks[1] {
            let Some((column, row)) = view.cell_at(dvec2(origin.x, *place)) else {
                continue;
            };
            if row < foot {
                self.write(buf, (column, row), y_tick, style);
            }
            let text = charset.text(text);
            let start = column.saturating_sub(text::width(&text) as u16);
            self.write(buf, (start.max(area.x), row), &text, numbers);
        }
    }

    /// Writes text within the picture's area; anything that does not fit is cut off.
    fn write(&self, buf: &mut Buffer, (column, row): (u16, u16), text: &str, style: Style) {
        let room = self.picture.area().right().saturating_sub(column);
        if buf.area.contains((column, row).into()) && room > 0 {
            buf.set_stringn(column, row, text, room.into(), style);
        }
    }
}

//! Reads the pages of a database file one by one, and skips damaged ones.
//!
//! SQLite ends a scan at the first unreadable page, and later rows can only be found by their keys.
//! A walk through the tree can continue after such a page, and needs no keys. The numbers in this
//! module are those of the Database File Format (<https://sqlite.org/fileformat.html>), sections
//! 1.3 to 2.1.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashSet};
use std::ops::RangeInclusive;

use rusqlite::types::ValueRef;

/// The size of a page in bytes; carrom's databases have no pages of another size.
const PAGE: usize = 4096;
/// The size of the file's header, which precedes the header of the first page.
const FILE_HEADER: usize = 100;
/// Where the file's header stores the number of the first page in the list of unused pages.
const UNUSED: usize = 32;
/// The limit on the number of bytes that are read, as a multiple of the file's size. It keeps
/// overlapping cells and merging chains from multiplying the work. An undamaged file is read twice.
const READINGS: usize = 16;

/// The layout of the pages of a tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PageLayout {
    /// A table whose rows have ids; only the leaves have rows.
    Table,
    /// A table without ids, or an index; every page has rows.
    Index,
}

/// The pages that a root leads to.
#[derive(Debug, Default)]
pub(super) struct Tree {
    pub(super) pages: BTreeSet<u32>,
    /// Whether all of them could be read.
    pub(super) is_whole: bool,
}

pub(super) struct BtreeCell {
    /// The row's id, in a table whose rows have ids.
    pub(super) id: Option<i64>,
    /// The row; `None` if it cannot be read.
    pub(super) record: Option<Vec<u8>>,
}

pub(super) struct PageContents {
    pub(super) layout: PageLayout,
    pub(super) cells: Vec<BtreeCell>,
    /// Whether all cells could be found.
    pub(super) is_whole: bool,
}

/// A database file.
pub(super) struct Pages<'f> {
    file: &'f [u8],
    /// The number of bytes that may still be read.
    left: usize,
}

struct Page<'f> {
    bytes: Cow<'f, [u8]>,
    layout: PageLayout,
    is_bottom: bool,
    header: usize,
}

impl<'f> Pages<'f> {
    /// The pages of a file. The last page may be truncated; its missing bytes are read as zeros.
    pub(super) fn of(file: &'f [u8]) -> Self {
        let left = file.len().saturating_mul(READINGS).saturating_add(PAGE);
        Self { file, left }
    }

    pub(super) fn numbers(&self) -> RangeInclusive<u32> {
        1..=u32::try_from(self.file.len().div_ceil(PAGE)).unwrap_or(u32::MAX)
    }

    /// The size of all pages in bytes.
    pub(super) fn size(&self) -> usize {
        self.file.len().next_multiple_of(PAGE)
    }

    /// The pages below a root, and the root itself.
    pub(super) fn tree(&mut self, root: u32, layout: PageLayout) -> Tree {
        let mut pages = BTreeSet::new();
        let mut is_whole = true;
        let mut ahead = vec![root];
        while let Some(number) = ahead.pop() {
            let page = if pages.contains(&number) {
                None
            } else {
                self.page(number).filter(|page| page.layout == layout)
            };
            is_whole &= page.is_some();
            if let Some(page) = page {
                pages.insert(number);
                for child in page.children() {
                    is_whole &= child.is_some();
                    ahead.extend(child);
                }
            }
        }
        Tree { pages, is_whole }
    }

    /// The contents of a page; `None` if it cannot be read or does not belong to a tree.
    pub(super) fn contents(&mut self, number: u32) -> Option<PageContents> {
        let page = self.page(number)?;
        let mut contents = PageContents {
            layout: page.layout,
            cells: Vec::new(),
            is_whole: true,
        };
        if page.layout == PageLayout::Table && !page.is_bottom {
            return Some(contents);
        }
        for start in page.starts() {
            match start.and_then(|start| page.part(start)) {
                Some(part) => contents.cells.push(BtreeCell {
                    id: part.id,
                    record: self.record(&part),
                }),
                None => contents.is_whole = false,
            }
        }
        Some(contents)
    }

    /// The pages that the file lists as unused; their contents were deleted.
    pub(super) fn unused(&mut self) -> HashSet<u32> {
        let mut unused = HashSet::new();
        let first = self.bytes(1);
        let mut next = first.and_then(|bytes| number_at(&bytes, UNUSED));
        while let Some(number) = next
            && let Some(bytes) = self.bytes(number)
            && unused.insert(number)
        {
            let listed = number_at(&bytes, 4).unwrap_or_default();
            let places = (8..PAGE).step_by(4).take(listed as usize);
            unused.extend(places.filter_map(|place| number_at(&bytes, place)));
            next = number_at(&bytes, 0);
        }
        unused
    }

    /// The whole row, given the part that is on the cell's page.
    fn record(&mut self, part: &Payload) -> Option<Vec<u8>> {
        if part.length > self.size() {
            return None;
        }
        let mut record = part.bytes.to_vec();
        let mut next = part.next;
        while record.len() < part.length {
            let bytes = self.bytes(next)?;
            next = number_at(&bytes, 0)?;
            let missing = part.length - record.len();
            record.extend(bytes.iter().skip(4).take(missing));
        }
        Some(record)
    }

    fn page(&mut self, number: u32) -> Option<Page<'f>> {
        let bytes = self.bytes(number)?;
        let header = if number == 1 { FILE_HEADER } else { 0 };
        let (layout, is_bottom) = match bytes.get(header)? {
            2 => (PageLayout::Index, false),
            5 => (PageLayout::Table, false),
            10 => (PageLayout::Index, true),
            13 => (PageLayout::Table, true),
            _ => return None,
        };
        Some(Page {
            bytes,
            layout,
            is_bottom,
            header,
        })
    }

    /// The bytes of a page; `None` if it cannot be read, or too much has been read already.
    fn bytes(&mut self, number: u32) -> Option<Cow<'f, [u8]>> {
        let bytes = self
            .file
            .chunks(PAGE)
            .nth(number.checked_sub(1)? as usize)?;
        self.left = self.left.checked_sub(PAGE)?;
        let missing = vec![0; PAGE - bytes.len()];
        Some(match missing.is_empty() {
            true => bytes.into(),
            false => [bytes, &missing].concat().into(),
        })
    }
}

/// The part of a row that is on the page of its cell.
struct Payload<'a> {
    id: Option<i64>,
    /// The size of the whole row in bytes.
    length: usize,
    bytes: &'a [u8],
    /// The page on which the row continues; 0 if it does not.
    next: u32,
}

impl Page<'_> {
    /// The start of each cell; `None` if the stored position is impossible.
    fn starts(&self) -> impl Iterator<Item = Option<usize>> {
        let count = short_at(&self.bytes, self.header + 3).unwrap_or_default();
        let list = self.header + if self.is_bottom { 8 } else { 12 };
        (0..count).map_while(move |cell| {
            let place = list + 2 * cell;
            (place + 2 <= PAGE).then(|| {
                let start = short_at(&self.bytes, place);
                start.filter(|start| (list..PAGE).contains(start))
            })
        })
    }

    /// The number of each page directly below this one; `None` if the number cannot be read.
    fn children(&self) -> impl Iterator<Item = Option<u32>> {
        let below = self
            .starts()
            .map(|start| start.and_then(|start| number_at(&self.bytes, start)));
        let last = number_at(&self.bytes, self.header + 8);
        below.chain([last]).filter(|_| !self.is_bottom)
    }

    /// The part of a row that is on this page; the row's cell begins at `start`.
    fn part(&self, start: usize) -> Option<Payload<'_>> {
        let start = start + if self.is_bottom { 0 } else { 4 };
        let (length, rest) = varint(self.bytes.get(start..)?)?;
        let length = usize::try_from(length).ok()?;
        let (id, rest, most) = match self.layout {
            PageLayout::Table => varint(rest).map(|(id, rest)| (Some(id), rest, PAGE - 35))?,
            PageLayout::Index => (None, rest, (PAGE - 12) * 64 / 255 - 23),
        };
        let least = (PAGE - 12) * 32 / 255 - 23;
        let on_page = if length <= most {
            length
        } else {
            let full = least + (length - least) % (PAGE - 4);
            if full <= most { full } else { least }
        };
        let bytes = rest.get(..on_page)?;
        let next = match on_page < length {
            true => number_at(rest, on_page)?,
            false => 0,
        };
        Some(Payload {
            id,
            length,
            bytes,
            next,
        })
    }
}

/// The values of a row in stored order; `None` if the row is invalid.
pub(super) fn values(record: &[u8]) -> Option<Vec<ValueRef<'_>>> {
    let (length, _) = varint(record)?;
    let (header, mut body) = record.split_at_checked(usize::try_from(length).ok()?)?;
    let (_, mut header) = varint(header)?;
    let mut values = Vec::new();
    while !header.is_empty() {
        let (kind, rest) = varint(header)?;
        header = rest;
        let length = match kind {
            0 | 8 | 9 => 0,
            1..=4 => kind,
            5 => 6,
            6 | 7 => 8,
            12.. => (kind - 12) / 2,
            _ => return None,
        };
        let (bytes, rest) = body.split_at_checked(usize::try_from(length).ok()?)?;
        body = rest;
        values.push(match kind {
            0 => ValueRef::Null,
            1..=6 => ValueRef::Integer(integer(bytes)),
            7 => ValueRef::Real(f64::from_bits(integer(bytes).cast_unsigned())),
            8 => ValueRef::Integer(0),
            9 => ValueRef::Integer(1),
            kind if kind % 2 == 0 => ValueRef::Blob(bytes),
            _ => ValueRef::Text(bytes),
        });
    }
    Some(values)
}

/// A big-endian number in two's complement.
fn integer(bytes: &[u8]) -> i64 {
    let is_negative = bytes.first().is_some_and(|it| *it > 127);
    let sign = -i64::from(is_negative);
    { bytes.iter() }.fold(sign, |number, byte| number << 8 | i64::from(*byte))
}

/// Reads a number of one to nine bytes, which hold seven bits each, except that the ninth holds
/// eight; also returns the remaining bytes.
fn varint(bytes: &[u8]) -> Option<(i64, &[u8])> {
    let mut number = 0;
    for (place, byte) in bytes.iter().enumerate().take(9) {
        let (bits, value) = if place == 8 {
            (8, *byte)
        } else {
            (7, byte & 127)
        };
        number = number << bits | i64::from(value);
        if place == 8 || *byte < 128 {
            return Some((number, &bytes[place + 1..]));
        }
    }
    None
}

fn short_at(bytes: &[u8], place: usize) -> Option<usize> {
    let (short, _) = bytes.get(place..)?.split_first_chunk()?;
    Some(u16::from_be_bytes(*short).into())
}

fn number_at(bytes: &[u8], place: usize) -> Option<u32> {
    let (number, _) = bytes.get(place..)?.split_first_chunk()?;
    Some(u32::from_be_bytes(*number))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The page has 1,200 cell pointers, which all lead to the same row. The row is nearly as long
    /// as the file, and the page on which it continues refers to itself.
    #[test]
    fn overlapping_cells_and_endless_chains_do_not_multiply_the_work() {
        let mut bytes = vec![0; 256 * PAGE];
        let length: u32 = 255 * 4096;
        let (leaf, next, start) = (PAGE, 2 * PAGE, 2500);
        bytes[leaf] = 13;
        bytes[leaf + 3..leaf + 5].copy_from_slice(&1200_u16.to_be_bytes());
        for pointer in bytes[leaf + 8..leaf + 2408].chunks_exact_mut(2) {
            pointer.copy_from_slice(&2500_u16.to_be_bytes());
        }
        let digits = [length >> 14 | 128, length >> 7 & 127 | 128, length & 127, 1];
        let cell = &mut bytes[leaf + start..2 * PAGE];
        cell[..4].copy_from_slice(&digits.map(|digit| digit as u8));
        // 1,020 bytes of the row are on the cell's page; it continues on page 3.
        cell[1024..1028].copy_from_slice(&3_u32.to_be_bytes());
        bytes[next..next + 4].copy_from_slice(&3_u32.to_be_bytes());
        let mut pages = Pages::of(&bytes);
        let contents = pages.contents(2).unwrap();
        let whole = contents.cells.iter().filter(|it| it.record.is_some());
        assert!(whole.count() > 1);
        assert!(pages.left < PAGE, "{}", pages.left);
        assert!(pages.contents(4).is_none(), "nothing more may be read");
    }
}

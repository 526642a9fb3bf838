//! Reads lines of any length from a stream, with limited memory.

use std::io::{self, BufRead, Read};

/// Reads at most `most` bytes of the next line into `line`, without its line break; the rest is
/// skipped. Returns whether the line is complete, or `None` at the end of the stream.
pub fn read_line(
    input: &mut (impl BufRead + ?Sized),
    most: usize,
    line: &mut Vec<u8>,
) -> io::Result<Option<bool>> {
    line.clear();
    let read = (&mut *input)
        .take(most as u64 + 1)
        .read_until(b'\n', line)?;
    let has_ended = line.pop_if(|last| *last == b'\n').is_some();
    let is_whole = has_ended || line.len() <= most;
    if !is_whole {
        line.truncate(most);
        input.skip_until(b'\n')?;
    }
    Ok((read > 0).then_some(is_whole))
}

//! Lines of any length from a stream, in bounded memory.

use std::io::{self, BufRead, Read};

/// Reads the next line into `line`, without its break, and at most `most` bytes of it: the rest is
/// skipped. `None` at the end, otherwise whether the line is complete.
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
